#include "ig/geometry/project.h"

#include "ig/geometry/project_lights.h"
#include "ig/geometry/whole_faces.h"
#include "ig/simd/simd_level.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::ig {

namespace {

/// A smooth-shaded triangle that reaches the near plane is cut into 4^2 before it is clipped: the screen's
/// interpolation has no meaning across the eye, and small pieces bound what it gets wrong.
constexpr int near_subdivisions = 2;

/// Of a face's depth plane: not made yet.
constexpr std::int32_t wanted = -2;

class Projector {
public:
    Projector(const ActiveDatabase& active, const ChannelView& channel, const Raster& raster,
              const GeometryNeeds& needs, GeometryScratch& scratch, ProjectedFaces& projected)
        : active_(active), view_(view_of(channel, raster)), lights_(active, view_, raster, projected),
          needs_(needs), scratch_(scratch), out_(projected),
          last_line_(256 * static_cast<std::int32_t>(raster.lines())),
          last_element_(256 * static_cast<std::int32_t>(raster.elements())) {
        side_length_[0] = std::sqrt(1.0 + view_.left * view_.left);
        side_length_[1] = std::sqrt(1.0 + view_.right * view_.right);
        side_length_[2] = std::sqrt(1.0 + view_.bottom * view_.bottom);
        side_length_[3] = std::sqrt(1.0 + view_.top * view_.top);
    }

    void run(const PriorityOrder& order, const OrderPart& part) {
        out_.scale = view_.scale;
        scratch_.depths.clear();
        std::uint32_t entered = ~0U;
        const std::size_t end_run = part.to.run + (part.to.face > 0 ? 1 : 0);
        for (std::size_t r = part.from.run; r < end_run; ++r) {
            const RankedRun& ranked = order.runs[r];
            if (ranked.block != entered) enter(ranked.block);
            entered = ranked.block;
            const FaceRun& run = block_->runs[ranked.run];
            const std::uint32_t begin = r == part.from.run ? part.from.face : 0;
            const std::uint32_t end = r == part.to.run ? part.to.face : run.face_count;
            out_.offered += end - begin;
            out_.lights_offered += begin == 0 ? run.light_count : 0;
            if (!in_sight(run)) continue;
            fade_ = level_opacity(active_, run.level);
            level_ = fade_ < opaque ? run.level : none;
            std::uint32_t lights_put = lights_before(run, begin);
            for (std::uint32_t f = begin; f < end;) {
                put_lights(run, f, lights_put);
                const std::uint32_t count = std::min(before_light(run, lights_put, end) - f, faces_together);
                put_faces(run.first_face + f, count);
                f += count;
            }
            if (end == run.face_count) put_lights(run, end, lights_put);
        }
        scratch_.depths.make(sight_, out_.depths);
    }

private:
    void enter(std::uint32_t block) {
        scratch_.depths.make(sight_, out_.depths);
        block_index_ = block;
        block_ = &active_.blocks[block];
        added_to_ = active_.database->lists[block_->list].added_to;
        sight_.view = &view_;
        sight_.block = block_;
        sight_.channel_from_list = view_.channel_from_world * block_->world_from_list;
        sight_.origin =
            block_->at_eye ? Vec3d(0) : view_.channel_from_world * (block_->origin_m - view_.eye_m);
        scratch_.seen.enter(sight_);
        lights_.enter(sight_.channel_from_list, sight_.origin, block_->at_eye);
    }

    /// Bounding sphere against the frustum's planes.
    bool in_sight(const FaceRun& run) const {
        if (run.radius < 0.0F) return true;
        const Vec3d c = sight_.channel_from_list * Vec3d(run.centre) + sight_.origin;
        const double r = static_cast<double>(run.radius);
        return c.z + r >= near_plane_m && c.x - view_.left * c.z >= -r * side_length_[0] &&
               view_.right * c.z - c.x >= -r * side_length_[1] &&
               c.y - view_.bottom * c.z >= -r * side_length_[2] &&
               view_.top * c.z - c.y >= -r * side_length_[3];
    }

    /// Light points of a run that an earlier part put out, with the faces before `begin`.
    std::uint32_t lights_before(const FaceRun& run, std::uint32_t begin) const {
        std::uint32_t before = 0;
        while (before < run.light_count && block_->lights[run.first_light + before].place < begin)
            ++before;
        return before;
    }

    /// The light points of a run that stand before its face number `place`.
    void put_lights(const FaceRun& run, std::uint32_t place, std::uint32_t& put) {
        for (; put < run.light_count && block_->lights[run.first_light + put].place <= place; ++put)
            lights_.put(block_->lights, run.first_light + put, fade_);
    }

