#include "host/loop/ship_methods.h"

#include <algorithm>
#include <cmath>

namespace linkdig::host {

namespace {

constexpr std::uint32_t wake_faces = 28; // S: report, 3.2.2

void point(const MaybeSlot& slot, std::uint32_t alternative, FramePacket& packet) {
    if (!slot) return;
    const std::uint32_t index = std::min(alternative, slot->alternatives - 1);
    // A [[sequence]] may have pointed it already: a slot has one row.
    const auto same = std::ranges::find(packet.substitutions, slot->slot, &Substitution::slot);
    if (same == packet.substitutions.end())
        packet.substitutions.push_back({slot->slot, index});
    else
        same->index = index;
}

/// A sequence over what a slot has beside nothing.
FaceSequence sequence_of(const MaybeSlot& slot, double dwell_s, double update_rate_hz) {
    if (!slot || slot->alternatives < 2) return {};
    const std::uint32_t faces = slot->alternatives == wake_faces ? wake_faces : slot->alternatives - 1;
    return FaceSequence::of(faces, dwell_s, 0.0, update_rate_hz);
}

void point_sequence(const MaybeSlot& slot, const FaceSequence& sequence, bool shown, std::uint64_t frame,
                    FramePacket& packet) {
    if (!slot) return;
    const std::uint32_t nothing = slot->alternatives == wake_faces ? 0 : 1; // such a slot begins with a face
    point(slot, shown ? sequence.index(frame) + nothing : 0, packet);
}

std::int32_t index_or_none(const std::optional<std::uint32_t>& index) {
    return index ? static_cast<std::int32_t>(*index) : none;
}

Signal signal_of(Wake wake) {
    if (wake == Wake::kelvin) return Signal::kelvin;
    if (wake == Wake::wave_particles) return Signal::wave_particles;
    return static_cast<Signal>(static_cast<std::size_t>(Signal::white_v) + static_cast<std::size_t>(wake));
}

} // namespace

std::uint32_t wedge_index(double risen_rad, std::uint32_t wedges) {
    if (risen_rad <= 0.0 || wedges == 0) return 0;
    const double steps = std::ceil(risen_rad / wedge_range_rad * wedges - 1e-9);
    return static_cast<std::uint32_t>(std::clamp(steps, 1.0, static_cast<double>(wedges)));
}

ShipMethods::ShipMethods(const MethodsSection& section, const ShipSlots& slots, const std::string& ship,
                         double update_rate_hz)
    : section_(section), slots_(slots),
      port_(sequence_of(slots.bow_wake_port, section.wake_dwell_s, update_rate_hz)),
      starboard_(sequence_of(slots.bow_wake_starboard, section.wake_dwell_s, update_rate_hz)),
      solid_(sequence_of(slots.solid_bow_wake, section.wake_dwell_s, update_rate_hz)),
      frames_per_roll_(section.cam_period_s * update_rate_hz) {
    for (std::size_t i = 0; i < can_occult_.size(); ++i)
        can_occult_[i] = lacking(slots, ship, static_cast<Occulting>(i)).empty();
    for (std::size_t i = 0; i < wake_count; ++i)
        can_wake_[i] = lacking(slots, ship, static_cast<Wake>(i)).empty();
}

Occulting ShipMethods::occulting(const SignalValues& signals) const {
    const auto asked = static_cast<std::size_t>(signals[Signal::occulting]);
    const Occulting said = section_.occulting.value_or(Occulting::waterline);
    if (asked == 0) return said;
    const auto method = static_cast<Occulting>(asked - 1);
    return can(method) ? method : said;
}

bool ShipMethods::shows(Wake wake, const SignalValues& signals) const {
    const bool said = section_.wakes && (*section_.wakes)[static_cast<std::size_t>(wake)];
    return can(wake) && said != signals.on(signal_of(wake));
}

bool ShipMethods::named(const SignalValues& signals) const {
    if (section_.occulting || section_.wakes || signals[Signal::occulting] != 0.0) return true;
    for (std::size_t i = 0; i < wake_count; ++i)
        if (signals.on(signal_of(static_cast<Wake>(i)))) return true;
    return false;
}

void ShipMethods::put(const MovingObject& ship, const SignalValues& signals, std::uint64_t frame,
                      FramePacket& packet) const {
    if (!named(signals)) return;
    put_occulting(ship, occulting(signals), packet);
    put_wakes(signals, frame, packet);
}

void ShipMethods::put_occulting(const MovingObject& ship, Occulting method, FramePacket& packet) const {
    const bool below = method != Occulting::waterline && method != Occulting::wedges;
    point(slots_.hull_below, below ? 1 : 0, packet);
    const std::uint32_t box = method == Occulting::box ? 1 : method == Occulting::fitted_box ? 2 : 0;
    point(slots_.box, box, packet);
    const double pitch = method == Occulting::wedges ? ship.attitude.pitch_rad : 0.0;
    const auto wedge = [&](const MaybeSlot& slot, double risen_rad) {
        if (slot) point(slot, wedge_index(risen_rad, slot->alternatives - 1), packet);
    };
    wedge(slots_.wedge_bow, pitch);
    wedge(slots_.wedge_stern, -pitch);
    if (method == Occulting::none && slots_.cluster && slots_.number_behind_sea)
        packet.priorities.push_back({*slots_.cluster, *slots_.number_behind_sea});
}

void ShipMethods::put_wakes(const SignalValues& signals, std::uint64_t frame, FramePacket& packet) const {
    const bool faces = shows(Wake::face_substitution, signals);
    // A scenario that says nothing of wakes leaves the bow wake to its [[sequence]].
    if (section_.wakes || signals.on(Signal::face_substitution)) {
        point_sequence(slots_.bow_wake_port, port_, faces, frame, packet);
        point_sequence(slots_.bow_wake_starboard, starboard_, faces, frame, packet);
    }
    point_sequence(slots_.solid_bow_wake, solid_, shows(Wake::solid, signals), frame, packet);
    const std::uint32_t v = shows(Wake::blended_v, signals) ? 2 : shows(Wake::white_v, signals) ? 1 : 0;
    point(slots_.v_wake, v, packet);
    point(slots_.churn, shows(Wake::churned, signals) ? 1 : 0, packet);
    point(slots_.cam, shows(Wake::cam, signals) ? 1 : 0, packet);
}

void ShipMethods::put_made_wakes(const SignalValues& signals, double speed_mps, FramePacket& packet) const {
    const WaterSection& water = section_.water;
    const auto ask = [&](Wake wake, WakeMethod method, const std::optional<std::uint32_t>& list,
                         std::uint32_t faces) {
        if (!shows(wake, signals)) return;
        const bool of_hull = method == WakeMethod::wave_particles;
        packet.wakes.push_back({.list = *list,
                                .moving_object = *slots_.moving_object,
                                .method = method,
                                .heights = water.heights,
                                .colour = *slots_.wake_light,
                                .most_faces = faces,
                                .age_s = static_cast<float>(water.kelvin_age_s),
                                .strength = static_cast<float>(water.strength),
                                .speed_mps = static_cast<float>(speed_mps),
                                .length_m = static_cast<float>(water.length_m),
                                .beam_m = static_cast<float>(water.beam_m),
                                .hull = of_hull ? index_or_none(slots_.hull) : none,
                                .hull_above = of_hull ? index_or_none(slots_.hull_above) : none});
    };
    ask(Wake::kelvin, WakeMethod::kelvin, slots_.kelvin, water.kelvin_faces);
    ask(Wake::wave_particles, WakeMethod::wave_particles, slots_.wave_particles, water.particle_faces);
}

void ShipMethods::put_lights(bool full_day, FramePacket& packet) const {
    const bool burn =
        section_.lights == ShipLights::on || (section_.lights == ShipLights::from_dusk && !full_day);
    if (burn) point(slots_.lights, 1, packet); // the slot's first alternative is nothing
}

void ShipMethods::roll_cams(const MovingObject& ship, const SignalValues& signals, std::uint64_t frame,
                            FramePacket& packet) const {
    if (!slots_.cam_port || !slots_.cam_starboard) return;
    const double turns = static_cast<double>(frame) / frames_per_roll_;
    const double rolled = (turns - std::floor(turns)) * two_pi;
    const Mat3d world_from_waterline = world_from_body({.heading_rad = ship.waterline_heading_rad});
    const auto place = [&](std::uint32_t row, double side) {
        const Vec3d at(section_.cam_position_m.x, side * section_.cam_position_m.y,
                       section_.cam_position_m.z);
        MovingObject& cam = packet.moving_objects[row];
        cam.visible = shows(Wake::cam, signals);
        cam.position_m = ship.waterline_position_m + world_from_waterline * at;
        cam.waterline_position_m = cam.position_m;
        cam.waterline_heading_rad = ship.waterline_heading_rad;
        cam.attitude = {.heading_rad = ship.waterline_heading_rad,
                        .roll_rad = -side * rolled}; // outward at the top
    };
    place(*slots_.cam_port, 1.0);
    place(*slots_.cam_starboard, -1.0);
}

} // namespace linkdig::host
