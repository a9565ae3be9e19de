#include "tests/ig/shipped_flight.h"

#include "database/compiler/compile.h"
#include "database/format/name_directory.h"
#include "host/loop/host_loop.h"
#include "host/scenario/scenario.h"

#include <gtest/gtest.h>

#include <numeric>

namespace linkdig::ig {

ShippedFlight shipped_flight(const std::string& scenario, double rate_hz,
                             const std::vector<std::uint64_t>& frames) {
    const host::ScenarioResult loaded =
        host::load_scenario(LINKDIG_SOURCE_DIR "/database/scenes/" + scenario);
    EXPECT_TRUE(loaded.scenario) << loaded.diagnostics.text();
    if (!loaded.scenario) return {};
    const database::CompileResult compiled = database::compile_file(loaded.scenario->database_path);
    EXPECT_TRUE(compiled.database) << compiled.diagnostics.text();
    if (!compiled.database) return {};
    ShippedFlight flight{*compiled.database, {}};
    host::HostLoop loop(*loaded.scenario, database::name_directory(flight.database, 0), rate_hz);
    for (const std::uint64_t frame : frames)
        flight.packets.push_back(loop.packet(frame, {}));
    return flight;
}

ShippedFlight wake_flight(double from_s, std::size_t count, double rate_hz) {
    std::vector<std::uint64_t> frames(count);
    std::iota(frames.begin(), frames.end(), static_cast<std::uint64_t>(from_s * rate_hz));
    return shipped_flight("two_ships/figure_of_eight.toml", rate_hz, frames);
}

} // namespace linkdig::ig
