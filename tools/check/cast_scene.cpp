#include "tools/check/cast_scene.h"

#include <utility>

namespace linkdig::tools {
namespace {

/// Where a corner at infinity is put, metres: so far that the chord between two of them is the
/// horizon from any eye. The tree's floats only find the face: ranges come from its plane, in double.
constexpr double far_m = 1e8;

/// Where a list hangs this frame.
struct Hanging {
    bool visible = true;
    Mat3d world_from_list{1.0};
    Vec3d origin_m{0}; ///< relative to the eye
};

Hanging hang(const VisualDatabase& database, const FramePacket& packet, const ObjectList& list,
             const Vec3d& eye_m) {
    Hanging at;
    const std::int32_t moving = database.clusters[list.cluster].moving_object;
    Vec3d origin = list.origin_m;
    if (moving != none) {
        const MovingObject& object = packet.moving_objects[static_cast<std::size_t>(moving)];
        at.visible = object.visible;
        if (list.attachment == Attachment::body) {
            at.world_from_list = world_from_body(object.attitude);
            origin = object.position_m + at.world_from_list * list.origin_m;
        }
        if (list.attachment == Attachment::waterline) {
            at.world_from_list = world_from_body({.heading_rad = object.waterline_heading_rad});
            origin = object.waterline_position_m + at.world_from_list * list.origin_m;
        }
    }
    at.origin_m = list.attachment == Attachment::eye ? list.origin_m : origin - eye_m;
    return at;
}

bool present(const Object& object, const FramePacket& packet) {
    if (object.slot == none) return true;
    std::uint32_t index = 0;
    for (const Substitution& substitution : packet.substitutions)
        if (substitution.slot == static_cast<std::uint32_t>(object.slot)) index = substitution.index;
    return index == object.alternative;
}

/// Is a level of detail present at the eye's range? Levels are replaced at once: without_transparent() takes out blends and
/// hysteresis.
bool level_present(const VisualDatabase& database, const FramePacket& packet, std::size_t index,
                   const Vec3d& eye_m) {
    const Detail& detail = database.details[database.detail_levels[index].detail];
    Vec3d reference = detail.reference_m;
    const std::int32_t moving = database.clusters[detail.cluster].moving_object;
    if (moving != none) {
        const MovingObject& object = packet.moving_objects[static_cast<std::size_t>(moving)];
        reference = object.position_m + world_from_body(object.attitude) * detail.reference_m;
    }
    const double range = glm::distance(reference, eye_m);
    const bool from_the_eye = detail.added != 0 || index == detail.first_level;
    const double from = from_the_eye ? 0.0 : static_cast<double>(database.detail_levels[index - 1].to_m);
    return (from_the_eye || range > from) && range <= static_cast<double>(database.detail_levels[index].to_m);
}

/// Half the sum of cross products of neighbouring corners (Newell): its length is the area.
Vec3d area_vector(const std::vector<Vec3d>& corners) {
    Vec3d sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return 0.5 * sum;
}

class Reader {
public:
    Reader(const VisualDatabase& database, const FramePacket& packet, const Vec3d& eye_m)
        : database_(database), packet_(packet) {
        scene_.of_face.assign(database.faces.size(), none);
        scene_.of_list.assign(database.lists.size(), none);
        for (const ObjectList& list : database.lists)
            hanging_.push_back(hang(database, packet, list, eye_m));
        for (std::size_t level = 0; level < database.detail_levels.size(); ++level)
            level_present_.push_back(level_present(database, packet, level, eye_m));
    }

    CastScene read() {
        for (std::uint32_t f = 0; f < database_.faces.size(); ++f)
            add_face(f);
        for (const RepeatedTile& tile : database_.tiles)
            add_ground(tile);
        return std::move(scene_);
    }

private:
    void add_face(std::uint32_t index) {
        const Face& face = database_.faces[index];
        const Object& object = database_.objects[face.object];
        const Hanging& at = hanging_[object.list];
        if (!at.visible || database_.lists[object.list].root == none || !present(object, packet_)) return;
        if (object.level != none && !level_present_[static_cast<std::size_t>(object.level)]) return;
        CastFace made{.list = object.list, .object = face.object, .face = static_cast<std::int32_t>(index)};
        made.two_sided = face.two_sided != 0;
        put_corners(face, at, made);
        const Vec3d area = area_vector(made.corners);
        if (glm::dot(area, area) < 1e-16) return;
        made.normal = glm::normalize(area);
        for (const Vec3d& corner : made.corners)
            made.distance_m += glm::dot(made.normal, corner) / static_cast<double>(made.corners.size());
        scene_.of_face[index] = static_cast<std::int32_t>(scene_.faces.size());
        if (!made.ways.empty()) scene_.reaching.push_back(static_cast<std::uint32_t>(scene_.faces.size()));
        scene_.faces.push_back(std::move(made));
    }

    /// A corner at infinity stands far out in its direction: from the eye if the whole face is there, else from a corner
    /// that is not, so that the face stays plane.
    void put_corners(const Face& face, const Hanging& at, CastFace& made) const {
        Vec3d base(0);
        std::uint32_t finite = 0;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const Vec4f& p = vertex(face, k).position;
            if (p.w == 0.0F) continue;
            base = at.origin_m + at.world_from_list * Vec3d(p);
            ++finite;
        }
        made.endless = finite == 0;
        const bool reaching = finite > 0 && finite < face.corner_count;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const Vec4f& p = vertex(face, k).position;
            const Vec3d turned = at.world_from_list * Vec3d(p);
            const Vec3d way = p.w == 0.0F ? glm::normalize(turned) : at.origin_m + turned;
            made.corners.push_back(p.w == 0.0F ? base + far_m * way : way);
            if (reaching) made.ways.push_back(way);
        }
    }

    const Vertex& vertex(const Face& face, std::uint32_t k) const {
        return database_.vertices[database_.corners[face.first_corner + k]];
    }

    void add_ground(const RepeatedTile& tile) {
        const Hanging& at = hanging_[tile.list];
        if (!at.visible || database_.lists[tile.list].tile == none) return;
        CastFace ground{.list = tile.list};
        for (std::uint32_t o = 0; o < database_.objects.size(); ++o)
            if (database_.objects[o].list == tile.list) ground.object = o;
        ground.normal = at.world_from_list[2];
        ground.distance_m = glm::dot(ground.normal, at.origin_m);
        scene_.of_list[tile.list] = static_cast<std::int32_t>(scene_.faces.size());
        scene_.faces.push_back(std::move(ground));
    }

    const VisualDatabase& database_;
    const FramePacket& packet_;
    std::vector<Hanging> hanging_;
    std::vector<bool> level_present_; ///< parallel to VisualDatabase::detail_levels
    CastScene scene_;
};

} // namespace

VisualDatabase without_transparent(VisualDatabase database) {
    for (Detail& detail : database.details) {
        detail.blend_m = 0;
        detail.hysteresis_m = 0;
    }
    for (ObjectList& list : database.lists) {
        if (list.added_to == none) continue;
        list.root = none;
        list.tile = none;
    }
    for (const Face& face : database.faces) {
        if (face.opacity == 256) continue;
        for (std::uint32_t k = 1; k < face.corner_count; ++k)
            database.corners[face.first_corner + k] = database.corners[face.first_corner];
    }
    return database;
}

CastScene cast_scene(const VisualDatabase& database, const FramePacket& packet, const Vec3d& eye_m) {
    return Reader(database, packet, eye_m).read();
}

} // namespace linkdig::tools
