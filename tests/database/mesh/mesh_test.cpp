/// Meshes in and out: what stands in a file becomes faces, and comes back.

#include "tests/database/compiler/authored.h"

#include "database/mesh/mesh_of_database.h"
#include "database/mesh/read_mesh.h"
#include "database/mesh/write_mesh.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

/// An L-shaped block, concave seen from above, as Wavefront OBJ: z up, two materials, counter-clockwise faces.
const std::string l_block = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 2 2 0\nv 2 4 0\nv 0 4 0\n"
                            "v 0 0 3\nv 4 0 3\nv 4 2 3\nv 2 2 3\nv 2 4 3\nv 0 4 3\n"
                            "o block\nusemtl walls\n"
                            "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n"
                            "usemtl roof\nf 7 8 9 10 11 12\nf 6 5 4 3 2 1\n";

std::string mesh_table(const std::string& file,
                       const std::string& more = "unit = \"m\"\ncolour = \"grey\"\n") {
    return "[[mesh]]\nname = \"thing\"\nfile = \"" + file + "\"\nlist = \"list\"\n" + more;
}

struct Scene {
    ScratchFolder folder;
    CompileResult compile(const std::string& tables) const {
        return compile_file(folder.write("root.toml", scene(tables)));
    }
    std::string said(const std::string& tables) const {
        const CompileResult result = compile(tables);
        EXPECT_FALSE(result.database) << tables;
        return messages(result);
    }
};

/// Calls visit(face, a, b, c) for the triangles of each face's fan.
template <typename Visit>
void for_triangles(const VisualDatabase& d, const Visit& visit) {
    for (const Face& face : d.faces) {
        const auto at = [&](std::uint32_t i) {
            return Vec3f(d.vertices[d.corners[face.first_corner + i]].position);
        };
        for (std::uint32_t i = 1; i + 1U < face.corner_count; ++i)
            visit(face, at(0), at(i), at(i + 1));
    }
}

double area_of(const VisualDatabase& d) {
    double sum = 0;
    for_triangles(d, [&](const Face& face, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
        sum += 0.5 * glm::dot(Vec3d(face.normal), glm::cross(b - a, c - a));
    });
    return sum;
}

/// Of a closed solid its volume, whatever triangles it is made of.
double volume_of(const VisualDatabase& d) {
    double sum = 0;
    for_triangles(d, [&](const Face&, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    });
    return sum;
}

TEST(Meshes, AConcaveBlockKeepsItsAreaAndVolume) {
    const Scene scene_of;
    scene_of.folder.write("l.obj", l_block);
    const CompileResult result =
        scene_of.compile(mesh_table("l.obj", "unit = \"m\"\nup = \"z\"\ncolour = \"grey\"\n"));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_NEAR(area_of(*result.database), 16 * 3 + 2 * 12, 1e-4);
    EXPECT_NEAR(volume_of(*result.database), 12 * 3, 1e-4);
    const MeshStatistics& mesh = result.statistics.meshes.at(0);
    EXPECT_EQ(mesh.polygons, 8U);
    EXPECT_EQ(mesh.cut, 2U); // roof and floor
    EXPECT_EQ(mesh.faces, 6U + 2U * 4U);
}

TEST(Meshes, UnitAxesHeadingAndPositionPlaceThem) {
    const Scene scene_of;
    scene_of.folder.write("t.obj", "v 1 2 3\nv 2 2 3\nv 1 3 3\nf 1 2 3\n"); // x, y, z of the file, in feet
    const auto first_corner = [&](const std::string& more) {
        const CompileResult result = scene_of.compile(mesh_table("t.obj", "colour = \"grey\"\n" + more));
        EXPECT_TRUE(result.database) << messages(result);
        return result.database ? Vec3d(Vec3f(result.database->vertices[0].position)) : Vec3d(0.0);
    };
    EXPECT_LT(glm::distance(first_corner("unit = \"ft\"\nup = \"z\"\n"), 0.3048 * Vec3d(1, 2, 3)), 1e-6);
    EXPECT_LT(glm::distance(first_corner("unit = \"m\"\n"), Vec3d(3, 1, 2)),
              1e-6); // y up: forward is z, port is x
    EXPECT_LT(glm::distance(first_corner("metres_per_unit = 0.5\nup = \"z\"\nposition_m = [10, 0, 0]\n"),
                            Vec3d(10.5, 1, 1.5)),
              1e-6);
    EXPECT_LT(glm::distance(first_corner("unit = \"m\"\nup = \"z\"\nheading_deg = 90\n"), Vec3d(-2, 1, 3)),
              1e-6);
}

