#include "tools/check/comparison.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace linkdig::tools {
namespace {

/// Planes nearer than this, metres, and as parallel as this are one plane: authored coordinates are that exact.
constexpr double same_plane_m = 2e-3;
constexpr double same_plane_cosine = 1.0 - 1e-6;

struct PixelRay {
    Vec3d direction{0}; ///< unit
    double near_m = 0;  ///< where the near plane cuts it
};

PixelRay ray_of(const ChannelView& channel, const ig::Raster& raster, const Mat3d& body, std::uint32_t column,
                std::uint32_t row) {
    const double x =
        channel.left_tangent + (channel.right_tangent - channel.left_tangent) * (column + 0.5) / raster.width;
    const double y =
        channel.top_tangent - (channel.top_tangent - channel.bottom_tangent) * (row + 0.5) / raster.height;
    const Vec3d along = body[0] - x * body[1] + y * body[2];
    const double length = glm::length(along);
    return {along / length, ig::near_plane_m * length};
}

bool same_plane(const CastFace& a, const CastFace& b) {
    return a.list == b.list && !a.endless && !b.endless && glm::dot(a.normal, b.normal) > same_plane_cosine &&
           std::fabs(a.distance_m - b.distance_m) < same_plane_m;
}

/// The face to be seen among hits that are equally near. Of those in the nearest one's plane any may be; the first in the
/// database stands for them, so that neighbouring pixels have the same.
std::int32_t to_be_seen(const CastScene& scene, const std::vector<CastHit>& hits) {
    if (hits.empty()) return background;
    const CastFace& nearest = scene.faces[hits.front().face];
    std::uint32_t first = hits.front().face;
    for (const CastHit& hit : hits)
        if (hit.face < first && same_plane(scene.faces[hit.face], nearest)) first = hit.face;
    return static_cast<std::int32_t>(first);
}

class PixelJudge {
public:
    PixelJudge(const CastScene& scene, const Caster& caster, const std::vector<DesignException>& exceptions,
               Comparison& result)
        : scene_(scene), caster_(caster), exceptions_(exceptions), result_(result) {}

    /// A pixel where machine and caster differ.
    void judge(const PixelRay& ray, WrongPixel pixel) {
        caster_.all(ray.direction, ray.near_m, hits_);
        const auto shown = std::ranges::find(hits_, static_cast<std::uint32_t>(pixel.shown), &CastHit::face);
        const double range = shown == hits_.end() ? endless_m : shown->range_m;
        std::int32_t excuse = none;
        if (pixel.shown >= 0) excuse = take_out_excepted(static_cast<std::uint32_t>(pixel.shown), range);
        if (hits_.empty()) return found(pixel);
        const double nearest = hits_.front().range_m;
        std::erase_if(hits_,
                      [&](const CastHit& hit) { return hit.range_m > nearest + tolerance_m(nearest); });
        pixel.nearest = to_be_seen(scene_, hits_);
        const bool met =
            std::ranges::find(hits_, static_cast<std::uint32_t>(pixel.shown), &CastHit::face) != hits_.end();
        pixel.nearer_by_m = range - nearest;
        if (!met) return found(pixel);
        if (excuse == none)
            ++result_.as_near;
        else
            ++result_.excepted[static_cast<std::size_t>(excuse)];
    }

private:
    void found(const WrongPixel& pixel) { result_.wrong.push_back(pixel); }

    /// Nearer faces that the shown one may hide by design; the first exception that was needed.
    std::int32_t take_out_excepted(std::uint32_t shown, double range_m) {
        std::int32_t first = none;
        std::erase_if(hits_, [&](const CastHit& hit) {
            if (hit.face == shown || hit.range_m >= range_m) return false;
            const std::int32_t excuse = exception_for(exceptions_, scene_.faces[shown].list,
                                                      scene_.faces[hit.face].list, range_m - hit.range_m);
            if (first == none) first = excuse;
            return excuse != none;
        });
        return first;
    }

    const CastScene& scene_;
    const Caster& caster_;
    const std::vector<DesignException>& exceptions_;
    Comparison& result_;
    std::vector<CastHit> hits_;
};

/// Do a pixel and its eight neighbours have one value?
bool uniform(const std::vector<std::int32_t>& picture, std::size_t width, std::size_t at) {
    const std::int32_t value = picture[at];
    for (const std::size_t row : {at - width, at, at + width})
        if (picture[row - 1] != value || picture[row] != value || picture[row + 1] != value) return false;
    return true;
}

std::vector<std::int32_t> faces_cast(const ig::Raster& raster, const ChannelView& channel,
                                     const CastScene& scene, const Caster& caster) {
    std::vector<std::int32_t> cast(std::size_t{raster.width} * raster.height, background);
    const Mat3d body = world_from_body(channel.attitude);
    tbb::parallel_for(0U, raster.height, [&](std::uint32_t row) {
        std::vector<CastHit> hits;
        for (std::uint32_t column = 0; column < raster.width; ++column) {
            const PixelRay ray = ray_of(channel, raster, body, column, row);
            caster.nearest(ray.direction, ray.near_m, hits);
            cast[std::size_t{row} * raster.width + column] = to_be_seen(scene, hits);
        }
    });
    return cast;
}

} // namespace

std::vector<std::int32_t> faces_shown(const VisualDatabase& database, const ig::Machine& machine,
                                      const CastScene& scene) {
    const std::vector<std::int32_t>& ranks = machine.picture(0).rank;
    std::vector<std::int32_t> shown(ranks.size(), background);
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (ranks[i] == none) continue;
        if (i > 0 && ranks[i] == ranks[i - 1]) {
            shown[i] = shown[i - 1];
            continue;
        }
        const ig::Machine::Source source = machine.source(0, ranks[i]);
        const Face* first = database.faces.data();
        const bool authored =
            !std::less<>{}(source.face, first) && std::less<>{}(source.face, first + database.faces.size());
        const std::int32_t found = authored ? scene.of_face[static_cast<std::size_t>(source.face - first)]
                                            : scene.of_list[source.list];
        shown[i] = found == none ? absent : found;
    }
    return shown;
}

Comparison compare_faces(const std::vector<std::int32_t>& shown, const ig::Raster& raster,
                         const ChannelView& channel, const CastScene& scene, const Caster& caster,
                         const std::vector<DesignException>& exceptions) {
    Comparison result;
    result.excepted.assign(exceptions.size(), 0);
    const std::vector<std::int32_t> cast = faces_cast(raster, channel, scene, caster);
    const Mat3d body = world_from_body(channel.attitude);
    PixelJudge judge(scene, caster, exceptions, result);
    for (std::uint32_t row = 1; row + 1 < raster.height; ++row) {
        for (std::uint32_t column = 1; column + 1 < raster.width; ++column) {
            const std::size_t at = std::size_t{row} * raster.width + column;
            if (!uniform(shown, raster.width, at) || !uniform(cast, raster.width, at)) continue;
            ++result.interior;
            if (shown[at] != cast[at])
                judge.judge(ray_of(channel, raster, body, column, row),
                            {.column = column, .row = row, .shown = shown[at], .nearest = cast[at]});
        }
    }
    return result;
}

} // namespace linkdig::tools
