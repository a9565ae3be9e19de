#include "ig/geometry/whole_faces.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

/// Twice the signed area, in (element, line), between a side or diagonal and another one.
std::int64_t cross(const RasterPoint& from, const RasterPoint& to, const RasterPoint& other_from,
                   const RasterPoint& other_to) {
    return static_cast<std::int64_t>(to.element - from.element) * (other_to.line - other_from.line) -
           static_cast<std::int64_t>(other_to.element - other_from.element) * (to.line - from.line);
}

class Writer {
public:
    Writer(const WholeFaces& common, ProjectedFaces& projected)
        : block_(*common.block), seen_(common.seen), common_(common), out_(projected) {}

    void put(const SiftedFace& sifted) {
        const Face& face = block_.faces[sifted.face];
        const std::uint32_t* corners = block_.corners.data() + face.first_corner;
        const bool smooth = face.shading == Shading::vertex && block_.smooth;
        if (smooth && !sifted.level()) {
            for (std::uint32_t k = 1; k + 1 < face.corner_count; ++k)
                put_piece(face, sifted.face, seen_[corners[0]], seen_[corners[k]], seen_[corners[k + 1]]);
            return;
        }
        const std::int64_t area = area_of(corners, face.corner_count);
        if (!is_seen(area, face)) return;
        ProjectedFace& put = put_face(face, sifted.face, face.corner_count);
        put.intensity = smooth                              ? seen_[corners[0]].intensity
                        : face.shading == Shading::unshaded ? intensity_one
                                                            : lit_intensity(block_, face.normal);
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            out_.points.push_back(at(corners[area < 0 ? face.corner_count - 1 - k : k]));
    }

private:
    const RasterPoint& at(std::uint32_t vertex) const { return seen_[vertex].snapped; }

    std::int64_t area_of(const std::uint32_t* corners, std::uint32_t count) const {
        if (count == 4) return cross(at(corners[0]), at(corners[2]), at(corners[1]), at(corners[3]));
        std::int64_t sum = 0;
        for (std::uint32_t k = 1; k + 1 < count; ++k)
            sum += cross(at(corners[0]), at(corners[k]), at(corners[0]), at(corners[k + 1]));
        return sum;
    }

    /// Counter-clockwise from the front is negative on a picture whose rows run down; swapped axes mirror it.
    bool is_seen(std::int64_t area, const Face& face) const {
        return face.two_sided != 0 ? area != 0 : (common_.vertical ? area > 0 : area < 0);
    }

    ProjectedFace& put_face(const Face& face, std::uint32_t index, std::uint32_t count) {
        ProjectedFace& put = out_.faces.emplace_back();
        put.first_point = static_cast<std::uint32_t>(out_.points.size());
        put.point_count = static_cast<std::uint16_t>(count);
        put.colour = block_.colour == none ? face.colour : static_cast<std::uint16_t>(block_.colour);
        put.block = common_.model.block;
        put.face = index;
        put.list = common_.model.list;
        put.added_to = common_.model.added_to;
        put.opacity = face.opacity;
        put.fade = common_.model.fade;
        put.level = common_.model.level;
        return put;
    }

    void put_piece(const Face& face, std::uint32_t index, const SeenVertex& a, const SeenVertex& b,
                   const SeenVertex& c) {
        const std::int64_t area = cross(a.snapped, b.snapped, a.snapped, c.snapped);
        if (!is_seen(area, face) || (face.corner_count > 3 && beside(a, b, c))) return;
        ProjectedFace& put = put_face(face, index, 3);
        put.triangle = static_cast<std::int32_t>(out_.triangles.size());
        put.intensity = 0;
        IntensityTriangle& triangle = out_.triangles.emplace_back();
        triangle.line[0] = a.snapped.line;
        triangle.line[1] = b.snapped.line;
        triangle.line[2] = c.snapped.line;
        triangle.element[0] = a.snapped.element;
        triangle.element[1] = b.snapped.element;
        triangle.element[2] = c.snapped.element;
        triangle.intensity[0] = a.intensity;
        triangle.intensity[1] = b.intensity;
        triangle.intensity[2] = c.intensity;
        out_.points.push_back(area < 0 ? c.snapped : a.snapped);
        out_.points.push_back(b.snapped);
        out_.points.push_back(area < 0 ? a.snapped : c.snapped);
    }

    /// Beside the picture, though the whole face is not.
    bool beside(const SeenVertex& a, const SeenVertex& b, const SeenVertex& c) const {
        const auto most = [&](std::int32_t RasterPoint::*axis) {
            return std::max({a.snapped.*axis, b.snapped.*axis, c.snapped.*axis});
        };
        const auto least = [&](std::int32_t RasterPoint::*axis) {
            return std::min({a.snapped.*axis, b.snapped.*axis, c.snapped.*axis});
        };
        return (a.outside & b.outside & c.outside & frustum_sides) != 0 || most(&RasterPoint::line) <= 0 ||
               most(&RasterPoint::element) <= 0 || least(&RasterPoint::line) >= common_.last_line ||
               least(&RasterPoint::element) >= common_.last_element;
    }

    const FaceBlock& block_;
    const SeenVertex* seen_;
    const WholeFaces& common_;
    ProjectedFaces& out_;
};

} // namespace

void put_whole_faces(const WholeFaces& common, std::span<const SiftedFace> faces, ProjectedFaces& projected) {
    Writer writer(common, projected);
    for (const SiftedFace& face : faces)
        writer.put(face);
}

} // namespace linkdig::ig
