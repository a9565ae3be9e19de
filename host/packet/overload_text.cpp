#include "host/packet/frame_report.h"

#include <fmt/format.h>

namespace linkdig {

std::vector<std::string> overload_text(const Overload& overload) {
    std::vector<std::string> lines;
    if (overload.edges_over != 0)
        lines.push_back(fmt::format("{} edges beyond the limit; the frame is complete", overload.edges_over));
    if (overload.crossings_over != 0)
        lines.push_back(
            fmt::format("{} crossings beyond the limit on the busiest line; the frame is complete",
                        overload.crossings_over));
    if (overload.lights_over != 0)
        lines.push_back(
            fmt::format("{} light points beyond the limit; the frame is complete", overload.lights_over));
    if (overload.range_factor < 1.0)
        lines.push_back(fmt::format("levels of detail end at {:.2f} of their range: {} show less",
                                    overload.range_factor, overload.coarser_details));
    if (overload.least_size_px > 0.0)
        lines.push_back(fmt::format("objects under {:.0f} px left out: {}", overload.least_size_px,
                                    overload.objects_left_out));
    if (overload.light_step > 0)
        lines.push_back(fmt::format("light points: one of {} is there: {} left out",
                                    1U << overload.light_step, overload.lights_left_out));
    return lines;
}

} // namespace linkdig
