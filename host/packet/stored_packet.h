#pragma once
/// Each row's two conversions, side by side: frame_packet.h to what recording.fbs stores, and back.

#include "host/packet/frame_packet.h"
#include "host/packet/recording_generated.h"

namespace linkdig {

inline stored::Vec3 to_stored(const Vec3f& v) { return {v.x, v.y, v.z}; }
inline Vec3f from_stored(const stored::Vec3& v) { return {v.x(), v.y(), v.z()}; }

inline stored::Vec3Double to_stored(const Vec3d& v) { return {v.x, v.y, v.z}; }
inline Vec3d from_stored(const stored::Vec3Double& v) { return {v.x(), v.y(), v.z()}; }

inline stored::Attitude to_stored(const Attitude& a) { return {a.heading_rad, a.pitch_rad, a.roll_rad}; }
inline Attitude from_stored(const stored::Attitude& a) {
    return {a.heading_rad(), a.pitch_rad(), a.roll_rad()};
}

inline stored::ChannelView to_stored(const ChannelView& c) {
    return {to_stored(c.eye_m),
            to_stored(c.attitude),
            c.left_tangent,
            c.right_tangent,
            c.bottom_tangent,
            c.top_tangent,
            c.on};
}
inline ChannelView from_stored(const stored::ChannelView& c) {
    return {.on = c.on(),
            .eye_m = from_stored(c.eye_m()),
            .attitude = from_stored(c.attitude()),
            .left_tangent = c.left_tangent(),
            .right_tangent = c.right_tangent(),
            .bottom_tangent = c.bottom_tangent(),
            .top_tangent = c.top_tangent()};
}

inline stored::ListLighting to_stored(const ListLighting& l) {
    return {l.list, l.sun, l.ambient, l.diffuse, l.colour, static_cast<std::uint32_t>(l.method)};
}
/// A method that is no byte becomes 255, which check_packet() refuses.
inline ListLighting from_stored(const stored::ListLighting& l) {
    return {.list = l.list(),
            .sun = l.sun(),
            .ambient = l.ambient(),
            .diffuse = l.diffuse(),
            .colour = l.colour(),
            .method = static_cast<ShadingMethod>(l.method() < 255 ? l.method() : 255)};
}

inline stored::MovingObject to_stored(const MovingObject& m) {
    return {to_stored(m.position_m), to_stored(m.attitude), to_stored(m.waterline_position_m),
            m.waterline_heading_rad, m.visible};
}
inline MovingObject from_stored(const stored::MovingObject& m) {
    return {.visible = m.visible(),
            .position_m = from_stored(m.position_m()),
            .attitude = from_stored(m.attitude()),
            .waterline_position_m = from_stored(m.waterline_position_m()),
            .waterline_heading_rad = m.waterline_heading_rad()};
}

inline stored::Substitution to_stored(const Substitution& s) { return {s.slot, s.index}; }
inline Substitution from_stored(const stored::Substitution& s) { return {s.slot(), s.index()}; }

inline stored::Colour to_stored(const Colour& c) { return {c.red, c.green, c.blue}; }
inline Colour from_stored(const stored::Colour& c) { return {c.red(), c.green(), c.blue(), 0}; }

inline stored::ClusterPriority to_stored(const ClusterPriority& c) { return {c.number, c.cluster}; }
inline ClusterPriority from_stored(const stored::ClusterPriority& c) { return {c.cluster(), c.number()}; }

inline stored::HostValue to_stored(const HostValue& h) { return {h.value, h.index}; }
inline HostValue from_stored(const stored::HostValue& h) { return {h.index(), h.value()}; }

inline stored::WakeRequest to_stored(const WakeRequest& w) {
    return {w.list,     w.moving_object, static_cast<std::uint32_t>(w.method),
            w.colour,   w.most_faces,    w.age_s,
            w.strength, w.speed_mps,     w.length_m,
            w.beam_m,   w.hull,          w.hull_above,
            w.heights};
}
/// A method that is no byte becomes 255, which check_packet() refuses.
inline WakeRequest from_stored(const stored::WakeRequest& w) {
    return {.list = w.list(),
            .moving_object = w.moving_object(),
            .method = static_cast<WakeMethod>(w.method() < 255 ? w.method() : 255),
            .heights = w.heights(),
            .colour = w.colour(),
            .most_faces = w.most_faces(),
            .age_s = w.age_s(),
            .strength = w.strength(),
            .speed_mps = w.speed_mps(),
            .length_m = w.length_m(),
            .beam_m = w.beam_m(),
            .hull = w.hull(),
            .hull_above = w.hull_above()};
}

inline stored::Vec2Double to_stored(const Vec2d& v) { return {v.x, v.y}; }
inline Vec2d from_stored(const stored::Vec2Double& v) { return {v.x(), v.y()}; }

inline stored::Quay to_stored(const Quay& q) { return {to_stored(q.from_m), to_stored(q.to_m)}; }
inline Quay from_stored(const stored::Quay& q) { return {from_stored(q.from_m()), from_stored(q.to_m())}; }

inline stored::SeaParameters to_stored(const SeaParameters& s) {
    return {s.state, s.current_east_mps, s.current_north_mps};
}
inline SeaParameters from_stored(const stored::SeaParameters& s) {
    return {s.state(), s.current_east_mps(), s.current_north_mps()};
}

} // namespace linkdig