    /// The end of the faces that stand before the next light point.
    std::uint32_t before_light(const FaceRun& run, std::uint32_t put, std::uint32_t end) const {
        return put < run.light_count ? std::min(block_->lights[run.first_light + put].place, end) : end;
    }

    // ---- vertices
    // ------------------------------------------------------------------------------------------------

    /// In the channel frame, worked out anew: few vertices are asked for theirs.
    ClipPoint point_of(std::uint32_t index, std::int32_t intensity = 0) const {
        return channel_point(sight_, block_->vertices[index].position, intensity);
    }

    /// One that has been seen since the block was entered.
    const SeenVertex& seen_of(std::uint32_t index) const { return scratch_.seen[index]; }

    void raster_position(const ClipPoint& p, double& line, double& element) const {
        ig::raster_position(view_, p, line, element);
    }

    // ---- faces
    // ---------------------------------------------------------------------------------------------------

    void put_faces(std::uint32_t first, std::uint32_t count) {
        scratch_.seen.see_corners(first, count);
        SiftedFaces& left = scratch_.sifted;
        if (!sift_faces({last_line_, last_element_, view_.vertical, needs_.low_faces}, *block_,
                        scratch_.seen.data(), first, count, left)) {
            for (std::uint32_t f = first; f < first + count; ++f)
                put_face(f);
            return;
        }
        for (std::uint32_t k = 0; k < left.count;) {
            std::uint32_t end = k;
            while (end < left.count && is_whole(left.faces[end]))
                ++end;
            if (end > k) put_whole(std::span(left.faces).subspan(k, end - k));
            k = end;
            if (k < left.count) put_face(left.faces[k++].face);
        }
    }

    bool is_whole(const SiftedFace& sifted) const {
        const Face& face = block_->faces[sifted.face];
        return sifted.whole() &&
               (face.coloured == 0 || block_->colour != none || block_->corner_colours.empty()) &&
               (active_.object_shed.empty() || active_.object_shed[face.object] == 0);
    }

    void put_whole(std::span<const SiftedFace> faces) {
        WholeFaces common{block_, scratch_.seen.data(), last_line_, last_element_, view_.vertical, {}};
        common.model.block = block_index_;
        common.model.list = block_->list;
        common.model.added_to = added_to_;
        common.model.fade = fade_;
        common.model.level = level_;
        std::size_t f = out_.faces.size();
        put_whole_faces(common, faces, out_);
        if (!needs_.depth || block_->at_eye) return;
        for (std::uint32_t before = ~0U; f < out_.faces.size(); ++f) {
            if (out_.faces[f].face != before) {
                face_index_ = before = out_.faces[f].face;
                depth_ = put_depth();
            }
            out_.faces[f].depth = depth_;
        }
    }

    void put_face(std::uint32_t f) {
        const Face& face = block_->faces[f];
        if (!active_.object_shed.empty() && active_.object_shed[face.object] != 0) return;
        face_index_ = f;
        two_sided_ = face.two_sided != 0;
        opacity_ = face.opacity;
        colour_ = block_->colour == none ? face.colour : static_cast<std::uint16_t>(block_->colour);
        const std::uint32_t* corners = block_->corners.data() + face.first_corner;
        std::int32_t all = 0xff;
        std::int32_t any = 0;
        const std::int32_t line = first_line_at(seen_of(corners[0]).snapped.line);
        std::int32_t other_lines = 0; // stays 0 if no line's centre lies between the corners
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const SeenVertex& seen = seen_of(corners[k]);
            all &= seen.outside;
            any |= seen.outside;
            other_lines |= first_line_at(seen.snapped.line) ^ line;
        }
        if ((all & frustum_sides) != 0) return;
        // Far faces are often too low for any line.
        if (!needs_.low_faces && (any & (before_near | guard)) == 0 && other_lines == 0) return;
        depth_ = needs_.depth && !block_->at_eye ? wanted : -1;
        if (face.coloured != 0 && block_->colour == none && !block_->corner_colours.empty()) {
            put_coloured(face, corners);
        } else if (face.shading == Shading::vertex && block_->smooth) {
            put_smooth(corners, face.corner_count);
        } else {
            put_flat(corners, face.corner_count,
                     face.shading == Shading::unshaded ? intensity_one : lit_intensity(*block_, face.normal));
        }
    }

    /// Of the whole face, when the first of its pieces is put out: what turns out not to be seen needs none.
    std::int32_t put_depth() { return scratch_.depths.want(sight_, face_index_, out_.depths); }