TEST(Meshes, MaterialsBecomeColoursAndNodesObjects) {
    const Scene scene_of;
    scene_of.folder.write("l.obj", l_block + "o lid\nusemtl grey\nf 7 8 9\n");
    const std::string colour = "[[colour]]\nname = \"red\"\nrgb = [200, 0, 0]\n";
    const CompileResult result = scene_of.compile(
        colour +
        mesh_table("l.obj",
                   "unit = \"m\"\nup = \"z\"\nlayer = 1\ncolours = { walls = \"red\", roof = \"grey\" }\n"
                   "objects = { lid = \"cover\" }\n"));
    // Lid and roof lie in one plane, in one layer: a mesh knows no layers, its later face is in front.
    EXPECT_TRUE(result.database) << messages(result);
    scene_of.folder.write("l.obj", l_block + "v 0 0 9\nv 1 0 9\nv 0 1 9\no lid\nusemtl grey\nf 13 14 15\n");
    const CompileResult good = scene_of.compile(
        colour + mesh_table("l.obj",
                            "unit = \"m\"\nup = \"z\"\ncolours = { walls = \"red\", roof = \"grey\" }\n"
                            "objects = { lid = \"cover\" }\n"));
    ASSERT_TRUE(good.database) << messages(good);
    std::map<std::string, int> faces;
    for (const Face& face : good.database->faces)
        ++faces[good.database->objects[face.object].name + "/" + good.database->colour_names[face.colour]];
    EXPECT_EQ(faces["thing.block/red"], 6);
    EXPECT_EQ(faces["thing.block/grey"], 8);
    EXPECT_EQ(faces["cover/grey"], 1); // a material with the name of a colour code
    EXPECT_EQ(faces.size(), 3U);
}

TEST(Meshes, WhatShowsNothingIsLeftOutAndCounted) {
    const Scene scene_of;
    scene_of.folder.write("t.obj",
                          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 2 3 1\nf 1 2 4\nf 3 2 1\n");
    const CompileResult result = scene_of.compile(mesh_table("t.obj"));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(result.database->faces.size(), 2U); // front and back
    EXPECT_EQ(result.statistics.meshes.at(0).doubled, 1U);
    EXPECT_EQ(result.statistics.meshes.at(0).without_area, 1U);
}

TEST(Meshes, MistakesAreTold) {
    const Scene scene_of;
    const ScratchFolder& folder = scene_of.folder;
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n");
    EXPECT_THAT(scene_of.said(mesh_table("no.obj")),
                HasSubstr("root.toml:17: cannot read the mesh \"" + folder.path() +
                          "/no.obj\": there is no such file"));
    folder.write("t.txt", "v");
    EXPECT_THAT(scene_of.said(mesh_table("t.txt")), HasSubstr("ends in \".txt\""));
    std::filesystem::create_directories(folder.path() + "/dir.obj");
    EXPECT_THAT(scene_of.said(mesh_table("dir.obj")), HasSubstr("it is a directory"));
    folder.write("empty.obj", "");
    EXPECT_THAT(scene_of.said(mesh_table("empty.obj")), HasSubstr("empty.obj\": "));
    folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    EXPECT_THAT(scene_of.said(mesh_table("points.obj")), HasSubstr("points.obj\": "));
    folder.write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(scene_of.said(mesh_table("nan.obj")), HasSubstr("is not a finite point"));
    folder.write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    EXPECT_THAT(scene_of.said(mesh_table("index.obj")), HasSubstr("index.obj\": "));
    folder.write("broken.gltf", "{ \"asset\": ");
    EXPECT_THAT(scene_of.said(mesh_table("broken.gltf")), HasSubstr("broken.gltf\": "));
    EXPECT_THAT(scene_of.said(mesh_table("/t.obj")), HasSubstr("expected a path relative to this file"));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "colour = \"grey\"\n")),
                HasSubstr("lacks the key \"unit\" or \"metres_per_unit\""));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "unit = \"furlong\"\ncolour = \"grey\"\n")),
                HasSubstr("furlong"));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "unit = \"m\"\nmetres_per_unit = 2\ncolour = \"grey\"\n")),
                HasSubstr("both \"unit\" and \"metres_per_unit\""));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "unit = \"m\"\n")), HasSubstr("the material \"paint\" of"));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "unit = \"m\"\ncolours = { pain = \"grey\" }\n")),
                HasSubstr("\"pain\" names no material of the mesh; did you mean \"paint\"?"));
    EXPECT_THAT(
        scene_of.said(mesh_table("t.obj", "unit = \"m\"\ncolour = \"grey\"\nobjects = { x = \"y\" }\n")),
        HasSubstr("\"x\" names no node of the mesh"));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "unit = \"mm\"\nmetres_per_unti = 2\ncolour = \"grey\"\n")),
                HasSubstr("unknown key \"metres_per_unti\""));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "metres_per_unit = 0.00001\ncolour = \"grey\"\n")),
                HasSubstr("no face of"));
    EXPECT_THAT(scene_of.said(mesh_table("t.obj", "unit = \"m\"\ncolour = \"grey\"\nalternative = 1\n")),
                HasSubstr("stands without \"slot\""));
}

