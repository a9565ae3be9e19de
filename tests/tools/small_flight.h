#pragma once
/// The shipped approach with a picture so small that a test can draw many.

#include "tools/flight/flight.h"

#include <cstdint>

namespace linkdig::tools {

inline FlightRequest small_flight(std::uint32_t width, std::uint32_t height, double update_rate_hz) {
    FlightRequest request;
    request.scenario_path = LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml";
    request.configuration = ig::modern_profile();
    request.configuration.raster.width = width;
    request.configuration.raster.height = height;
    request.configuration.update_rate_hz = update_rate_hz;
    return request;
}

} // namespace linkdig::tools
