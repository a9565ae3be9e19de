#pragma once
/// A visual database as a mesh: nodes cluster, object list, object.

#include "database/mesh/mesh.h"

namespace linkdig::database {

struct DatabaseMesh {
    /// Metres; file x is our y (port, north), file y our z (up), file z our x (forward, east), as in glTF.
    Mesh mesh;
    std::uint64_t faces = 0;
    std::uint64_t at_infinity = 0; ///< faces left out: a corner of theirs has no place
    std::uint64_t tiles = 0;       ///< repeated tiles left out: they have no end
};

/// A material for each colour code, opacity and kind of face in use, with the colour's name; a node for every object
/// with faces, those of absent alternatives too. Faces that the compiler has cut come as their parts.
DatabaseMesh mesh_of(const VisualDatabase& database);

} // namespace linkdig::database
