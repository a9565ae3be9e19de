#include "host/packet/check_packet.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace linkdig {

namespace {

constexpr double unit_tolerance = 1e-3;

/// Names a member of a table's row without taking memory: "channels[0].eye_m".
struct Field {
    std::string_view table; ///< empty: the packet itself
    std::size_t row;
    std::string_view member;

    std::string text() const {
        if (table.empty()) return std::string(member);
        return member.empty() ? fmt::format("{}[{}]", table, row)
                              : fmt::format("{}[{}].{}", table, row, member);
    }
};

std::string check_range(const Field& field, double value, double least, double greatest) {
    if (!std::isfinite(value)) return fmt::format("{} is not finite", field.text());
    if (value < least || value > greatest)
        return fmt::format("{} is {}; expected {} to {}", field.text(), value, least, greatest);
    return {};
}

std::string check_place(const Field& field, const Vec3d& place) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(place[axis])) return fmt::format("{} is not finite", field.text());
    for (int axis = 0; axis < 3; ++axis)
        if (std::fabs(place[axis]) > max_packet_coordinate_m)
            return fmt::format("{} has the coordinate {}; expected no more than {} m", field.text(),
                               place[axis], max_packet_coordinate_m);
    return {};
}

std::string check_attitude(std::string_view table, std::size_t row, const Attitude& attitude) {
    using Angle = std::pair<std::string_view, double>;
    for (const auto& [member, angle] :
         {Angle{"attitude.heading_rad", attitude.heading_rad},
          Angle{"attitude.pitch_rad", attitude.pitch_rad}, Angle{"attitude.roll_rad", attitude.roll_rad}})
        if (std::string reason = check_range({table, row, member}, angle, -max_angle_rad, max_angle_rad);
            !reason.empty())
            return reason;
    return {};
}

std::string check_index(const Field& field, std::int64_t index, std::size_t count, std::string_view of_what) {
    if (index < 0 || static_cast<std::uint64_t>(index) >= count)
        return fmt::format("{} is {}, but the database has {} {}", field.text(), index, count, of_what);
    return {};
}

double length_of(const Vec3f& v) {
    const double x = v.x;
    const double y = v.y;
    const double z = v.z;
    return std::sqrt(x * x + y * y + z * z);
}

std::string check_frustum(std::size_t row, const ChannelView& channel) {
    using Side = std::pair<std::string_view, double>;
    for (const auto& [member, tangent] :
         {Side{"left_tangent", channel.left_tangent}, Side{"right_tangent", channel.right_tangent},
          Side{"bottom_tangent", channel.bottom_tangent}, Side{"top_tangent", channel.top_tangent}})
        if (std::string reason = check_range({"channels", row, member}, tangent, -max_tangent, max_tangent);
            !reason.empty())
            return reason;
    // Narrower than this, the picture's scale in pixels would pass every bound.
    constexpr double narrowest = 1e-6;
    if (!(channel.right_tangent - channel.left_tangent >= narrowest))
        return fmt::format("channels[{}].right_tangent is {}; expected more than left_tangent, {}", row,
                           channel.right_tangent, channel.left_tangent);
    if (!(channel.top_tangent - channel.bottom_tangent >= narrowest))
        return fmt::format("channels[{}].top_tangent is {}; expected more than bottom_tangent, {}", row,
                           channel.top_tangent, channel.bottom_tangent);
    return {};
}

std::string check_channels(const FramePacket& packet, const PacketLimits&) {
    if (packet.channels.empty() || packet.channels.size() > max_channels)
        return fmt::format("channels has {} rows; expected 1 to {}", packet.channels.size(), max_channels);
    for (std::size_t i = 0; i < packet.channels.size(); ++i) {
        const ChannelView& channel = packet.channels[i];
        std::string reason = check_place({"channels", i, "eye_m"}, channel.eye_m);
        if (reason.empty()) reason = check_attitude("channels", i, channel.attitude);
        if (reason.empty()) reason = check_frustum(i, channel);
        if (!reason.empty()) return reason;
    }
    return {};
}

std::string check_suns(const FramePacket& packet, const PacketLimits& limits) {
    if (packet.suns.size() != limits.suns)
        return fmt::format("suns has {} rows; the database has {} suns", packet.suns.size(), limits.suns);
    for (std::size_t i = 0; i < packet.suns.size(); ++i) {
        const double length = length_of(packet.suns[i]);
        if (!std::isfinite(length)) return fmt::format("suns[{}] is not finite", i);
        if (std::fabs(length - 1.0) > unit_tolerance)
            return fmt::format("suns[{}] is {} long; expected a unit vector", i, length);
    }
    return {};
}

