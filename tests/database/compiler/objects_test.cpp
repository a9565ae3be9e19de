/// Objects as authored: normals, mirrors, directions, diagonals, sequences, includes, and the database around
/// them.

#include "tests/database/compiler/authored.h"

#include "database/format/write.h"
#include "database/model/tile_tables.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace linkdig::database {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

VisualDatabase compiled(const std::string& objects) {
    const CompileResult result = compile_text(scene(objects));
    EXPECT_TRUE(result.database) << messages(result);
    return result.database.value_or(VisualDatabase());
}

const Vertex& vertex(const VisualDatabase& d, const Face& face, std::uint32_t corner) {
    return d.vertices[d.corners[face.first_corner + corner]];
}

const std::string head = "[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n";

TEST(Objects, VertexNormalsAreTheMedianOfTheAdjacentFaces) {
    const VisualDatabase d = compiled(
        head + "shading = \"vertex\"\n[object.vertices_m]\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [1, 1, 0]\nd = "
               "[0, 1, 0]\n"
               "e = [1, 0, -1]\nf = [1, 1, -1]\n[[object.face]]\ncorners = [\"a\", \"b\", \"c\", \"d\"]\n"
               "[[object.face]]\ncorners = [\"b\", \"e\", \"f\", \"c\"]\n");
    ASSERT_EQ(d.faces.size(), 2U);
    const float half = std::sqrt(0.5F);
    for (const Face& face : d.faces)
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Vertex& v = vertex(d, face, i);
            const Vec3f expected = v.position.x == 0   ? Vec3f(0, 0, 1)
                                   : v.position.z == 0 ? Vec3f(half, 0, half)
                                                       : Vec3f(1, 0, 0);
            EXPECT_NEAR(glm::distance(v.normal, expected), 0, 1e-6);
        }
}

TEST(Objects, NormalsAsGivenAreUnitVectors) {
    const VisualDatabase d =
        compiled(head + "shading = \"vertex\"\nvertices_m = { a = [0, 0, 0], b = [1, 0, 0], c = [0, 1, 0] }\n"
                        "normals = { b = [0, 3, 4] }\n[[object.face]]\ncorners = [\"a\", \"b\", \"c\"]\n");
    EXPECT_EQ(vertex(d, d.faces[0], 0).normal, Vec3f(0, 0, 1));
    EXPECT_NEAR(glm::distance(vertex(d, d.faces[0], 1).normal, Vec3f(0, 0.6F, 0.8F)), 0, 1e-6);
}

TEST(Objects, AMirroredObjectIsClosedAndFacesOutward) {
    // Port half of a box, its inner side left out: with its image a closed box of 2 x 4 x 2.
    const VisualDatabase d = compiled(head + "mirror = \"y\"\nshading = \"vertex\"\n[[object.box]]\nfrom_m = "
                                             "[-1, 0, -1]\nto_m = [1, 2, 1]\nomit = [\"starboard\"]\n");
    ASSERT_EQ(d.faces.size(), 10U);
    EXPECT_EQ(d.objects.size(), 1U);
    EXPECT_EQ(d.vertices.size(), 12U) << "the vertices on the mirror are shared";
    for (const Face& face : d.faces) {
        Vec3d centre(0.0);
        for (std::uint32_t i = 0; i < 4; ++i)
            centre += 0.25 * Vec3d(vertex(d, face, i).position);
        const Vec3d a(vertex(d, face, 0).position), b(vertex(d, face, 1).position),
            c(vertex(d, face, 2).position);
        const Vec3d normal = glm::normalize(glm::cross(b - a, c - a));
        EXPECT_NEAR(glm::distance(normal, Vec3d(face.normal)), 0, 1e-6);
        EXPECT_GT(glm::dot(normal, centre), 0.5);
    }
}

