// Each rule of validate(), broken alone, and the words that tell it.

#include "database/format/read.h"
#include "database/format/validate.h"
#include "database/format/write.h"
#include "tests/database/format/sample_database.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace linkdig::database {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

struct Fault {
    const char* told; ///< the whole message
    std::function<void(VisualDatabase&)> make;
};

void expect_told(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) {
        VisualDatabase database = sample_database();
        fault.make(database);
        EXPECT_EQ(validate(database), fault.told);
        // The same fault in a file whose hash fits.
        const ReadResult read = decode_database(encode_database(database));
        EXPECT_FALSE(read.database) << fault.told;
    }
}

TEST(Validate, SampleIsSound) { EXPECT_EQ(validate(sample_database()), ""); }

TEST(Validate, Names) {
    const std::string endless(max_name_bytes + 1, 'x');
    expect_told({
        {"name holds control characters", [](auto& d) { d.name = "a\x1b[2J"; }},
        {"source_files[1] is 4097 bytes long; at most 4096 are allowed",
         [&](auto& d) { d.source_files[1] = endless; }},
        {"objects[2] holds control characters", [](auto& d) { d.objects[2].name = "a\n"; }},
        {"two of suns are named \"ocean\"", [](auto& d) { d.suns[1] = "ocean"; }},
        {"one of lists has no name", [](auto& d) { d.lists[1].name = ""; }},
        {"two of clusters are named \"sea\"", [](auto& d) { d.clusters[2].name = "sea"; }},
        {"two of colour_names are named \"sea\"", [](auto& d) { d.colour_names[1] = "sea"; }},
        {"there are 2 colours, but 1 colour_names", [](auto& d) { d.colour_names.pop_back(); }},
    });
}

TEST(Validate, Owners) {
    expect_told({
        {"slots[0].alternatives is 0; expected 1 to 65535", [](auto& d) { d.slots[0].alternatives = 0; }},
        {"slots[0].alternatives is 65536; expected 1 to 65535",
         [](auto& d) { d.slots[0].alternatives = 65536; }},
        {"groups[1].number is -3 after -3; expected ascending numbers",
         [](auto& d) { d.groups[1].number = -3; }},
        {"clusters[0].group is 2, but there are 2 groups", [](auto& d) { d.clusters[0].group = 2; }},
        {"clusters[0].moving_object is 1, but there are 1 moving_objects",
         [](auto& d) { d.clusters[0].moving_object = 1; }},
        {"clusters[0].moving_object is -2, but there are 1 moving_objects",
         [](auto& d) { d.clusters[0].moving_object = -2; }},
        {"clusters[1].reference_point_m is not finite, or beyond 1e7 m",
         [](auto& d) { d.clusters[1].reference_point_m.y = 1.1e7; }},
        {"clusters[0].half_extent_m is negative, not finite, or beyond 4e7 m",
         [](auto& d) { d.clusters[0].half_extent_m.z = -1; }},
        {"lists[0].cluster is 3, but there are 3 clusters", [](auto& d) { d.lists[0].cluster = 3; }},
        {"lists[0].sun is 2, but there are 2 suns", [](auto& d) { d.lists[0].sun = 2; }},
        {"lists[0].attachment is none of world, body, waterline, eye",
         [](auto& d) { d.lists[0].attachment = static_cast<Attachment>(4); }},
        {"lists[1].added_to is the list itself", [](auto& d) { d.lists[1].added_to = 1; }},
        {"lists[1].ambient is not in 0 to 1", [](auto& d) { d.lists[1].ambient = 1.5F; }},
        {"lists[1].diffuse is not in 0 to 1", [](auto& d) { d.lists[1].diffuse = nan; }},
        {"lists[1].origin_m is not finite, or beyond 1e7 m",
         [](auto& d) { d.lists[1].origin_m.x = std::numeric_limits<double>::infinity(); }},
        {"lists[2].tile is 1, but there are 1 tiles", [](auto& d) { d.lists[2].tile = 1; }},
        {"objects[0].list is 4, but there are 4 lists", [](auto& d) { d.objects[0].list = 4; }},
        {"objects[1].slot is 1, but there are 1 slots", [](auto& d) { d.objects[1].slot = 1; }},
        {"objects[1].alternative is 2, beyond its slot's", [](auto& d) { d.objects[1].alternative = 2; }},
    });
}

