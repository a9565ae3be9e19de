#include "tools/flight/planes.h"

#include "ig/geometry/projected_face.h"
#include "ig/sink/image_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>

namespace linkdig::tools {
namespace {

struct NamedPlane {
    const char* name;
    ig::Plane plane;
};
constexpr std::array named_planes{
    NamedPlane{"colour", ig::Plane::colour}, NamedPlane{"intensity", ig::Plane::intensity},
    NamedPlane{"rank", ig::Plane::rank},     NamedPlane{"list", ig::Plane::list},
    NamedPlane{"object", ig::Plane::object}, NamedPlane{"face", ig::Plane::face},
};

ig::Plane plane_of(const std::string& name) {
    const auto found = std::ranges::find(named_planes, std::string_view(name), &NamedPlane::name);
    if (found != named_planes.end()) return found->plane;
    std::vector<std::string> known;
    known.reserve(named_planes.size());
    for (const NamedPlane& named : named_planes)
        known.emplace_back(named.name);
    throw std::invalid_argument(
        fmt::format("there is no plane named '{}'; expected some of {}", name, fmt::join(known, ", ")));
}

std::uint32_t face_number(const Face* face, const VisualDatabase& database) {
    const Face* first = database.faces.data();
    // std::less orders pointers of different arrays as well.
    if (std::less<>{}(face, first) || !std::less<>{}(face, first + database.faces.size())) return made_face;
    return static_cast<std::uint32_t>(face - first);
}

std::uint32_t number(ig::Plane plane, const VisualDatabase& database, const ig::Machine::Source& source) {
    switch (plane) {
    case ig::Plane::list:
        return source.list;
    case ig::Plane::object:
        return source.object;
    default:
        return face_number(source.face, database);
    }
}

} // namespace

std::vector<ig::Plane> parse_planes(const std::string& names) {
    std::vector<ig::Plane> planes;
    std::size_t begin = 0;
    while (begin <= names.size()) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        planes.push_back(plane_of(names.substr(begin, end - begin)));
        begin = end + 1;
    }
    return planes;
}

const char* plane_name(ig::Plane plane) {
    return std::ranges::find(named_planes, plane, &NamedPlane::plane)->name;
}

std::vector<float> intensities(std::span<const std::int32_t> plane) {
    std::vector<float> values(plane.size());
    std::ranges::transform(plane, values.begin(), [](std::int32_t intensity) {
        return intensity < 0 ? 0.0F : static_cast<float>(intensity) / static_cast<float>(ig::intensity_one);
    });
    return values;
}

std::vector<std::uint32_t> numbers(ig::Plane plane, const VisualDatabase& database,
                                   const ig::Machine& machine, std::size_t channel) {
    const std::vector<std::int32_t>& ranks = machine.picture(channel).rank;
    std::vector<std::uint32_t> values(ranks.size());
    std::ranges::transform(ranks, values.begin(), [&](std::int32_t rank) {
        if (rank == none) return no_face;
        if (plane == ig::Plane::rank) return static_cast<std::uint32_t>(rank);
        return number(plane, database, machine.source(channel, rank));
    });
    return values;
}

void write_plane(ig::Plane plane, const VisualDatabase& database, const ig::Machine& machine,
                 std::size_t channel, const std::string& folder, std::uint64_t frame) {
    const ig::VideoFrame& picture = machine.picture(channel);
    const std::string stem = fmt::format("{}/{}_{:06}", folder, plane_name(plane), frame);
    if (plane == ig::Plane::colour)
        ig::write_png(stem + ".png", picture);
    else if (plane == ig::Plane::intensity)
        ig::write_exr(stem + ".exr", picture.width, picture.height, intensities(picture.intensity));
    else
        ig::write_exr(stem + ".exr", plane_name(plane), picture.width, picture.height,
                      numbers(plane, database, machine, channel));
}

} // namespace linkdig::tools