TEST(Objects, TheDiagonalStartsTheFan) {
    const auto first = [](const std::string& diagonal) {
        const VisualDatabase d =
            compiled(head +
                     "vertices_m = { a = [0, 0, 0], b = [1, 0, 0], c = [1, 1, 0], d = [0, 1, 0] }\n"
                     "[[object.face]]\ncorners = [\"a\", \"b\", \"c\", \"d\"]\n" +
                     diagonal);
        return Vec3f(vertex(d, d.faces[0], 0).position);
    };
    EXPECT_EQ(first(""), Vec3f(0, 0, 0));
    EXPECT_EQ(first("diagonal = [\"b\", \"d\"]\n"), Vec3f(1, 0, 0));
    EXPECT_EQ(first("diagonal = \"d\"\n"), Vec3f(0, 1, 0));
}

TEST(Objects, FacesReachInfinity) {
    const VisualDatabase d = compiled(head + "vertices_m = { a = [0, -10, 0], b = [0, 10, 0] }\n"
                                             "directions = { l = [5, 5, 0], r = [1, -1, 0] }\n"
                                             "[[object.face]]\ncorners = [\"a\", \"r\", \"l\", \"b\"]\n");
    ASSERT_EQ(d.faces.size(), 1U);
    EXPECT_EQ(d.faces[0].normal, Vec3f(0, 0, 1));
    EXPECT_EQ(vertex(d, d.faces[0], 1).position.w, 0.0F);
    EXPECT_NEAR(vertex(d, d.faces[0], 2).position.x, std::sqrt(0.5), 1e-6);
    EXPECT_LT(d.runs[0].radius, 0) << "never culled";
    EXPECT_THAT(
        messages(compile_text(scene(head + "vertices_m = { a = [0, -10, 0], b = [0, 10, 0] }\ndirections = { "
                                           "l = [5, 5, 1], r = [1, -1, 0] }\n"
                                           "[[object.face]]\ncorners = [\"a\", \"r\", \"l\", \"b\"]\n"))),
        HasSubstr("is not planar"));
}

TEST(Objects, SkyFacesLieBehindEverything) {
    const VisualDatabase d =
        compiled(head + "directions = { a = [1, -1, 0], b = [1, 1, 0], c = [1, 1, 2], d = [1, -1, 2] }\n"
                        "[[object.face]]\ncorners = [\"b\", \"a\", \"d\", \"c\"]\n"
                        "[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, 1]\n");
    ASSERT_EQ(d.faces.size(), 7U);
    EXPECT_EQ(d.run_leaves.size(), 1U);
    EXPECT_LT(d.faces.back().normal.x, -0.5F) << "its normal points at the eye";
    EXPECT_THAT(
        messages(compile_text(scene(head + "directions = { a = [1, -1, 0], b = [1, 1, 0], c = [1, 1, 2] "
                                           "}\n[[object.face]]\ncorners = [\"a\", \"b\", \"c\"]\n"))),
        HasSubstr("counter-clockwise seen from the front"));
}

const std::string sequence = "[[slot]]\nname = \"wake\"\nalternatives = 5\n[[sequence]]\nname = \"w\"\nlist "
                             "= \"list\"\nslot = \"wake\"\ncolour = \"grey\"\n";

TEST(Sequences, InterpolateBetweenTheirKeys) {
    const std::string keys = "[[sequence.key]]\nframe = 1\ncorners_m = [[0, 1, 0], [1, 1, 0], [1, 1, 1]]\n"
                             "[[sequence.key]]\nframe = 3\ncorners_m = [[0, 1, 0], [3, 1, 0], [3, 1, 3]]\n"
                             "[[sequence.key]]\nframe = 5\ncorners_m = [[0, 1, 0], [1, 1, 0], [1, 1, 1]]\n";
    const VisualDatabase d = compiled(sequence + keys);
    ASSERT_EQ(d.faces.size(), 5U);
    ASSERT_EQ(d.runs.size(), 5U);
    const float widths[] = {1, 2, 3, 2, 1};
    for (std::uint32_t i = 0; i < 5; ++i) {
        EXPECT_EQ(d.runs[i].alternative, i);
        EXPECT_EQ(d.runs[i].slot, 0);
        const Face& face = d.faces[d.runs[i].first_face];
        EXPECT_EQ(vertex(d, face, 1).position.x, widths[i]);
        EXPECT_EQ(face.two_sided, 1);
        EXPECT_EQ(d.objects[face.object].name, fmt::format("w.{}", i + 1));
        EXPECT_EQ(d.objects[face.object].alternative, i);
    }
    const VisualDatabase mirrored = compiled(sequence + "mirror = \"y\"\n" + keys);
    for (const Vertex& each : mirrored.vertices)
        EXPECT_EQ(each.position.y, -1.0F);
    EXPECT_EQ(mirrored.faces[0].normal, Vec3f(0, -d.faces[0].normal.y, 0));
}

