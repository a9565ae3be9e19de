/// The airdromes, against the coordinates that they are modelled from, and two properties of their ground.

#include "tests/database/compiler/authored.h"

#include <algorithm>
#include <cmath>

namespace linkdig::database {
namespace {

/// Polygons of a list as (x, y), with their heights and colours.
struct Flat {
    std::vector<Vec2d> corners;
    double z = 0;
    std::string colour, object;
};

std::vector<Flat> faces_of(const VisualDatabase& d, const std::string& list) {
    std::vector<Flat> flats;
    for (const Face& face : d.faces) {
        const Object& object = d.objects[face.object];
        if (d.lists[object.list].name != list) continue;
        Flat flat{.corners = {}, .z = 0, .colour = d.colour_names[face.colour], .object = object.name};
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const Vec4f& p = d.vertices[d.corners[face.first_corner + i]].position;
            flat.corners.emplace_back(p.x, p.y);
            flat.z = static_cast<double>(p.z);
        }
        flats.push_back(std::move(flat));
    }
    return flats;
}

bool holds(const Flat& flat, const Vec2d& p) {
    for (std::size_t i = 0; i < flat.corners.size(); ++i) {
        const Vec2d a = flat.corners[i];
        const Vec2d b = flat.corners[(i + 1) % flat.corners.size()];
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < -0.01 * glm::distance(a, b)) return false;
    }
    return true;
}

struct Airdrome {
    const char* name;
    Vec2d first_ft, second_ft; ///< ends of the runway, of which the first is that with the lower number
    double length_ft;
};

class Airdromes : public testing::TestWithParam<Airdrome> {
protected:
    static VisualDatabase database() {
        const std::string name = GetParam().name;
        const CompileResult result =
            compile_file(LINKDIG_SOURCE_DIR "/database/scenes/" + name + "/" + name + ".toml");
        EXPECT_TRUE(result.database) << messages(result);
        return result.database.value_or(VisualDatabase());
    }
};

TEST_P(Airdromes, RunwayLiesWhereItsThresholdsAre) {
    const VisualDatabase d = database();
    const auto pavement = faces_of(d, "pavement");
    const auto runway =
        std::find_if(pavement.begin(), pavement.end(), [](const Flat& f) { return f.colour == "runway"; });
    ASSERT_NE(runway, pavement.end());
    ASSERT_EQ(runway->corners.size(), 4U);
    // The runway's ends are the middles of its two short sides.
    std::vector<Vec2d> ends;
    for (std::size_t i = 0; i < 4; ++i)
        if (glm::distance(runway->corners[i], runway->corners[(i + 1) % 4]) < 100)
            ends.push_back(0.5 * (runway->corners[i] + runway->corners[(i + 1) % 4]));
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_NEAR(glm::distance(ends[0], ends[1]), GetParam().length_ft * 0.3048, 3.0);
    for (const Vec2d& wanted_ft : {GetParam().first_ft, GetParam().second_ft}) {
        const Vec2d wanted = 0.3048 * wanted_ft;
        EXPECT_LT(std::min(glm::distance(ends[0], wanted), glm::distance(ends[1], wanted)), 4.0);
    }
    EXPECT_EQ(runway->z, 0.0);
}

TEST_P(Airdromes, MarkingsLieOnPavement) {
    const VisualDatabase d = database();
    const auto pavement = faces_of(d, "pavement");
    const auto markings = faces_of(d, "markings");
    EXPECT_GT(markings.size(), 200U);
    for (const Flat& marking : markings) {
        EXPECT_EQ(marking.z, 0.0);
        for (const Vec2d& corner : marking.corners)
            EXPECT_TRUE(
                std::any_of(pavement.begin(), pavement.end(),
                            [&](const Flat& f) { return f.colour != "mown grass" && holds(f, corner); }))
                << marking.object << " at " << corner.x << ", " << corner.y;
    }
}

TEST_P(Airdromes, NoGroundHangsOverTheWater) {
    // What lies on the land's plane lies on the land: of the runways' ground and the fields each corner is inside one of the
    // land's faces (which reach infinity: then inside the strip that the face is).
    const VisualDatabase d = database();
    std::vector<Flat> land;
    for (const Face& face : d.faces) {
        if (d.lists[d.objects[face.object].list].name != "land" || face.normal.z < 0.999F) continue;
        Flat flat;
        bool level = true;
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const Vec4f& p = d.vertices[d.corners[face.first_corner + i]].position;
            level = level && p.z == 0;
            flat.corners.emplace_back(p.w == 0 ? 1e6 * p.x : p.x, p.w == 0 ? 1e6 * p.y : p.y);
        }
        // A corner at infinity becomes one far away, so the strips widen to triangles: a metre of a thousand kilometres.
        if (level) land.push_back(std::move(flat));
    }
    for (const char* list : {"pavement", "fields", "markings"})
        for (const Flat& flat : faces_of(d, list))
            for (const Vec2d& corner : flat.corners)
                EXPECT_TRUE(std::any_of(
                    land.begin(), land.end(),
                    [&](const Flat& f) {
                        Flat near = f;
                        for (Vec2d& each :
                             near.corners) // a far corner has the height of its strip where we look
                            if (std::fabs(each.x) > 9e5 && std::fabs(each.y) < 1) each.y = corner.y;
                        return holds(near, corner);
                    }))
                    << list << " " << flat.object << " at " << corner.x << ", " << corner.y;
}

TEST(Pier, ItsClustersShareTheShipsGroup) {
    const CompileResult result = compile_file(LINKDIG_SOURCE_DIR "/database/scenes/pier/pier.toml");
    ASSERT_TRUE(result.database) << messages(result);
    std::size_t together = 0;
    for (const Cluster& cluster : result.database->clusters)
        together += result.database->groups[cluster.group].number == 10 ? 1 : 0;
    EXPECT_GE(together, 5U) << "quay, pier, shed, crane and the ship";
}

INSTANTIATE_TEST_SUITE_P(Both, Airdromes,
                         testing::Values(Airdrome{"plattsburgh", {-2251, 5432}, {2251, -5432}, 11759},
                                         Airdrome{"pease", {-2899, 4866}, {2899, -4866}, 11322}),
                         [](const auto& each) { return std::string(each.param.name); });

} // namespace
} // namespace linkdig::database
