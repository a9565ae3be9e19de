#pragma once
/// The parts of validate(): each checks one kind of record and returns what is wrong, or an empty string.

#include "database/model/visual_database.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace linkdig::database {

std::string check_names(const VisualDatabase& database);
std::string check_owners(const VisualDatabase& database); ///< slots, groups, clusters, lists, objects
std::string check_details(const VisualDatabase& database);
std::string check_vertices(const VisualDatabase& database);
std::string check_faces(const VisualDatabase& database);
std::string check_runs(const VisualDatabase& database);
std::string check_lights(const VisualDatabase& database);
std::string check_planes(const VisualDatabase& database);
std::string check_tiles(const VisualDatabase& database);
/// Last, for it follows indices that the others have found in range.
std::string check_trees(const VisualDatabase& database);

/// "lists[3].sun is 7, but there are 2 suns"
inline std::string out_of_range(std::string_view records, std::size_t i, std::string_view member,
                                std::int64_t index, std::size_t count, std::string_view of_what) {
    return fmt::format("{}[{}].{} is {}, but there are {} {}", records, i, member, index, count, of_what);
}

/// "vertices[3].normal is not a unit vector"
inline std::string wrong(std::string_view records, std::size_t i, std::string_view what) {
    return fmt::format("{}[{}].{}", records, i, what);
}

inline double length_of(const Vec3f& v) {
    const double x = v.x;
    const double y = v.y;
    const double z = v.z;
    return std::sqrt(x * x + y * y + z * z);
}

/// False for what is not finite, too.
inline bool within(double value, double least, double greatest) {
    return value >= least && value <= greatest;
}

template <typename Vector>
bool all_within(const Vector& v, double least, double greatest) {
    for (int i = 0; i < v.length(); ++i)
        if (!within(static_cast<double>(v[i]), least, greatest)) return false;
    return true;
}

/// Of an index that may be `none`.
inline bool none_or_below(std::int32_t index, std::size_t count) {
    return index == none || (index >= 0 && static_cast<std::size_t>(index) < count);
}

/// Do `count` things from `first` on lie inside `size` things?
inline bool span_fits(std::uint64_t first, std::uint64_t count, std::uint64_t size) {
    return count <= size && first <= size - count;
}

} // namespace linkdig::database
