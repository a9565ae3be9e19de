#include "tools/bench/sea_methods.h"

#include "tools/bench/measure.h"
#include "tools/flight/flight.h"
#include "tools/flight/shipped_scenes.h"

#include <algorithm>
#include <cstdlib>

namespace linkdig::bench {

namespace {

int greatest_difference(const ig::VideoFrame& a, const ig::VideoFrame& b) {
    int greatest = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        for (std::uint32_t shift = 0; shift < 24; shift += 8) {
            const auto x = static_cast<int>(a.pixels[k] >> shift & 255U);
            const auto y = static_cast<int>(b.pixels[k] >> shift & 255U);
            greatest = std::max(greatest, std::abs(x - y));
        }
    }
    return greatest;
}

} // namespace

SeaMethodCosts compare_sea_methods(std::uint32_t size, std::uint32_t frames) {
    tools::FlightRequest request;
    request.scenario_path = tools::shipped_scenes() + "/report/methods.toml";
    request.configuration = ig::modern_profile();
    request.configuration.raster.width = request.configuration.raster.height = size;
    request.configuration.threads = 1;
    tools::Flight sun(request), normals(request);
    host::SignalValues by_normals;
    by_normals.set(host::Signal::sea_method, 1.0);
    std::vector<double> sun_host_ms, sun_machine_ms, normals_host_ms, normals_machine_ms;
    SeaMethodCosts costs;
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        sun.draw(frame, {});
        normals.draw(frame, by_normals);
        sun_host_ms.push_back(1e3 * sun.costs().last_host_s);
        sun_machine_ms.push_back(1e3 * sun.costs().last_machine_s);
        normals_host_ms.push_back(1e3 * normals.costs().last_host_s);
        normals_machine_ms.push_back(1e3 * normals.costs().last_machine_s);
        costs.greatest_difference =
            std::max(costs.greatest_difference,
                     greatest_difference(sun.machine().picture(0), normals.machine().picture(0)));
    }
    for (const VertexNormalUpdate& update : normals.packet().normal_updates)
        costs.normals += update.normals.size();
    costs.sun_host_ms = median(sun_host_ms);
    costs.sun_machine_ms = median(sun_machine_ms);
    costs.normals_host_ms = median(normals_host_ms);
    costs.normals_machine_ms = median(normals_machine_ms);
    return costs;
}

} // namespace linkdig::bench
