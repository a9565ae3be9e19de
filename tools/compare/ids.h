#pragma once
/// Who is seen: the planes of lists, objects and faces beside a picture, and their names from a database.

#include "database/model/visual_database.h"
#include "tools/compare/picture.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace linkdig::compare {

/// Numbers for every pixel, as linkdig render writes them; each plane may be empty: not known.
struct Ids {
    std::vector<std::uint32_t> list, object, face;
    bool any() const { return !list.empty() || !object.empty() || !face.empty(); }
};

/// "face 31 of object "deck", list lph2.hull (hull.toml:12)"; numbers alone without a database, "the
/// background" where no face is seen.
std::string who(const Ids& ids, std::size_t pixel, const VisualDatabase* database);

/// What differing pixels show on either side.
struct Culprit {
    std::string expected;
    std::string actual;
    std::uint64_t pixels = 0;
    std::size_t first = 0; ///< pixel
};

/// The pairs behind the differing pixels, most pixels first, at most `most`. `levels` is difference_levels().
std::vector<Culprit> culprits(std::span<const float> levels, const Ids& expected, const Ids& actual,
                              const VisualDatabase* expected_names, const VisualDatabase* actual_names,
                              std::size_t most);

/// A byte per pixel: 1 where either side shows a face. Empty if neither has a plane.
std::vector<std::uint8_t> drawn_pixels(const Ids& expected, const Ids& actual);

} // namespace linkdig::compare