TEST(Sequences, TellOfKeysThatDoNotFit) {
    const auto said = [](const std::string& keys) { return messages(compile_text(scene(sequence + keys))); };
    const auto key = [](int frame, const char* corners = "[[0, 0, 0], [1, 0, 0], [1, 0, 1]]") {
        return fmt::format("[[sequence.key]]\nframe = {}\ncorners_m = {}\n", frame, corners);
    };
    EXPECT_THAT(said(key(1) + key(4)), HasSubstr("do not reach from 1 to 5"));
    EXPECT_THAT(said(key(1) + key(5) + key(3)),
                HasSubstr("the key frame 3 follows 5; expected ascending frames"));
    EXPECT_THAT(said(key(1) + key(6)), HasSubstr("\"frame\" is 6; expected 1 to 5"));
    EXPECT_THAT(said(key(1) + key(5, "[[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]]")),
                HasSubstr("has 4 corners and the first one 3"));
    EXPECT_THAT(said(key(1) + key(5, "[[0, 0, 0], [1, 0, 0]]")), HasSubstr("has 2 corners; expected 3"));
}

TEST(Objects, OpacityIsAFaceStyle) {
    const std::string smoke =
        "[[object]]\nname = \"smoke\"\nlist = \"list\"\ncolour = \"grey\"\nopacity = 0.25\n"
        "vertices_m = {a = [0, 0, 0], b = [1, 0, 0], c = [1, 1, 0], d = [5, 0, 0], e = [6, 0, 0], f = [6, 1, "
        "0]}\n"
        "[[object.face]]\ncorners = [\"a\", \"b\", \"c\"]\n"
        "[[object.face]]\ncorners = [\"d\", \"e\", \"f\"]\nopacity = 1.0\n";
    const VisualDatabase d = compiled(smoke);
    ASSERT_EQ(d.faces.size(), 2U);
    EXPECT_EQ(d.faces[0].opacity, 64);
    EXPECT_EQ(d.faces[1].opacity, 256);
    std::string nothing = smoke;
    nothing.replace(nothing.find("0.25"), 4, "0.0");
    EXPECT_THAT(messages(compile_text(scene(nothing))), HasSubstr("\"opacity\""));
}

TEST(Lists, AreAddedToListsThatStandLater) {
    const std::string lists =
        "[[object_list]]\nname = \"wake\"\ncluster = \"cluster\"\nsun = \"sun\"\npriority = -1\n"
        "added_to = \"water\"\n[[object_list]]\nname = \"water\"\ncluster = \"cluster\"\nsun = \"sun\"\n"
        "priority = 7\n";
    const VisualDatabase d = compiled(lists);
    const auto number_of = [&](std::string_view name) {
        std::size_t k = 0;
        while (k < d.lists.size() && d.lists[k].name != name)
            ++k;
        return k;
    };
    ASSERT_LT(number_of("water"), d.lists.size());
    EXPECT_EQ(d.lists[number_of("wake")].added_to, static_cast<std::int32_t>(number_of("water")));
    EXPECT_EQ(d.lists[number_of("water")].added_to, none);
    std::string wrong = lists;
    wrong.replace(wrong.find("added_to = \"water\""), 18, "added_to = \"watre\"");
    EXPECT_THAT(messages(compile_text(scene(wrong))),
                HasSubstr("no object list is named \"watre\"; did you mean \"water\"?"));
    wrong = lists;
    wrong.replace(wrong.find("added_to = \"water\""), 18, "added_to = \"wake\" ");
    EXPECT_THAT(messages(compile_text(scene(wrong))), HasSubstr("a list is added to itself"));
}

