// The shipped flight from its authoring text to its pixels: compiler, host loop and machine.

#include "database/compiler/compile.h"
#include "database/format/name_directory.h"
#include "database/format/write.h"
#include "host/loop/host_loop.h"
#include "host/scenario/scenario.h"
#include "tests/determinism/hashes.h"
#include "tests/determinism/picture_table.h"

#include <gtest/gtest.h>

namespace linkdig::determinism {

namespace {

constexpr double update_rate_hz = 30.0;

struct Flight {
    host::Scenario scenario;
    VisualDatabase database;
    std::uint64_t id = 0;
};

/// Compiled once for all tests of this file.
const Flight& flight() {
    static const Flight shipped = [] {
        host::ScenarioResult loaded =
            host::load_scenario(LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml");
        if (!loaded.scenario) throw std::runtime_error(loaded.diagnostics.text());
        database::CompileResult compiled = database::compile_file(loaded.scenario->database_path);
        if (!compiled.database) throw std::runtime_error(compiled.diagnostics.text());
        const std::uint64_t id = database::database_id(*compiled.database);
        return Flight{std::move(*loaded.scenario), std::move(*compiled.database), id};
    }();
    return shipped;
}

void expect_frames(const std::string& name, const ig::Raster& raster, std::vector<std::uint64_t> frames,
                   bool edge_smoothing = false, float visibility_m = 0.0F) {
    const double aspect = static_cast<double>(raster.width) / raster.height;
    host::HostLoop loop(flight().scenario, database::name_directory(flight().database, flight().id),
                        update_rate_hz, aspect);
    std::vector<NamedPacket> packets;
    for (const std::uint64_t frame : frames) {
        packets.push_back({"first_flight/" + name + "/" + std::to_string(frame), loop.packet(frame, {})});
        packets.back().packet.visibility_m = visibility_m;
    }
    expect_pictures(flight().database, packets, raster, edge_smoothing);
}

} // namespace

TEST(FirstFlight, CompiledDatabaseKeepsItsBytes) { expect_hash("first_flight/database", flight().id); }

TEST(FirstFlight, HorizontalScanKeepsItsBytes) {
    expect_frames("horizontal", {640, 480, ig::Scan::horizontal}, {0, 200, 400, 599});
}

TEST(FirstFlight, VerticalScanKeepsItsBytes) {
    expect_frames("vertical", {384, 288, ig::Scan::vertical}, {0, 599});
}

TEST(FirstFlight, SmoothedEdgesKeepTheirBytes) {
    expect_frames("smoothed", {320, 240, ig::Scan::horizontal}, {200, 599}, true);
    expect_frames("smoothed_vertical", {320, 240, ig::Scan::vertical}, {599}, true);
}

TEST(FirstFlight, HazeKeepsItsBytes) {
    expect_frames("haze", {320, 240, ig::Scan::horizontal}, {200, 599}, false, 900.0F);
    expect_frames("smoothed_haze", {320, 240, ig::Scan::vertical}, {400}, true, 900.0F);
}

} // namespace linkdig::determinism
