// A wake on the water of a database.

#include "database/compiler/compile.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace linkdig::database {
namespace {

const std::string scenes = LINKDIG_SOURCE_DIR "/database/scenes/wakes/kelvin/";

/// A lake with the field of a straight wake, 8 m a side, `more` added to its table.
CompileResult compiled(const std::string& more) {
    const auto folder = std::filesystem::temp_directory_path() /
                        testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "spec.toml")
        << "[field]\ncells = 128\nside_m = 8.0\n[[swimmer]]\nname = \"boat\"\nspeed_mps = 0.8\n"
           "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[1.0, 4.0], [7.0, 4.0]]\n";
    std::ofstream(folder / "lake.toml")
        << "include = [\"" + std::filesystem::relative(scenes + "lake.toml", folder).string() +
               "\"]\n[database]\nname = \"lake\"\n"
        << "[[wake_field]]\nname = \"wake\"\nlist = \"wakes\"\ncolour = \"lake\"\n"
        << "corner_m = [10.0, 20.0, 0.0]\nsquares = 32\n" + more;
    CompileResult result = compile_file((folder / "lake.toml").string());
    std::filesystem::remove_all(folder);
    return result;
}

TEST(WakeField, LiesFlatWithNormalsThatLeanAsItsSteepnessSays) {
    const CompileResult result = compiled("spec = \"spec.toml\"\nsteepness_deg = 10.0\n");
    ASSERT_TRUE(result.database) << result.diagnostics.text();
    std::size_t vertices = 0;
    double lean = 0.0;
    std::size_t leaning = 0;
    for (const Vertex& vertex : result.database->vertices) {
        const Vec4f& p = vertex.position;
        if (p.w != 1.0F || p.x < 10.0F || p.y < 20.0F || p.x > 18.0F || p.y > 28.0F || p.z != 0.0F) continue;
        ++vertices;
        EXPECT_NEAR(glm::length(vertex.normal), 1.0F, 1e-5F);
        const bool rim = p.x == 10.0F || p.y == 20.0F || p.x == 18.0F || p.y == 28.0F;
        EXPECT_TRUE(!rim || vertex.normal.z == 1.0F);
        if (vertex.normal.z == 1.0F) continue;
        ++leaning;
        const double slope =
            std::hypot(vertex.normal.x, vertex.normal.y) / static_cast<double>(vertex.normal.z);
        lean += slope * slope;
    }
    EXPECT_EQ(vertices, 33U * 33U);
    EXPECT_NEAR(std::sqrt(lean / static_cast<double>(leaning)), std::tan(10.0 * std::acos(-1.0) / 180.0),
                0.01);
}

TEST(WakeField, MistakesAreToldWhereTheyStand) {
    using testing::HasSubstr;
    EXPECT_THAT(compiled("").diagnostics.text(), HasSubstr("lacks the key \"spec\""));
    EXPECT_THAT(compiled("spec = \"none.toml\"\n").diagnostics.text(), HasSubstr("none.toml"));
    EXPECT_THAT(compiled("spec = \"lake.toml\"\n").diagnostics.text(), HasSubstr("no [[swimmer]]"));
    EXPECT_THAT(compiled("spec = \"spec.toml\"\nsteepness_deg = 80.0\n").diagnostics.text(),
                HasSubstr("steepness_deg"));
}

TEST(WakeField, ShippedLakesCompile) {
    for (const char* figure : {"figure12", "figure15", "figure19", "figure21"}) {
        const CompileResult result = compile_file(scenes + figure + "_database.toml");
        EXPECT_TRUE(result.database) << result.diagnostics.text();
        EXPECT_THAT(result.files, testing::Contains(scenes + figure + ".toml")); // --watch looks at it
    }
}

} // namespace
} // namespace linkdig::database