TEST(Clusters, AreBoxedByTheirContents) {
    const VisualDatabase d = compiled(head + "[[object.box]]\nfrom_m = [0, -2, 1]\nto_m = [10, 2, 3]\n");
    EXPECT_EQ(d.clusters[0].reference_point_m, Vec3d(5, 0, 2));
    EXPECT_EQ(d.clusters[0].half_extent_m, Vec3f(5, 2, 1));
}

TEST(Tiles, HoldTheirTablesOfNormals) {
    const VisualDatabase d = compiled(
        "[[tile]]\nlist = \"list\"\nperiod = 16\ncell_m = 50\nrings = 8\nfine_levels = 2\nhalf_width = 16\n"
        "vertical_angle_deg = 60\ncolour = \"grey\"\nseed = 1\n");
    ASSERT_EQ(d.tiles.size(), 1U);
    EXPECT_EQ(d.lists[0].tile, 0);
    EXPECT_EQ(d.tile_normals.size(), 512U);
    EXPECT_EQ(d.tiles[0].first_face_normal, 256U);
    EXPECT_FALSE(has_coarser_tables(d.tiles[0]));
    EXPECT_NEAR(d.tile_normals[300].z, std::sin(3.14159265358979 / 3), 1e-6);
    EXPECT_EQ(d.objects.size(), 1U) << "whose faces the tile's are";
}

const std::string tile_head =
    "[[tile]]\nlist = \"list\"\nperiod = 16\ncell_m = 8\nrings = 3\nfine_levels = 1\n"
    "half_width = 8\ncolour = \"grey\"\n";

TEST(Tiles, OfWavesAndLevelsHaveCoarserTables) {
    const VisualDatabase waves =
        compiled(tile_head + "vertical_angle_deg = 60\npattern = \"two_waves\"\nfirst_wavelength_m = 64\n"
                             "second_wavelength_m = 64\nbetween_deg = 90\ntable_size = 32\n");
    EXPECT_EQ(waves.tile_normals.size(), 2U * (256 + 64 + 16 + 4 + 1));
    EXPECT_TRUE(has_coarser_tables(waves.tiles[0]));
    EXPECT_FALSE(is_face_shaded(waves.tiles[0]));
    const VisualDatabase swell =
        compiled(tile_head + "vertical_angle_deg = 60\npattern = \"sine\"\nwavelength_ft = 105\n");
    EXPECT_NEAR(swell.tile_normals[1].y, 0.5, 1e-6) << "a quarter of a wave further, 32 m being four squares";
    const VisualDatabase levels =
        compiled(tile_head + "pattern = \"levels\"\nshading = \"face\"\nlevels = [[1, 0.5], [0.25, 0]]\n");
    EXPECT_TRUE(is_face_shaded(levels.tiles[0]));
    EXPECT_EQ(levels.tile_normals.size(), 341U) << "squares have no vertex normals then";
    const std::uint32_t first = levels.tiles[0].first_face_normal;
    EXPECT_EQ(levels.tile_normals[first], Vec3f(0, 0, 0.25F)) << "the last row is the southern one";
    EXPECT_EQ(levels.tile_normals[first + 17], Vec3f(0, 0, 0.5F));
    EXPECT_EQ(levels.tile_normals.back(), Vec3f(0, 0, 0.4375F));
}

TEST(Objects, AreTurnedAndMovedWhole) {
    const VisualDatabase d =
        compiled(head + "shading = \"vertex\"\nmirror = \"y\"\nat_m = [100, 50, 3]\nturned_deg = 90\n"
                        "vertices_m = { a = [0, 0, 0], b = [4, 0, 0], c = [4, 2, 0] }\n"
                        "normals = { b = [1, 0, 0] }\n[[object.face]]\ncorners = [\"a\", \"b\", \"c\"]\n");
    std::vector<Vec4f> positions;
    for (const Vertex& vertex : d.vertices)
        positions.push_back(vertex.position);
    EXPECT_THAT(positions, testing::UnorderedElementsAre(Vec4f(100, 50, 3, 1), Vec4f(100, 54, 3, 1),
                                                         Vec4f(98, 54, 3, 1), Vec4f(102, 54, 3, 1)));
    for (const Vertex& vertex : d.vertices)
        if (vertex.position == Vec4f(100, 54, 3, 1)) {
            EXPECT_NEAR(vertex.normal.y, 1, 1e-6);
        }
}

