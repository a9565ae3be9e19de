#pragma once
/// The two ways of moving the sea that the report compares (3.1.4): the host turns every vertex normal, or the one sun vector.

#include <cstdint>

namespace linkdig::bench {

/// Medians over the frames, one thread.
struct SeaMethodCosts {
    double sun_host_ms = 0.0;
    double sun_machine_ms = 0.0;
    double normals_host_ms = 0.0;
    double normals_machine_ms = 0.0;
    std::uint64_t normals = 0;   ///< sent with each frame
    int greatest_difference = 0; ///< of any component of any pixel of the two pictures, levels
};

/// Flies the shipped scenario of the report's methods with each, frame by frame in turn.
SeaMethodCosts compare_sea_methods(std::uint32_t size, std::uint32_t frames);

} // namespace linkdig::bench
