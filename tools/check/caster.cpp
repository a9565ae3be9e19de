#include "tools/check/caster.h"

#include "database/model/rotation.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace linkdig::tools {
namespace {

constexpr double least_tolerance_m = 0.01;
constexpr double relative_tolerance = 1e-4;
/// Farther than every stand-in for infinity.
constexpr float tree_reach_m = 1e9F;

enum class Wanted : std::uint8_t { nearest_visible, all_visible, nearest_of_any_side };

/// What one ray wants, and what it found. `context` first: Embree hands back a pointer to it.
struct Query {
    RTCIntersectContext context{};
    const CastScene* scene = nullptr;
    const std::vector<std::uint32_t>* face_of = nullptr;
    Vec3d direction{0};
    Wanted wanted = Wanted::nearest_visible;
    std::vector<CastHit>* hits = nullptr;
};

bool shows(const CastFace& face, const Vec3d& direction) {
    return face.two_sided || glm::dot(face.normal, direction) < 0.0;
}

/// Keeps Embree looking (valid = 0) behind faces that turn their back, and behind everything while collecting.
void filter(const RTCFilterFunctionNArguments* arguments) {
    auto& query = *reinterpret_cast<Query*>(arguments->context);
    if (arguments->valid[0] != -1 || query.wanted == Wanted::nearest_of_any_side) return;
    const std::uint32_t face = (*query.face_of)[RTCHitN_primID(arguments->hit, arguments->N, 0)];
    const bool visible = shows(query.scene->faces[face], query.direction);
    if (query.wanted == Wanted::nearest_visible) {
        if (!visible) arguments->valid[0] = 0;
        return;
    }
    if (visible)
        query.hits->push_back({face, static_cast<double>(RTCRayN_tfar(arguments->ray, arguments->N, 0))});
    arguments->valid[0] = 0;
}

/// Range of a plane along a ray; the tree's own where the ray grazes it.
double range_of(const CastFace& face, const Vec3d& direction, double from_tree) {
    if (face.endless) return endless_m;
    const double cosine = glm::dot(face.normal, direction);
    return std::fabs(cosine) < 1e-5 ? from_tree : face.distance_m / cosine;
}

/// Range of the plane where the ray meets a face that reaches to infinity; negative elsewhere. Seen from the eye such a face is
/// the cone of its corners' ways: the ray lies on one side of all the planes through two neighbours.
double range_of_reaching(const CastFace& face, const Vec3d& direction) {
    bool left = false;
    bool right = false;
    for (std::size_t k = 0; k < face.ways.size(); ++k) {
        const Vec3d& next = face.ways[k + 1 == face.ways.size() ? 0 : k + 1];
        const double side = glm::dot(glm::cross(face.ways[k], next), direction);
        left = left || side < 0.0;
        right = right || side > 0.0;
    }
    return left && right ? -1.0 : face.distance_m / glm::dot(face.normal, direction);
}

} // namespace

double tolerance_m(double range_m) { return std::max(least_tolerance_m, relative_tolerance * range_m); }

struct Caster::Tree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::uint32_t> face_of; ///< parallel to the tree's triangles

    explicit Tree(const CastScene& faces) : device(rtcNewDevice("threads=1")) {
        if (device == nullptr) throw std::runtime_error("Embree, the ray caster, cannot start");
        scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
        add_triangles(faces);
        rtcCommitScene(scene);
    }
    ~Tree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;

    void add_triangles(const CastScene& faces) {
        std::vector<Vec3f> corners;
        for (std::uint32_t f = 0; f < faces.faces.size(); ++f) {
            if (!faces.faces[f].ways.empty()) continue;
            const std::vector<Vec3d>& c = faces.faces[f].corners;
            for (std::size_t i = 1; i + 1 < c.size(); ++i) {
                corners.insert(corners.end(), {Vec3f(c[0]), Vec3f(c[i]), Vec3f(c[i + 1])});
                face_of.push_back(f);
            }
        }
        if (corners.empty()) return;
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* to = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corners.size()));
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                to[3 * i + static_cast<std::size_t>(axis)] = corners[i][axis];
        auto* index = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), face_of.size()));
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            index[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }

    /// The nearest hit's triangle, or none; ranges between the two.
    RTCRayHit cast(Query& query, float from_m, float to_m) const {
        rtcInitIntersectContext(&query.context);
        query.context.filter = filter;
        query.face_of = &face_of;
        RTCRayHit ray{};
        ray.ray.dir_x = static_cast<float>(query.direction.x);
        ray.ray.dir_y = static_cast<float>(query.direction.y);
        ray.ray.dir_z = static_cast<float>(query.direction.z);
        ray.ray.tnear = from_m;
        ray.ray.tfar = to_m;
        ray.ray.mask = ~0U;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &query.context, &ray);
        return ray;
    }
};

