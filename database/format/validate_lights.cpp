// Light points: every number finite and inside what the machine's fixed point holds.

#include "database/format/validate.h"
#include "database/format/validate_parts.h"

namespace linkdig::database {

namespace {

bool is_unit(const Vec3f& v) { return within(length_of(v), 1.0 - unit_tolerance, 1.0 + unit_tolerance); }

std::string check_numbers(const LightPoint& light) {
    if (!all_within(light.position, -max_coordinate_m, max_coordinate_m))
        return "position is not finite, or beyond 1e7 m";
    if (light.beam > LightBeam::two_way) return "beam is none of all_round, one_way, two_way";
    if (light.fall_off > FallOff::square) return "fall_off is none of flat, linear, square";
    if (!is_unit(light.direction)) return "direction is not a unit vector";
    if (!is_unit(light.side)) return "side is not a unit vector";
    if (!within(light.across, 0.0, max_beam_steepness) || !within(light.upward, 0.0, max_beam_steepness))
        return fmt::format("across or upward is not in 0 to {}", max_beam_steepness);
    if (!within(light.intensity, 0.0, max_light_intensity))
        return fmt::format("intensity is not in 0 to {}", max_light_intensity);
    if (!within(light.size_m, 0.0, max_coordinate_m))
        return "size_m is negative, not finite, or beyond 1e7 m";
    if (!within(light.full_to_m, 0.0, max_coordinate_m))
        return "full_to_m is negative, not finite, or beyond 1e7 m";
    if (!within(light.flash_hz, 0.0, max_flash_hz))
        return fmt::format("flash_hz is not in 0 to {}", max_flash_hz);
    if (!within(light.duty, 0.0, 1.0) || !within(light.phase, 0.0, 1.0))
        return "duty or phase is not in 0 to 1";
    return {};
}

std::string check_indices(const VisualDatabase& database, std::size_t i) {
    const LightPoint& light = database.lights[i];
    for (const std::uint16_t colour : {light.colour, light.back_colour})
        if (colour >= database.colours.size())
            return out_of_range("lights", i, "colour", colour, database.colours.size(), "colours");
    if (light.object >= database.objects.size())
        return out_of_range("lights", i, "object", light.object, database.objects.size(), "objects");
    const bool generated = database.source_files.empty() && light.file == 0 && light.line == 0;
    if (!generated && light.file >= database.source_files.size())
        return out_of_range("lights", i, "file", light.file, database.source_files.size(), "source_files");
    return {};
}

} // namespace

std::string check_lights(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.lights.size(); ++i) {
        if (const std::string reason = check_numbers(database.lights[i]); !reason.empty())
            return wrong("lights", i, reason);
        if (std::string reason = check_indices(database, i); !reason.empty()) return reason;
    }
    return {};
}

} // namespace linkdig::database
