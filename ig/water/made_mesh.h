#pragma once
/// Faces made at frame time over rows of vertices, lit through their list's sun by normals that are slopes.

#include "ig/active/face_block.h"

namespace linkdig::ig {

/// Slope to light: a normal is this many times the slope, turned against it. The sea's own normals lean 22 degrees: waves of a real
/// steepness, a tenth, would not be seen beside them (estimated, by eye).
inline constexpr double slope_gain = 4.0;

/// A vertex relative to the block's origin. Longer normals than 1 are cut to that: the light has its limit there.
Vertex lit_vertex(const Vec2d& position_m, double height_m, const Vec2d& slope, double light);

/// Can it be told from no light at all?
bool is_dark(const Vertex& vertex);

/// The rows of one mesh: vertex (row, column) is first_vertex + row * columns + column.
struct MeshRows {
    std::uint32_t first_vertex = 0;
    std::uint32_t columns = 0;
    std::uint32_t rows = 0; ///< of vertices
};

/// Squares between rows, without the dark ones, in runs of 16 rows with their bounding spheres; two-sided, since a mesh that bends
/// folds over.
void make_mesh_faces(const MeshRows& mesh, std::uint16_t colour, ActiveDatabase& active);

/// Makes the block one of the runs from `first_run` on.
void finish_made_block(std::uint32_t first_run, std::uint32_t block_index, ActiveDatabase& active);

} // namespace linkdig::ig