TEST(Mounds, StandEachInItsSquareOnTheGround) {
    const VisualDatabase d =
        compiled("[[mounds]]\nname = \"m\"\nlist = \"list\"\ncolour = \"grey\"\nfrom_m = [0, 0, 2]\n"
                 "to_m = [100, 65, 2]\nspacing_m = 20\nradius_m = [4, 9]\nheight_m = [1, 3]\n"
                 "least_sides = 4\ngreatest_sides = 6\nseed = 5\n");
    std::map<std::pair<int, int>, float> tops;
    for (const Vertex& vertex : d.vertices) {
        float& top = tops[{static_cast<int>(std::floor(vertex.position.x / 20)),
                           static_cast<int>(std::floor(vertex.position.y / 20))}];
        top = std::max(top, vertex.position.z);
        EXPECT_GE(vertex.position.z, 2);
    }
    EXPECT_EQ(tops.size(), 15U) << "five columns and three rows, and nothing across their borders";
    for (const auto& [square, top] : tops) {
        EXPECT_TRUE(square.first >= 0 && square.first < 5 && square.second >= 0 && square.second < 3);
        EXPECT_TRUE(top >= 3 && top <= 5) << top;
    }
    EXPECT_GE(d.faces.size(), 15U * 4);
    for (const Face& face : d.faces)
        EXPECT_GT(face.normal.z, 0) << "seen from above";
}

/// A base of three corners may not reach as far as its top leans: the top then stands over the base's middle.
TEST(Mounds, LeanOverNoSideOfTheirs) {
    for (const std::string seed : {"1", "2", "3", "4"}) {
        const VisualDatabase d =
            compiled("[[mounds]]\nname = \"m\"\nlist = \"list\"\ncolour = \"grey\"\nfrom_m = [0, 0, 0]\n"
                     "to_m = [400, 400, 0]\nspacing_m = 20\nradius_m = [4, 9]\nheight_m = [1, 3]\n"
                     "least_sides = 3\ngreatest_sides = 3\nseed = " +
                     seed + "\n");
        EXPECT_GE(d.faces.size(), 20U * 20U * 3U);
        for (const Face& face : d.faces)
            EXPECT_GT(face.normal.z, 0);
    }
}

TEST(Mounds, StandInStaggeredRows) {
    const VisualDatabase d =
        compiled("[[mounds]]\nname = \"m\"\nlist = \"list\"\ncolour = \"grey\"\nfrom_m = [0, 0, 0]\n"
                 "to_m = [60, 40, 0]\nspacing_m = 20\nradius_ft = [32.5, 32.8]\nheight_m = [2, 2]\n"
                 "staggered = true\nseed = 5\n");
    std::vector<Vec2f> tops;
    for (const Vertex& vertex : d.vertices)
        if (vertex.position.z > 1) tops.emplace_back(vertex.position.x, vertex.position.y);
    std::ranges::sort(tops, [](const Vec2f& a, const Vec2f& b) {
        return std::tuple(a.y > 20.0F, a.x) < std::tuple(b.y > 20.0F, b.x);
    });
    ASSERT_EQ(tops.size(), 5U) << "three, and two between them";
    const std::array<float, 5> middles{10, 30, 50, 20, 40};
    for (std::size_t i = 0; i < tops.size(); ++i)
        EXPECT_NEAR(tops[i].x, middles[i], 2.7) << "a top leans by a quarter of the radius at most";
}

