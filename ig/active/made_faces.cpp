#include "ig/active/made_faces.h"

namespace linkdig::ig {

namespace {

std::uint32_t object_of_list(const VisualDatabase& database, std::uint32_t list) {
    for (std::uint32_t o = 0; o < database.objects.size(); ++o) {
        if (database.objects[o].list == list) return o;
    }
    return 0;
}

} // namespace

void clear_made_faces(ActiveDatabase& active) {
    active.made_vertices.clear();
    active.made_corners.clear();
    active.made_faces.clear();
    active.made_runs.clear();
    active.made_leaves.clear();
    active.made_faces_of.clear();
}

void give_to_list(std::uint32_t list, std::size_t first_face, ActiveDatabase& active) {
    const std::uint32_t object = object_of_list(*active.database, list);
    for (std::size_t f = first_face; f < active.made_faces.size(); ++f)
        active.made_faces[f].object = object;
}

void settle_made_faces(ActiveDatabase& active) {
    for (const std::uint32_t b : active.made_faces_of) {
        FaceBlock& block = active.blocks[b];
        block.vertices = active.made_vertices;
        block.corners = active.made_corners;
        block.faces = active.made_faces;
        block.runs = active.made_runs;
        block.leaves = active.made_leaves;
    }
}

} // namespace linkdig::ig
