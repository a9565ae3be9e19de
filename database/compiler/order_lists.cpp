#include "database/compiler/order_lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace linkdig::database {

namespace {

/// A list with one mistake in a repeated primitive has thousands of pairs: these many tell enough.
constexpr std::size_t most_pairs_told = 20;
/// Relative error of a stored coordinate, with a margin for the sums of its side.
constexpr double coordinate_error = 4e-7;

Levels levels_of(const Detail& detail) {
    if (detail.added != 0) return Levels::added;
    return detail.blend_m > 0 ? Levels::blended : Levels::one_by_one;
}

void place_in_detail(const ModelObject& object, const Registry& registry, OrderFace& face) {
    face.detail = object.detail;
    face.level = object.level;
    if (object.detail != none)
        face.levels = levels_of(registry.authored_details[static_cast<std::size_t>(object.detail)].detail);
}

OrderFace order_face(const ModelObject& object, const ModelFace& face, std::uint32_t source,
                     const Registry& registry) {
    OrderFace result;
    double largest = 0;
    const std::uint16_t number = face.style.colour.value_or(0);
    const Colour code = number < registry.colours.size() ? registry.colours[number] : Colour{};
    const Vec3d own_colour(code.red, code.green, code.blue);
    result.interpolates = face.style.shading == Shading::vertex;
    for (const std::uint32_t corner : face.corners) {
        const ModelVertex& vertex = object.vertices[corner];
        OrderCorner made{vertex.position};
        if (vertex.colour) result.coloured = true;
        made.colour = vertex.colour.value_or(own_colour);
        if (result.interpolates) made.normal = vertex.normal.value_or(face.plane.normal);
        result.corners.push_back(made);
        if (vertex.position.w != 0) largest = std::max(largest, glm::length(Vec3d(vertex.position)));
    }
    result.plane = face.plane;
    result.tolerance = std::max({plane_tolerance_m, 1.01 * face.deviation_m, coordinate_error * largest});
    result.at_infinity = face.at_infinity;
    result.two_sided = face.style.two_sided;
    result.layer = face.style.layer;
    result.of_mesh = object.of_mesh;
    result.slot = object.slot;
    result.alternative = object.alternative;
    place_in_detail(object, registry, result);
    result.source = source;
    return result;
}

OrderFace order_light(const ModelObject& object, const ModelLight& light, std::uint32_t source,
                      const Registry& registry) {
    OrderFace result;
    const Vec3d position(light.point.position);
    result.corners.emplace_back().position = Vec4d(position, 1.0);
    result.is_light = true;
    result.directed = light.point.beam == LightBeam::one_way;
    result.plane.normal = Vec3d(light.point.direction);
    result.plane.distance = glm::dot(result.plane.normal, position);
    result.tolerance = std::max(plane_tolerance_m, coordinate_error * glm::length(position));
    result.slot = object.slot;
    result.alternative = object.alternative;
    result.source = source;
    place_in_detail(object, registry, result);
    return result;
}

class PairReport {
public:
    PairReport(const std::vector<ModelObject>& objects, const OrderedList& list, const Reading& reading)
        : objects_(objects), list_(list), reading_(reading) {}

    void tell(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs, const char* what,
              const char* expected) const {
        for (std::size_t i = 0; i < pairs.size() && i < most_pairs_told; ++i) {
            const auto& [a, b] = pairs[i];
            std::string message = fmt::format(
                "{}: this one of object \"{}\" and that of object \"{}\" in {}:{}; {}", what, object(b).name,
                object(a).name, reading_.sources->files[place(a).file].path, place(a).line, expected);
            if (i + 1 == most_pairs_told && pairs.size() > most_pairs_told)
                message += fmt::format(" (and {} more pairs of this list)", pairs.size() - most_pairs_told);
            reading_.error(place(b), std::move(message));
        }
    }

private:
    const ModelObject& object(std::uint32_t source) const { return objects_[list_.sources[source].object]; }
    Place place(std::uint32_t source) const {
        const FaceSource& from = list_.sources[source];
        return from.is_light ? object(source).lights[from.face].at : object(source).faces[from.face].at;
    }
    const std::vector<ModelObject>& objects_;
    const OrderedList& list_;
    const Reading& reading_;
};

} // namespace

std::vector<OrderedList> order_lists(const std::vector<ModelObject>& objects, const Reading& reading) {
    std::vector<OrderedList> lists(reading.registry->lists.size());
    std::vector<std::vector<OrderFace>> faces(lists.size());
    for (std::uint32_t o = 0; o < objects.size(); ++o) {
        if (!objects[o].resolved) continue;
        OrderedList& list = lists[objects[o].list];
        for (std::uint32_t f = 0; f < objects[o].faces.size(); ++f) {
            faces[objects[o].list].push_back(order_face(objects[o], objects[o].faces[f],
                                                        static_cast<std::uint32_t>(list.sources.size()),
                                                        *reading.registry));
            list.sources.push_back({o, f});
        }
        for (std::uint32_t l = 0; l < objects[o].lights.size(); ++l) {
            faces[objects[o].list].push_back(order_light(objects[o], objects[o].lights[l],
                                                         static_cast<std::uint32_t>(list.sources.size()),
                                                         *reading.registry));
            list.sources.push_back({o, l, true});
        }
    }
    for (std::size_t i = 0; i < lists.size(); ++i) {
        lists[i].order = order_faces(std::move(faces[i]));
        const PairReport report(objects, lists[i], reading);
        report.tell(lists[i].order.ties, "coplanar faces overlap with the same layer",
                    "expected different layers");
        report.tell(lists[i].order.inseparable, "faces intersect, and no plane divides them",
                    "expected faces that a plane can order");
    }
    return lists;
}

} // namespace linkdig::database
