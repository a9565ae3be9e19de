#include "tests/database/compiler/authored.h"

#include "database/model/mathematics.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

namespace linkdig::database {
namespace {

VisualDatabase compiled(const std::string& kind, const std::string& text) {
    const CompileResult result = compile_text(scene(fmt::format(
        "[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.{}]]\n{}\n", kind, text)));
    EXPECT_TRUE(result.database) << messages(result);
    return result.database.value_or(VisualDatabase());
}

std::vector<Vec3d> corners_of(const VisualDatabase& d, const Face& face) {
    std::vector<Vec3d> corners;
    for (std::uint32_t i = 0; i < face.corner_count; ++i)
        corners.emplace_back(d.vertices[d.corners[face.first_corner + i]].position);
    return corners;
}

Vec3d area_of(const std::vector<Vec3d>& corners) {
    Vec3d area(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area += 0.5 * glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return area;
}

double total_area(const VisualDatabase& d) {
    double sum = 0;
    for (const Face& face : d.faces)
        sum += glm::length(area_of(corners_of(d, face)));
    return sum;
}

/// Volume of a closed surface with outward normals (divergence theorem): wrong in sign or size if any face is
/// turned.
double volume(const VisualDatabase& d) {
    double sum = 0;
    for (const Face& face : d.faces) {
        const std::vector<Vec3d> corners = corners_of(d, face);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            sum += glm::dot(corners[0], glm::cross(corners[i], corners[i + 1])) / 6;
    }
    return sum;
}

void expect_normals_match_corners(const VisualDatabase& d) {
    for (const Face& face : d.faces) {
        const Vec3d normal = glm::normalize(area_of(corners_of(d, face)));
        EXPECT_NEAR(glm::distance(normal, Vec3d(face.normal)), 0, 1e-6);
    }
}

TEST(Primitives, ABoxHasSixOutwardSides) {
    const VisualDatabase d = compiled("box", "from_m = [4, 3, 6]\nto_m = [1, -2, 2]");
    EXPECT_EQ(d.faces.size(), 6U);
    EXPECT_EQ(d.vertices.size(), 8U);
    EXPECT_DOUBLE_EQ(volume(d), 3.0 * 5.0 * 4.0);
    expect_normals_match_corners(d);
}

TEST(Primitives, ABoxNamesItsSides) {
    const std::map<std::string, Vec3f> sides{{"bow", {1, 0, 0}},  {"stern", {-1, 0, 0}},
                                             {"port", {0, 1, 0}}, {"starboard", {0, -1, 0}},
                                             {"top", {0, 0, 1}},  {"bottom", {0, 0, -1}}};
    for (const auto& [omitted, normal] : sides) {
        const VisualDatabase d =
            compiled("box", fmt::format("from_ft = [0, 0, 0]\nto_ft = [1, 1, 1]\nomit = [\"{}\"]", omitted));
        EXPECT_EQ(d.faces.size(), 5U);
        for (const Face& face : d.faces)
            EXPECT_NE(face.normal, normal) << omitted;
    }
}

TEST(Primitives, APrismTapers) {
    const std::string text = "base_m = [[0, 0], [4, 0], [4, 2], [0, 2]]\nbottom_m = 0\ntop_m = 3\n";
    EXPECT_NEAR(volume(compiled("prism", text)), 24, 1e-9);
    const VisualDatabase frustum =
        compiled("prism", text + "top_base_m = [[1, 0.5], [3, 0.5], [3, 1.5], [1, 1.5]]\n");
    EXPECT_NEAR(volume(frustum), 3.0 / 3 * (8 + 2 + 4), 1e-6); // h/3 (A + B + sqrt(AB))
    EXPECT_EQ(frustum.faces.size(), 6U);
    const VisualDatabase pyramid =
        compiled("prism", text + "top_base_m = [[2, 1], [2, 1], [2, 1], [2, 1]]\nomit = [\"top\"]\n");
    EXPECT_NEAR(volume(pyramid), 8, 1e-9);
    EXPECT_EQ(pyramid.faces.size(), 5U);
    expect_normals_match_corners(pyramid);
}

TEST(Primitives, ALoftFacesTheCrossProductOfPointAndSectionDirection) {
    // Points run along x, sections along y: the front is +z.
    const std::string text =
        "sections_m = [[[0, 0, 0], [2, 0, 0], [4, 0, 0]], [[0, 3, 0], [2, 3, 0], [4, 3, 0]]]\n";
    const VisualDatabase up = compiled("loft", text);
    ASSERT_EQ(up.faces.size(), 2U);
    EXPECT_EQ(up.faces[0].normal, Vec3f(0, 0, 1));
    EXPECT_DOUBLE_EQ(total_area(up), 12);
    EXPECT_EQ(compiled("loft", text + "flip = true\n").faces[0].normal, Vec3f(0, 0, -1));
}

TEST(Primitives, ALoftCutsWhatIsNotPlanarAndDropsWhatIsNothing) {
    const VisualDatabase twisted =
        compiled("loft", "sections_m = [[[0, 0, 0], [2, 0, 0]], [[0, 2, 0], [2, 2, 1]]]");
    EXPECT_EQ(twisted.faces.size(), 2U);
    for (const Face& face : twisted.faces)
        EXPECT_EQ(face.corner_count, 3);
    const VisualDatabase stem = compiled(
        "loft", "sections_m = [[[0, 0, 0], [0, 0, 0], [1, 0, 0]], [[0, 1, 0], [0.5, 1, 0], [1, 1, 0]]]");
    ASSERT_EQ(stem.faces.size(), 2U);
    EXPECT_DOUBLE_EQ(total_area(stem), 1);
}

TEST(Primitives, ALoftSharesVerticesSoThatItShadesSmoothly) {
    std::string sections;
    for (const double z : {0.0, 5.0}) {
        sections += "[";
        for (int i = 0; i <= 8; ++i) {
            const SineCosine a = sine_cosine(two_pi * (i % 8) / 8);
            sections += fmt::format("[{}, {}, {}], ", a.cosine, a.sine, z);
        }
        sections += "], ";
    }
    const VisualDatabase d =
        compiled("loft", fmt::format("shading = \"vertex\"\nsections_m = [{}]", sections));
    EXPECT_EQ(d.faces.size(), 8U);
    EXPECT_EQ(d.vertices.size(), 16U);
    for (const Vertex& vertex : d.vertices) { // of a cylinder: radial, the seam included
        EXPECT_NEAR(glm::distance(Vec3d(vertex.normal), Vec3d(vertex.position.x, vertex.position.y, 0)), 0,
                    1e-6);
    }
}

TEST(Primitives, MarkingsFaceUpWithTheirArea) {
    const auto area = [](const std::string& kind, const std::string& text) {
        const VisualDatabase d = compiled(kind, text);
        for (const Face& face : d.faces)
            EXPECT_EQ(face.normal, Vec3f(0, 0, 1)) << kind;
        expect_normals_match_corners(d);
        return total_area(d);
    };
    EXPECT_NEAR(area("rectangle", "centre_m = [1, 2, 3]\nsize_m = [4, 2]\nheading_deg = 30"), 8, 1e-5);
    const double polygon = 0.5 * 12 * 9 * sine(two_pi / 12);
    EXPECT_NEAR(area("disc", "centre_m = [1, 2, 3]\nradius_m = 3\nsides = 12"), polygon, 1e-5);
    EXPECT_NEAR(area("ring", "centre_m = [1, 2, 3]\nradius_m = 3\nwidth_m = 1\nsides = 12"), polygon * 5 / 9,
                1e-5);
    EXPECT_NEAR(area("stripe", "from_m = [0, 0, 3]\nto_m = [3, 4, 3]\nwidth_m = 0.5"), 2.5, 1e-5);
    EXPECT_NEAR(area("path", "points_m = [[0, 0, 1], [10, 0, 1], [10, 10, 1], [20, 15, 1]]\nwidth_ft = 10"),
                3.048 * (20 + std::sqrt(125.0)), 1e-4)
        << "a mitre gives outside what it takes inside";
    // 5 m in dashes of 1 m every 1.5 m: 0-1, 1.5-2.5, 3-4, 4.5-5.
    EXPECT_NEAR(
        area("stripe", "from_m = [0, 0, 3]\nto_m = [3, 4, 3]\nwidth_m = 0.5\ndash_m = 1\ngap_m = 0.5"), 1.75,
        1e-5);
}

TEST(Primitives, ARectangleRunsAlongItsHeading) {
    const VisualDatabase d =
        compiled("rectangle", "centre_m = [0, 0, 0]\nsize_m = [10, 2]\nheading_deg = 90");
    for (const Vec3d& corner : corners_of(d, d.faces[0])) {
        EXPECT_NEAR(std::fabs(corner.x), 1, 1e-6);
        EXPECT_NEAR(std::fabs(corner.y), 5, 1e-6);
    }
}

TEST(Primitives, NumeralsAreDrawnOfStrokesThatDoNotOverlap) {
    // 0.6 high wide, stroke 1 of 10: bars 6, posts 8 or parts of them. Overlaps would be ties, so compiling
    // proves none.
    const std::map<char, double> area{{'0', 6 * 2 + 8 * 2},     {'1', 10},
                                      {'2', 6 * 3 + 3.5 * 2},   {'3', 6 * 3 + 3.5 * 2},
                                      {'4', 6 + 4.5 * 2 + 4.5}, {'5', 6 * 3 + 3.5 * 2},
                                      {'6', 6 * 3 + 3.5 * 3},   {'7', 6 + 9},
                                      {'8', 6 * 3 + 3.5 * 4},   {'9', 6 * 3 + 3.5 * 3}};
    for (const auto& [digit, expected] : area) {
        const VisualDatabase d =
            compiled("numeral",
                     fmt::format("text = \"{}\"\ncentre_m = [3, 4, 5]\nheight_m = 10\nstroke_m = 1", digit));
        EXPECT_NEAR(total_area(d), expected, 1e-4) << digit;
        double low = 1e9, high = -1e9;
        for (const Vertex& vertex : d.vertices) {
            low = std::min(low, static_cast<double>(vertex.position.x));
            high = std::max(high, static_cast<double>(vertex.position.x));
        }
        EXPECT_NEAR(low, -2, 1e-5) << digit;
        EXPECT_NEAR(high, 8, 1e-5) << digit;
    }
}

TEST(Primitives, NumeralsReadWithTheirTopAhead) {
    // "7" has its bar ahead (+x) and its post to starboard (-y).
    const VisualDatabase d =
        compiled("numeral", "text = \"7\"\ncentre_m = [0, 0, 0]\nheight_m = 10\nstroke_m = 1");
    for (const Face& face : d.faces)
        for (const Vec3d& corner : corners_of(d, face))
            EXPECT_TRUE(corner.x >= 4 - 1e-5 || corner.y <= -2 + 1e-5);
    const VisualDatabase two =
        compiled("numeral", "text = \"17\"\ncentre_m = [0, 0, 0]\nheight_m = 10\nstroke_m = 1");
    EXPECT_EQ(two.faces.size(), 3U);
}

TEST(Primitives, RepeatAtEqualSteps) {
    const VisualDatabase d = compiled(
        "rectangle", "centre_m = [0, 0, 0]\nsize_m = [1, 1]\nrepeat = { count = 4, step_m = [0, 3, 0.5] }");
    ASSERT_EQ(d.faces.size(), 4U);
    std::set<double> centres;
    for (const Face& face : d.faces)
        centres.insert(corners_of(d, face)[0].y + 0.5);
    EXPECT_EQ(centres, (std::set<double>{0, 3, 6, 9}));
}

TEST(Primitives, SidesHaveColoursOfTheirOwn) {
    const CompileResult result = compile_text(
        scene("[[colour]]\nname = \"deck\"\nrgb = [1, 2, 3]\n[[object]]\nname = \"o\"\nlist = \"list\"\n"
              "colour = \"grey\"\n[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, 1]\ncolours = { top = "
              "\"deck\" }\n"));
    ASSERT_TRUE(result.database) << messages(result);
    for (const Face& face : result.database->faces) {
        EXPECT_EQ(face.colour, face.normal.z > 0.5F ? 1 : 0);
        EXPECT_EQ(face.line, 22U);
    }
}

} // namespace
} // namespace linkdig::database