    void put_flat(const std::uint32_t* corners, std::uint32_t count, std::int32_t intensity) {
        std::int32_t any = 0;
        for (std::uint32_t k = 0; k < count; ++k)
            any |= seen_of(corners[k]).outside;
        if ((any & (before_near | guard)) == 0) {
            const std::size_t first = out_.points.size();
            for (std::uint32_t k = 0; k < count; ++k)
                out_.points.push_back(seen_of(corners[k]).snapped);
            finish_polygon(first, -1, intensity);
            return;
        }
        scratch_.polygon.clear();
        for (std::uint32_t k = 0; k < count; ++k)
            scratch_.polygon.push_back(point_of(corners[k]));
        clip_near();
        put_clipped_to_guard(-1, intensity);
    }

    void put_smooth(const std::uint32_t* corners, std::uint32_t count) {
        bool level = true;
        std::int32_t any = 0;
        for (std::uint32_t k = 0; k < count; ++k) {
            any |= seen_of(corners[k]).outside;
            level = level && seen_of(corners[k]).intensity == seen_of(corners[0]).intensity;
        }
        if (level && (any & before_near) == 0) {
            put_flat(corners, count, seen_of(corners[0]).intensity);
            return;
        }
        for (std::uint32_t k = 1; k + 1 < count; ++k)
            put_triangle({corner(corners[0]), corner(corners[k]), corner(corners[k + 1])});
    }

    /// A corner of a triangle, with the intensity that counts there.
    struct Corner {
        std::uint32_t index = 0; ///< of its vertex
        const SeenVertex* seen = nullptr;
        std::int32_t intensity = 0;
    };

    Corner corner(std::uint32_t index) {
        const SeenVertex& seen = seen_of(index);
        return {index, &seen, seen.intensity};
    }

    ClipPoint point_of(const Corner& corner) const { return point_of(corner.index, corner.intensity); }

    /// Three interpolants, each by the way of the one: the same triangles come three times, in the same order, and faces
    /// are put out the first time.
    void put_coloured(const Face& face, const std::uint32_t* corners) {
        const std::size_t first_face = out_.faces.size();
        const std::size_t first_triangle = out_.triangles.size();
        for (const auto component : {&Colour::red, &Colour::green, &Colour::blue}) {
            for (std::uint32_t k = 1; k + 1 < face.corner_count; ++k) {
                put_triangle({coloured(face, corners, 0, component), coloured(face, corners, k, component),
                              coloured(face, corners, k + 1, component)});
            }
            triangles_alone_ = true;
        }
        triangles_alone_ = false;
        const auto step = static_cast<std::uint32_t>(out_.triangles.size() - first_triangle) / 3;
        for (std::size_t f = first_face; f < out_.faces.size(); ++f)
            out_.faces[f].colour_step = step;
    }

    /// A corner whose intensity is that of a component of its colour.
    Corner coloured(const Face& face, const std::uint32_t* corners, std::uint32_t k,
                    std::uint8_t Colour::*component) {
        const Vec3f& normal = face.shading == Shading::vertex && block_->smooth
                                  ? block_->vertices[corners[k]].normal
                                  : face.normal;
        const std::int64_t intensity =
            face.shading == Shading::unshaded ? intensity_one : lit_intensity(*block_, normal);
        const std::uint8_t code = block_->corner_colours[face.first_corner + k].*component;
        const auto part = static_cast<std::int32_t>((intensity * code + 127) / 255);
        return {corners[k], &seen_of(corners[k]), part};
    }