TEST(Validate, Geometry) {
    expect_told({
        {"vertices[3].position.w is 0.5; expected 1, or 0 at infinity",
         [](auto& d) { d.vertices[3].position.w = 0.5F; }},
        {"vertices[3].position is not finite, or beyond 1e7 m",
         [](auto& d) { d.vertices[3].position.x = nan; }},
        {"vertices[3].position is not finite, or beyond 1e7 m",
         [](auto& d) { d.vertices[3].position.z = -1.1e7F; }},
        {"vertices[3].position lies at infinity in no direction",
         [](auto& d) { d.vertices[3].position = Vec4f(0); }},
        {"vertices[3].normal is not finite, or longer than 1",
         [](auto& d) { d.vertices[3].normal.x = 0.1F; }},
        {"vertices[3].normal is not finite, or longer than 1",
         [](auto& d) { d.vertices[3].normal.x = infinite; }},
        {"faces[1].corner_count is 2; expected at least 3", [](auto& d) { d.faces[1].corner_count = 2; }},
        {"faces[4].first_corner is 17, but there are 20 corners",
         [](auto& d) { d.faces[4].first_corner = 17; }},
        {"faces[4].first_corner is 4294967295, but there are 20 corners",
         [](auto& d) { d.faces[4].first_corner = 0xffffffffU; }},
        {"faces have 21 corners in all, but there are 20", [](auto& d) { d.faces[0].corner_count = 5; }},
        {"faces[1].colour is 2, but there are 2 colours", [](auto& d) { d.faces[1].colour = 2; }},
        {"faces[1].object is 4, but there are 4 objects", [](auto& d) { d.faces[1].object = 4; }},
        {"faces[1].file is 2, but there are 2 source_files", [](auto& d) { d.faces[1].file = 2; }},
        {"faces[1].shading is none of none, face, vertex",
         [](auto& d) { d.faces[1].shading = static_cast<Shading>(3); }},
        {"faces[1].two_sided is neither 0 nor 1", [](auto& d) { d.faces[1].two_sided = 2; }},
        {"faces[1].opacity is not in 1 to 256", [](auto& d) { d.faces[1].opacity = 0; }},
        {"faces[1].opacity is not in 1 to 256", [](auto& d) { d.faces[1].opacity = 257; }},
        {"faces[1].normal is not a unit vector", [](auto& d) { d.faces[1].normal.z = 1.01F; }},
        {"faces[1].normal is not a unit vector", [](auto& d) { d.faces[1].normal.z = nan; }},
        {"corners[5] is 20, but there are 20 vertices", [](auto& d) { d.corners[5] = 20; }},
    });
}

TEST(Validate, RunsAndPlanes) {
    expect_told({
        {"runs[4].first_face is 5, but there are 5 faces", [](auto& d) { d.runs[4].first_face = 5; }},
        {"runs[2].slot is 1, but there are 1 slots", [](auto& d) { d.runs[2].slot = 1; }},
        {"runs[2].alternative is 2, beyond its slot's", [](auto& d) { d.runs[2].alternative = 2; }},
        {"runs[2].centre is not finite, or beyond 1e7 m", [](auto& d) { d.runs[2].centre.x = infinite; }},
        {"runs[2].radius is not finite, or beyond 4e7 m", [](auto& d) { d.runs[2].radius = -infinite; }},
        {"planes[0].normal is neither a unit vector nor zero", [](auto& d) { d.planes[0].normal.z = 0.5F; }},
        {"planes[0].distance is not finite, or beyond 4e7 m", [](auto& d) { d.planes[0].distance = nan; }},
        {"planes[2].waterline is neither 0 nor 1", [](auto& d) { d.planes[2].waterline = 2; }},
    });
}

