// A golden is a directory of tests/golden:
//
//   golden.toml     database, raster, and in one line why it is there
//   packets.jsonl   a frame packet per line
//   frame_<n>.png   the expected picture of packet <n>'s first channel
//
// LINKDIG_UPDATE_GOLDENS=1 rewrites the pictures that differ; look at them before they are committed.

#include "database/text/table_reader.h"
#include "host/packet/packet_json.h"
#include "ig/machine/machine.h"
#include "ig/sink/image_file.h"
#include "tests/support/picture_comparison.h"
#include "tools/flight/open_database.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace linkdig {
namespace {

namespace fs = std::filesystem;

struct Golden {
    fs::path folder;
    std::string database;
    std::string why;
    ig::Configuration configuration;
};

Golden read_golden(const fs::path& folder) {
    Golden golden;
    golden.folder = folder;
    database::Diagnostics diagnostics;
    const std::string path = (folder / "golden.toml").string();
    if (const auto document = database::parse_file(path, diagnostics)) {
        database::TableReader reader(document->root, path, "golden", diagnostics);
        golden.database = (folder / reader.text("database")).string();
        golden.why = reader.text("why");
        golden.configuration.raster.width = static_cast<std::uint32_t>(reader.integer("width", 1, 4096));
        golden.configuration.raster.height = static_cast<std::uint32_t>(reader.integer("height", 1, 4096));
        golden.configuration.raster.scan = reader.choice("scan", 0, {"horizontal", "vertical"}) == 0
                                               ? ig::Scan::horizontal
                                               : ig::Scan::vertical;
        golden.configuration.edge_smoothing = reader.boolean("smoothing", false);
        golden.configuration.threads = 1;
        reader.finish();
    }
    EXPECT_FALSE(diagnostics.any()) << diagnostics.text();
    return golden;
}

/// An 8-bit RGB file as a picture; empty if it cannot be read.
ig::VideoFrame read_picture(const fs::path& path) {
    ig::VideoFrame picture;
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input || input->spec().nchannels != 3) return picture;
    picture.width = static_cast<std::uint32_t>(input->spec().width);
    picture.height = static_cast<std::uint32_t>(input->spec().height);
    std::vector<std::uint8_t> bytes(std::size_t{picture.width} * picture.height * 3);
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, bytes.data())) return {};
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        picture.pixels.push_back(0xff000000U | static_cast<std::uint32_t>(bytes[k + 2]) << 16U |
                                 static_cast<std::uint32_t>(bytes[k + 1]) << 8U | bytes[k]);
    }
    return picture;
}

void check_golden(const Golden& golden) {
    const tools::OpenedDatabase opened = tools::open_database(golden.database);
    ig::Machine machine(opened.database, golden.configuration);
    std::ifstream packets(golden.folder / "packets.jsonl");
    std::string line;
    int frames = 0;
    for (; std::getline(packets, line); ++frames) {
        const PacketResult packet = from_json(line);
        ASSERT_TRUE(packet.packet) << golden.folder << " packet " << frames << ": " << packet.error;
        const FrameReport& report = machine.frame(*packet.packet);
        ASSERT_TRUE(report.errors.empty()) << report.errors.front();
        const fs::path expected = golden.folder / fmt::format("frame_{}.png", packet.packet->frame);
        const ig::VideoFrame reference = read_picture(expected);
        const support::PictureDifference difference = support::compare(reference, machine.picture(0));
        const bool same = !reference.pixels.empty() && difference.pixels == 0;
        if (!same && std::getenv("LINKDIG_UPDATE_GOLDENS") != nullptr) {
            ig::write_png(expected.string(), machine.picture(0));
            continue;
        }
        EXPECT_FALSE(reference.pixels.empty()) << expected << " cannot be read";
        EXPECT_EQ(difference.pixels, 0U) << expected << " (" << golden.why << ")\n" << difference.explanation;
    }
    EXPECT_GT(frames, 0) << golden.folder << " has no packets";
}

TEST(Golden, EveryDirectoryShowsWhatItShowed) {
    int directories = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(LINKDIG_SOURCE_DIR) / "tests/golden")) {
        if (!entry.is_directory()) continue;
        SCOPED_TRACE(entry.path().filename().string());
        const Golden golden = read_golden(entry.path());
        EXPECT_FALSE(golden.why.empty());
        check_golden(golden);
        ++directories;
    }
    EXPECT_GE(directories, 1);
}

// A golden that cannot fail is none: one pixel off by one level must be told.
TEST(Golden, OnePixelOffByOneLevelIsADifference) {
    const fs::path path = fs::path(LINKDIG_SOURCE_DIR) / "tests/golden/approach/frame_300.png";
    const ig::VideoFrame expected = read_picture(path);
    ASSERT_FALSE(expected.pixels.empty());
    ig::VideoFrame actual = expected;
    actual.pixels[actual.pixels.size() / 2] ^= 1U;
    const support::PictureDifference difference = support::compare(expected, actual);
    EXPECT_EQ(difference.pixels, 1U);
    EXPECT_EQ(difference.worst_level, 1U);
    EXPECT_FALSE(difference.explanation.empty());
}

} // namespace
} // namespace linkdig
