#include "ig/geometry/whole_faces.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

constexpr std::int32_t frustum_sides = before_near | left_of | right_of | below | above;

/// Twice the signed area over two sides or diagonals, in (element, line).
std::int64_t cross(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c, const RasterPoint& d) {
    return static_cast<std::int64_t>(b.element - a.element) * (d.line - c.line) -
           static_cast<std::int64_t>(d.element - c.element) * (b.line - a.line);
}

/// Writes into room that was made for all: to append face by face would wait each time for the vectors' ends.
class Writer {
public:
    Writer(const WholeFaces& common, std::span<const SiftedFace> faces, ProjectedFaces& projected)
        : common_(common), out_(projected), first_point_(projected.points.size()),
          first_triangle_(projected.triangles.size()), first_face_(projected.faces.size()) {
        std::size_t triangles = 0;
        std::size_t corners = 0;
        std::size_t pieces = 0;
        for (const SiftedFace& sifted : faces) {
            const Face& face = common.block->faces[sifted.face];
            const std::size_t count = face.corner_count;
            const bool fan = is_fan(sifted, face);
            triangles += fan ? count - 2 : 0;
            pieces += fan ? count - 2 : 1;
            corners += fan ? 3 * (count - 2) : count;
        }
        out_.points.resize(first_point_ + corners);
        out_.triangles.resize(first_triangle_ + triangles);
        out_.faces.resize(first_face_ + pieces);
        point_ = out_.points.data() + first_point_;
        triangle_ = out_.triangles.data() + first_triangle_;
        face_ = out_.faces.data() + first_face_;
    }

    void put(const SiftedFace& sifted) {
        const FaceBlock& block = *common_.block;
        const Face& face = block.faces[sifted.face];
        const std::uint32_t* corners = block.corners.data() + face.first_corner;
        if (is_fan(sifted, face)) {
            for (std::uint32_t k = 1; k + 1 < face.corner_count; ++k)
                put_piece(sifted.face, corners[0], corners[k], corners[k + 1]);
            return;
        }
        if (!faces_us(area(corners, face.corner_count), face)) return;
        put_flat(sifted.face, corners, flat_intensity(face, corners[0]));
    }

    std::int32_t flat_intensity(const Face& face, std::uint32_t corner) const {
        if (face.shading == Shading::unshaded) return intensity_one;
        if (face.shading == Shading::vertex && common_.block->smooth) return common_.seen[corner].intensity;
        return lit_intensity(*common_.block, face.normal);
    }

    /// Gives back the room that was not needed.
    void close() {
        out_.points.resize(static_cast<std::size_t>(point_ - out_.points.data()));
        out_.triangles.resize(static_cast<std::size_t>(triangle_ - out_.triangles.data()));
        out_.faces.resize(static_cast<std::size_t>(face_ - out_.faces.data()));
    }

    /// What will be written next, at about the same rate: to wait for memory when it is written costs as much as all else.
    void fetch_ahead() const {
        fetch(point_, out_.points.data() + first_point_, out_.points.data() + out_.points.capacity());
        fetch(triangle_, out_.triangles.data() + first_triangle_,
              out_.triangles.data() + out_.triangles.capacity());
        fetch(face_, out_.faces.data() + first_face_, out_.faces.data() + out_.faces.capacity());
    }

private:
    /// Of several intensities: cut into triangles that fan out from its first corner.
    bool is_fan(const SiftedFace& sifted, const Face& face) const {
        return face.shading == Shading::vertex && common_.block->smooth && !sifted.level();
    }

    template <typename Value>
    static void fetch(const Value* next, const Value* begun, const Value* end) {
        const auto* const from = reinterpret_cast<const char*>(next);
        const auto bytes =
            std::min<std::ptrdiff_t>((next - begun) * static_cast<std::ptrdiff_t>(sizeof(Value)),
                                     (end - next) * static_cast<std::ptrdiff_t>(sizeof(Value)));
        for (std::ptrdiff_t b = 0; b < bytes; b += 64)
            __builtin_prefetch(from + b, 1);
    }

