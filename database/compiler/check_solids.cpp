#include "database/compiler/check_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace linkdig::database {
namespace {

/// More faces than this are a landscape or a loft, not a solid that somebody wrote face by face.
constexpr std::size_t most_faces = 20000;

using Point = std::array<double, 3>;
struct EdgeUse {
    std::size_t face;
    bool forward; ///< from the lesser end to the greater
};

/// The faces of an object, with places instead of vertices: several vertices may stand in one place.
class SolidCheck {
public:
    SolidCheck(const ModelObject& object, const Reading& reading)
        : object_(object), reading_(reading), turned_(object.faces.size()), met_(object.faces.size(), false) {
        for (std::size_t f = 0; f < object.faces.size(); ++f)
            for (std::size_t i = 0; i < object.faces[f].corners.size(); ++i) {
                const auto [ends, forward] = edge(f, i);
                edges_[ends].push_back({f, forward});
            }
    }

    void run() {
        for (std::size_t f = 0; f < object_.faces.size(); ++f)
            if (!met_[f]) check_part(f);
    }

private:
    using Ends = std::pair<Point, Point>;

    Vec3d corner(std::size_t face, std::size_t i) const {
        const auto& corners = object_.faces[face].corners;
        return Vec3d(object_.vertices[corners[i % corners.size()]].position);
    }
    std::pair<Ends, bool> edge(std::size_t face, std::size_t i) const {
        const Vec3d a = corner(face, i), b = corner(face, i + 1);
        const Point from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
        return {from < to ? Ends(from, to) : Ends(to, from), from < to};
    }

    /// From one face over all edges: which faces are turned against it, and do they close?
    void check_part(std::size_t first) {
        std::vector<std::size_t> part{first};
        met_[first] = true;
        bool closed = true;
        for (std::size_t next = 0; next < part.size(); ++next)
            closed = cross_edges(part[next], part) && closed;
        if (!closed || part.size() < 4) return;
        const auto against = static_cast<std::size_t>(
            std::ranges::count_if(part, [&](std::size_t face) { return turned_[face]; }));
        if (against == 0 || against == part.size()) {
            if (six_volumes(part) < 0.0)
                reading_.error(object_.at,
                               fmt::format("the solid of {} faces in object \"{}\" is inside out; expected "
                                           "corners counter-clockwise seen from outside",
                                           part.size(), object_.name));
            return;
        }
        // Whichever way round encloses a volume is meant.
        const bool meant = six_volumes(part) < 0.0;
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> wrong;
        for (const std::size_t face : part) {
            const Place& at = object_.faces[face].at;
            if (turned_[face] != meant) wrong[{at.line, at.column}].push_back(face);
        }
        for (const auto& [place, faces] : wrong)
            tell_turned(faces);
    }

    /// One message for each shape, however many of its faces are turned.
    void tell_turned(const std::vector<std::size_t>& faces) const {
        const std::string who = faces.size() == 1 ? "a face" : fmt::format("{} faces", faces.size());
        reading_.error(
            object_.faces[faces.front()].at,
            fmt::format("{} of object \"{}\" {} turned against the other faces of {} solid; expected "
                        "corners counter-clockwise seen from outside",
                        who, object_.name, faces.size() == 1 ? "is" : "are",
                        faces.size() == 1 ? "its" : "their"));
    }

    /// Adds the neighbours of a face; false where an edge has not two faces.
    bool cross_edges(std::size_t face, std::vector<std::size_t>& part) {
        bool closed = !object_.faces[face].style.two_sided;
        for (std::size_t i = 0; i < object_.faces[face].corners.size(); ++i) {
            const auto [ends, forward] = edge(face, i);
            const std::vector<EdgeUse>& uses = edges_[ends];
            closed = closed && uses.size() == 2;
            for (const EdgeUse& use : uses) {
                if (met_[use.face]) continue;
                met_[use.face] = true;
                turned_[use.face] = turned_[face] != (use.forward == forward);
                part.push_back(use.face);
            }
        }
        return closed;
    }

    /// Six times the volume that the part would enclose with all faces turned like its first.
    double six_volumes(const std::vector<std::size_t>& part) const {
        const Vec3d origin = corner(part.front(), 0);
        double sum = 0.0;
        for (const std::size_t face : part)
            for (std::size_t i = 1; i + 1 < object_.faces[face].corners.size(); ++i) {
                const double volume =
                    glm::dot(corner(face, 0) - origin,
                             glm::cross(corner(face, i) - origin, corner(face, i + 1) - origin));
                sum += turned_[face] ? -volume : volume;
            }
        return sum;
    }

    const ModelObject& object_;
    const Reading& reading_;
    std::map<Ends, std::vector<EdgeUse>> edges_;
    std::vector<bool> turned_; ///< against the first face of its part
    std::vector<bool> met_;
};

bool reaches_infinity(const ModelObject& object) {
    return std::ranges::any_of(object.vertices,
                               [](const ModelVertex& vertex) { return vertex.position.w == 0.0; });
}

} // namespace

void check_solids(const std::vector<ModelObject>& objects, const Reading& reading) {
    for (const ModelObject& object : objects) {
        if (!object.resolved || object.of_mesh || object.faces.size() > most_faces ||
            reaches_infinity(object) ||
            reading.registry->lists[object.list].list.attachment == Attachment::eye)
            continue;
        SolidCheck(object, reading).run();
    }
}

} // namespace linkdig::database
