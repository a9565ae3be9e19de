#include "tests/ig/wake_flight.h"

#include "database/compiler/compile.h"
#include "database/format/name_directory.h"
#include "host/loop/host_loop.h"
#include "host/scenario/scenario.h"

#include <gtest/gtest.h>

namespace linkdig::ig {

WakeFlight wake_flight(double from_s, std::size_t count, double rate_hz) {
    const host::ScenarioResult loaded =
        host::load_scenario(LINKDIG_SOURCE_DIR "/database/scenes/two_ships/figure_of_eight.toml");
    EXPECT_TRUE(loaded.scenario) << loaded.diagnostics.text();
    const database::CompileResult compiled = database::compile_file(loaded.scenario->database_path);
    EXPECT_TRUE(compiled.database) << compiled.diagnostics.text();
    WakeFlight flight{*compiled.database, {}};
    host::HostLoop loop(*loaded.scenario, database::name_directory(flight.database, 0), rate_hz);
    const auto first = static_cast<std::uint64_t>(from_s * rate_hz);
    for (std::uint64_t k = 0; k < count; ++k)
        flight.packets.push_back(loop.packet(first + k, {}));
    return flight;
}

} // namespace linkdig::ig
