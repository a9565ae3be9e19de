#include "tools/compare/ids.h"

#include "tools/flight/planes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

namespace linkdig::compare {
namespace {

using tools::made_face;
using tools::no_face;

/// What the planes say of a pixel; an unknown plane is no_face.
using Triple = std::array<std::uint32_t, 3>; // list, object, face

Triple triple(const Ids& ids, std::size_t pixel) {
    const auto at = [&](const std::vector<std::uint32_t>& plane) {
        return plane.empty() ? no_face : plane[pixel];
    };
    return {at(ids.list), at(ids.object), at(ids.face)};
}

/// A face knows its object, an object its list: planes that are not there are filled in.
void fill_in(Triple& t, const VisualDatabase& database) {
    auto& [list, object, face] = t;
    if (face < database.faces.size()) object = database.faces[face].object;
    if (object < database.objects.size()) list = database.objects[object].list;
}

std::string named(const Triple& t, const VisualDatabase& database) {
    const auto [list, object, face] = t;
    std::vector<std::string> parts;
    if (face < database.faces.size()) parts.push_back(fmt::format("face {}", face));
    if (face == made_face) parts.emplace_back("a copy of a tile's face");
    if (object < database.objects.size())
        parts.push_back(fmt::format("object \"{}\"", database.objects[object].name));
    if (list < database.lists.size()) parts.push_back(fmt::format("list {}", database.lists[list].name));
    std::string text = fmt::format("{}", fmt::join(parts, ", "));
    if (face < database.faces.size()) {
        const Face& found = database.faces[face];
        if (found.file < database.source_files.size())
            text += fmt::format(" ({}:{})", database.source_files[found.file], found.line);
    }
    return text;
}

std::string numbered(const Triple& t) {
    constexpr std::array words{"list", "object", "face"};
    std::vector<std::string> parts;
    for (std::size_t k = words.size(); k-- > 0;)
        if (t[k] != no_face)
            parts.push_back(t[k] == made_face ? "a tile's face" : fmt::format("{} {}", words[k], t[k]));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string text_of(Triple t, const VisualDatabase* database) {
    if (std::ranges::all_of(t, [](std::uint32_t number) { return number == no_face; }))
        return "the background";
    if (database == nullptr) return numbered(t);
    fill_in(t, *database);
    const std::string text = named(t, *database);
    return text.empty() ? numbered(t) : text; // planes of another database
}

} // namespace

std::string who(const Ids& ids, std::size_t pixel, const VisualDatabase* database) {
    return ids.any() ? text_of(triple(ids, pixel), database) : "";
}

std::vector<Culprit> culprits(std::span<const float> levels, const Ids& expected, const Ids& actual,
                              const VisualDatabase* expected_names, const VisualDatabase* actual_names,
                              std::size_t most) {
    struct Count {
        std::uint64_t pixels = 0;
        std::size_t first = 0;
    };
    std::map<std::pair<Triple, Triple>, Count> counts;
    if (!expected.any() && !actual.any()) return {};
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (levels[k] == 0.0F) continue;
        Count& count = counts[{triple(expected, k), triple(actual, k)}];
        if (count.pixels++ == 0) count.first = k;
    }
    std::vector<Culprit> found;
    found.reserve(counts.size());
    for (const auto& [pair, count] : counts)
        found.push_back({expected.any() ? text_of(pair.first, expected_names) : "",
                         actual.any() ? text_of(pair.second, actual_names) : "", count.pixels, count.first});
    std::ranges::stable_sort(found, [](const Culprit& a, const Culprit& b) { return a.pixels > b.pixels; });
    found.resize(std::min(found.size(), most));
    return found;
}

std::vector<std::uint8_t> drawn_pixels(const Ids& expected, const Ids& actual) {
    std::vector<std::uint8_t> drawn;
    for (const Ids* ids : {&expected, &actual}) {
        for (const auto* plane : {&ids->list, &ids->object, &ids->face}) {
            if (plane->empty()) continue;
            drawn.resize(plane->size(), 0);
            for (std::size_t k = 0; k < std::min(drawn.size(), plane->size()); ++k)
                drawn[k] |= (*plane)[k] != no_face ? 1 : 0;
        }
    }
    return drawn;
}

} // namespace linkdig::compare
