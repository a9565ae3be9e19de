#include "database/mesh/write_mesh.h"

#include "database/model/mathematics.h"

#include <assimp/Exporter.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace linkdig::database {

namespace {

/// glTF's factors are linear; colour codes are display-referred (IEC 61966-2-1, sRGB).
float linear(std::uint8_t code) {
    const double c = code / 255.0;
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : power((c + 0.055) / 1.055, 2.4));
}

aiString text(const std::string& from) { return aiString(from); }

std::unique_ptr<aiMaterial> material_of(const MeshMaterial& from) {
    auto made = std::make_unique<aiMaterial>();
    const aiString name = text(from.name);
    // Assimp multiplies the colour's alpha by the opacity.
    const aiColor4D colour(linear(from.colour.red), linear(from.colour.green), linear(from.colour.blue),
                           1.0F);
    const int two_sided = from.two_sided ? 1 : 0;
    const float metallic = 0.0F, rough = 1.0F, opacity = static_cast<float>(from.opacity);
    made->AddProperty(&name, AI_MATKEY_NAME);
    made->AddProperty(&colour, 1, AI_MATKEY_BASE_COLOR);
    made->AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
    made->AddProperty(&two_sided, 1, AI_MATKEY_TWOSIDED);
    made->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
    made->AddProperty(&rough, 1, AI_MATKEY_ROUGHNESS_FACTOR);
    made->AddProperty(&opacity, 1, AI_MATKEY_OPACITY);
    return made;
}

aiVector3D vector_of(const Vec3d& v) {
    return {static_cast<ai_real>(v.x), static_cast<ai_real>(v.y), static_cast<ai_real>(v.z)};
}

/// What one aiMesh takes of a node: the faces of one material, in fans of triangles over the points in use.
class Part {
public:
    explicit Part(const MeshNode& node) : node_(node) {}

    void add(const MeshFace& face) {
        for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
            for (const std::size_t corner : {std::size_t{0}, i, i + 1})
                indices_.push_back(point(face.corners[corner]));
    }

    std::unique_ptr<aiMesh> mesh(std::uint32_t material) const {
        auto made = std::make_unique<aiMesh>();
        made->mName = text(node_.name);
        made->mMaterialIndex = material;
        made->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
        made->mNumVertices = static_cast<unsigned>(points_.size());
        made->mVertices = new aiVector3D[points_.size()];
        if (!node_.normals.empty()) made->mNormals = new aiVector3D[points_.size()];
        for (std::size_t i = 0; i < points_.size(); ++i) {
            made->mVertices[i] = vector_of(node_.points[points_[i]]);
            if (!node_.normals.empty()) made->mNormals[i] = vector_of(node_.normals[points_[i]]);
        }
        made->mNumFaces = static_cast<unsigned>(indices_.size() / 3);
        made->mFaces = new aiFace[made->mNumFaces];
        for (unsigned f = 0; f < made->mNumFaces; ++f) {
            made->mFaces[f].mNumIndices = 3;
            made->mFaces[f].mIndices = new unsigned[3];
            for (unsigned i = 0; i < 3; ++i)
                made->mFaces[f].mIndices[i] = indices_[3 * std::size_t{f} + i];
        }
        return made;
    }

private:
    std::uint32_t point(std::uint32_t from) {
        const auto [found, is_new] = index_.emplace(from, static_cast<std::uint32_t>(points_.size()));
        if (is_new) points_.push_back(from);
        return found->second;
    }

    const MeshNode& node_;
    std::map<std::uint32_t, std::uint32_t> index_;
    std::vector<std::uint32_t> points_; ///< into the node's
    std::vector<std::uint32_t> indices_;
};

/// Hands a vector's things over to one of Assimp's counted arrays.
template <typename Thing>
void give(std::vector<std::unique_ptr<Thing>>& from, Thing**& to, unsigned& count) {
    count = static_cast<unsigned>(from.size());
    if (from.empty()) return;
    to = new Thing*[from.size()];
    for (std::size_t i = 0; i < from.size(); ++i)
        to[i] = from[i].release();
}

class SceneWriter {
public:
    explicit SceneWriter(const Mesh& mesh) : mesh_(mesh) {}

    std::unique_ptr<aiScene> scene() {
        auto made = std::make_unique<aiScene>();
        std::vector<std::unique_ptr<aiMaterial>> materials;
        for (const MeshMaterial& material : mesh_.materials)
            materials.push_back(material_of(material));
        made->mRootNode = new aiNode("linkdig");
        add_children(none, *made->mRootNode);
        give(materials, made->mMaterials, made->mNumMaterials);
        give(meshes_, made->mMeshes, made->mNumMeshes);
        return made;
    }

private:
    void add_children(std::int32_t parent, aiNode& to) {
        std::vector<std::unique_ptr<aiNode>> children;
        for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
            if (mesh_.nodes[i].parent != parent) continue;
            children.push_back(std::make_unique<aiNode>(mesh_.nodes[i].name));
            children.back()->mParent = &to;
            add_meshes(mesh_.nodes[i], *children.back());
            add_children(static_cast<std::int32_t>(i), *children.back());
        }
        give(children, to.mChildren, to.mNumChildren);
    }

    void add_meshes(const MeshNode& node, aiNode& to) {
        std::map<std::uint32_t, Part> parts; // by material
        for (const MeshFace& face : node.faces)
            parts.try_emplace(face.material, node).first->second.add(face);
        if (parts.empty()) return;
        to.mMeshes = new unsigned[parts.size()];
        for (const auto& [material, part] : parts) {
            to.mMeshes[to.mNumMeshes++] = static_cast<unsigned>(meshes_.size());
            meshes_.push_back(part.mesh(material));
        }
    }

    const Mesh& mesh_;
    std::vector<std::unique_ptr<aiMesh>> meshes_;
};

} // namespace

void write_mesh(const Mesh& mesh, const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending != ".gltf" && ending != ".glb")
        throw std::runtime_error(fmt::format("cannot write {}: expected a name in .gltf or .glb", path));
    const std::unique_ptr<aiScene> scene = SceneWriter(mesh).scene();
    Assimp::Exporter exporter;
    if (exporter.Export(scene.get(), ending == ".glb" ? "glb2" : "gltf2", path) != aiReturn_SUCCESS)
        throw std::runtime_error(fmt::format("cannot write {}: {}", path, exporter.GetErrorString()));
}

} // namespace linkdig::database
