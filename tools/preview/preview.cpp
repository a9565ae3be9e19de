#include "tools/preview/preview.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"
#include "host/motion/view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::tools {
namespace {

/// Half of the vertical field of view: narrow, so that shapes are hardly distorted.
constexpr double half_field_deg = 14.0;
/// How a sea or a field is seen: from a low helicopter over it.
constexpr double low_height_m = 30.0;
constexpr float finest = 16.0F; ///< of FramePacket::lod_bias

/// Box of what is drawn of a cluster or a moving object.
struct Bounds {
    Vec3d low{0};
    Vec3d high{0};
    bool any = false;
    void add(const Vec3d& point) {
        low = any ? glm::min(low, point) : point;
        high = any ? glm::max(high, point) : point;
        any = true;
    }
};

void add_list(const VisualDatabase& database, std::uint32_t list, Bounds& bounds, std::uint32_t& faces) {
    for (const Face& face : database.faces) {
        if (database.objects[face.object].list != list) continue;
        // What is drawn: the first alternative of each slot, as in the packet below.
        const Object& object = database.objects[face.object];
        if (object.slot != none && object.alternative != 0) continue;
        ++faces;
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const Vec4f& p = database.vertices[database.corners[face.first_corner + i]].position;
            if (p.w != 0) bounds.add(database.lists[list].origin_m + Vec3d(Vec3f(p)));
        }
    }
}

PreviewSubject subject_of(const VisualDatabase& database, const std::string& name, std::int32_t moving_object,
                          const std::vector<std::uint32_t>& clusters) {
    PreviewSubject subject{.name = name, .moving_object = moving_object};
    Bounds bounds;
    for (std::uint32_t list = 0; list < database.lists.size(); ++list) {
        if (std::find(clusters.begin(), clusters.end(), database.lists[list].cluster) == clusters.end() ||
            database.lists[list].attachment == Attachment::eye)
            continue;
        add_list(database, list, bounds, subject.faces);
        if (database.lists[list].tile != none) ++subject.faces; // at least one, wherever the eye is
    }
    subject.centre_m = 0.5 * (bounds.low + bounds.high);
    subject.half_extent_m = 0.5 * (bounds.high - bounds.low);
    return subject;
}

double half_width(const PreviewSubject& subject) {
    return std::min(subject.half_extent_m.x, subject.half_extent_m.y);
}

/// Flat: a sea without tiles, land. Seen as a whole it shows little.
bool is_field(const PreviewSubject& subject) { return subject.half_extent_m.z < 0.03 * half_width(subject); }

/// Where a field is seen from: low over it, but the higher and the farther back the wider it is, so that ranges of hills show,
/// and not one slope.
Vec3d over_field(const PreviewSubject& subject, const Vec3d& level) {
    const double height_m = std::max(low_height_m, 0.04 * half_width(subject));
    return subject.centre_m + Vec3d(0.0, 0.0, subject.half_extent_m.z + height_m) +
           0.6 * half_width(subject) * level;
}

bool is_endless(const PreviewSubject& subject) { return subject.half_extent_m == Vec3d(0); }

/// Puts a moving object at the origin, or clear of everything static, to the east of it.
void put_clear(const std::vector<PreviewSubject>& subjects, PreviewSubject& moving) {
    for (const PreviewSubject& other : subjects)
        if (other.moving_object == none && !is_endless(other))
            moving.stands_m.x = std::max(moving.stands_m.x, other.centre_m.x + other.half_extent_m.x +
                                                                5.0 * glm::length(moving.half_extent_m));
}

/// The least range along `outward` from the subject's middle at which all corners of its box lie inside the picture.
double fitting_range(const PreviewSubject& subject, const Vec3d& outward, double up_tangent, double aspect) {
    constexpr double margin = 1.1;
    const Vec3d right = glm::normalize(Vec3d(-outward.y, outward.x, 0.0));
    const Vec3d up = glm::cross(outward, right);
    const Vec3d half = glm::max(subject.half_extent_m, Vec3d(0.01)); // a point has no size
    double range = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3d at = half * Vec3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const double across = std::max(std::abs(glm::dot(at, right)) / aspect, std::abs(glm::dot(at, up)));
        range = std::max(range, margin * across / up_tangent + glm::dot(at, outward));
    }
    return range;
}

