#include "ig/water/made_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace linkdig::ig {

namespace {

constexpr std::uint32_t rows_of_a_run = 16;
constexpr float dark = 0.002F; ///< half a step of an 8-bit colour

/// How much the light changes between two corners.
float change_between(const ActiveDatabase& active, std::uint32_t a, std::uint32_t b) {
    const Vec3f change = active.made_vertices[a].normal - active.made_vertices[b].normal;
    return change.x * change.x + change.y * change.y + change.z * change.z;
}

/// A square is cut along the diagonal from its first corner: the one over which the light changes less, or a crest that runs the other
/// way would have teeth.
void make_square(const MeshRows& mesh, std::uint32_t row, std::uint32_t column, Face face,
                 ActiveDatabase& active) {
    const std::uint32_t at = mesh.first_vertex + row * mesh.columns + column;
    std::uint32_t corners[4] = {at, at + 1, at + mesh.columns + 1, at + mesh.columns};
    if (std::ranges::all_of(corners, [&](std::uint32_t c) { return is_dark(active.made_vertices[c]); }))
        return;
    if (change_between(active, corners[1], corners[3]) < change_between(active, corners[0], corners[2]))
        std::rotate(std::begin(corners), std::begin(corners) + 1, std::end(corners));
    face.first_corner = static_cast<std::uint32_t>(active.made_corners.size());
    active.made_corners.insert(active.made_corners.end(), std::begin(corners), std::end(corners));
    active.made_faces.push_back(face);
}

/// Bounding sphere of the rows from `first` to `last`.
void bound(const MeshRows& mesh, std::uint32_t first, std::uint32_t last, const ActiveDatabase& active,
           FaceRun& run) {
    const auto vertices = std::span<const Vertex>(active.made_vertices)
                              .subspan(mesh.first_vertex + std::size_t{first} * mesh.columns,
                                       (std::size_t{last} - first + 1) * mesh.columns);
    Vec3f least(vertices.front().position);
    Vec3f greatest = least;
    for (const Vertex& vertex : vertices) {
        least = glm::min(least, Vec3f(vertex.position));
        greatest = glm::max(greatest, Vec3f(vertex.position));
    }
    run.centre = 0.5F * (least + greatest);
    const Vec3f half = 0.5F * (greatest - least);
    run.radius = 1.001F * std::sqrt(half.x * half.x + half.y * half.y + half.z * half.z) + 0.01F;
}

} // namespace

Vertex lit_vertex(const Vec2d& position_m, double height_m, const Vec2d& slope, double light) {
    Vec3d normal(-slope_gain * slope.x, -slope_gain * slope.y, light);
    const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
    if (length > 1.0) normal /= length;
    return {.position = {static_cast<float>(position_m.x), static_cast<float>(position_m.y),
                         static_cast<float>(height_m), 1.0F},
            .normal = Vec3f(normal)};
}

bool is_dark(const Vertex& vertex) {
    return std::fabs(vertex.normal.x) + std::fabs(vertex.normal.y) + std::fabs(vertex.normal.z) < dark;
}

void make_mesh_faces(const MeshRows& mesh, std::uint16_t colour, ActiveDatabase& active) {
    const Face face{.corner_count = 4, .colour = colour, .shading = Shading::vertex, .two_sided = 1};
    for (std::uint32_t first = 0; first + 1 < mesh.rows; first += rows_of_a_run) {
        const std::uint32_t last = std::min(first + rows_of_a_run, mesh.rows - 1);
        FaceRun run{.first_face = static_cast<std::uint32_t>(active.made_faces.size())};
        for (std::uint32_t row = first; row < last; ++row)
            for (std::uint32_t column = 0; column + 1 < mesh.columns; ++column)
                make_square(mesh, row, column, face, active);
        run.face_count = static_cast<std::uint32_t>(active.made_faces.size()) - run.first_face;
        if (run.face_count == 0) continue;
        bound(mesh, first, last, active, run);
        active.made_runs.push_back(run);
    }
}

void finish_made_block(std::uint32_t first_run, std::uint32_t block_index, ActiveDatabase& active) {
    const auto runs = static_cast<std::uint32_t>(active.made_runs.size()) - first_run;
    if (runs == 0) return;
    active.made_leaves.push_back({.first_run = first_run, .run_count = runs});
    active.blocks[block_index].root =
        leaf_reference(static_cast<std::uint32_t>(active.made_leaves.size() - 1));
    active.made_faces_of.push_back(block_index);
}

} // namespace linkdig::ig