TEST(Validate, Lights) {
    expect_told({
        {"lights[1].position is not finite, or beyond 1e7 m", [](auto& d) { d.lights[1].position.y = nan; }},
        {"lights[0].direction is not a unit vector", [](auto& d) { d.lights[0].direction.x = 0.5F; }},
        {"lights[0].side is not a unit vector",
         [](auto& d) {
             d.lights[0].side = {0, 0, 0};
         }},
        {"lights[0].across or upward is not in 0 to 20000", [](auto& d) { d.lights[0].upward = infinite; }},
        {"lights[0].intensity is not in 0 to 1000", [](auto& d) { d.lights[0].intensity = nan; }},
        {"lights[0].size_m is negative, not finite, or beyond 1e7 m",
         [](auto& d) { d.lights[0].size_m = -1; }},
        {"lights[0].full_to_m is negative, not finite, or beyond 1e7 m",
         [](auto& d) { d.lights[0].full_to_m = infinite; }},
        {"lights[0].flash_hz is not in 0 to 1000", [](auto& d) { d.lights[0].flash_hz = -1; }},
        {"lights[0].duty or phase is not in 0 to 1", [](auto& d) { d.lights[0].phase = 1.5F; }},
        {"lights[0].beam is none of all_round, one_way, two_way",
         [](auto& d) { d.lights[0].beam = static_cast<LightBeam>(3); }},
        {"lights[0].fall_off is none of flat, linear, square",
         [](auto& d) { d.lights[0].fall_off = static_cast<FallOff>(3); }},
        {"lights[1].colour is 2, but there are 2 colours", [](auto& d) { d.lights[1].back_colour = 2; }},
        {"lights[1].object is 4, but there are 4 objects", [](auto& d) { d.lights[1].object = 4; }},
        {"lights[1].file is 2, but there are 2 source_files", [](auto& d) { d.lights[1].file = 2; }},
        {"runs[0].first_light is 1, but there are 2 lights", [](auto& d) { d.runs[0].first_light = 1; }},
        {"lights[0].place is 2; expected 0 to 1, in ascending order (in the tree of lists[0])",
         [](auto& d) { d.lights[0].place = 2; }},
        {"lights[1].place is 0; expected 1 to 1, in ascending order (in the tree of lists[0])",
         [](auto& d) { d.lights[0].place = d.lights[1].place, d.lights[1].place = 0; }},
        {"lights[1] stands in no run", [](auto& d) { d.runs[0].light_count = 1; }},
        {"lights[0] stands in two runs (in the tree of lists[0])",
         [](auto& d) { d.runs[1].light_count = 1; }},
        {"lights[0] belongs to lists[3] (in the tree of lists[0])", [](auto& d) { d.lights[0].object = 3; }},
    });
}

TEST(Validate, Tiles) {
    expect_told({
        {"tiles[0].period is 3; expected a power of two from 2 to 1024",
         [](auto& d) { d.tiles[0].period = 3; }},
        {"tiles[0].period is 2048; expected a power of two from 2 to 1024",
         [](auto& d) { d.tiles[0].period = 2048; }},
        {"tiles[0].rings is 0; expected 1 to 16", [](auto& d) { d.tiles[0].rings = 0; }},
        {"tiles[0].rings is 17; expected 1 to 16", [](auto& d) { d.tiles[0].rings = 17; }},
        {"tiles[0].fine_levels is 7; expected 0 to 6", [](auto& d) { d.tiles[0].fine_levels = 7; }},
        {"tiles[0].half_width is 10; expected a multiple of 4 from 8 to 256",
         [](auto& d) { d.tiles[0].half_width = 10; }},
        {"tiles[0].half_width is 260; expected a multiple of 4 from 8 to 256",
         [](auto& d) { d.tiles[0].half_width = 260; }},
        {"tiles[0].cell_m is 0; expected 0.01 at least, and rings that reach no further than 1000000000 m",
         [](auto& d) { d.tiles[0].cell_m = 0; }},
        {"tiles[0].cell_m is 0.009; expected 0.01 at least, and rings that reach no further than 1000000000 "
         "m",
         [](auto& d) { d.tiles[0].cell_m = 0.009; }},
        {"tiles[0].cell_m is 20000000; expected 0.01 at least, and rings that reach no further than "
         "1000000000 "
         "m",
         [](auto& d) { d.tiles[0].cell_m = 2e7; }},
        {"tiles[0].vertical_angle_rad is 1.6; expected 0 to pi/2",
         [](auto& d) { d.tiles[0].vertical_angle_rad = 1.6F; }},
        {"tiles[0].first_normal is 5, but there are 8 tile_normals",
         [](auto& d) { d.tiles[0].first_normal = 5; }},
        {"tiles[0].first_face_normal is 4294967295, but there are 8 tile_normals",
         [](auto& d) { d.tiles[0].first_face_normal = 0xffffffffU; }},
        {"tiles[0].colour is 2, but there are 2 colours", [](auto& d) { d.tiles[0].colour = 2; }},
        {"tiles[0].file is 2, but there are 2 source_files", [](auto& d) { d.tiles[0].file = 2; }},
        {"tiles[0].list is 4, but there are 4 lists", [](auto& d) { d.tiles[0].list = 4; }},
        {"tiles[0].list is 1, whose own tile is -1", [](auto& d) { d.tiles[0].list = 1; }},
        {"tiles[0].list is 2, which has faces of its own",
         [](auto& d) { d.lists[2].root = leaf_reference(0); }},
        {"lists[1].tile is 0, which belongs to another list", [](auto& d) { d.lists[1].tile = 0; }},
        {"tile_normals[6] is longer than a unit vector", [](auto& d) { d.tile_normals[6].y = 0.1F; }},
        {"tiles[0].first_face_normal is 5, but there are 8 tile_normals", // two tables with coarser ones
         [](auto& d) { d.tiles[0].first_face_normal = 5; }},
        {"tiles[0].first_normal is 4, but there are 8 tile_normals", // one such table
         [](auto& d) { d.tiles[0].first_normal = 4; }},
        {"tiles make 4456448 squares a frame; at most 4000000 are allowed",
         [](auto& d) {
             d.tiles[0].half_width = 256;
             d.tiles[0].rings = 15;
             d.tiles[0].cell_m = 1;
         }},
    });
}

