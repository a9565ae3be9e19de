/// HostLoop's first half: what a scenario's sections become before the first frame.

#include "host/loop/host_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace linkdig::host {

namespace {

Seaway seaway_of(const MotionSection& section) {
    return {.significant_height_m = section.significant_height_m,
            .modal_period_s = section.period_s,
            .travel_heading_rad = section.travel_heading_rad,
            .seed = section.seed,
            .components = section.components};
}

ShipResponse response_of(const MotionSection& section) {
    ShipResponse response = large_ship_response();
    response.length_m = section.length_m;
    for (std::size_t axis = 0; axis < ship_axes; ++axis) {
        response.axes[axis].gain = section.axes[axis].gain;
        response.axes[axis].limit = section.axes[axis].limit;
    }
    response[ShipAxis::heave].natural_period_s = section.heave_period_s;
    response[ShipAxis::roll].natural_period_s = section.roll_period_s;
    response[ShipAxis::pitch].natural_period_s = section.pitch_period_s;
    return response;
}

void refuse_unless_positive(const char* what, double value) {
    if (!(value > 0.0) || !std::isfinite(value))
        throw std::invalid_argument(
            fmt::format("the {} is {}; expected a finite number above 0", what, value));
}

Binding bound(const Scenario& scenario, const NameDirectory& directory) {
    database::Diagnostics diagnostics;
    Binding binding = bind(scenario, directory, diagnostics);
    if (diagnostics.any()) throw std::invalid_argument(diagnostics.text());
    return binding;
}

} // namespace

HostLoop::HostLoop(const Scenario& scenario, const NameDirectory& directory, double update_rate_hz,
                   double picture_aspect)
    : update_rate_hz_(update_rate_hz) {
    refuse_unless_positive("update rate", update_rate_hz);
    refuse_unless_positive("picture's aspect", picture_aspect);
    const Binding binding = bound(scenario, directory);
    frames_ = static_cast<std::uint64_t>(std::max(1.0, std::round(scenario.duration_s * update_rate_hz)));
    place_suns(scenario, binding);
    place_ships(scenario, binding);
    start_sequences(scenario, binding);
    place_channels(scenario, picture_aspect);
    choose_approach(scenario);
    fill_constants(scenario);
    light_without_smoothing(directory, binding);
    remember_day(scenario, directory, binding);
    packet_.database_id = directory.database_id;
}

void HostLoop::place_suns(const Scenario& scenario, const Binding& binding) {
    packet_.suns.assign(binding.sun_count, Vec3f(0, 0, 1));
    for (std::size_t i = 0; i < scenario.suns.size(); ++i) {
        const SunSection& section = scenario.suns[i];
        const SunPosition initial{section.azimuth_rad, section.elevation_rad};
        packet_.suns[binding.suns[i]] = sun_vector(initial);
        if (!section.turning()) continue;
        turning_suns_.push_back({binding.suns[i],
                                 {.initial = initial,
                                  .azimuth_increment_rad = section.azimuth_rate_rad_s / update_rate_hz_,
                                  .elevation_increment_rad = section.elevation_rate_rad_s / update_rate_hz_,
                                  .least_elevation_rad = section.least_elevation_rad,
                                  .greatest_elevation_rad = section.greatest_elevation_rad}});
    }
}

void HostLoop::place_ships(const Scenario& scenario, const Binding& binding) {
    MovingObject unseen; // a moving object of the database that the scenario leaves out
    unseen.visible = false;
    packet_.moving_objects.assign(binding.moving_object_count, unseen);
    for (std::size_t i = 0; i < scenario.ships.size(); ++i) {
        const ShipSection& section = scenario.ships[i];
        const ShipTrack track{section.position_m, section.heading_rad, section.speed_mps};
        ShipMotion motion;
        if (section.motion)
            motion = ShipMotion(seaway_of(*section.motion), response_of(*section.motion), section.heading_rad,
                                section.speed_mps);
        ships_.push_back({binding.ships[i], track, std::move(motion)});
    }
}

void HostLoop::start_sequences(const Scenario& scenario, const Binding& binding) {
    for (std::size_t i = 0; i < scenario.sequences.size(); ++i) {
        const SequenceSection& section = scenario.sequences[i];
        pointers_.push_back({binding.slots[i], FaceSequence::of(binding.slot_alternatives[i], section.dwell_s,
                                                                section.phase, update_rate_hz_)});
        packet_.substitutions.push_back({.slot = binding.slots[i], .index = 0});
    }
}

void HostLoop::place_channels(const Scenario& scenario, double picture_aspect) {
    for (const ChannelSection& section : scenario.channels) {
        const double across = tangent(section.horizontal_field_rad / 2.0);
        const double up =
            section.vertical_field_rad ? tangent(*section.vertical_field_rad / 2.0) : across / picture_aspect;
        ChannelView& channel = packet_.channels.emplace_back();
        channel.left_tangent = -across;
        channel.right_tangent = across;
        channel.bottom_tangent = -up;
        channel.top_tangent = up;
        mounts_.push_back({.heading_rad = section.azimuth_rad, .pitch_rad = section.elevation_rad});
    }
}

void HostLoop::choose_approach(const Scenario& scenario) {
    const ApproachSection& section = approach_for(scenario);
    approach_ = {.control_m = section.path_m,
                 .first_aim_m = section.first_aim_m,
                 .last_aim_m = section.last_aim_m,
                 .duration_s = scenario.duration_s};
    const auto flown = [&](const ShipSection& ship) { return ship.moving_object.text == section.ship.text; };
    const auto ship = std::ranges::find_if(scenario.ships, flown);
    approached_ = static_cast<std::size_t>(ship - scenario.ships.begin());
}

void HostLoop::fill_constants(const Scenario& scenario) {
    packet_.seed = scenario.seed;
    packet_.sea = {.state = static_cast<float>(scenario.sea_state),
                   .current_east_mps = static_cast<float>(scenario.current_east_mps),
                   .current_north_mps = static_cast<float>(scenario.current_north_mps)};
    visibility_m_ = scenario.visibility_m;
}

/// A packet overrides a list's light as a whole, so the rest of it is taken from the database.
void HostLoop::light_without_smoothing(const NameDirectory& directory, const Binding& binding) {
    for (std::uint32_t list = 0; list < directory.lists.size(); ++list) {
        if (std::ranges::find(binding.sky_lists, list) != binding.sky_lists.end()) continue;
        const auto& modelled = directory.lists[list];
        without_smoothing_.push_back({.list = list,
                                      .sun = modelled.sun,
                                      .ambient = modelled.ambient,
                                      .diffuse = modelled.diffuse,
                                      .colour = none,
                                      .method = ShadingMethod::no_smooth});
    }
    packet_.lighting.reserve(without_smoothing_.size());
}

} // namespace linkdig::host
