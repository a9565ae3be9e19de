#pragma once
/// The pools of faces that are made at frame time: repeated tiles (repeated_tile.h) and what other stages add.

#include "ig/active/face_block.h"

#include <cstddef>

namespace linkdig::ig {

/// Empties the pools of made faces; capacity stays.
void clear_made_faces(ActiveDatabase& active);

/// Gives all faces made since there were `first_face` of them to the list's own object, which the compiler adds to every list that
/// holds none: what is counted, shed and explained goes by objects.
void give_to_list(std::uint32_t list, std::size_t first_face, ActiveDatabase& active);

/// Gives every block of made faces its spans, once the pools no longer grow.
void settle_made_faces(ActiveDatabase& active);

} // namespace linkdig::ig