Caster::Caster(const CastScene& scene) : scene_(scene), tree_(std::make_unique<Tree>(scene)) {}
Caster::~Caster() = default;

/// Exact ranges, what is not in the tree, nearest first, each face once (a ray along a diagonal meets both triangles).
void Caster::finish(const Vec3d& direction, double from_m, std::vector<CastHit>& hits) const {
    for (CastHit& hit : hits)
        hit.range_m = range_of(scene_.faces[hit.face], direction, hit.range_m);
    for (const std::int32_t ground : scene_.of_list) {
        if (ground == none) continue;
        const CastFace& face = scene_.faces[static_cast<std::size_t>(ground)];
        const double cosine = glm::dot(face.normal, direction);
        const double range = cosine < 0.0 ? face.distance_m / cosine : -1.0;
        if (range > from_m) hits.push_back({static_cast<std::uint32_t>(ground), range});
    }
    for (const std::uint32_t reaching : scene_.reaching) {
        const CastFace& face = scene_.faces[reaching];
        if (!shows(face, direction)) continue;
        const double range = range_of_reaching(face, direction);
        if (range > from_m) hits.push_back({reaching, range});
    }
    std::sort(hits.begin(), hits.end(), [](const CastHit& a, const CastHit& b) {
        return a.range_m != b.range_m ? a.range_m < b.range_m : a.face < b.face;
    });
    hits.erase(std::unique(hits.begin(), hits.end(),
                           [](const CastHit& a, const CastHit& b) { return a.face == b.face; }),
               hits.end());
}

void Caster::all(const Vec3d& direction, double from_m, std::vector<CastHit>& hits) const {
    hits.clear();
    Query query{.scene = &scene_, .direction = direction, .wanted = Wanted::all_visible, .hits = &hits};
    tree_->cast(query, static_cast<float>(from_m), tree_reach_m);
    finish(direction, from_m, hits);
}

void Caster::nearest(const Vec3d& direction, double from_m, std::vector<CastHit>& hits) const {
    hits.clear();
    Query query{.scene = &scene_, .direction = direction};
    const RTCRayHit first = tree_->cast(query, static_cast<float>(from_m), tree_reach_m);
    if (first.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        // Twice the tolerance: the tree's floats may be off by some of it.
        const double reach = first.ray.tfar + 2.0 * tolerance_m(static_cast<double>(first.ray.tfar));
        query.wanted = Wanted::all_visible;
        query.hits = &hits;
        tree_->cast(query, static_cast<float>(from_m), static_cast<float>(reach));
    }
    finish(direction, from_m, hits);
    if (hits.empty()) return;
    const double limit = hits.front().range_m + tolerance_m(hits.front().range_m);
    std::erase_if(hits, [&](const CastHit& hit) { return hit.range_m > limit; });
}

/// The face that the ray meets first, whichever side it shows; null if none. Grounds are left out.
const CastFace* Caster::first_of_any_side(const Vec3d& direction) const {
    Query query{.scene = &scene_, .direction = direction, .wanted = Wanted::nearest_of_any_side};
    const RTCRayHit hit = tree_->cast(query, 0.0F, tree_reach_m);
    const CastFace* first = nullptr;
    double nearest = endless_m;
    if (hit.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        first = &scene_.faces[tree_->face_of[hit.hit.primID]];
        nearest = static_cast<double>(hit.ray.tfar);
    }
    for (const std::uint32_t reaching : scene_.reaching) {
        const double range = range_of_reaching(scene_.faces[reaching], direction);
        if (range <= 0.0 || range >= nearest) continue;
        first = &scene_.faces[reaching];
        nearest = range;
    }
    return first;
}

bool Caster::eye_is_inside() const {
    for (const CastFace& face : scene_.faces)
        if (face.corners.empty() && face.distance_m > -0.5) return true;
    constexpr int rays = 96;
    int backs = 0;
    for (int i = 0; i < rays; ++i) { // spread evenly over the sphere, by the golden angle
        const double height = (2.0 * i + 1.0) / rays - 1.0;
        const Vec3d way = direction(2.399963 * i, arc_sine(height));
        const CastFace* first = first_of_any_side(way);
        if (first != nullptr && !shows(*first, way)) ++backs;
    }
    return 3 * backs > rays;
}

} // namespace linkdig::tools
