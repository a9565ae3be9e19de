// A flight at a panel, its recording, and the same pictures without the panel.

#include "host/loop/host_values.h"
#include "host/loop/steady_rates.h"
#include "host/packet/packet_bytes.h"
#include "host/panel/panel_link.h"
#include "ig/sink/hash_sink.h"
#include "tests/tools/command.h"
#include "tests/tools/small_flight.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/flight.h"
#include "tools/flight/replay.h"
#include "tools/panel/lamp_test.h"
#include "tools/panel/shipped_mappings.h"

#include <gmock/gmock.h>

#include <fstream>
#include <set>

namespace linkdig::tools {
namespace {

using host::Signal;
using testing::HasSubstr;

/// The bits of the multi panel in each frame: knobs turned at several places of the selector, and buttons.
constexpr std::array<std::uint32_t, 14> hands{0x000001, 0x000041, 0x000001, 0x000010, 0x000030,
                                              0x000010, 0x000050, 0x000004, 0x000024, 0x000004,
                                              0x000204, 0x000004, 0x080004, 0x000004};

TEST(PanelRecording, TheSamePicturesWithoutThePanel) {
    const TemporaryFolder folder;
    std::vector<std::uint64_t> pictures;
    std::vector<std::vector<std::uint8_t>> packets;
    {
        Flight flight(small_flight(160, 120, 30.0));
        host::SignalStore signals;
        const host::IndicationStore indications;
        panel::PanelDesk desk(mappings_of({}), signals, indications, [](const std::string&) {});
        const panel::PanelPlace place{panel::PanelKind::multi, "1-4"};
        desk.attached(place);
        host::SteadyRates rates;
        RecordingWriter recording(folder.file("flight.rec"), flight.recording_header(), flight.history());
        for (std::uint64_t frame = 0; frame < hands.size(); ++frame) {
            const std::uint32_t bits = hands[frame];
            desk.report(place,
                        std::vector<std::uint8_t>{static_cast<std::uint8_t>(bits),
                                                  static_cast<std::uint8_t>(bits >> 8U),
                                                  static_cast<std::uint8_t>(bits >> 16U)},
                        panel::ReportSource::sent, static_cast<double>(frame) / 30.0);
            flight.draw(frame,
                        rates.follow(signals.snapshot(), flight.loop(), frame == 0 ? 0 : frame - 1, signals));
            recording.write(flight.packet());
            pictures.push_back(ig::picture_hash(flight.machine().picture(0)));
            packets.push_back(encode_packet(flight.packet()));
        }
        recording.close();
        EXPECT_NE(signals.value(Signal::visibility), 1.0);
        EXPECT_NE(signals.value(Signal::ship_speed), 1.0);
        EXPECT_EQ(signals.value(Signal::smooth_shading), 0.0);
        EXPECT_NE(signals.value(Signal::time_of_day), 0.0);
    }
    Replay replay(folder.file("flight.rec"), "", small_flight(160, 120, 30.0).configuration);
    for (std::uint64_t frame = 0; frame < hands.size(); ++frame) {
        EXPECT_EQ(encode_packet(replay.draw()), packets[frame]) << frame;
        EXPECT_EQ(ig::picture_hash(replay.machine().picture(0)), pictures[frame]) << frame;
    }
    Flight again(small_flight(160, 120, 30.0)); // by the recorded signals alone
    RecordingReader reader(folder.file("flight.rec"));
    FramePacket packet;
    while (reader.next(packet)) {
        again.draw(packet.frame, host::signals_of(packet));
        EXPECT_EQ(encode_packet(again.packet()), packets[packet.frame]) << packet.frame;
    }
}

TEST(PanelMappings, NamedOnesReplaceTheShippedOnesOfTheirKind) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("mine.toml")) << "[panel]\nkind = \"multi\"\n";
    std::ofstream(folder.file("port.toml")) << "[panel]\nkind = \"switch\"\nport = \"1-4\"\n";
    EXPECT_EQ(mappings_of({}).size(), 3U);
    const auto mappings = mappings_of({folder.file("mine.toml"), folder.file("port.toml")});
    ASSERT_EQ(mappings.size(), 4U) << "the two, and the shipped ones of switch and radio panels";
    EXPECT_EQ(panel::mapping_for(mappings, panel::PanelKind::multi, "1-1")->path, folder.file("mine.toml"));
    EXPECT_EQ(panel::mapping_for(mappings, panel::PanelKind::switches, "1-4")->path,
              folder.file("port.toml"));
    EXPECT_THAT(panel::mapping_for(mappings, panel::PanelKind::switches, "1-5")->path,
                HasSubstr("switch.toml"));
    std::ofstream(folder.file("bad.toml")) << "[panel]\nkind = \"mutli\"\n";
    EXPECT_THROW(mappings_of({folder.file("bad.toml")}), BadInput);
}

TEST(PanelCommandLine, MapSaysWhatAFileDoesOrWhatIsWrongWithIt) {
    const Outcome shipped = run("panel map " LINKDIG_SOURCE_DIR "/host/panel/mappings/switch.toml");
    EXPECT_EQ(shipped.exit_code, 0);
    EXPECT_THAT(shipped.output,
                HasSubstr("magneto                      sea_state = 0 off, 1 right, 2 left, 3 both\n"));
    const TemporaryFolder folder;
    std::ofstream(folder.file("bad.toml"))
        << "[panel]\nkind = \"switch\"\n[[switch]]\ninput = \"nav\"\nsignal = \"freze\"\n"
           "[[lamp]]\nlamp = \"nose\"\nshows = \"overrun\"\n";
    const Outcome bad = run("panel map " + folder.file("bad.toml"));
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.errors,
                HasSubstr("bad.toml:5:10: error: signal \"freze\" is unknown; did you mean \"freeze\"?"));
    EXPECT_THAT(bad.errors, HasSubstr("bad.toml:7:8: error: the switch panel's lamp \"nose\" is unknown"));
    EXPECT_EQ(run("panel").exit_code, 2);
    EXPECT_EQ(run("panel map").exit_code, 2);
    EXPECT_THAT(
        run("fly " LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml --headless --panel")
            .errors,
        HasSubstr("--panel needs a window"));
}

TEST(PanelCommandLine, AListThereIsOrAReasonWhyNot) {
    const Outcome list = run("panel list");
    if (const std::string why = panel::no_panels_because(); why.empty()) {
        EXPECT_TRUE(list.exit_code == 0 || list.errors.find("USB cannot be reached") != std::string::npos);
    } else {
        EXPECT_EQ(list.exit_code, 3);
        EXPECT_EQ(list.errors, "linkdig: error: " + why + "\n");
    }
}

TEST(LampTestFaces, EveryLampAloneAndEveryDigit) {
    for (std::size_t i = 0; i < panel::panel_kinds; ++i) {
        const panel::PanelLayout& layout = panel::layout_of(static_cast<panel::PanelKind>(i));
        std::set<std::string> reports;
        const auto faces = lamp_test_faces(layout);
        for (const panel::PanelFace& face : faces) {
            const std::vector<std::uint8_t> bytes = panel::feature_report(layout, face);
            reports.emplace(bytes.begin(), bytes.end());
        }
        EXPECT_GE(reports.size(), layout.lamps.size() + (layout.displays.empty() ? 2 : 12)) << layout.name;
        EXPECT_EQ(panel::feature_report(layout, faces.back()),
                  std::vector<std::uint8_t>(layout.dark.begin(), layout.dark.end()));
    }
}

} // namespace
} // namespace linkdig::tools
