#pragma once
/// The names of a frame packet's fields, once, for writer and reader of JSON alike.
///
/// A visitor is called as visitor(name, value) for a field with a default, visitor.required(name, value) for
/// one that must stand, visitor.bits(name, value) for 64 bits of which each counts.

#include "host/packet/frame_packet.h"

#include <concepts>
#include <type_traits>

namespace linkdig {

/// T, const or not: the writer visits const values.
template <typename T, typename Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

void fields(auto& visit, Is<Attitude> auto& attitude) {
    visit("heading_rad", attitude.heading_rad);
    visit("pitch_rad", attitude.pitch_rad);
    visit("roll_rad", attitude.roll_rad);
}

void fields(auto& visit, Is<ChannelView> auto& channel) {
    visit("on", channel.on);
    visit("eye_m", channel.eye_m);
    visit("attitude", channel.attitude);
    visit("left_tangent", channel.left_tangent);
    visit("right_tangent", channel.right_tangent);
    visit("bottom_tangent", channel.bottom_tangent);
    visit("top_tangent", channel.top_tangent);
}

void fields(auto& visit, Is<ListLighting> auto& lighting) {
    visit.required("list", lighting.list);
    visit("sun", lighting.sun);
    visit("ambient", lighting.ambient);
    visit("diffuse", lighting.diffuse);
    visit("colour", lighting.colour);
    visit("method", lighting.method);
}

void fields(auto& visit, Is<MovingObject> auto& object) {
    visit("visible", object.visible);
    visit("position_m", object.position_m);
    visit("attitude", object.attitude);
    visit("waterline_position_m", object.waterline_position_m);
    visit("waterline_heading_rad", object.waterline_heading_rad);
}

void fields(auto& visit, Is<Substitution> auto& substitution) {
    visit.required("slot", substitution.slot);
    visit.required("index", substitution.index);
}

void fields(auto& visit, Is<VertexNormalUpdate> auto& update) {
    visit.required("list", update.list);
    visit("first", update.first);
    visit.required("normals", update.normals);
}

void fields(auto& visit, Is<Colour> auto& colour) {
    visit.required("red", colour.red);
    visit.required("green", colour.green);
    visit.required("blue", colour.blue);
}

void fields(auto& visit, Is<ClusterPriority> auto& priority) {
    visit.required("cluster", priority.cluster);
    visit.required("number", priority.number);
}

void fields(auto& visit, Is<HostValue> auto& value) {
    visit.required("index", value.index);
    visit.required("value", value.value);
}

void fields(auto& visit, Is<WakeRequest> auto& wake) {
    visit.required("list", wake.list);
    visit.required("moving_object", wake.moving_object);
    visit("method", wake.method);
    visit("heights", wake.heights);
    visit("colour", wake.colour);
    visit("most_faces", wake.most_faces);
    visit("age_s", wake.age_s);
    visit("strength", wake.strength);
    visit("speed_mps", wake.speed_mps);
    visit("length_m", wake.length_m);
    visit("beam_m", wake.beam_m);
    visit("hull", wake.hull);
    visit("hull_above", wake.hull_above);
}

void fields(auto& visit, Is<Quay> auto& quay) {
    visit.required("from_m", quay.from_m);
    visit.required("to_m", quay.to_m);
}

void fields(auto& visit, Is<SeaParameters> auto& sea) {
    visit("state", sea.state);
    visit("current_east_mps", sea.current_east_mps);
    visit("current_north_mps", sea.current_north_mps);
}

void fields(auto& visit, Is<FramePacket> auto& packet) {
    visit.required("frame", packet.frame);
    visit("time_s", packet.time_s);
    visit.bits("database_id", packet.database_id);
    visit("channels", packet.channels);
    visit("suns", packet.suns);
    visit("lighting", packet.lighting);
    visit("moving_objects", packet.moving_objects);
    visit("substitutions", packet.substitutions);
    visit("normal_updates", packet.normal_updates);
    visit("lod_bias", packet.lod_bias);
    visit("visibility_m", packet.visibility_m);
    visit("sky", packet.sky);
    visit("time_of_day_h", packet.time_of_day_h);
    visit("colours", packet.colours);
    visit("light_points", packet.light_points);
    visit("sea", packet.sea);
    visit.bits("seed", packet.seed);
    visit("discontinuity", packet.discontinuity);
    visit("priorities", packet.priorities);
    visit("host_values", packet.host_values);
    visit("wakes", packet.wakes);
    visit("quays", packet.quays);
}

inline constexpr const char* shading_method_names[] = {"as_modelled", "no_smooth"};
inline constexpr const char* wake_method_names[] = {"kelvin", "wave_particles"};

} // namespace linkdig
