#include "database/compiler/check_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace linkdig::database {

namespace {

std::string corner_text(const ModelObject& object, const ModelFace& face, std::size_t corner) {
    const ModelVertex& vertex = object.vertices[face.corners[corner]];
    return vertex.name.empty() ? fmt::format("corner {}", corner + 1)
                               : fmt::format("corner \"{}\"", vertex.name);
}

std::string fault_text(const ModelObject& object, const ModelFace& face, const PolygonReport& report) {
    const std::string of_face = fmt::format("a face of object \"{}\"", object.name);
    switch (report.fault) {
    case PolygonFault::not_planar:
        return fmt::format("{} is not planar: {} lies {:.4g} m off its plane; expected at most {:.4g} m",
                           of_face, corner_text(object, face, report.corner), report.deviation_m,
                           report.allowed_m);
    case PolygonFault::concave:
        return fmt::format(
            "{} is concave at {}; expected convex faces, counter-clockwise seen from the front", of_face,
            corner_text(object, face, report.corner));
    case PolygonFault::self_intersecting:
        return fmt::format("{} intersects itself; expected corners in their order around the face", of_face);
    case PolygonFault::zero_area:
        return fmt::format("{} has no area; expected three corners that span one", of_face);
    case PolygonFault::none:
        break;
    }
    return {};
}

/// Two neighbours at one place: the machine would draw an edge without length.
std::optional<std::size_t> coincident_corner(const ModelObject& object, const ModelFace& face) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const std::size_t next = (i + 1) % face.corners.size();
        if (object.vertices[face.corners[i]].position == object.vertices[face.corners[next]].position)
            return i;
    }
    return std::nullopt;
}

bool check_vertices(const ModelObject& object, const Reading& reading) {
    bool good = true;
    for (const ModelVertex& vertex : object.vertices) {
        const Vec3d size = glm::abs(Vec3d(vertex.position));
        if (std::max({size.x, size.y, size.z}) <= largest_coordinate_m) continue;
        const std::string name =
            vertex.name.empty() ? "a vertex" : fmt::format("the vertex \"{}\"", vertex.name);
        reading.error(vertex.at, fmt::format("{} of object \"{}\" lies beyond {:.0f} m; expected less", name,
                                             object.name, largest_coordinate_m));
        good = false;
        break; // one tells enough: a repeated primitive would tell thousands
    }
    for (const ModelLight& light : object.lights) {
        const Vec3f size = glm::abs(light.point.position);
        if (static_cast<double>(std::max({size.x, size.y, size.z})) <= largest_coordinate_m) continue;
        reading.error(light.at, fmt::format("a light of object \"{}\" lies beyond {:.0f} m; expected less",
                                            object.name, largest_coordinate_m));
        good = false;
        break;
    }
    return good;
}

/// Normals that the author gave say where the front is: if all of a face's are on its back, its corners run the wrong way.
bool check_normals(const ModelObject& object, const ModelFace& face, const Reading& reading) {
    std::size_t given = 0, against = 0;
    for (const std::uint32_t corner : face.corners) {
        const std::optional<Vec3d>& normal = object.vertices[corner].normal;
        given += normal ? 1 : 0;
        against += normal && glm::dot(*normal, face.plane.normal) < 0 ? 1 : 0;
    }
    if (given == 0 || against < given || face.style.two_sided || face.at_infinity) return true;
    reading.error(
        face.at,
        fmt::format("a face of object \"{}\" is reversed: the normals of its corners point behind it; "
                    "expected corners counter-clockwise seen from the front",
                    object.name));
    return false;
}

bool check_face(const ModelObject& object, ModelFace& face, const Reading& reading) {
    if (const auto corner = coincident_corner(object, face)) {
        reading.error(face.at,
                      fmt::format("{} and {} of a face of object \"{}\" are at the same place; expected "
                                  "distinct corners",
                                  corner_text(object, face, *corner),
                                  corner_text(object, face, (*corner + 1) % face.corners.size()),
                                  object.name));
        return false;
    }
    std::vector<Vec4d> corners;
    for (const std::uint32_t corner : face.corners)
        corners.push_back(object.vertices[corner].position);
    const PolygonReport report = examine(corners);
    face.plane = report.plane;
    face.deviation_m = report.deviation_m;
    face.at_infinity = report.at_infinity;
    if (report.fault == PolygonFault::none) return object.of_mesh || check_normals(object, face, reading);
    reading.error(face.at, fault_text(object, face, report));
    return false;
}

} // namespace

