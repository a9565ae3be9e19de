#include "tools/flight/planes.h"

#include "ig/geometry/projected_face.h"
#include "ig/sink/image_file.h"
#include "ig/video/pixel_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <utility>

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
    NamedPlane{"edges", ig::Plane::edges},   NamedPlane{"flat", ig::Plane::flat},
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

std::vector<std::uint32_t> edges_over(const ig::VideoFrame& picture) {
    std::vector<std::uint32_t> pixels = picture.pixels;
    const auto is_border = [&](std::size_t at, std::uint32_t column, std::uint32_t row) {
        const std::int32_t rank = picture.rank[at];
        return (column + 1 < picture.width && picture.rank[at + 1] != rank) ||
               (row + 1 < picture.height && picture.rank[at + picture.width] != rank);
    };
    for (std::uint32_t row = 0; row < picture.height; ++row)
        for (std::uint32_t column = 0; column < picture.width; ++column) {
            const std::size_t at = std::size_t{row} * picture.width + column;
            if (!is_border(at, column, row)) continue;
            const std::uint32_t seen = pixels[at];
            const bool dark = (seen & 255U) + 2 * (seen >> 8U & 255U) + (seen >> 16U & 255U) < 4 * 128;
            pixels[at] = dark ? 0xffffffffU : 0xff000000U;
        }
    return pixels;
}

std::vector<std::uint32_t> flat_colours(const VisualDatabase& database, const ig::Machine& machine,
                                        std::size_t channel) {
    const ig::VideoFrame& picture = machine.picture(channel);
    std::vector<std::uint32_t> pixels = picture.pixels;
    for (std::size_t at = 0; at < pixels.size(); ++at) {
        if (picture.rank[at] == none) continue; // the background keeps its colour
        const ig::Machine::Source source = machine.source(channel, picture.rank[at]);
        if (database.lists[source.list].attachment == Attachment::eye) continue; // as does a sky
        pixels[at] = ig::shade(database.colours[source.colour], source.flat_intensity);
    }
    return pixels;
}

namespace {

void write_pixels(const std::string& path, const ig::VideoFrame& picture, std::vector<std::uint32_t> pixels) {
    ig::VideoFrame shown;
    shown.width = picture.width;
    shown.height = picture.height;
    shown.pixels = std::move(pixels);
    ig::write_png(path, shown);
}

} // namespace

void write_plane(ig::Plane plane, const VisualDatabase& database, const ig::Machine& machine,
                 std::size_t channel, const std::string& folder, std::uint64_t frame) {
    const ig::VideoFrame& picture = machine.picture(channel);
    const std::string stem = fmt::format("{}/{}_{:06}", folder, plane_name(plane), frame);
    if (plane == ig::Plane::colour)
        ig::write_png(stem + ".png", picture);
    else if (plane == ig::Plane::edges)
        write_pixels(stem + ".png", picture, edges_over(picture));
    else if (plane == ig::Plane::flat)
        write_pixels(stem + ".png", picture, flat_colours(database, machine, channel));
    else if (plane == ig::Plane::intensity)
        ig::write_exr(stem + ".exr", picture.width, picture.height, intensities(picture.intensity));
    else
        ig::write_exr(stem + ".exr", plane_name(plane), picture.width, picture.height,
                      numbers(plane, database, machine, channel));
}

} // namespace linkdig::tools
