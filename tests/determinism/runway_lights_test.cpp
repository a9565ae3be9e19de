// A night of light points from its authoring text to its pixels.

#include "database/compiler/compile.h"
#include "database/format/name_directory.h"
#include "host/loop/host_loop.h"
#include "host/scenario/scenario.h"
#include "tests/determinism/picture_table.h"

#include <gtest/gtest.h>

namespace linkdig::determinism {

TEST(RunwayLights, KeepTheirBytes) {
    const host::ScenarioResult loaded =
        host::load_scenario(LINKDIG_SOURCE_DIR "/database/scenes/runway_lights/night_approach.toml");
    ASSERT_TRUE(loaded.scenario) << loaded.diagnostics.text();
    const database::CompileResult compiled = database::compile_file(loaded.scenario->database_path);
    ASSERT_TRUE(compiled.database) << compiled.diagnostics.text();
    host::HostLoop loop(*loaded.scenario, database::name_directory(*compiled.database, 0), 30.0);
    for (const ig::Scan scan : {ig::Scan::horizontal, ig::Scan::vertical}) {
        std::vector<NamedPacket> packets;
        for (const std::uint64_t frame : {0ULL, 500ULL, 800ULL})
            packets.push_back({std::string("runway_lights/") +
                                   (scan == ig::Scan::vertical ? "vertical/" : "horizontal/") +
                                   std::to_string(frame),
                               loop.packet(frame, {})});
        expect_pictures(*compiled.database, packets, {320, 240, scan}, true);
    }
}

} // namespace linkdig::determinism