Vec3f default_sun() { return Vec3f(direction(radians(35.0), radians(42.0))); }

} // namespace

std::vector<PreviewSubject> preview_subjects(const VisualDatabase& database) {
    std::vector<PreviewSubject> subjects;
    for (std::uint32_t object = 0; object < database.moving_objects.size(); ++object) {
        std::vector<std::uint32_t> clusters;
        for (std::uint32_t c = 0; c < database.clusters.size(); ++c)
            if (database.clusters[c].moving_object == static_cast<std::int32_t>(object))
                clusters.push_back(c);
        subjects.push_back(subject_of(database, database.moving_objects[object],
                                      static_cast<std::int32_t>(object), clusters));
    }
    for (std::uint32_t c = 0; c < database.clusters.size(); ++c)
        if (database.clusters[c].moving_object == none)
            subjects.push_back(subject_of(database, database.clusters[c].name, none, {c}));
    std::erase_if(subjects, [](const PreviewSubject& subject) { return subject.faces == 0; });
    const auto solid = [](const PreviewSubject& subject) {
        return subject.moving_object == none && !is_endless(subject);
    };
    if (std::ranges::any_of(subjects, solid)) // a sea shows behind them
        std::erase_if(subjects, [](const PreviewSubject& subject) {
            return subject.moving_object == none && is_endless(subject);
        });
    for (PreviewSubject& subject : subjects)
        if (subject.moving_object != none) put_clear(subjects, subject);
    return subjects;
}

PreviewView preview_view(std::uint32_t index) {
    constexpr std::array<PreviewView, preview_views> views{
        {{"bow", 40.0, 14.0}, {"port", 90.0, 6.0}, {"stern", 205.0, 24.0}, {"above", 0.1, 78.0}}};
    return views[index % preview_views];
}

FramePacket preview_packet(const VisualDatabase& database, const PreviewSubject& subject,
                           const PreviewView& view, double aspect) {
    FramePacket packet;
    packet.suns.assign(database.suns.size(), default_sun());
    for (const ObjectList& list :
         database.lists) // a dome's normals are its shading under a sun straight above
        if (list.attachment == Attachment::eye) packet.suns[list.sun] = {0.0F, 0.0F, 1.0F};
    packet.moving_objects.resize(database.moving_objects.size());
    for (std::size_t i = 0; i < packet.moving_objects.size(); ++i)
        packet.moving_objects[i].visible = subject.moving_object == static_cast<std::int32_t>(i);
    if (subject.moving_object != none) {
        MovingObject& object = packet.moving_objects[static_cast<std::size_t>(subject.moving_object)];
        object.position_m = object.waterline_position_m = subject.stands_m;
    }
    packet.lod_bias = finest;
    const Vec3d outward = direction(radians(view.azimuth_deg), radians(view.elevation_deg));
    const double half = radians(half_field_deg);
    ChannelView channel;
    channel.eye_m = subject.centre_m + fitting_range(subject, outward, tangent(half), aspect) * outward;
    Vec3d aim = subject.centre_m;
    if (is_field(subject) && view.elevation_deg < 60.0) {
        const Vec3d level = glm::normalize(Vec3d(outward.x, outward.y, 0.0));
        channel.eye_m = over_field(subject, level);
        aim = channel.eye_m - Vec3d(level.x, level.y, 0.12);
    } else if (is_endless(subject)) {
        channel.eye_m = Vec3d(0.0, 0.0, low_height_m);
        aim = channel.eye_m - Vec3d(outward.x, outward.y, view.elevation_deg < 60.0 ? 0.12 : outward.z);
    }
    channel.attitude = host::looking_along(aim - channel.eye_m);
    channel.eye_m += subject.stands_m;
    channel.top_tangent = tangent(half);
    channel.bottom_tangent = -channel.top_tangent;
    channel.right_tangent = channel.top_tangent * aspect;
    channel.left_tangent = -channel.right_tangent;
    packet.channels.push_back(channel);
    return packet;
}

} // namespace linkdig::tools