TEST(Mounds, HaveOutlinesAndASecondColour) {
    const std::string field =
        "[[colour]]\nname = \"line\"\nrgb = [1, 1, 1]\n[[mounds]]\nname = \"m\"\nlist = \"list\"\n"
        "colour = \"grey\"\nfrom_m = [0, 0, 0]\nto_m = [20, 20, 0]\nspacing_m = 20\n"
        "radius_m = [8, 8]\nheight_m = [2, 2]\nleast_sides = 6\ngreatest_sides = 6\nseed = 2\n";
    const auto count_of = [](const VisualDatabase& d, std::uint16_t colour) {
        return std::count_if(d.faces.begin(), d.faces.end(),
                             [&](const Face& f) { return f.colour == colour; });
    };
    const VisualDatabase outlined = compiled(field + "outline_colour = \"line\"\noutline_width_m = 0.5\n");
    EXPECT_EQ(count_of(outlined, 0), 6);
    EXPECT_EQ(count_of(outlined, 1), 6);
    EXPECT_EQ(outlined.faces.front().colour, 0) << "what is inside an outline lies in front of it";
    const VisualDatabase checkered = compiled(field + "second_colour = \"line\"\n");
    EXPECT_EQ(count_of(checkered, 0), 3);
    EXPECT_EQ(count_of(checkered, 1), 3);
}

TEST(Patchworks, CoverTheirGroundOnce) {
    const VisualDatabase d =
        compiled("[[colour]]\nname = \"green\"\nrgb = [1, 9, 1]\n[[patchwork]]\nname = \"p\"\n"
                 "list = \"list\"\ncolours = [\"grey\", \"green\"]\nfrom_m = [-30, 10, 2]\n"
                 "to_m = [70, 50, 2]\ncolumns = 10\nrows = 8\ndisorder = 0.2\nseed = 4\n");
    EXPECT_EQ(d.faces.size(), 80U);
    EXPECT_EQ(d.vertices.size(), 99U) << "corners are shared";
    double area = 0;
    std::set<int> colours;
    for (const Face& face : d.faces) {
        EXPECT_EQ(face.normal, Vec3f(0, 0, 1));
        colours.insert(face.colour);
        for (std::uint32_t i = 1; i + 1 < face.corner_count; ++i) {
            const Vec3d a(d.vertices[d.corners[face.first_corner]].position);
            const Vec3d b(d.vertices[d.corners[face.first_corner + i]].position);
            const Vec3d c(d.vertices[d.corners[face.first_corner + i + 1]].position);
            area += 0.5 * glm::cross(b - a, c - a).z;
        }
    }
    EXPECT_NEAR(area, 4000, 0.01);
    EXPECT_EQ(colours.size(), 2U);
}

TEST(Includes, ContributeOnceAndFirst) {
    const ScratchFolder folder;
    folder.write("lib/colours.toml", "[[colour]]\nname = \"first\"\nrgb = [1, 1, 1]\n");
    folder.write("lib/part.toml",
                 "include = [\"colours.toml\"]\n[[colour]]\nname = \"second\"\nrgb = [2, 2, 2]\n");
    const std::string root = folder.write(
        "root.toml", "include = [\"lib/part.toml\", \"lib/../lib/colours.toml\"]\n[database]\nname = "
                     "\"t\"\n[[colour]]\nname = \"third\"\nrgb = [3, 3, 3]\n");
    const CompileResult result = compile_file(root);
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_THAT(result.database->colour_names, ElementsAre("first", "second", "third"));
    EXPECT_THAT(result.database->source_files, ElementsAre("lib/colours.toml", "lib/part.toml", "root.toml"));
}

TEST(Compile, GivesTheSameBytesWhereverTheFilesStand) {
    const std::string text = scene(head + "[[object.box]]\nfrom_m = [0, -2, 1]\nto_m = [10, 2, 3]\n");
    const ScratchFolder folder;
    const CompileResult one = compile_file(folder.write("here/root.toml", text));
    const CompileResult two = compile_file(folder.write("some/where/else/root.toml", text));
    ASSERT_TRUE(one.database && two.database);
    EXPECT_EQ(*one.database, *two.database);
    EXPECT_EQ(encode_database(*one.database), encode_database(*two.database));
}

