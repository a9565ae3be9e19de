/// HostLoop's first half: what a scenario's sections become before the first frame.

#include "host/loop/check_tracks.h"
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

MotionHistory history_of(const std::vector<HistoryRow>& rows) {
    MotionHistory history;
    for (const HistoryRow& row : rows) {
        history.time_s.push_back(row.time_s);
        history.values.push_back(row.values);
    }
    return history;
}

ShipMover mover_of(const ShipSection& section, const ShipTrack& track) {
    ShipMover mover;
    if (!section.motion) return mover;
    if (!section.motion->history.empty()) {
        mover.history = history_of(section.motion->history);
        return mover;
    }
    const Seaway seaway = seaway_of(*section.motion);
    const ShipResponse response = response_of(*section.motion);
    if (track.kind == ShipTrack::Kind::straight)
        mover.straight = ShipMotion(seaway, response, track.heading_rad, track.speed_mps);
    else
        mover.curved = CurvedMotion(seaway, response, track.speed_mps);
    return mover;
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
    check_ways(scenario, directory);
    start_sequences(scenario, binding);
    place_channels(scenario, picture_aspect);
    begin_own_ship(scenario);
    choose_sea(scenario, directory, binding);
    fill_constants(scenario);
    light_without_smoothing(directory, binding);
    remember_day(scenario, directory, binding);
    packet_.database_id = directory.database_id;
    packet_.host_values.reserve(signal_count + 16);
}

void HostLoop::place_suns(const Scenario& scenario, const Binding& binding) {
    packet_.suns.assign(binding.sun_count, Vec3f(0, 0, 1));
    for (std::size_t i = 0; i < scenario.suns.size(); ++i) {
        const SunSection& section = scenario.suns[i];
        const SunPosition initial{section.azimuth_rad, section.elevation_rad};
        packet_.suns[binding.suns[i]] = sun_vector(initial);
        if (!section.turning()) continue;
        auto& turning = section.sun.text == "churn" ? other_suns_ : sea_suns_;
        turning.push_back({binding.suns[i],
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
    std::size_t rows = scenario.sequences.size();
    for (std::size_t i = 0; i < scenario.ships.size(); ++i) {
        const ShipSection& section = scenario.ships[i];
        const ShipTrack track = track_of(scenario, section.moving_object.text);
        ships_.push_back({binding.ships[i], track, mover_of(section, track)});
        ship_names_.push_back(section.moving_object.text);
        methods_.emplace_back(section.methods, binding.ship_slots[i], section.moving_object.text,
                              update_rate_hz_);
        rows += methods_.back().most_rows();
    }
    packet_.substitutions.reserve(rows);
    packet_.priorities.reserve(ships_.size());
    packet_.wakes.reserve(2 * ships_.size());
    packet_.quays = scenario.quays;
}

/// A ship that keeps station follows her leader's track, a fixed place off it.
ShipTrack HostLoop::track_of(const Scenario& scenario, const std::string& moving_object) {
    const auto named = [&](const std::string& name) {
        return std::ranges::find_if(scenario.ships,
                                    [&](const ShipSection& each) { return each.moving_object.text == name; });
    };
    const ShipSection& section = *named(moving_object);
    if (section.track.kind == TrackSection::Kind::station) {
        ShipTrack track = track_of(scenario, section.track.leader.text);
        track.station_m = section.track.offset_m;
        return track;
    }
    return {.start_m = section.position_m,
            .heading_rad = section.heading_rad,
            .speed_mps = section.speed_mps,
            .kind = static_cast<ShipTrack::Kind>(section.track.kind),
            .begin_s = section.track.begin_s,
            .radius_m = section.track.radius_m,
            .to_port = section.track.to_port,
            .angle_rad = section.track.angle_rad};
}

void HostLoop::check_ways(const Scenario& scenario, const NameDirectory& directory) const {
    database::Diagnostics diagnostics;
    for (std::size_t i = 0; i < ships_.size(); ++i)
        check_track(scenario.ships[i], ships_[i].track, scenario.duration_s, directory, diagnostics);
    if (diagnostics.any()) throw std::invalid_argument(diagnostics.text());
}

void HostLoop::start_sequences(const Scenario& scenario, const Binding& binding) {
    for (std::size_t i = 0; i < scenario.sequences.size(); ++i) {
        const SequenceSection& section = scenario.sequences[i];
        pointers_.push_back({binding.slots[i], FaceSequence::of(binding.slot_alternatives[i], section.dwell_s,
                                                                section.phase, update_rate_hz_)});
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

OwnShipProgram HostLoop::program_of(const Scenario& scenario) {
    const OwnShipSection& own = scenario.own_ship;
    OwnShipProgram program;
    if (own.kind == OwnShipSection::Kind::fixed) {
        program.fixed = true;
        program.approach.control_m.fill(own.position_m);
        program.approach.first_aim_m = program.approach.last_aim_m = own.aim_m;
        if (own.beside) program.beside = track_of(scenario, own.beside->text);
    } else if (own.kind == OwnShipSection::Kind::path) {
        program.path = history_of(own.path);
    } else if (own.kind == OwnShipSection::Kind::approach) {
        const ApproachSection& section = approach_for(scenario);
        program.approach = {.control_m = section.path_m,
                            .first_aim_m = section.first_aim_m,
                            .last_aim_m = section.last_aim_m,
                            .duration_s = scenario.duration_s};
        if (!section.ship.text.empty()) program.beside = track_of(scenario, section.ship.text);
    }
    return program;
}

void HostLoop::begin_own_ship(const Scenario& scenario) {
    const OwnShipSection& own = scenario.own_ship;
    std::optional<HelicopterState> flown;
    if (own.kind == OwnShipSection::Kind::flown)
        flown = HelicopterState{.position_m = own.position_m,
                                .velocity_mps = direction(own.heading_rad, 0.0) * own.speed_mps,
                                .attitude = {.heading_rad = own.heading_rad}};
    own_ship_ = OwnShip(program_of(scenario), flown, update_rate_hz_);
}

void HostLoop::choose_sea(const Scenario& scenario, const NameDirectory& directory, const Binding& binding) {
    sea_method_ = scenario.sea_method;
    normals_every_ = scenario.normals_every;
    if (!binding.sea_tile) return;
    const NameDirectory::Tile& tile = directory.tiles[*binding.sea_tile];
    sea_sun_row_ = directory.lists[tile.list].sun;
    sea_normals_ = tile.normals;
    sea_update_.list = tile.list;
    sea_update_.normals.reserve(tile.normals.size());
}

void HostLoop::fill_constants(const Scenario& scenario) {
    packet_.seed = scenario.seed;
    packet_.sea = {.state = static_cast<float>(scenario.sea_state),
                   .current_east_mps = static_cast<float>(scenario.current_east_mps),
                   .current_north_mps = static_cast<float>(scenario.current_north_mps)};
    sea_state_ = packet_.sea.state;
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