void check_faces(std::vector<ModelObject>& objects, const Reading& reading) {
    for (ModelObject& object : objects) {
        if (!check_vertices(object, reading)) {
            object.faces.clear();
            object.lights.clear();
            continue;
        }
        std::vector<ModelFace> good;
        for (ModelFace& face : object.faces)
            if (check_face(object, face, reading)) good.push_back(std::move(face));
        object.faces = std::move(good);
    }
}

void check_slots(const std::vector<ModelObject>& objects, const Reading& reading) {
    const Registry& registry = *reading.registry;
    std::vector<std::set<std::uint32_t>> covered(registry.slots.size());
    for (const ModelObject& object : objects) {
        if (object.slot == none) continue;
        const auto slot = static_cast<std::size_t>(object.slot);
        const std::uint32_t first = registry.first_objects[slot];
        if (object.alternative >= first && object.alternative < registry.alternatives[slot])
            covered[slot].insert(object.alternative);
        else
            reading.error(
                object.at,
                fmt::format("object \"{}\" is alternative {} of slot \"{}\", which has {}{}; expected "
                            "{} to {}",
                            object.name, object.alternative, registry.slots.names()[slot],
                            registry.alternatives[slot], first == 0 ? "" : ", the first empty", first,
                            registry.alternatives[slot] - 1));
    }
    for (std::size_t slot = 0; slot < covered.size(); ++slot) {
        const std::uint32_t first = registry.first_objects[slot];
        if (covered[slot].size() + first == registry.alternatives[slot]) continue;
        std::uint32_t missing = first;
        while (covered[slot].count(missing) != 0)
            ++missing;
        reading.error(
            registry.slot_places[slot],
            fmt::format("slot \"{}\" has {} alternatives, but its objects cover {} of them; expected also "
                        "alternative {}",
                        registry.slots.names()[slot], registry.alternatives[slot], covered[slot].size(),
                        missing));
    }
}

void check_levels(const std::vector<ModelObject>& objects, const Reading& reading) {
    const Registry& registry = *reading.registry;
    std::vector<std::set<std::uint32_t>> covered(registry.authored_details.size());
    for (const ModelObject& object : objects) {
        if (object.detail == none) continue;
        const auto detail = static_cast<std::size_t>(object.detail);
        const std::size_t levels = registry.authored_details[detail].to_m.size();
        covered[detail].insert(object.level);
        if (object.level >= levels && levels > 0) // without any, its ranges were reported
            reading.error(
                object.at,
                fmt::format("object \"{}\" is level {} of detail \"{}\", which has {}; expected 0 to {}",
                            object.name, object.level, registry.details.names()[detail], levels, levels - 1));
    }
    for (std::size_t detail = 0; detail < covered.size(); ++detail) {
        const AuthoredDetail& authored = registry.authored_details[detail];
        for (std::uint32_t level = 0; level < authored.to_m.size(); ++level)
            if (!covered[detail].contains(level))
                reading.error(authored.at,
                              fmt::format("no object is level {} of detail \"{}\"; expected at least one",
                                          level, registry.details.names()[detail]));
    }
}

void average_normals(ModelObject& object) {
    std::vector<Vec3d> sums(object.vertices.size(), Vec3d(0.0));
    std::vector<const ModelFace*> first(object.vertices.size(), nullptr);
    for (const ModelFace& face : object.faces)
        for (const std::uint32_t corner : face.corners) {
            sums[corner] += face.plane.normal;
            if (first[corner] == nullptr) first[corner] = &face;
        }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (object.vertices[i].normal || first[i] == nullptr) continue;
        const double length = glm::length(sums[i]);
        // Faces back to back have no median direction: the first one's normal stands for them.
        object.vertices[i].normal = length > 1e-6 ? sums[i] / length : first[i]->plane.normal;
    }
}

} // namespace linkdig::database
