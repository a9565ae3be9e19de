#include "database/mesh/read_mesh.h"

#include <assimp/GltfMaterial.h>
#include <assimp/Importer.hpp>
#include <assimp/commonMetaData.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace linkdig::database {

namespace {

namespace fs = std::filesystem;

/// Nodes inside one another: deeper files are refused rather than walked.
constexpr int most_levels = 200;

/// What Assimp would say less well: nothing if the file can be opened.
std::string cannot_be_opened(const std::string& path) {
    const std::string ending = fs::path(path).extension().string();
    if (ending != ".gltf" && ending != ".glb" && ending != ".obj")
        return fmt::format("its name ends in \"{}\", not in .gltf, .glb or .obj", ending);
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found) return "there is no such file";
    if (status.type() == fs::file_type::directory) return "it is a directory";
    if (code) return code.message();
    if (status.type() != fs::file_type::regular) return "it is not a regular file";
    const std::uint64_t size = fs::file_size(path, code);
    if (!code && size > max_mesh_bytes)
        return fmt::format("it has {} MiB, more than {}", size >> 20U, max_mesh_bytes >> 20U);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    return file ? "" : std::generic_category().message(errno);
}

std::string name_of(const aiString& name) { return {name.C_Str(), name.length}; }

/// Column by column as we multiply, in double: destination-from-source as everywhere.
struct Affine {
    Mat3d turn{1.0};
    Vec3d shift{0.0};
    Vec3d point(const aiVector3D& p) const { return turn * Vec3d(p.x, p.y, p.z) + shift; }
};

Affine affine_of(const aiMatrix4x4& m) {
    Affine result;
    result.turn = Mat3d(Vec3d(m.a1, m.b1, m.c1), Vec3d(m.a2, m.b2, m.c2), Vec3d(m.a3, m.b3, m.c3));
    result.shift = Vec3d(m.a4, m.b4, m.c4);
    return result;
}

Affine operator*(const Affine& outer, const Affine& inner) {
    return {outer.turn * inner.turn, outer.turn * inner.shift + outer.shift};
}

bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

class SceneReader {
public:
    explicit SceneReader(const aiScene& scene) : scene_(scene) {}

    MeshResult read() {
        for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
            mesh_.materials.push_back(material(*scene_.mMaterials[i]));
        if (scene_.mRootNode != nullptr) add(*scene_.mRootNode, {}, 0);
        if (error_.empty() && mesh_.nodes.empty()) error_ = "it has no faces";
        if (!error_.empty()) return {{}, error_};
        return {std::move(mesh_), {}};
    }

private:
    static MeshMaterial material(const aiMaterial& from) {
        aiString name;
        int two_sided = 0;
        from.Get(AI_MATKEY_NAME, name);
        from.Get(AI_MATKEY_TWOSIDED, two_sided);
        return {name_of(name), {}, two_sided != 0, opacity_of(from)};
    }

    /// Of glTF, and only where it says that it blends: elsewhere files bear any alpha, and nobody sees it.
    static double opacity_of(const aiMaterial& from) {
        aiString mode;
        float opacity = 1.0F;
        if (from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS || name_of(mode) != "BLEND")
            return 1.0;
        from.Get(AI_MATKEY_OPACITY, opacity);
        return opacity >= 0.0F && opacity <= 1.0F ? static_cast<double>(opacity) : 1.0;
    }

    void add(const aiNode& node, const Affine& file_from_parent, int level) {
        if (level > most_levels) error_ = fmt::format("its nodes stand more than {} deep", most_levels);
        if (!error_.empty()) return;
        const Affine file_from_node = file_from_parent * affine_of(node.mTransformation);
        MeshNode made;
        made.name = name_of(node.mName);
        for (unsigned i = 0; i < node.mNumMeshes && error_.empty(); ++i)
            add(*scene_.mMeshes[node.mMeshes[i]], file_from_node, made);
        if (!made.faces.empty()) mesh_.nodes.push_back(std::move(made));
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            add(*node.mChildren[i], file_from_node, level + 1);
    }

    void add(const aiMesh& from, const Affine& file_from_node, MeshNode& node) {
        const auto first = static_cast<std::uint32_t>(node.points.size());
        const bool mirrored = glm::determinant(file_from_node.turn) < 0;
        const Mat3d normal_turn = cofactors(file_from_node.turn) * (mirrored ? -1.0 : 1.0);
        if (from.HasNormals()) node.normals.resize(first, Vec3d(0.0));
        for (unsigned i = 0; i < from.mNumVertices; ++i) {
            node.points.push_back(file_from_node.point(from.mVertices[i]));
            if (!finite(node.points.back()) && error_.empty())
                error_ = fmt::format("vertex {} of node \"{}\" is not a finite point", i, node.name);
            if (!from.HasNormals()) continue;
            const Vec3d n = normal_turn * Vec3d(from.mNormals[i].x, from.mNormals[i].y, from.mNormals[i].z);
            node.normals.push_back(finite(n) ? n : Vec3d(0.0));
        }
        if (!node.normals.empty()) node.normals.resize(node.points.size(), Vec3d(0.0));
        for (unsigned i = 0; i < from.mNumFaces && error_.empty(); ++i)
            add(from.mFaces[i], from, first, mirrored, node);
    }

    void add(const aiFace& from, const aiMesh& mesh, std::uint32_t first, bool mirrored, MeshNode& node) {
        if (from.mNumIndices < 3) return; // points and lines
        MeshFace face;
        face.material = mesh.mMaterialIndex;
        for (unsigned i = 0; i < from.mNumIndices; ++i) {
            if (from.mIndices[i] >= mesh.mNumVertices) {
                error_ = fmt::format("a face of node \"{}\" names vertex {}, but there are {}", node.name,
                                     from.mIndices[i], mesh.mNumVertices);
                return;
            }
            face.corners.push_back(first + from.mIndices[i]);
        }
        if (mirrored) std::reverse(face.corners.begin() + 1, face.corners.end());
        node.faces.push_back(std::move(face));
    }

    /// The inverse of `m`, transposed, times its determinant: turns normals where `m` turns points.
    static Mat3d cofactors(const Mat3d& m) {
        return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
    }

    const aiScene& scene_;
    Mesh mesh_;
    std::string error_;
};

/// Assimp 5.2 multiplies translation, turn and size of glTF 1.0's nodes in the wrong order: parts would stand in wrong places.
bool is_first_gltf(const aiScene& scene) {
    aiString version;
    return scene.mMetaData != nullptr && scene.mMetaData->Get(AI_METADATA_SOURCE_FORMAT_VERSION, version) &&
           name_of(version).starts_with("1");
}

/// Assimp's messages may run over several lines; ours do not.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
        text.pop_back();
    return text.empty() ? "Assimp gives no reason" : text;
}

} // namespace

MeshResult read_mesh(const std::string& path) {
    if (std::string reason = cannot_be_opened(path); !reason.empty()) return {{}, std::move(reason)};
    try {
        Assimp::Importer importer;
        const aiScene* scene = importer.ReadFile(path, 0); // no post-processing: it may round as it likes
        if (scene == nullptr) return {{}, one_line(importer.GetErrorString())};
        if (is_first_gltf(*scene)) return {{}, "it is glTF 1.0; save it as glTF 2.0"};
        return SceneReader(*scene).read();
    } catch (const std::exception& thrown) { // Assimp lets some escape
        return {{}, one_line(thrown.what())};
    }
}

} // namespace linkdig::database
