#include "ig/active/activate.h"

#include "ig/active/detail_levels.h"
#include "ig/active/made_faces.h"
#include "ig/active/repeated_tile.h"
#include "ig/active/shedding.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

void place_clusters(const VisualDatabase& database, const FramePacket& packet, ActiveDatabase& active) {
    active.poses.assign(database.clusters.size(), ClusterPose{});
    for (std::size_t c = 0; c < database.clusters.size(); ++c) {
        const std::int32_t moving = database.clusters[c].moving_object;
        if (moving == none) continue;
        const MovingObject& object = packet.moving_objects[static_cast<std::size_t>(moving)];
        ClusterPose& pose = active.poses[c];
        pose.visible = object.visible;
        pose.world_from_body = world_from_body(object.attitude);
        pose.body_origin_m = object.position_m;
        pose.world_from_waterline = world_from_body({.heading_rad = object.waterline_heading_rad});
        pose.waterline_origin_m = object.waterline_position_m;
    }
}

void point_slots(const VisualDatabase& database, const FramePacket& packet, ActiveDatabase& active) {
    active.slot_index.assign(database.slots.size(), 0);
    for (const Substitution& substitution : packet.substitutions) {
        active.slot_index[substitution.slot] = substitution.index;
    }
}

/// The later of two numbers for one cluster counts.
void move_clusters(const FramePacket& packet, ActiveDatabase& active) {
    active.moved.clear();
    for (const ClusterPriority& each : packet.priorities) {
        const auto same = std::ranges::find(active.moved, each.cluster, &ClusterPriority::cluster);
        if (same == active.moved.end())
            active.moved.push_back(each);
        else
            same->number = each.number;
    }
    std::ranges::sort(active.moved, [](const ClusterPriority& a, const ClusterPriority& b) {
        return a.number != b.number ? a.number < b.number : a.cluster < b.cluster;
    });
}

void light(const VisualDatabase& database, const FramePacket& packet, std::uint32_t list, FaceBlock& block) {
    const ObjectList& modelled = database.lists[list];
    ListLighting lighting{
        .list = list, .sun = modelled.sun, .ambient = modelled.ambient, .diffuse = modelled.diffuse};
    for (const ListLighting& override_of_list : packet.lighting) {
        if (override_of_list.list == list) lighting = override_of_list;
    }
    // The rotation's transpose takes the world's sun to the list's frame, so that modelled normals stay as
    // they are.
    block.sun = Vec3f(glm::transpose(block.world_from_list) * Vec3d(packet.suns[lighting.sun]));
    block.ambient = lighting.ambient;
    block.diffuse = lighting.diffuse;
    block.colour = lighting.colour;
    block.smooth = lighting.method != ShadingMethod::no_smooth;
}

void attach(const ObjectList& list, const ClusterPose& pose, FaceBlock& block) {
    block.world_from_list = Mat3d(1.0);
    block.origin_m = list.origin_m;
    block.at_eye = list.attachment == Attachment::eye;
    if (list.attachment == Attachment::body) {
        block.world_from_list = pose.world_from_body;
        block.origin_m = pose.body_origin_m + pose.world_from_body * list.origin_m;
    } else if (list.attachment == Attachment::waterline) {
        block.world_from_list = pose.world_from_waterline;
        block.origin_m = pose.waterline_origin_m + pose.world_from_waterline * list.origin_m;
    }
}

/// Will faces be made for this list later in the frame?
bool is_made_later(const FramePacket& packet, std::uint32_t list) {
    return std::ranges::find(packet.wakes, list, &WakeRequest::list) != packet.wakes.end();
}

void point_at_database(const VisualDatabase& database, const ObjectList& list, FaceBlock& block) {
    block.vertices = database.vertices;
    block.corners = database.corners;
    block.corner_colours = database.corner_colours;
    block.faces = database.faces;
    block.runs = database.runs;
    block.leaves = database.run_leaves;
    block.lights = database.lights;
    block.root = list.root;
}

} // namespace

void activate(const VisualDatabase& database, const FramePacket& packet, const Configuration& configuration,
              History& history, ActiveDatabase& active) {
    active.database = &database;
    active.time_s = packet.time_s;
    active.visibility_m = static_cast<double>(packet.visibility_m);
    active.light_points = packet.light_points;
    active.light_step = configuration.capacity.limited() ? history.load.light_step : 0;
    place_clusters(database, packet, active);
    point_slots(database, packet, active);
    choose_levels(database, packet, history, active);
    move_clusters(packet, active);
    active.blocks.clear();
    clear_made_faces(active);
    for (std::uint32_t l = 0; l < database.lists.size(); ++l) {
        const ObjectList& list = database.lists[l];
        const ClusterPose& pose = active.poses[list.cluster];
        const bool empty = list.root == none && list.tile == none;
        if (!pose.visible || (empty && !is_made_later(packet, l))) continue;
        FaceBlock block{.list = l, .cluster = list.cluster, .number = list.number};
        attach(list, pose, block);
        light(database, packet, l, block);
        point_at_database(database, list, block);
        if (list.tile != none) {
            make_tile_faces(database, database.tiles[static_cast<std::size_t>(list.tile)], packet,
                            configuration, active, block);
        }
        active.blocks.push_back(block);
    }
    settle_made_faces(active);
    if (configuration.capacity.limited())
        shed_objects(database, packet, configuration.raster, history.load.step, active);
}

} // namespace linkdig::ig
