#include "tests/database/format/sample_database.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

namespace linkdig::database {

namespace {

/// A unit square facing up at height `z`, of vertices of its own, as a run and leaf of its own; the leaf's
/// reference.
std::int32_t add_square(VisualDatabase& d, std::uint32_t object, float z) {
    const auto vertex = static_cast<std::uint32_t>(d.vertices.size());
    for (const Vec2f& at : {Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1), Vec2f(0, 1)})
        d.vertices.push_back({{at.x, at.y, z, 1}, {0, 0, 1}});
    const auto corner = static_cast<std::uint32_t>(d.corners.size());
    for (std::uint32_t i = 0; i < 4; ++i)
        d.corners.push_back(vertex + i);
    const auto face = static_cast<std::uint32_t>(d.faces.size());
    d.faces.push_back({.first_corner = corner,
                       .corner_count = 4,
                       .colour = 1,
                       .object = object,
                       .shading = Shading::vertex,
                       .two_sided = 1,
                       .file = 1,
                       .line = 42});
    const Object& owner = d.objects[object];
    d.runs.push_back({.first_face = face,
                      .face_count = 1,
                      .slot = owner.slot,
                      .alternative = owner.alternative,
                      .level = owner.level,
                      .centre = {0.5F, 0.5F, z},
                      .radius = 0.75F});
    d.run_leaves.push_back({static_cast<std::uint32_t>(d.runs.size() - 1), 1});
    return leaf_reference(static_cast<std::uint32_t>(d.run_leaves.size() - 1));
}

void add_names(VisualDatabase& d) {
    d.name = "sample";
    d.source_files = {"sample.toml", "ship.toml"};
    d.colours = {{10, 20, 30, 0}, {255, 0, 128, 0}};
    d.colour_names = {"sea", "deck"};
    d.suns = {"ocean", "fixed"};
    d.moving_objects = {"lph"};
    d.slots = {{"wake", 2}};
    d.groups = {{-3, none}, {7, none}};
}

/// A moving ship of two lists: hull (two squares parted by a plane) and wake (a slot of two alternatives).
void add_ship(VisualDatabase& d) {
    d.lists.push_back({.name = "hull",
                       .cluster = 0,
                       .number = 1,
                       .attachment = Attachment::body,
                       .sun = 1,
                       .ambient = 0.25F,
                       .diffuse = 0.75F,
                       .origin_m = {1.5, -2.25, 1e6 + 0.125}});
    d.lists.push_back(
        {.name = "wake", .cluster = 0, .number = 1, .attachment = Attachment::waterline, .sun = 0});
    d.objects.push_back({.name = "deck", .list = 0});
    d.objects.push_back({.name = "wake.1", .list = 1, .slot = 0, .alternative = 0});
    d.objects.push_back({.name = "wake.2", .list = 1, .slot = 0, .alternative = 1});
    d.planes.push_back({.normal = {0, 0, 1}, .distance = 0.5F});
    d.planes[0].front = add_square(d, 0, 1);
    d.planes[0].back = add_square(d, 0, 0);
    d.lists[0].root = 0;
    for (std::uint32_t k = 0; k < 2; ++k) // before and behind the deck's first square
        d.lights.push_back({.position = {0.25F, 0.5F, 1.5F - static_cast<float>(k)},
                            .place = k,
                            .direction = {0, 0.6F, 0.8F},
                            .across = 3.5F,
                            .side = {1, 0, 0},
                            .upward = 0.25F,
                            .intensity = 2.5F,
                            .size_m = 0.125F,
                            .full_to_m = 750,
                            .flash_hz = 1.5F,
                            .duty = 0.25F,
                            .phase = 0.75F,
                            .object = 0,
                            .line = 43,
                            .file = 1,
                            .colour = 1,
                            .back_colour = 0,
                            .beam = LightBeam::two_way,
                            .fall_off = FallOff::square});
    d.runs[0].light_count = 2;
    d.planes.push_back({.normal = {0, 0, 0}, .distance = -1}); // a chain: fixed order
    d.planes[1].front = add_square(d, 1, 0);
    d.planes[1].back = add_square(d, 2, 0);
    d.lists[1].root = 1;
    d.planes.push_back({.normal = {0, 1, 0},
                        .distance = 0,
                        .front = leaf_reference(0),
                        .on = none,
                        .back = leaf_reference(1),
                        .waterline = 1});
    d.clusters.push_back({.name = "ship",
                          .group = 0,
                          .moving_object = 0,
                          .reference_point_m = {0.5, 0, 2},
                          .half_extent_m = {90, 15, 20},
                          .root = 2});
}

/// Two static clusters parted by a plane: a sea of one tile, and ground with a vertex at infinity.
void add_surroundings(VisualDatabase& d) {
    d.clusters.push_back({.name = "sea", .group = 1, .root = leaf_reference(2)});
    d.clusters.push_back({.name = "ground", .group = 1, .root = leaf_reference(3)});
    d.lists.push_back({.name = "sea", .cluster = 1, .tile = 0});
    d.lists.push_back({.name = "ground", .cluster = 2});
    d.details.push_back(
        {.name = "runway", .cluster = 2, .reference_m = {0.5, 0.5, 0}, .blend_m = 50, .levels = 1});
    d.details.push_back(
        {.name = "ship", .cluster = 0, .hysteresis_m = 5, .added = 1, .first_level = 1, .levels = 2});
    d.detail_levels = {{0, 500}, {1, 100}, {1, 250}};
    d.objects.push_back({.name = "runway", .list = 3, .level = 0});
    d.lists[3].root = add_square(d, 3, 0);
    d.vertices.back().position = {1, 2, 0, 0};
    d.runs.back().radius = -1;
    d.planes.push_back(
        {.normal = {0.6F, 0.8F, 0}, .distance = 1000, .front = leaf_reference(1), .back = leaf_reference(2)});
    d.groups[1].root = 3;
    d.tiles.push_back({.list = 2,
                       .period = 2,
                       .cell_m = 12.5,
                       .rings = 3,
                       .fine_levels = 1,
                       .half_width = 8,
                       .vertical_angle_rad = 1.25F,
                       .colour = 0,
                       .file = 0,
                       .line = 7,
                       .first_normal = 0,
                       .first_face_normal = 4});
    for (int i = 0; i < 8; ++i)
        d.tile_normals.emplace_back(i % 2 == 0 ? 0.6F : -0.6F, 0.0F, 0.8F);
}

} // namespace

VisualDatabase sample_database() {
    VisualDatabase d;
    add_names(d);
    add_ship(d);
    add_surroundings(d);
    for (std::size_t i = 0; i < d.corners.size(); ++i)
        d.corner_colours.push_back({static_cast<std::uint8_t>(i), 20, 200, 0});
    d.faces[4].coloured = 1;
    return d;
}

TestFolder::TestFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ =
        std::filesystem::path(testing::TempDir()) / (std::string("linkdig-") + test->test_suite_name() + "." +
                                                     test->name() + "-" + std::to_string(::getpid()));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
}

TestFolder::~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TestFolder::names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        found.push_back(entry.path().filename().string());
    std::ranges::sort(found);
    return found;
}

} // namespace linkdig::database