std::string check_lighting(const FramePacket& packet, const PacketLimits& limits) {
    if (packet.lighting.size() > limits.lists)
        return fmt::format("lighting has {} rows; the database has {} lists", packet.lighting.size(),
                           limits.lists);
    for (std::size_t i = 0; i < packet.lighting.size(); ++i) {
        const ListLighting& row = packet.lighting[i];
        std::string reason = check_index({"lighting", i, "list"}, row.list, limits.lists, "lists");
        if (reason.empty()) reason = check_index({"lighting", i, "sun"}, row.sun, limits.suns, "suns");
        if (reason.empty() && row.colour != none)
            reason = check_index({"lighting", i, "colour"}, row.colour, limits.colours, "colours");
        if (reason.empty()) reason = check_range({"lighting", i, "ambient"}, row.ambient, 0.0, 1.0);
        if (reason.empty()) reason = check_range({"lighting", i, "diffuse"}, row.diffuse, 0.0, 1.0);
        if (reason.empty() && row.method > ShadingMethod::no_smooth)
            reason = fmt::format("lighting[{}].method is none of as_modelled, no_smooth", i);
        if (!reason.empty()) return reason;
    }
    return {};
}

std::string check_moving_objects(const FramePacket& packet, const PacketLimits& limits) {
    if (packet.moving_objects.size() != limits.moving_objects)
        return fmt::format("moving_objects has {} rows; the database has {} moving objects",
                           packet.moving_objects.size(), limits.moving_objects);
    constexpr std::string_view table = "moving_objects";
    for (std::size_t i = 0; i < packet.moving_objects.size(); ++i) {
        const MovingObject& object = packet.moving_objects[i];
        std::string reason = check_place({table, i, "position_m"}, object.position_m);
        if (reason.empty()) reason = check_attitude(table, i, object.attitude);
        if (reason.empty())
            reason = check_place({table, i, "waterline_position_m"}, object.waterline_position_m);
        if (reason.empty())
            reason = check_range({table, i, "waterline_heading_rad"}, object.waterline_heading_rad,
                                 -max_angle_rad, max_angle_rad);
        if (!reason.empty()) return reason;
    }
    return {};
}

std::string check_substitutions(const FramePacket& packet, const PacketLimits& limits) {
    const std::size_t slots = limits.alternatives.size();
    if (packet.substitutions.size() > slots)
        return fmt::format("substitutions has {} rows; the database has {} slots",
                           packet.substitutions.size(), slots);
    for (std::size_t i = 0; i < packet.substitutions.size(); ++i) {
        const Substitution& row = packet.substitutions[i];
        if (std::string reason = check_index({"substitutions", i, "slot"}, row.slot, slots, "slots");
            !reason.empty())
            return reason;
        if (row.index >= limits.alternatives[row.slot])
            return fmt::format("substitutions[{}].index is {}, but slot {} has {} alternatives", i, row.index,
                               row.slot, limits.alternatives[row.slot]);
    }
    return {};
}

std::string check_normal_updates(const FramePacket& packet, const PacketLimits& limits) {
    for (std::size_t i = 0; i < packet.normal_updates.size(); ++i) {
        const VertexNormalUpdate& update = packet.normal_updates[i];
        if (std::string reason =
                check_index({"normal_updates", i, "list"}, update.list, limits.lists, "lists");
            !reason.empty())
            return reason;
        if (update.normals.size() > std::numeric_limits<std::uint32_t>::max() - update.first)
            return fmt::format("normal_updates[{}].first is {}: the last normal's index passes 32 bits", i,
                               update.first);
        for (std::size_t k = 0; k < update.normals.size(); ++k)
            if (!(length_of(update.normals[k]) <= 1.0 + unit_tolerance))
                return fmt::format("normal_updates[{}].normals[{}] is not finite, or longer than 1", i, k);
    }
    return {};
}

std::string check_priorities(const FramePacket& packet, const PacketLimits& limits) {
    for (std::size_t i = 0; i < packet.priorities.size(); ++i)
        if (std::string reason = check_index({"priorities", i, "cluster"}, packet.priorities[i].cluster,
                                             limits.clusters, "clusters");
            !reason.empty())
            return reason;
    return {};
}

/// The machine does not look at them, but a recording keeps them, and its text does not tell one NaN from another.
std::string check_host_values(const FramePacket& packet, const PacketLimits&) {
    for (std::size_t i = 0; i < packet.host_values.size(); ++i)
        if (!std::isfinite(packet.host_values[i].value))
            return fmt::format("host_values[{}].value is not finite", i);
    return {};
}

