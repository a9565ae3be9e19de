// The binary as a person runs it, with panels that umockdev makes up.

#include "host/loop/host_values.h"
#include "host/packet/recording.h"
#include "tests/panel/bus_test.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#ifdef LINKDIG_BINARY

namespace linkdig::panel {
namespace {

using host::Signal;
using testing::HasSubstr;

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A running linkdig, with what it says in two files.
class Running {
public:
    Running(const std::string& folder, const std::string& arguments)
        : output_(folder + "/output"), errors_(folder + "/errors") {
        const std::string command =
            fmt::format("exec '" LINKDIG_BINARY "' {} >{} 2>{}", arguments, output_, errors_);
        process_ = fork();
        if (process_ != 0) return;
        setenv("SDL_VIDEODRIVER", "dummy", 1);
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    ~Running() {
        if (process_ > 0) kill(process_, SIGKILL), waitpid(process_, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    std::string output() const { return text_of(output_); }
    std::string errors() const { return text_of(errors_); }
    void interrupt() const { kill(process_, SIGTERM); }
    int exit_code() {
        int status = 0;
        EXPECT_TRUE(until([&] { return waitpid(process_, &status, WNOHANG) == process_; }))
            << "it goes on for ever";
        process_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    std::string output_, errors_;
    pid_t process_ = -1;
};

class PanelCommand : public testing::Test {
protected:
    PanelCommand() {
        std::string name = (std::filesystem::temp_directory_path() / "linkdig_panel_XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~PanelCommand() override { std::filesystem::remove_all(folder_); }
    MockBus bus_;
    std::string folder_;
};

constexpr std::uint32_t at_rest = 0x082000;

TEST_F(PanelCommand, ListNamesThemByPort) {
    {
        Running none(folder_, "panel list");
        EXPECT_EQ(none.exit_code(), 0);
        EXPECT_EQ(none.output(), "no panel is plugged in\n");
    }
    MockPanel radio(bus_, {.kind = PanelKind::radio, .device = 7, .port = "2"});
    MockPanel wrong(
        bus_,
        {.device = 8, .port = "1", .configuration = "09021200010100803209040000000300000009211101000122"});
    Running list(folder_, "panel list --json");
    EXPECT_EQ(list.exit_code(), 0) << list.errors();
    const auto found = nlohmann::json::parse(list.output());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0]["port"], "1-1");
    EXPECT_EQ(found[0]["ready"], false);
    EXPECT_THAT(found[0]["trouble"].get<std::string>(), HasSubstr("no interrupt endpoint"));
    EXPECT_EQ(found[1]["panel"], "radio");
    EXPECT_EQ(found[1]["product"], "0d05");
    EXPECT_EQ(found[1]["ready"], true);
}

TEST_F(PanelCommand, MonitorPrintsWhatIsDone) {
    MockPanel panel(bus_, {.kind = PanelKind::multi});
    panel.stand(0x01);
    Running monitor(folder_, "panel monitor");
    ASSERT_TRUE(
        until([&] { return monitor.output().find("selector alt  (so it stands)") != std::string::npos; }));
    panel.send(0x21);
    panel.send(0x01);
    panel.send(0x81);
    ASSERT_TRUE(until([&] { return monitor.output().find("ap on\n") != std::string::npos; }));
    EXPECT_THAT(monitor.output(), HasSubstr("1-4      multi   encoder up\n"));
    panel.unplug();
    ASSERT_TRUE(until([&] { return monitor.output().find("gone") != std::string::npos; }));
    monitor.interrupt();
    EXPECT_EQ(monitor.exit_code(), 0);
}

TEST_F(PanelCommand, TestLightsEveryLampAndDigit) {
    MockPanel switches(bus_, {});
    MockPanel multi(bus_, {.kind = PanelKind::multi, .device = 5, .port = "2"});
    MockPanel radio(bus_, {.kind = PanelKind::radio, .device = 6, .port = "3"});
    Running test(folder_, "panel test --step 0.25");
    EXPECT_EQ(test.exit_code(), 0) << test.errors();
    EXPECT_EQ(test.output(), "3 panels: every lamp and digit was lit\n");
    std::set<std::uint8_t> lamps;
    for (const auto& each : switches.all_features())
        lamps.insert(each[0]);
    EXPECT_EQ(lamps, (std::set<std::uint8_t>{0x00, 0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x3f}));
    std::set<std::uint8_t> multi_lamps;
    for (const auto& each : multi.all_features())
        multi_lamps.insert(each[10]);
    EXPECT_EQ(multi_lamps,
              (std::set<std::uint8_t>{0x00, 0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0xff}));
    for (std::size_t at = 0; at < 20; ++at) {
        std::set<std::uint8_t> digits;
        for (const auto& each : radio.all_features())
            digits.insert(each[at]);
        for (std::uint8_t digit = 0; digit <= 9; ++digit)
            EXPECT_TRUE(digits.contains(digit)) << at;
        EXPECT_TRUE(digits.contains(0xe0)) << "dash";
        EXPECT_TRUE(digits.contains(static_cast<std::uint8_t>(0xd1 + at % 5))) << "digit with dot";
    }
    EXPECT_EQ(multi.feature()[0], 0x0f) << "left dark";
}

TEST_F(PanelCommand, TestWithoutAPanelSaysSo) {
    Running test(folder_, "panel test");
    EXPECT_EQ(test.exit_code(), 3);
    EXPECT_THAT(test.errors(), HasSubstr("no panel to test"));
}

/// A flight with a panel that is unplugged and comes back; then what it recorded, with no panel at all.
TEST_F(PanelCommand, AFlightWithAPanelIsReplayedWithoutIt) {
    const std::string recording = folder_ + "/flight.rec";
    {
        MockPanel panel(bus_, {});
        panel.stand(at_rest);
        Running flight(folder_, fmt::format("fly {} --size 64x48 --panel --record {}",
                                            LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml",
                                            recording));
        ASSERT_TRUE(until([&] { return panel.features() >= 1; })) << flight.errors();
        panel.send(at_rest | 0x1000); // landing light: twice the pitch
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        panel.send(at_rest | 0x1400); // strobe: haze
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        panel.unplug();
        ASSERT_TRUE(until([&] { return flight.errors().find("has gone") != std::string::npos; }));
        panel.stand(at_rest);
        panel.plug();
        ASSERT_TRUE(until([&] { return flight.errors().find("connected again") != std::string::npos; }));
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        flight.interrupt();
        EXPECT_EQ(flight.exit_code(), 0) << flight.errors();
        EXPECT_THAT(flight.output(), HasSubstr(recording)) << flight.errors();
        EXPECT_THAT(flight.errors(), testing::EndsWith("connected again\n")) << "its end is no unplugging";
    }
    RecordingReader reader(recording);
    FramePacket packet;
    std::vector<std::pair<double, double>> stands; ///< pitch_amplitude, visibility; each once in a row
    while (reader.next(packet)) {
        const host::SignalValues signals = host::signals_of(packet);
        const std::pair now{signals[Signal::pitch_amplitude], signals[Signal::visibility]};
        if (stands.empty() || stands.back() != now) stands.push_back(now);
        EXPECT_EQ(packet.visibility_m, now.second == 1.0 ? 0.0F : 5000.0F);
    }
    EXPECT_THAT(stands, testing::ElementsAre(std::pair(1.0, 1.0), std::pair(2.0, 1.0), std::pair(2.0, 0.1),
                                             std::pair(1.0, 1.0)));
    std::string first;
    for (const char* threads : {"1", "2"}) {
        Running replay(folder_,
                       fmt::format("replay {} --size 64x48 --hashes --threads {}", recording, threads));
        EXPECT_EQ(replay.exit_code(), 0) << replay.errors();
        if (first.empty()) first = replay.output();
        EXPECT_EQ(replay.output(), first);
    }
    EXPECT_THAT(first, testing::Not(testing::IsEmpty()));
}

} // namespace
} // namespace linkdig::panel

#endif
