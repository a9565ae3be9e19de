#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"

namespace linkdig::ig {

VisualDatabase sea_database(const SeaOptions& options) {
    VisualDatabase database;
    database.name = "sea";
    database.colours = {{20, 90, 120, 0}, {200, 40, 40, 0}, {40, 200, 40, 0}, {40, 40, 200, 0}};
    database.colour_names = {"water", "red", "green", "blue"};
    database.source_files = {"made in code"};
    database.suns = {"ocean"};
    database.groups.push_back({.number = 100, .root = none});
    Cluster cluster;
    cluster.name = "sea";
    cluster.root = leaf_reference(0);
    database.clusters.push_back(cluster);
    ObjectList list;
    list.name = "sea";
    list.ambient = options.ambient;
    list.diffuse = options.diffuse;
    list.tile = 0;
    database.lists.push_back(list);
    Object object;
    object.name = "sea";
    database.objects.push_back(object);
    RepeatedTile tile;
    tile.period = options.period;
    tile.cell_m = options.cell_m;
    tile.rings = options.rings;
    tile.fine_levels = options.fine_levels;
    tile.half_width = options.half_width;
    const double a = radians(options.vertical_angle_deg);
    tile.vertical_angle_rad = static_cast<float>(a);
    const std::uint32_t count = options.period * options.period;
    tile.first_face_normal = count;
    database.tiles.push_back(tile);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        for (std::uint32_t k = 0; k < count; ++k) {
            const double phi = two_pi * random_unit(seed, k);
            database.tile_normals.push_back(Vec3f(direction(phi, a)));
        }
    }
    return database;
}

std::uint32_t add_box(VisualDatabase& database, const BoxOptions& options) {
    const auto cluster_index = static_cast<std::uint32_t>(database.clusters.size());
    const auto list_index = static_cast<std::uint32_t>(database.lists.size());
    Cluster cluster;
    cluster.name = "box " + std::to_string(cluster_index);
    cluster.group = options.group;
    cluster.moving_object = options.moving_object;
    cluster.reference_point_m = Vec3d(0.5F * (options.from + options.to));
    cluster.half_extent_m = 0.5F * (options.to - options.from);
    cluster.root = leaf_reference(list_index);
    database.clusters.push_back(cluster);

    ObjectList list;
    list.name = cluster.name;
    list.cluster = cluster_index;
    list.attachment = options.moving_object == none ? Attachment::world : Attachment::body;
    list.root = leaf_reference(static_cast<std::uint32_t>(database.run_leaves.size()));
    database.lists.push_back(list);
    Object object;
    object.name = cluster.name;
    object.list = list_index;
    database.objects.push_back(object);

    const auto first_vertex = static_cast<std::uint32_t>(database.vertices.size());
    for (int k = 0; k < 8; ++k) {
        const Vec4f position((k & 1) != 0 ? options.to.x : options.from.x,
                             (k & 2) != 0 ? options.to.y : options.from.y,
                             (k & 4) != 0 ? options.to.z : options.from.z, 1.0F);
        database.vertices.push_back({.position = position, .normal = {0, 0, 1}});
    }
    static constexpr std::uint32_t sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                  {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    static constexpr float normals[6][3] = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                            {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};
    database.run_leaves.push_back(
        {.first_run = static_cast<std::uint32_t>(database.runs.size()), .run_count = 1});
    FaceRun run;
    run.first_face = static_cast<std::uint32_t>(database.faces.size());
    run.face_count = 6;
    run.centre = 0.5F * (options.from + options.to);
    run.radius = 0.5F * glm::length(options.to - options.from);
    database.runs.push_back(run);
    for (int side = 0; side < 6; ++side) {
        Face face;
        face.first_corner = static_cast<std::uint32_t>(database.corners.size());
        face.corner_count = 4;
        face.colour = options.colour;
        face.object = static_cast<std::uint32_t>(database.objects.size() - 1);
        face.normal = {normals[side][0], normals[side][1], normals[side][2]};
        face.shading = Shading::unshaded;
        for (const std::uint32_t corner : sides[side])
            database.corners.push_back(first_vertex + corner);
        database.faces.push_back(face);
    }
    return cluster_index;
}

ChannelView channel_at(const Vec3d& eye_m, double heading_deg, double pitch_deg, double roll_deg) {
    ChannelView channel;
    channel.eye_m = eye_m;
    channel.attitude = {radians(heading_deg), radians(pitch_deg), radians(roll_deg)};
    return channel;
}

} // namespace linkdig::ig