    void put_triangle(const std::array<Corner, 3>& corners) {
        const std::int32_t sides[3] = {corners[0].seen->outside, corners[1].seen->outside,
                                       corners[2].seen->outside};
        if ((sides[0] & sides[1] & sides[2] & frustum_sides) != 0) return;
        const std::int32_t any = sides[0] | sides[1] | sides[2];
        if ((any & before_near) != 0) {
            put_subdivided({point_of(corners[0]), point_of(corners[1]), point_of(corners[2])},
                           near_subdivisions);
            return;
        }
        const auto put = static_cast<std::int32_t>(out_.triangles.size());
        IntensityTriangle& triangle = out_.triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            const Corner& corner = corners[static_cast<std::size_t>(k)];
            triangle.line[k] = corner.seen->snapped.line;
            triangle.element[k] = corner.seen->snapped.element;
            if ((sides[k] & guard) != 0)
                raster_position(point_of(corner), triangle.line[k], triangle.element[k]);
            triangle.intensity[k] = corner.intensity;
        }
        if ((any & guard) == 0) {
            const std::size_t first = out_.points.size();
            for (const Corner& corner : corners)
                out_.points.push_back(corner.seen->snapped);
            finish_polygon(first, put, 0);
            return;
        }
        scratch_.polygon.assign({point_of(corners[0]), point_of(corners[1]), point_of(corners[2])});
        put_clipped_to_guard(put, 0);
    }

    // ---- faces that reach the near plane or the guard band
    // -------------------------------------------------------

    static ClipPoint middle(const ClipPoint& a, const ClipPoint& b) {
        return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z), 0.5 * (a.w + b.w),
                0.5 * (a.intensity + b.intensity)};
    }

    /// An edge is halved if one of its own ends lies before the near plane: both faces that share it agree.
    static bool halved(const ClipPoint& a, const ClipPoint& b) {
        return near_plane(a) < 0.0 || near_plane(b) < 0.0;
    }

    void put_subdivided(const std::array<ClipPoint, 3>& t, int divisions) {
        const bool ab_halved = halved(t[0], t[1]);
        const bool bc_halved = halved(t[1], t[2]);
        const bool ca_halved = halved(t[2], t[0]);
        if (divisions == 0 || (!ab_halved && !bc_halved && !ca_halved)) {
            put_clipped_to_near(t);
            return;
        }
        const ClipPoint ab = middle(t[0], t[1]);
        const ClipPoint bc = middle(t[1], t[2]);
        const ClipPoint ca = middle(t[2], t[0]);
        if (ab_halved && bc_halved && ca_halved) {
            put_subdivided({t[0], ab, ca}, divisions - 1);
            put_subdivided({ab, t[1], bc}, divisions - 1);
            put_subdivided({ca, bc, t[2]}, divisions - 1);
            put_subdivided({ab, bc, ca}, divisions - 1);
        } else if (
            !bc_halved) { // one corner lies before the near plane, and halves the two edges that meet in it
            put_cut_corner(t[0], t[1], t[2], ab, ca, divisions - 1);
        } else if (!ca_halved) {
            put_cut_corner(t[1], t[2], t[0], bc, ab, divisions - 1);
        } else {
            put_cut_corner(t[2], t[0], t[1], ca, bc, divisions - 1);
        }
    }

    void put_cut_corner(const ClipPoint& corner, const ClipPoint& next, const ClipPoint& last,
                        const ClipPoint& to_next, const ClipPoint& to_last, int divisions) {
        put_subdivided({corner, to_next, to_last}, divisions);
        put_subdivided({to_next, next, last}, divisions);
        put_subdivided({to_next, last, to_last}, divisions);
    }

    void clip_near() { clip(scratch_.polygon, near_plane, scratch_.spare); }

    void put_clipped_to_near(const std::array<ClipPoint, 3>& t) {
        scratch_.polygon.assign(t.begin(), t.end());
        clip_near();
        if (scratch_.polygon.size() < 3) return;
        std::vector<ClipPoint>& pieces = scratch_.pieces;
        pieces.assign(scratch_.polygon.begin(), scratch_.polygon.end());
        for (std::size_t k = 1; k + 1 < pieces.size(); ++k) {
            scratch_.polygon.assign({pieces[0], pieces[k], pieces[k + 1]});
            const auto put = static_cast<std::int32_t>(out_.triangles.size());
            IntensityTriangle& triangle = out_.triangles.emplace_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const ClipPoint& p = scratch_.polygon[corner];
                raster_position(p, triangle.line[corner], triangle.element[corner]);
                if (std::fabs(triangle.line[corner]) <= guard_limit &&
                    std::fabs(triangle.element[corner]) <= guard_limit) {
                    triangle.line[corner] = snap(triangle.line[corner]);
                    triangle.element[corner] = snap(triangle.element[corner]);
                }
                triangle.intensity[corner] = static_cast<std::int32_t>(snap(p.intensity));
            }
            put_clipped_to_guard(put, 0);
        }
    }

    /// Clips scratch_.polygon, all of it in front of the near plane, to the guard band, and puts it out.
    void put_clipped_to_guard(std::int32_t triangle, std::int32_t intensity) {
        if (triangles_alone_) return;
        auto& polygon = scratch_.polygon;
        // |scale * t + offset| <= limit for each raster axis, as planes through the eye.
        clip(polygon, {.a = view_.scale.x_scale, .c = view_.scale.x_offset + guard_limit}, scratch_.spare);
        clip(polygon, {.a = -view_.scale.x_scale, .c = guard_limit - view_.scale.x_offset}, scratch_.spare);
        clip(polygon, {.b = view_.scale.y_scale, .c = view_.scale.y_offset + guard_limit}, scratch_.spare);
        clip(polygon, {.b = -view_.scale.y_scale, .c = guard_limit - view_.scale.y_offset}, scratch_.spare);
        if (polygon.size() < 3) return;
        const std::size_t first = out_.points.size();
        for (const ClipPoint& p : polygon) {
            double line = 0;
            double element = 0;
            raster_position(p, line, element);
            out_.points.push_back(
                {static_cast<std::int32_t>(snap(line)), static_cast<std::int32_t>(snap(element))});
        }
        finish_polygon(first, triangle, intensity);
    }

    // ---- the end of every path
    // -----------------------------------------------------------------------------------

    /// Turns the points from `first` on into a face, or takes them back if it cannot be seen.
    void finish_polygon(std::size_t first, std::int32_t triangle, std::int32_t intensity) {
        if (triangles_alone_) {
            out_.points.resize(first);
            return;
        }
        const std::size_t count = out_.points.size() - first;
        RasterPoint* points = out_.points.data() + first;
        std::int64_t area = 0;
        std::int32_t least_line = points[0].line, greatest_line = points[0].line;
        std::int32_t least_element = points[0].element, greatest_element = points[0].element;
        for (std::size_t k = 0; k < count; ++k) {
            const RasterPoint& a = points[k];
            const RasterPoint& b = points[k + 1 == count ? 0 : k + 1];
            area +=
                static_cast<std::int64_t>(a.element) * b.line - static_cast<std::int64_t>(b.element) * a.line;
            least_line = std::min(least_line, a.line);
            greatest_line = std::max(greatest_line, a.line);
            least_element = std::min(least_element, a.element);
            greatest_element = std::max(greatest_element, a.element);
        }
        // Counter-clockwise from the front is negative on a picture whose rows run down; swapped axes mirror
        // it.
        const bool front = view_.vertical ? area > 0 : area < 0;
        const bool unseen = area == 0 || (!front && !two_sided_) || greatest_line <= 0 ||
                            greatest_element <= 0 || least_line >= last_line_ ||
                            least_element >= last_element_;
        if (unseen) {
            out_.points.resize(first);
            return;
        }
        if (area < 0) std::reverse(points, points + count);
        put_out(first, count, triangle, intensity);
    }

    /// Written where it stays: a copy of what has just been written in parts waits for all of them.
    void put_out(std::size_t first, std::size_t count, std::int32_t triangle, std::int32_t intensity) {
        if (depth_ == wanted) depth_ = put_depth();
        ProjectedFace& face = out_.faces.emplace_back();
        face.first_point = static_cast<std::uint32_t>(first);
        face.point_count = static_cast<std::uint16_t>(count);
        face.colour = colour_;
        face.triangle = triangle;
        face.intensity = intensity;
        face.block = block_index_;
        face.face = face_index_;
        face.depth = depth_;
        face.list = block_->list;
        face.added_to = added_to_;
        face.opacity = opacity_;
        face.fade = fade_;
        face.level = level_;
    }

    const ActiveDatabase& active_;
    View view_;
    LightProjector lights_;
    GeometryNeeds needs_;
    GeometryScratch& scratch_;
    ProjectedFaces& out_;
    std::int32_t last_line_;
    std::int32_t last_element_;
    double side_length_[4] = {1, 1, 1, 1};

    const FaceBlock* block_ = nullptr;
    std::uint32_t block_index_ = 0;
    BlockView sight_; ///< of the block
    std::uint32_t face_index_ = 0;
    std::int32_t depth_ = -1;      ///< or wanted, until a piece of the face is put out
    std::int32_t added_to_ = none; ///< of the block's list
    std::uint16_t colour_ = 0;
    std::uint16_t opacity_ = opaque;
    std::uint16_t fade_ = opaque;
    std::int32_t level_ = none;
    bool two_sided_ = false;
    bool triangles_alone_ = false; ///< the second and third time that a coloured face comes
};

} // namespace

void project(const ActiveDatabase& active, const PriorityOrder& order, const OrderPart& part,
             const ChannelView& channel, const Raster& raster, const GeometryNeeds& needs,
             GeometryScratch& scratch, ProjectedFaces& projected) {
    projected.faces.clear();
    projected.points.clear();
    projected.triangles.clear();
    projected.depths.clear();
    projected.lights.clear();
    projected.offered = 0;
    projected.lights_offered = 0;
    projected.lights_left_out = 0;
    projected.lights_at_step = {};
    Projector(active, channel, raster, needs, scratch, projected).run(order, part);
}

} // namespace linkdig::ig