TEST(Meshes, AFileOfAGigabyteIsRefusedUnread) {
    const Scene scene_of;
    scene_of.folder.write("huge.glb", "");
    std::filesystem::resize_file(scene_of.folder.path() + "/huge.glb", std::uintmax_t{1} << 30U); // sparse
    EXPECT_THAT(scene_of.said(mesh_table("huge.glb")),
                HasSubstr("huge.glb\": it has 1024 MiB, more than 256"));
}

TEST(Meshes, AMissingBufferIsNamed) {
    const Scene scene_of;
    scene_of.folder.write("g.gltf",
                          R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"gone.bin"}],
"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})");
    EXPECT_THAT(scene_of.said(mesh_table("g.gltf")), HasSubstr("gone.bin"));
}

/// Triangles as corner places, each beginning at its least corner, sorted: what may differ between a database, its
/// glTF and what is compiled from that is order and the diagonals of polygons only.
using Triangle = std::array<std::array<float, 3>, 3>;
std::vector<std::pair<std::string, Triangle>> triangles_of(const VisualDatabase& d) {
    std::vector<std::pair<std::string, Triangle>> all;
    for_triangles(d, [&](const Face& face, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        Triangle triangle{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        all.emplace_back(d.colour_names[face.colour], triangle);
    });
    std::sort(all.begin(), all.end());
    return all;
}

TEST(Meshes, OutAndInAgainAreTheSameFaces) {
    const std::string boxes =
        "[[colour]]\nname = \"red\"\nrgb = [200, 0, 0]\n"
        "[[object]]\nname = \"a\"\nlist = \"list\"\ncolour = \"grey\"\n"
        "[[object.box]]\nfrom_m = [-5, -2, 0]\nto_m = [5, 2, 1.25]\ncolours = { top = \"red\" }\n"
        "[[object]]\nname = \"b\"\nlist = \"list\"\ncolour = \"red\"\nshading = \"vertex\"\n"
        "[[object.prism]]\nbase_m = [[8, 0], [11, 0], [12.5, 2], [8, 3]]\nbottom_m = 0\ntop_m = 2\n";
    const Scene scene_of;
    const CompileResult first = scene_of.compile(boxes);
    ASSERT_TRUE(first.database) << messages(first);
    for (const char* name : {"out.gltf", "out.glb"}) {
        write_mesh(mesh_of(*first.database).mesh, scene_of.folder.path() + "/" + name);
        const CompileResult second = scene_of.compile("[[colour]]\nname = \"red\"\nrgb = [200, 0, 0]\n" +
                                                      mesh_table(name, "unit = \"m\"\n"));
        ASSERT_TRUE(second.database) << messages(second);
        EXPECT_EQ(triangles_of(*first.database), triangles_of(*second.database)) << name;
        EXPECT_EQ(second.statistics.meshes.at(0).without_area, 0U);
        std::vector<std::string> objects;
        for (const Object& object : second.database->objects)
            objects.push_back(object.name);
        EXPECT_THAT(objects, testing::UnorderedElementsAre("thing.a", "thing.b"));
    }
}

/// What a reader of glTF that knows nothing of ours finds in a file: triangles, and how many of them face the way that
/// their normals say.
struct Gltf {
    explicit Gltf(const std::string& path) {
        std::ifstream(path) >> json;
        const std::string name = json["buffers"][0]["uri"];
        std::ifstream file(std::filesystem::path(path).parent_path() / name, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
        for (const auto& mesh : json["meshes"])
            for (const auto& part : mesh["primitives"])
                count(part);
    }

    nlohmann::json json;
    std::vector<char> bytes;
    std::size_t triangles = 0, against = 0;
    Vec3d least{1e9}, greatest{-1e9};

private:
    template <typename Number>
    Number number(const nlohmann::json& accessor, std::size_t i) const {
        const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        Number value{};
        std::memcpy(&value,
                    bytes.data() + view.value("byteOffset", std::size_t{0}) +
                        accessor.value("byteOffset", std::size_t{0}) + i * sizeof(Number),
                    sizeof(Number));
        return value;
    }
    std::size_t index(const nlohmann::json& accessor, std::size_t i) const {
        return accessor["componentType"] == 5123 ? number<std::uint16_t>(accessor, i)
                                                 : number<std::uint32_t>(accessor, i);
    }
    Vec3d vector(const nlohmann::json& accessor, std::size_t i) const {
        return {number<float>(accessor, 3 * i), number<float>(accessor, 3 * i + 1),
                number<float>(accessor, 3 * i + 2)};
    }
    void count(const nlohmann::json& part) {
        ASSERT_EQ(part.value("mode", 4), 4);
        const auto& accessors = json["accessors"];
        const auto& indices = accessors[part["indices"].get<std::size_t>()];
        const auto& places = accessors[part["attributes"]["POSITION"].get<std::size_t>()];
        const auto& normals = accessors[part["attributes"]["NORMAL"].get<std::size_t>()];
        for (std::size_t i = 0; i + 2 < indices["count"].get<std::size_t>(); i += 3) {
            std::array<Vec3d, 3> corners{};
            Vec3d normal{0};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t corner = index(indices, i + k);
                ASSERT_LT(corner, places["count"].get<std::size_t>());
                corners[k] = vector(places, corner);
                normal += vector(normals, corner);
                least = glm::min(least, corners[k]);
                greatest = glm::max(greatest, corners[k]);
            }
            ++triangles;
            const Vec3d across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            if (glm::dot(across, normal) < 0.0) ++against;
        }
    }
};

/// A whole database with ships, land and lights goes out, and is the same to two readers: Assimp, and the one above.
TEST(Meshes, AShippedDatabaseGoesOutAsItIs) {
    const CompileResult compiled = compile_file(LINKDIG_SOURCE_DIR "/database/scenes/pier/pier.toml");
    ASSERT_TRUE(compiled.database) << messages(compiled);
    const DatabaseMesh made = mesh_of(*compiled.database);
    EXPECT_EQ(made.faces + made.at_infinity, compiled.database->faces.size());
    const ScratchFolder folder;
    write_mesh(made.mesh, folder.path() + "/out.gltf");
    std::size_t triangles = 0;
    Vec3d least{1e9}, greatest{-1e9};
    for (const MeshNode& node : made.mesh.nodes)
        for (const MeshFace& face : node.faces) {
            triangles += face.corners.size() - 2;
            for (const std::uint32_t corner : face.corners) {
                least = glm::min(least, node.points[corner]);
                greatest = glm::max(greatest, node.points[corner]);
            }
        }
    const Gltf other(folder.path() + "/out.gltf");
    EXPECT_EQ(other.triangles, triangles);
    EXPECT_LT(glm::distance(other.least, least) + glm::distance(other.greatest, greatest), 1e-2);
    // Smooth-shaded slivers, and water walls whose authored normals lean out of their faces, may seem turned.
    EXPECT_LT(other.against, triangles / 50);
    ASSERT_EQ(other.json["materials"].size(), made.mesh.materials.size());
    for (std::size_t i = 0; i < made.mesh.materials.size(); ++i) {
        const auto& material = other.json["materials"][i];
        EXPECT_EQ(material["name"], made.mesh.materials[i].name);
        EXPECT_EQ(material.value("doubleSided", false), made.mesh.materials[i].two_sided);
        EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0.0);
    }
    const MeshResult again = read_mesh(folder.path() + "/out.gltf");
    ASSERT_TRUE(again.mesh) << again.error;
    std::size_t read = 0;
    for (const MeshNode& node : again.mesh->nodes)
        for (const MeshFace& face : node.faces)
            read += face.corners.size() - 2;
    EXPECT_EQ(read, triangles);
}