    const RasterPoint& at(std::uint32_t vertex) const { return common_.seen[vertex].snapped; }

    std::int64_t area(const std::uint32_t* corners, std::uint32_t count) const {
        std::int64_t sum = 0;
        if (count == 4) return cross(at(corners[0]), at(corners[2]), at(corners[1]), at(corners[3]));
        for (std::uint32_t k = 1; k + 1 < count; ++k)
            sum += cross(at(corners[0]), at(corners[k]), at(corners[0]), at(corners[k + 1]));
        return sum;
    }

    /// Counter-clockwise from the front is negative on a picture whose rows run down; swapped axes mirror it.
    bool faces_us(std::int64_t area, const Face& face) {
        reversed_ = area < 0;
        return face.two_sided != 0 ? area != 0 : (common_.vertical ? area > 0 : area < 0);
    }

    ProjectedFace& put_face(std::uint32_t index, std::uint32_t count) {
        const FaceBlock& block = *common_.block;
        const Face& face = block.faces[index];
        ProjectedFace& put = *face_++;
        put.first_point = static_cast<std::uint32_t>(point_ - out_.points.data());
        put.point_count = static_cast<std::uint16_t>(count);
        put.colour = block.colour == none ? face.colour : static_cast<std::uint16_t>(block.colour);
        put.block = common_.model.block;
        put.face = index;
        put.list = common_.model.list;
        put.added_to = common_.model.added_to;
        put.opacity = face.opacity;
        put.fade = common_.model.fade;
        put.level = common_.model.level;
        return put;
    }

    void put_flat(std::uint32_t index, const std::uint32_t* corners, std::int32_t intensity) {
        const std::uint32_t count = common_.block->faces[index].corner_count;
        ProjectedFace& put = put_face(index, count);
        put.triangle = -1;
        put.intensity = intensity;
        for (std::uint32_t k = 0; k < count; ++k)
            point_[k] = at(corners[reversed_ ? count - 1 - k : k]);
        point_ += count;
    }

    void put_piece(std::uint32_t index, std::uint32_t first, std::uint32_t second, std::uint32_t third) {
        const SeenVertex& a = common_.seen[first];
        const SeenVertex& b = common_.seen[second];
        const SeenVertex& c = common_.seen[third];
        const std::int64_t area = cross(a.snapped, b.snapped, a.snapped, c.snapped);
        if (!faces_us(area, common_.block->faces[index]) || beside(a, b, c)) return;
        ProjectedFace& put = put_face(index, 3);
        put.triangle = static_cast<std::int32_t>(triangle_ - out_.triangles.data());
        put.intensity = 0;
        IntensityTriangle& triangle = *triangle_++;
        triangle.line[0] = a.snapped.line;
        triangle.line[1] = b.snapped.line;
        triangle.line[2] = c.snapped.line;
        triangle.element[0] = a.snapped.element;
        triangle.element[1] = b.snapped.element;
        triangle.element[2] = c.snapped.element;
        triangle.intensity[0] = a.intensity;
        triangle.intensity[1] = b.intensity;
        triangle.intensity[2] = c.intensity;
        point_[0] = reversed_ ? c.snapped : a.snapped;
        point_[1] = b.snapped;
        point_[2] = reversed_ ? a.snapped : c.snapped;
        point_ += 3;
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

    const WholeFaces& common_;
    ProjectedFaces& out_;
    std::size_t first_point_, first_triangle_, first_face_;
    RasterPoint* point_ = nullptr;
    IntensityTriangle* triangle_ = nullptr;
    ProjectedFace* face_ = nullptr;
    bool reversed_ = false;
};

} // namespace

void put_whole_faces(const WholeFaces& common, std::span<const SiftedFace> faces, ProjectedFaces& projected) {
    Writer writer(common, faces, projected);
    for (const SiftedFace& face : faces)
        writer.put(face);
    writer.fetch_ahead();
    writer.close();
}

} // namespace linkdig::ig
