#include "ig/geometry/project_lights.h"

#include "database/model/mathematics.h"

#include <algorithm>
#include <cmath>

namespace linkdig::ig {

namespace {

/// -log of the contrast that is left at the visibility's range (ig/video/fog.h).
constexpr double extinction_of_lights = 2.996;
/// Bound of ProjectedLight::total: brighter ones are all the same.
constexpr double greatest_total = 1U << 24U;

} // namespace

bool is_lit(const LightPoint& light, double time_s) {
    if (light.flash_hz <= 0.0F) return true;
    const double periods = time_s * static_cast<double>(light.flash_hz) + static_cast<double>(light.phase);
    return periods - std::floor(periods) < static_cast<double>(light.duty);
}

double beam_part(const LightPoint& light, const Vec3d& to_eye, bool& back) {
    back = false;
    if (light.beam == LightBeam::all_round) return 1.0;
    const Vec3d direction(light.direction);
    const Vec3d side(light.side);
    double ahead = glm::dot(to_eye, direction);
    back = light.beam == LightBeam::two_way && ahead < 0.0;
    if (back) ahead = -ahead;
    if (ahead <= 0.0) return 0.0;
    const double a = glm::dot(to_eye, side) / ahead;
    const double b = glm::dot(to_eye, glm::cross(direction, side)) / ahead;
    const double q = a * a * static_cast<double>(light.across) + b * b * static_cast<double>(light.upward);
    return std::max(0.0, 1.0 - 0.5 * q);
}

double fall_off_at(const LightPoint& light, double range_m) {
    const double full_to_m = static_cast<double>(light.full_to_m);
    if (light.fall_off == FallOff::flat || range_m <= full_to_m) return 1.0;
    const double part = full_to_m / range_m;
    return light.fall_off == FallOff::linear ? part : part * part;
}

LightProjector::LightProjector(const ActiveDatabase& active, const View& view, const Raster& raster,
                               ProjectedFaces& projected)
    : active_(active), view_(view), out_(projected), last_line_(256.0 * raster.lines()),
      last_element_(256.0 * raster.elements()),
      pixels_at_one_m_(std::max(std::fabs(view.scale.x_scale), std::fabs(view.scale.y_scale))) {}

void LightProjector::enter(const Mat3d& channel_from_list, const Vec3d& origin_m, bool at_eye) {
    channel_from_list_ = channel_from_list;
    origin_ = origin_m;
    at_eye_ = at_eye;
}

/// A light that would be back one step before is looked at as well: the next frame's step follows from how many are.
void LightProjector::put(std::span<const LightPoint> lights, std::uint32_t index, std::uint32_t fade) {
    const std::uint32_t last_step = last_step_of_light(index);
    const bool there = last_step >= active_.light_step;
    out_.lights_left_out += there ? 0 : 1;
    if (last_step + 1 < active_.light_step) return;
    ProjectedLight projected;
    if (!project(lights[index], fade, projected)) return;
    for (std::uint32_t step = 0; step <= last_step; ++step)
        ++out_.lights_at_step[step];
    if (there) out_.lights.push_back(projected);
}

/// False: nothing of it reaches the picture.
bool LightProjector::project(const LightPoint& light, std::uint32_t fade, ProjectedLight& projected) const {
    if (!is_lit(light, active_.time_s)) return false;
    const Vec3d p = channel_from_list_ * Vec3d(light.position) + origin_;
    if (p.z < near_plane_m) return false;
    const double size = pixels_at_one_m_ * static_cast<double>(light.size_m) / p.z; // 1/256 pixel
    const auto radius = static_cast<std::int32_t>(std::clamp(size, static_cast<double>(least_splat_radius),
                                                             static_cast<double>(greatest_splat_radius)));
    const double column = view_.scale.x_scale * (p.x / p.z) + view_.scale.x_offset;
    const double row = view_.scale.y_scale * (p.y / p.z) + view_.scale.y_offset;
    const double line = std::floor((view_.vertical ? column : row) + 0.5);
    const double element = std::floor((view_.vertical ? row : column) + 0.5);
    const double reach = radius;
    if (!(line > -reach && line < last_line_ + reach && element > -reach && element < last_element_ + reach))
        return false;
    bool back = false;
    const double beam = beam_part(light, glm::transpose(channel_from_list_) * -p, back) * fade / 256.0;
    const double light_of_splat = std::floor(total(light, beam, glm::length(p), radius) + 0.5);
    if (light_of_splat < 1.0) return false;
    projected = {.at = {static_cast<std::int32_t>(line), static_cast<std::int32_t>(element)},
                 .radius = radius,
                 .total = static_cast<std::uint32_t>(light_of_splat),
                 .rank = static_cast<std::uint32_t>(out_.faces.size()),
                 .colour = back ? light.back_colour : light.colour};
    return true;
}

double LightProjector::total(const LightPoint& light, double beam, double range_m,
                             std::int32_t radius) const {
    if (beam <= 0.0) return 0.0;
    const double growth = static_cast<double>(radius) / least_splat_radius;
    double part = beam * fall_off_at(light, range_m) * growth * growth;
    if (active_.visibility_m > 0.0 && !at_eye_)
        part *= exponential(-extinction_of_lights * range_m / active_.visibility_m);
    const double intensity = static_cast<double>(light.intensity) * static_cast<double>(active_.light_points);
    return std::min(256.0 * intensity * part, greatest_total);
}

} // namespace linkdig::ig