TEST(Validate, Trees) {
    expect_told({
        {"a reference to plane 4, but there are 4 planes (in the tree of lists[0])",
         [](auto& d) { d.lists[0].root = 4; }},
        {"planes[0] is referred to twice (in the tree of lists[0])", [](auto& d) { d.planes[0].on = 0; }},
        {"planes[2] is referred to twice (in the tree of lists[0])", [](auto& d) { d.planes[0].on = 2; }},
        {"a reference to leaf 5, but there are 5 run_leaves (in the tree of lists[0])",
         [](auto& d) { d.planes[0].on = leaf_reference(5); }},
        {"a reference to leaf 2147483646, but there are 5 run_leaves (in the tree of lists[0])",
         [](auto& d) { d.planes[0].on = std::numeric_limits<std::int32_t>::min(); }},
        {"run_leaves[0] is referred to twice (in the tree of lists[0])",
         [](auto& d) { d.planes[0].on = leaf_reference(0); }},
        {"planes[0].waterline is set, but only a cluster's planes can float (in the tree of lists[0])",
         [](auto& d) { d.planes[0].waterline = 1; }},
        {"planes[3].waterline is set, but only a cluster's planes can float (in the tree of groups[1])",
         [](auto& d) { d.planes[3].waterline = 1; }},
        {"planes[0] stands in no tree",
         [](auto& d) {
             d.lists[0].root = leaf_reference(0);
             d.planes[0].back = none;
             d.planes[1].on = none;
         }},
        {"run_leaves[1] stands in no list's tree", [](auto& d) { d.planes[0].back = none; }},
        {"a reference to cluster 3, but there are 3 clusters (in the tree of groups[1])",
         [](auto& d) { d.planes[3].on = leaf_reference(3); }},
        {"clusters[1] is referred to twice (in the tree of groups[1])",
         [](auto& d) { d.planes[3].back = leaf_reference(1); }},
        {"clusters[2] belongs to groups[0] (in the tree of groups[1])",
         [](auto& d) { d.clusters[2].group = 0; }},
        {"clusters[0] moves; expected a static one (in the tree of groups[0])",
         [](auto& d) { d.groups[0].root = leaf_reference(0); }},
        {"a reference to list 4, but there are 4 lists (in the tree of clusters[0])",
         [](auto& d) { d.planes[2].on = leaf_reference(4); }},
        {"lists[0] is referred to twice (in the tree of clusters[0])",
         [](auto& d) { d.planes[2].back = leaf_reference(0); }},
        {"lists[2] belongs to clusters[1] (in the tree of clusters[0])",
         [](auto& d) { d.planes[2].back = leaf_reference(2); }},
    });
}

TEST(Validate, EachFaceStandsInOneRunAndOneLeaf) {
    expect_told({
        {"run_leaves[4].first_run is 5, but there are 5 runs (in the tree of lists[3])",
         [](auto& d) { d.run_leaves[4].first_run = 5; }},
        {"runs[0] stands in two leaves (in the tree of lists[0])",
         [](auto& d) { d.run_leaves[1].first_run = 0; }},
        {"runs[1] stands in no leaf", [](auto& d) { d.run_leaves[1].run_count = 0; }},
        {"faces[1] stands in two runs (in the tree of lists[0])", [](auto& d) { d.runs[0].face_count = 2; }},
        {"faces[3] stands in no run", [](auto& d) { d.runs[3].face_count = 0; }},
        {"faces[0] belongs to lists[3] (in the tree of lists[0])", [](auto& d) { d.faces[0].object = 3; }},
        {"runs[0] has another slot or alternative than the object of faces[0] (in the tree of lists[0])",
         [](auto& d) { d.runs[0].slot = 0; }},
        {"runs[3] has another slot or alternative than the object of faces[3] (in the tree of lists[1])",
         [](auto& d) { d.runs[3].alternative = 0; }},
    });
}

