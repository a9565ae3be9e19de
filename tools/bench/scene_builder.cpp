#include "tools/bench/scene_builder.h"

#include <array>

namespace linkdig::bench {

SceneBuilder::SceneBuilder(VisualDatabase& database, const std::string& name) : database_(database) {
    database.name = name;
    database.source_files = {"made in code"};
    database.suns = {"world", "ocean"};
}

std::uint16_t SceneBuilder::colour(const std::string& name, Colour code) {
    database_.colours.push_back(code);
    database_.colour_names.push_back(name);
    return static_cast<std::uint16_t>(database_.colours.size() - 1);
}

void SceneBuilder::begin_list(const std::string& name, std::uint32_t sun, Attachment attachment) {
    const auto index = static_cast<std::uint32_t>(database_.lists.size());
    database_.groups.push_back({.number = static_cast<std::int32_t>(index), .root = none});
    Cluster cluster;
    cluster.name = name;
    cluster.group = index;
    cluster.root = leaf_reference(index);
    database_.clusters.push_back(cluster);
    ObjectList list;
    list.name = name;
    list.cluster = index;
    list.attachment = attachment;
    list.sun = sun;
    list.ambient = 0.35F;
    list.diffuse = 0.65F;
    list.root = leaf_reference(index);
    database_.lists.push_back(list);
    Object object;
    object.name = name;
    object.list = index;
    database_.objects.push_back(object);
    database_.run_leaves.push_back({.first_run = index, .run_count = 1});
    FaceRun run;
    run.first_face = static_cast<std::uint32_t>(database_.faces.size());
    run.radius = -1.0F;
    database_.runs.push_back(run);
}

std::uint32_t SceneBuilder::vertex(const Vec4f& position, const Vec3f& normal) {
    database_.vertices.push_back({.position = position, .normal = normal});
    return static_cast<std::uint32_t>(database_.vertices.size() - 1);
}

void SceneBuilder::face(std::span<const std::uint32_t> corners, std::uint16_t colour, Shading shading) {
    const auto at = [&](std::size_t k) { return Vec3f(database_.vertices[corners[k]].position); };
    Face made;
    made.first_corner = static_cast<std::uint32_t>(database_.corners.size());
    made.corner_count = static_cast<std::uint16_t>(corners.size());
    made.colour = colour;
    made.object = static_cast<std::uint32_t>(database_.objects.size() - 1);
    made.normal = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    made.shading = shading;
    database_.corners.insert(database_.corners.end(), corners.begin(), corners.end());
    database_.faces.push_back(made);
    ++database_.runs.back().face_count;
}

void SceneBuilder::box(const Vec3f& from, const Vec3f& to, std::uint16_t colour) {
    std::array<std::uint32_t, 8> v{};
    for (std::size_t k = 0; k < 8; ++k) {
        v[k] = vertex(Vec3f((k & 1U) != 0 ? to.x : from.x, (k & 2U) != 0 ? to.y : from.y,
                            (k & 4U) != 0 ? to.z : from.z));
    }
    static constexpr std::uint8_t sides[5][4] = {
        {4, 5, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
    for (const auto& side : sides)
        face(std::array{v[side[0]], v[side[1]], v[side[2]], v[side[3]]}, colour, Shading::face);
}

void SceneBuilder::rectangle(const Vec2f& from, const Vec2f& to, float height, std::uint16_t colour) {
    const std::array corners{vertex(Vec3f(from.x, from.y, height)), vertex(Vec3f(to.x, from.y, height)),
                             vertex(Vec3f(to.x, to.y, height)), vertex(Vec3f(from.x, to.y, height))};
    face(corners, colour, Shading::face);
}

} // namespace linkdig::bench
