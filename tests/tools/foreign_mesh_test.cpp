/// A mesh that nobody here made, all the way: glTF, compiled database on disk, pictures against the ray caster, glTF.

#include "database/compiler/compile.h"
#include "database/format/read.h"
#include "database/format/write.h"
#include "database/mesh/mesh_of_database.h"
#include "database/mesh/write_mesh.h"
#include "ig/machine/machine.h"
#include "tests/database/compiler/authored.h"
#include "tools/check/check.h"
#include "tools/preview/preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace linkdig::tools {
namespace {

/// 121,496 triangles in 67 parts that stand inside one another (Debian's package assimp-testmodels).
const std::string engine = "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";

std::string table(const std::string& file, const std::string& unit) {
    return "[[mesh]]\nname = \"engine\"\nfile = \"" + file + "\"\nlist = \"list\"\nunit = \"" + unit +
           "\"\ncolour = \"grey\"\n";
}

/// Pixels of anything but the background.
std::size_t drawn(const VisualDatabase& database) {
    ig::Configuration configuration = ig::modern_profile();
    configuration.raster = {.width = 200, .height = 150};
    ig::Machine machine(database, configuration);
    machine.draw_planes(false, true);
    const FramePacket packet =
        preview_packet(database, preview_subjects(database).front(), preview_view(0), 200.0 / 150.0);
    EXPECT_TRUE(machine.frame(packet).errors.empty());
    const ig::VideoFrame& picture = machine.picture(0);
    return static_cast<std::size_t>(std::ranges::count_if(
        picture.rank, [&](auto rank) { return machine.source(0, rank).face != nullptr; }));
}

TEST(ForeignMesh, GoesFromGltfToPicturesAndBack) {
    if (!std::filesystem::exists(engine)) GTEST_SKIP() << "package assimp-testmodels is not installed";
    const database::ScratchFolder folder;
    std::filesystem::copy_file(engine, folder.path() + "/engine.glb");
    const database::CompileResult compiled =
        database::compile_file(folder.write("a.toml", database::scene(table("engine.glb", "mm"))));
    ASSERT_TRUE(compiled.database) << compiled.diagnostics.text();
    database::write_database(*compiled.database, folder.path() + "/a.igdb");
    const database::ReadResult opened = database::read_database(folder.path() + "/a.igdb");
    ASSERT_TRUE(opened.database);

    CheckRequest request;
    request.views = 40;
    request.raster = {256, 256, ig::Scan::horizontal};
    const CheckResult result = check_database(*opened.database, request);
    EXPECT_GT(result.interior, 400000U);
    EXPECT_EQ(result.wrong, 0U);
    const std::size_t before = drawn(*opened.database);
    EXPECT_GT(before, 200U * 150U / 8U);

    database::write_mesh(database::mesh_of(*opened.database).mesh, folder.path() + "/again.glb");
    const database::CompileResult again =
        database::compile_file(folder.write("b.toml", database::scene(table("again.glb", "m"))));
    ASSERT_TRUE(again.database) << again.diagnostics.text();
    const auto after = static_cast<double>(drawn(*again.database));
    EXPECT_NEAR(after, static_cast<double>(before), 0.01 * static_cast<double>(before));
}

} // namespace
} // namespace linkdig::tools