TEST(Sequences, OfSolidsInASlotWhoseFirstAlternativeIsNothing) {
    const VisualDatabase d = compiled(
        "[[slot]]\nname = \"wake\"\nalternatives = 4\nfirst_empty = true\n[[sequence]]\nname = \"w\"\nlist = "
        "\"list\"\nslot = \"wake\"\ncolour = \"grey\"\ntwo_sided = false\nfaces = [[1, 2, 3, 4], [1, 5, 2]]\n"
        "[[sequence.key]]\nframe = 1\ncorners_m = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, -1]]\n"
        "[[sequence.key]]\nframe = 3\ncorners_m = [[0, 0, 0], [3, 0, 0], [3, 1, 0], [0, 1, 0], [0, 0, "
        "-3]]\n");
    EXPECT_EQ(d.slots[0].alternatives, 4U);
    ASSERT_EQ(d.faces.size(), 6U);
    std::vector<std::uint32_t> faces_of(4, 0);
    for (const FaceRun& run : d.runs)
        faces_of[run.alternative] += run.face_count;
    EXPECT_EQ(faces_of, (std::vector<std::uint32_t>{0, 2, 2, 2}));
    for (const Object& object : d.objects)
        EXPECT_EQ(object.name, fmt::format("w.{}", object.alternative))
            << "frame and alternative have one number";
}

const std::string churn = "[[churn]]\nname = \"c\"\nlist = \"list\"\ncolour = \"grey\"\nsquare_m = 1\n"
                          "left_m = [[0, 3], [6, 4], [12, 4]]\nright_m = [[0, -1], [12, -2]]\n"
                          "vertical_angle_deg = 40\nseed = 5\nfade_start = 2\nfade_end = 4\nfade_sides = 2\n";

TEST(Churn, SquaresCoverTheStripAndFadeToNothingAtItsRims) {
    const VisualDatabase d = compiled(churn);
    ASSERT_EQ(d.faces.size(), 12U * 5U);
    double area = 0;
    for (const Face& face : d.faces) {
        const auto at = [&](std::uint32_t i) { return Vec3d(vertex(d, face, i % 4).position); };
        EXPECT_EQ(face.shading, Shading::vertex);
        EXPECT_NEAR(glm::length(Vec3d(face.normal)), 1, 1e-6) << "flat shading shows the squares (Figure 14)";
        for (std::uint32_t i = 0; i < 4; ++i)
            area += 0.5 * (at(i).x * at(i + 1).y - at(i + 1).x * at(i).y);
    }
    EXPECT_NEAR(area, 3.5 * 6 + 4 * 6 + 1.5 * 12, 0.2)
        << "counter-clockwise from above, corners of the rim apart";
    double longest = 0;
    for (const Vertex& each : d.vertices) {
        const bool on_rim = each.position.x == 0 || each.position.x == 12;
        const double length = glm::length(Vec3d(each.normal));
        if (on_rim) {
            EXPECT_EQ(length, 0);
        }
        if (length > 0) {
            EXPECT_NEAR(each.normal.z / length, 0.642788, 1e-5) << "one vertical angle";
        }
        longest = std::max(longest, length);
    }
    EXPECT_NEAR(longest, 1, 1e-6);
    EXPECT_EQ(compiled(churn), d);
}

TEST(Churn, AMirroredStripIsOneObject) {
    const VisualDatabase d =
        compiled("[[churn]]\nname = \"c\"\nlist = \"list\"\ncolour = \"grey\"\nsquare_m = 1\nleft_m = [[0, "
                 "3], [4, 3]]\n"
                 "right_m = [[0, 1], [4, 1]]\nvertical_angle_deg = 40\nseed = 5\nmirror = \"y\"\n");
    EXPECT_EQ(d.objects.size(), 1U);
    ASSERT_EQ(d.faces.size(), 16U);
    double sum = 0;
    for (const Vertex& each : d.vertices)
        sum += each.position.y + each.normal.y;
    EXPECT_NEAR(sum, 0, 1e-5);
}

} // namespace
} // namespace linkdig::database