// The model alone has these members; the file does not store them.
TEST(Validate, ReservedMembersAreZero) {
    VisualDatabase database = sample_database();
    database.colours[1].reserved = 1;
    EXPECT_EQ(validate(database), "colours[1].reserved is not zero");
    database = sample_database();
    database.objects[1].reserved = 1;
    EXPECT_EQ(validate(database), "objects[1].reserved is not zero");
    database = sample_database();
    database.planes[1].reserved[2] = 1;
    EXPECT_EQ(validate(database), "planes[1].reserved is not zero");
}

/// A chain of `depth` planes in the place of the ship's tree.
VisualDatabase chain(std::int32_t depth) {
    VisualDatabase database = sample_database();
    const auto first = static_cast<std::int32_t>(database.planes.size());
    for (std::int32_t i = 1; i < depth; ++i)
        database.planes.push_back(
            {.normal = {0, 0, 0}, .distance = -1, .back = i + 1 < depth ? first + i : none});
    database.planes[2].on = first;
    return database;
}

// The machine may walk trees recursively.
TEST(Validate, DeepTrees) {
    EXPECT_EQ(validate(chain(max_tree_depth)), "");
    EXPECT_EQ(validate(chain(max_tree_depth + 1)),
              "the tree is more than 4096 planes deep (in the tree of clusters[0])");
}

TEST(Validate, ToleranceOfUnitVectors) {
    VisualDatabase database = sample_database();
    database.faces[0].normal = {0, 0, 1.0009F};
    database.vertices[0].normal = {0, 0, 1.0009F};
    database.vertices[1].normal = {0, 0, 0.1F}; // a mean of unit normals
    EXPECT_EQ(validate(database), "");
    database.faces[0].normal = {0, 0, 1.0011F};
    EXPECT_EQ(validate(database), "faces[0].normal is not a unit vector");
}

TEST(Validate, ColoursOfCorners) {
    expect_told({
        {"faces[4].coloured is neither 0 nor 1", [](auto& d) { d.faces[4].coloured = 2; }},
        {"faces[4].coloured is set, but there are no corner_colours",
         [](auto& d) { d.corner_colours.clear(); }},
        {"there are 20 corners, but 19 corner_colours", [](auto& d) { d.corner_colours.pop_back(); }},
    });
}

TEST(Validate, Details) {
    expect_told({
        {"one of details has no name", [](auto& d) { d.details[0].name = ""; }},
        {"details[1].cluster is 3, but there are 3 clusters", [](auto& d) { d.details[1].cluster = 3; }},
        {"details[0].reference_m is not finite, or beyond 1e7 m",
         [](auto& d) { d.details[0].reference_m.z = std::numeric_limits<double>::quiet_NaN(); }},
        {"details[0].hysteresis_m or blend_m is negative, not finite, or beyond 1e7 m",
         [](auto& d) { d.details[0].blend_m = infinite; }},
        {"details[0].hysteresis_m and blend_m are both set", [](auto& d) { d.details[0].hysteresis_m = 1; }},
        {"details[1].added is neither 0 nor 1", [](auto& d) { d.details[1].added = 2; }},
        {"details[0].levels is 0; expected 1 to 16", [](auto& d) { d.details[0].levels = 0; }},
        {"details[1].first_level is not where the levels before it end, or its levels pass the end",
         [](auto& d) { d.details[1].levels = 3; }},
        {"details[1].first_level is not where the levels before it end, or its levels pass the end",
         [](auto& d) { d.details[1].first_level = 0; }},
        {"there are 4 detail_levels, but details own 3",
         [](auto& d) {
             d.detail_levels.push_back({1, 900});
         }},
        {"detail_levels[1].detail is 0; expected its owner, 1",
         [](auto& d) { d.detail_levels[1].detail = 0; }},
        {"detail_levels[2].to_m leaves no range to the level",
         [](auto& d) { d.detail_levels[2].to_m = 100; }},
        {"detail_levels[0].to_m leaves no range to the level",
         [](auto& d) { d.detail_levels[0].to_m = nan; }},
        {"detail_levels[2].to_m is closer to the level before than blend or hysteresis reach",
         [](auto& d) { d.detail_levels[2].to_m = 104; }},
        {"objects[3].level is 3, but there are 3 detail_levels", [](auto& d) { d.objects[3].level = 3; }},
        {"runs[4].level is -2, but there are 3 detail_levels", [](auto& d) { d.runs[4].level = -2; }},
        {"runs[4] has another level of detail than the object of faces[4] (in the tree of lists[3])",
         [](auto& d) { d.runs[4].level = 1; }},
    });
}

} // namespace

} // namespace linkdig::database