std::string check_wake(const FramePacket& packet, std::size_t i, const PacketLimits& limits) {
    const WakeRequest& wake = packet.wakes[i];
    constexpr std::string_view table = "wakes";
    std::string reason = check_index({table, i, "list"}, wake.list, limits.lists, "lists");
    for (std::size_t k = 0; k < i && reason.empty(); ++k)
        if (packet.wakes[k].list == wake.list)
            reason = fmt::format("wakes[{}].list is {}, as wakes[{}].list is", i, wake.list, k);
    if (reason.empty())
        reason = check_index({table, i, "moving_object"}, wake.moving_object, limits.moving_objects,
                             "moving objects");
    if (reason.empty()) reason = check_index({table, i, "colour"}, wake.colour, limits.colours, "colours");
    if (reason.empty() && wake.method > WakeMethod::wave_particles)
        reason = fmt::format("wakes[{}].method is none of kelvin, wave_particles", i);
    if (reason.empty() && (wake.method == WakeMethod::wave_particles || wake.hull != none))
        reason = check_index({table, i, "hull"}, wake.hull, limits.lists, "lists");
    if (reason.empty() && wake.hull_above != none)
        reason = check_index({table, i, "hull_above"}, wake.hull_above, limits.lists, "lists");
    struct Bound {
        std::string_view member;
        double value, least, greatest;
    };
    for (const Bound& bound :
         {Bound{"most_faces", static_cast<double>(wake.most_faces), 0.0, most_wake_faces},
          Bound{"age_s", wake.age_s, 1.0, most_wake_age_s}, Bound{"strength", wake.strength, 0.0, 10.0},
          Bound{"speed_mps", wake.speed_mps, -100.0, 100.0}, Bound{"length_m", wake.length_m, 1.0, 1000.0},
          Bound{"beam_m", wake.beam_m, 0.1, 1000.0}})
        if (reason.empty())
            reason = check_range({table, i, bound.member}, bound.value, bound.least, bound.greatest);
    return reason;
}

std::string check_wakes(const FramePacket& packet, const PacketLimits& limits) {
    for (std::size_t i = 0; i < packet.wakes.size(); ++i)
        if (std::string reason = check_wake(packet, i, limits); !reason.empty()) return reason;
    return {};
}

std::string check_quays(const FramePacket& packet, const PacketLimits&) {
    if (packet.quays.size() > max_quays)
        return fmt::format("quays has {} rows; expected at most {}", packet.quays.size(), max_quays);
    for (std::size_t i = 0; i < packet.quays.size(); ++i) {
        const Quay& quay = packet.quays[i];
        std::string reason = check_place({"quays", i, "from_m"}, Vec3d(quay.from_m, 0.0));
        if (reason.empty()) reason = check_place({"quays", i, "to_m"}, Vec3d(quay.to_m, 0.0));
        if (!reason.empty()) return reason;
        const Vec2d along = quay.to_m - quay.from_m;
        if (along.x * along.x + along.y * along.y < least_quay_m * least_quay_m)
            return fmt::format("quays[{}] has no length; expected {} m at least", i, least_quay_m);
    }
    return {};
}

std::string check_environment(const FramePacket& packet, const PacketLimits& limits) {
    if (packet.database_id != 0 && limits.database_id != 0 && packet.database_id != limits.database_id)
        return fmt::format("database_id is {:016x}; the database in use has {:016x}", packet.database_id,
                           limits.database_id);
    if (!packet.colours.empty() && packet.colours.size() != limits.colours)
        return fmt::format("colours has {} rows; expected none, or the database's {}", packet.colours.size(),
                           limits.colours);
    constexpr double most = std::numeric_limits<float>::max();
    struct Bound {
        std::string_view member;
        double value, least, greatest;
    };
    const std::array bounds = {Bound{"time_s", packet.time_s, -max_time_s, max_time_s},
                               Bound{"lod_bias", packet.lod_bias, -max_lod_bias, max_lod_bias},
                               Bound{"visibility_m", packet.visibility_m, 0.0, most},
                               Bound{"sky.x", packet.sky.x, 0.0, 1.0},
                               Bound{"sky.y", packet.sky.y, 0.0, 1.0},
                               Bound{"sky.z", packet.sky.z, 0.0, 1.0},
                               Bound{"time_of_day_h", packet.time_of_day_h, 0.0, 24.0},
                               Bound{"light_points", packet.light_points, 0.0, 100.0},
                               Bound{"sea.state", packet.sea.state, 0.0, 9.0},
                               Bound{"sea.current_east_mps", packet.sea.current_east_mps, -100.0, 100.0},
                               Bound{"sea.current_north_mps", packet.sea.current_north_mps, -100.0, 100.0}};
    for (const Bound& bound : bounds)
        if (std::string reason = check_range({"", 0, bound.member}, bound.value, bound.least, bound.greatest);
            !reason.empty())
            return reason;
    return {};
}

} // namespace

PacketLimits packet_limits(const VisualDatabase& database, std::uint64_t database_id) {
    PacketLimits limits;
    limits.suns = database.suns.size();
    limits.moving_objects = database.moving_objects.size();
    limits.lists = database.lists.size();
    limits.colours = database.colours.size();
    limits.clusters = database.clusters.size();
    for (const SubstitutionSlot& slot : database.slots)
        limits.alternatives.push_back(slot.alternatives);
    limits.database_id = database_id;
    return limits;
}

std::string check_packet(const FramePacket& packet, const PacketLimits& limits) {
    for (const auto& check : {check_channels, check_suns, check_lighting, check_moving_objects,
                              check_substitutions, check_normal_updates, check_priorities, check_host_values,
                              check_wakes, check_quays, check_environment})
        if (std::string reason = check(packet, limits); !reason.empty()) return reason;
    return {};
}

} // namespace linkdig