TEST(Meshes, OpacityGoesOutAndComesBack) {
    const Scene scene_of;
    const CompileResult first =
        scene_of.compile("[[object]]\nname = \"a\"\nlist = \"list\"\ncolour = \"grey\"\nopacity = 0.5\n"
                         "[[object.box]]\nfrom_m = [-5, -2, 0]\nto_m = [5, 2, 1.25]\n");
    ASSERT_TRUE(first.database) << messages(first);
    write_mesh(mesh_of(*first.database).mesh, scene_of.folder.path() + "/out.gltf");
    const Gltf other(scene_of.folder.path() + "/out.gltf");
    EXPECT_EQ(other.json["materials"][0]["alphaMode"], "BLEND");
    EXPECT_EQ(other.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][3], 0.5);
    const CompileResult second = scene_of.compile(mesh_table("out.gltf", "unit = \"m\"\n"));
    ASSERT_TRUE(second.database) << messages(second);
    EXPECT_EQ(second.database->faces.at(0).opacity, 128);
    const CompileResult opaque = scene_of.compile(mesh_table("out.gltf", "unit = \"m\"\nopacity = 1\n"));
    ASSERT_TRUE(opaque.database) << messages(opaque);
    EXPECT_EQ(opaque.database->faces.at(0).opacity, 256);
}

