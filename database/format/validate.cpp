#include "database/format/validate.h"

#include "database/format/validate_parts.h"

#include <tbb/parallel_for.h>

#include <array>
#include <initializer_list>
#include <utility>

namespace linkdig::database {

std::string check_vertices(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.vertices.size(); ++i) {
        const Vertex& vertex = database.vertices[i];
        const Vec4f& p = vertex.position;
        if (p.w != 0.0F && p.w != 1.0F)
            return wrong("vertices", i, fmt::format("position.w is {}; expected 1, or 0 at infinity", p.w));
        if (!all_within(p, -max_coordinate_m, max_coordinate_m))
            return wrong("vertices", i, "position is not finite, or beyond 1e7 m");
        if (p.w == 0.0F && p.x == 0.0F && p.y == 0.0F && p.z == 0.0F)
            return wrong("vertices", i, "position lies at infinity in no direction");
        if (!within(length_of(vertex.normal), 0.0, 1.0 + unit_tolerance))
            return wrong("vertices", i, "normal is not finite, or longer than 1");
    }
    return {};
}

namespace {

std::string check_face(const VisualDatabase& database, std::size_t i) {
    const Face& face = database.faces[i];
    if (face.corner_count < 3)
        return wrong("faces", i, fmt::format("corner_count is {}; expected at least 3", face.corner_count));
    if (!span_fits(face.first_corner, face.corner_count, database.corners.size()))
        return out_of_range("faces", i, "first_corner", face.first_corner, database.corners.size(),
                            "corners");
    if (face.colour >= database.colours.size())
        return out_of_range("faces", i, "colour", face.colour, database.colours.size(), "colours");
    if (face.object >= database.objects.size())
        return out_of_range("faces", i, "object", face.object, database.objects.size(), "objects");
    const bool generated = database.source_files.empty() && face.file == 0 && face.line == 0;
    if (!generated && face.file >= database.source_files.size())
        return out_of_range("faces", i, "file", face.file, database.source_files.size(), "source_files");
    if (face.shading > Shading::vertex) return wrong("faces", i, "shading is none of none, face, vertex");
    if (face.two_sided > 1) return wrong("faces", i, "two_sided is neither 0 nor 1");
    if (face.coloured > 1) return wrong("faces", i, "coloured is neither 0 nor 1");
    if (face.coloured == 1 && database.corner_colours.empty())
        return wrong("faces", i, "coloured is set, but there are no corner_colours");
    if (face.opacity < 1 || face.opacity > 256) return wrong("faces", i, "opacity is not in 1 to 256");
    if (!within(length_of(face.normal), 1.0 - unit_tolerance, 1.0 + unit_tolerance))
        return wrong("faces", i, "normal is not a unit vector");
    return {};
}

} // namespace

std::string check_faces(const VisualDatabase& database) {
    if (!database.corner_colours.empty() && database.corner_colours.size() != database.corners.size())
        return fmt::format("there are {} corners, but {} corner_colours", database.corners.size(),
                           database.corner_colours.size());
    std::uint64_t corners = 0;
    for (std::size_t i = 0; i < database.faces.size(); ++i) {
        if (std::string reason = check_face(database, i); !reason.empty()) return reason;
        corners += database.faces[i].corner_count;
    }
    // Faces that share corners could make a small file draw for hours.
    if (corners > database.corners.size())
        return fmt::format("faces have {} corners in all, but there are {}", corners,
                           database.corners.size());
    for (std::size_t i = 0; i < database.corners.size(); ++i)
        if (database.corners[i] >= database.vertices.size())
            return fmt::format("corners[{}] is {}, but there are {} vertices", i, database.corners[i],
                               database.vertices.size());
    return {};
}

std::string check_runs(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.runs.size(); ++i) {
        const FaceRun& run = database.runs[i];
        if (!span_fits(run.first_face, run.face_count, database.faces.size()))
            return out_of_range("runs", i, "first_face", run.first_face, database.faces.size(), "faces");
        if (!span_fits(run.first_light, run.light_count, database.lights.size()))
            return out_of_range("runs", i, "first_light", run.first_light, database.lights.size(), "lights");
        if (!none_or_below(run.slot, database.slots.size()))
            return out_of_range("runs", i, "slot", run.slot, database.slots.size(), "slots");
        if (run.slot != none &&
            run.alternative >= database.slots[static_cast<std::size_t>(run.slot)].alternatives)
            return wrong("runs", i, fmt::format("alternative is {}, beyond its slot's", run.alternative));
        if (!none_or_below(run.level, database.detail_levels.size()))
            return out_of_range("runs", i, "level", run.level, database.detail_levels.size(),
                                "detail_levels");
        if (!all_within(run.centre, -max_coordinate_m, max_coordinate_m))
            return wrong("runs", i, "centre is not finite, or beyond 1e7 m");
        if (!within(run.radius, -4 * max_coordinate_m, 4 * max_coordinate_m))
            return wrong("runs", i, "radius is not finite, or beyond 4e7 m");
    }
    return {};
}

std::string check_planes(const VisualDatabase& database) {
    for (std::size_t i = 0; i < database.planes.size(); ++i) {
        const PlaneNode& plane = database.planes[i];
        const double length = length_of(plane.normal);
        if (length != 0.0 && !within(length, 1.0 - unit_tolerance, 1.0 + unit_tolerance))
            return wrong("planes", i, "normal is neither a unit vector nor zero");
        if (!within(plane.distance, -4 * max_coordinate_m, 4 * max_coordinate_m))
            return wrong("planes", i, "distance is not finite, or beyond 4e7 m");
        if (plane.waterline > 1) return wrong("planes", i, "waterline is neither 0 nor 1");
        for (const std::uint8_t byte : plane.reserved)
            if (byte != 0) return wrong("planes", i, "reserved is not zero");
    }
    return {};
}

namespace {

using Check = std::string (*)(const VisualDatabase&);

std::string in_turn(const VisualDatabase& database, std::initializer_list<Check> checks) {
    for (const Check check : checks)
        if (std::string reason = check(database); !reason.empty()) return reason;
    return {};
}

/// These follow no index that another of them finds in range. Of several reasons the first in their order is told.
std::string side_by_side(const VisualDatabase& database) {
    constexpr std::array<Check, 5> checks = {check_vertices, check_faces, check_lights, check_runs,
                                             check_planes};
    std::array<std::string, checks.size()> reasons;
    tbb::parallel_for(std::size_t{0}, checks.size(),
                      [&](std::size_t i) { reasons[i] = checks[i](database); });
    for (std::string& reason : reasons)
        if (!reason.empty()) return std::move(reason);
    return {};
}

} // namespace

std::string validate(const VisualDatabase& database) {
    return in_turn(database,
                   {check_names, check_owners, check_details, side_by_side, check_tiles, check_trees});
}

} // namespace linkdig::database
