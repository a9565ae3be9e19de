// Once it has seen its largest frame, the machine asks for no memory.

#include "database/compiler/compile.h"
#include "database/format/name_directory.h"
#include "host/loop/host_loop.h"
#include "host/scenario/scenario.h"
#include "ig/machine/machine.h"
#include "tests/ig/wake_flight.h"
#include "tests/support/allocation_count.h"

#include <gtest/gtest.h>

#include <vector>

namespace linkdig::ig {
namespace {

/// Every 20th frame of the shipped flight, from the hover over the deck to the far sea.
struct ShippedFlight {
    VisualDatabase database;
    std::vector<FramePacket> packets;
};

ShippedFlight shipped_flight(float visibility_m) {
    const host::ScenarioResult loaded =
        host::load_scenario(LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml");
    EXPECT_TRUE(loaded.scenario) << loaded.diagnostics.text();
    const database::CompileResult compiled = database::compile_file(loaded.scenario->database_path);
    EXPECT_TRUE(compiled.database) << compiled.diagnostics.text();
    ShippedFlight flight{*compiled.database, {}};
    host::HostLoop loop(*loaded.scenario, database::name_directory(flight.database, 0), 30.0);
    for (std::uint64_t frame = 0; frame < 600; frame += 20) {
        flight.packets.push_back(loop.packet(frame, {}));
        flight.packets.back().visibility_m = visibility_m;
    }
    return flight;
}

std::uint64_t allocations_of(const ShippedFlight& flight, const Configuration& configuration) {
    Machine machine(flight.database, configuration);
    for (int round = 0; round < 2; ++round)
        for (const FramePacket& packet : flight.packets)
            machine.frame(packet);
    const std::uint64_t before = allocations();
    for (const FramePacket& packet : flight.packets)
        machine.frame(packet);
    return allocations() - before;
}

TEST(Allocation, CountsWhatIsAllocated) {
    static std::vector<int> kept; // a compiler may leave out what nobody outside can see
    const std::uint64_t before = allocations();
    kept.reserve(1000);
    EXPECT_EQ(allocations() - before, 1U);
}

TEST(Allocation, NoneAfterWarmUp) {
    for (const float visibility_m : {0.0F, 3000.0F}) {
        const ShippedFlight flight = shipped_flight(visibility_m);
        for (const bool smoothing : {false, true}) {
            for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
                const Configuration configuration{
                    .raster = {320, 240, scan}, .edge_smoothing = smoothing, .threads = 1};
                EXPECT_EQ(allocations_of(flight, configuration), 0U)
                    << "visibility " << visibility_m << " m, smoothing " << smoothing << ", "
                    << (scan == Scan::vertical ? "vertical" : "horizontal") << " scan";
            }
        }
    }
}

TEST(Allocation, NoneAfterWarmUpWithWakesThatTheMachineMakes) {
    // Twelve seconds of the ships' turn; going back to their first packet, wakes begin anew and become what they were.
    const WakeFlight wakes = wake_flight(40.0, 12 * 15, 15.0);
    for (const bool smoothing : {false, true})
        EXPECT_EQ(allocations_of(
                      {wakes.database, wakes.packets},
                      {.raster = {160, 120, Scan::horizontal}, .edge_smoothing = smoothing, .threads = 1}),
                  0U)
            << "smoothing " << smoothing;
}

} // namespace
} // namespace linkdig::ig
