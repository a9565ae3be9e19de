// Once it has seen its largest frame, the machine asks for no memory.

#include "ig/machine/machine.h"
#include "tests/ig/shipped_flight.h"
#include "tests/support/allocation_count.h"

#include <gtest/gtest.h>

#include <vector>

namespace linkdig::ig {
namespace {

/// Every 20th frame of the shipped flight, from the hover over the deck to the far sea.
ShippedFlight first_flight(float visibility_m) {
    std::vector<std::uint64_t> frames;
    for (std::uint64_t frame = 0; frame < 600; frame += 20)
        frames.push_back(frame);
    ShippedFlight flight = shipped_flight("first_flight/approach.toml", 30.0, frames);
    for (FramePacket& packet : flight.packets)
        packet.visibility_m = visibility_m;
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
        const ShippedFlight flight = first_flight(visibility_m);
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
    const ShippedFlight wakes = wake_flight(40.0, 12 * 15, 15.0);
    for (const bool smoothing : {false, true})
        EXPECT_EQ(
            allocations_of(
                wakes, {.raster = {160, 120, Scan::horizontal}, .edge_smoothing = smoothing, .threads = 1}),
            0U)
            << "smoothing " << smoothing;
}

} // namespace
} // namespace linkdig::ig