TEST(Meshes, TheSameFileGivesTheSameBytes) {
    const Scene scene_of;
    const CompileResult first =
        scene_of.compile("[[object]]\nname = \"a\"\nlist = \"list\"\ncolour = \"grey\"\n"
                         "[[object.disc]]\ncentre_m = [0, 0, 0]\nradius_m = 5\n");
    ASSERT_TRUE(first.database);
    const auto bytes = [&](const std::string& name) {
        write_mesh(mesh_of(*first.database).mesh, scene_of.folder.path() + "/" + name);
        std::ifstream in(scene_of.folder.path() + "/" + name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    EXPECT_EQ(bytes("a.glb"), bytes("b.glb"));
    const nlohmann::json gltf = nlohmann::json::parse(bytes("c.gltf"));
    EXPECT_EQ(gltf["asset"]["version"], "2.0");
    EXPECT_EQ(gltf["materials"][0]["name"], "grey");
}

#define TESTMODELS "/usr/share/assimp/models/"

/// Models that nobody here made, from Debian's package of Assimp's own tests.
TEST(Meshes, RealModelsCompile) {
    if (!std::filesystem::exists(TESTMODELS)) GTEST_SKIP() << "package assimp-testmodels is not installed";
    for (const char* model :
         {"OBJ/spider.obj", "OBJ/WusonOBJ.obj"}) { // a glTF: tests/tools/foreign_mesh_test.cpp
        const Scene scene_of;
        std::filesystem::copy(
            (std::filesystem::path(TESTMODELS) / model).parent_path(), scene_of.folder.path() + "/model",
            std::filesystem::copy_options::recursive | std::filesystem::copy_options::skip_symlinks);
        const std::string file = "model/" + std::filesystem::path(model).filename().string();
        const CompileResult result = scene_of.compile(mesh_table(file));
        ASSERT_TRUE(result.database) << messages(result);
        EXPECT_GT(result.statistics.meshes.at(0).faces, 1000U);
        write_mesh(mesh_of(*result.database).mesh, scene_of.folder.path() + "/again.glb");
        const CompileResult again = scene_of.compile(mesh_table("again.glb"));
        ASSERT_TRUE(again.database) << messages(again);
        EXPECT_NEAR(area_of(*again.database), area_of(*result.database), 1e-4 * area_of(*result.database))
            << model;
    }
}

/// Assimp would put its front wheels beside their arches.
TEST(Meshes, TheFirstGltfIsRefused) {
    if (!std::filesystem::exists(TESTMODELS)) GTEST_SKIP() << "package assimp-testmodels is not installed";
    EXPECT_EQ(read_mesh(TESTMODELS "glTF/CesiumMilkTruck/CesiumMilkTruck.gltf").error,
              "it is glTF 1.0; save it as glTF 2.0");
}

} // namespace
} // namespace linkdig::database
