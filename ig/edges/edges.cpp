#include "ig/edges/edges.h"

#include "ig/edges/edge_batch.h"
#include "ig/floor.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

/// dividend / divisor in units of 2^-40, rounded down. |dividend| < 2^49, 0 < divisor < 2^24. Double holds both, and divides
/// faster than whole numbers do. A quotient that is not whole is at least 1 / divisor from whole numbers: the first one is off
/// by a sixteenth of that at most; the second may be rounded up to a whole number, which the remainder tells.
std::uint64_t fixed_quotient(std::int64_t dividend, std::int64_t divisor) {
    const auto d = static_cast<double>(divisor);
    const std::int64_t whole = floor_of(static_cast<double>(dividend) / d);
    const std::int64_t rest = dividend - whole * divisor;
    constexpr double one = std::int64_t{1} << fraction_bits;
    const auto fraction =
        static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<double>(rest) * one / d));
    const std::uint64_t left =
        (static_cast<std::uint64_t>(rest) << fraction_bits) - fraction * static_cast<std::uint64_t>(divisor);
    return (static_cast<std::uint64_t>(whole) << fraction_bits) + fraction - (left >> 63U);
}

/// The edge between two snapped points, upper one first, over the lines whose centres it spans: a pure function of the
/// two points and the raster's height.
void make_edge(const RasterPoint& upper, const RasterPoint& lower, std::int32_t first_line,
               std::int32_t end_line, Edge& edge) {
    edge.first_line = first_line;
    edge.end_line = end_line;
    const std::int64_t height = lower.line - upper.line;
    const std::int64_t width = static_cast<std::int64_t>(lower.element) - upper.element;
    const std::int64_t down = (std::int64_t{first_line} * 256 + 128) - upper.line;
    const std::uint64_t crossing =
        (static_cast<std::uint64_t>(std::int64_t{upper.element}) << fraction_bits) +
        fixed_quotient(down * width, height);
    edge.start = static_cast<std::int64_t>(crossing + static_cast<std::uint64_t>(crossing_to_start));
    edge.slope =
        end_line - first_line > 1 ? static_cast<std::int64_t>(fixed_quotient(width * 256, height)) : 0;
}

/// A value of an intensity plane as an integer of 2^-22, modulo 2^32.
std::uint32_t to_plane_units(double value) {
    return static_cast<std::uint32_t>(floor_of(std::clamp(value, -plane_bound, plane_bound) + 0.5));
}

/// The plane through the three corners. All products are exact in double (below 2^53) for snapped corners;
/// each quotient is rounded once, by IEEE 754, the same everywhere.
void make_plane(const IntensityTriangle& t, std::int32_t line, std::int32_t element, IntensityPlane& plane) {
    plane.reference_line = line;
    plane.reference_element = element;
    const auto [least, greatest] = std::minmax({t.intensity[0], t.intensity[1], t.intensity[2]});
    plane.least = least;
    plane.greatest = greatest;
    const double e1 = t.element[1] - t.element[0], e2 = t.element[2] - t.element[0];
    const double l1 = t.line[1] - t.line[0], l2 = t.line[2] - t.line[0];
    const double i1 = t.intensity[1] - t.intensity[0], i2 = t.intensity[2] - t.intensity[0];
    const double area = e1 * l2 - e2 * l1;
    if (area == 0.0) {
        plane.value = static_cast<std::uint32_t>(t.intensity[0]);
        return;
    }
    const double along = (i1 * l2 - i2 * l1) / area;
    const double across = (e1 * i2 - e2 * i1) / area;
    const double from_corner_e = element * 256.0 + 128.0 - t.element[0];
    const double from_corner_l = line * 256.0 + 128.0 - t.line[0];
    plane.value = to_plane_units(t.intensity[0] + along * from_corner_e + across * from_corner_l);
    plane.along = to_plane_units(along * 256.0);
    plane.across = to_plane_units(across * 256.0);
}

/// The edge as part of an outline: positions at the borders between lines, rounded to the nearest 1/256 pixel.
void make_outline_edge(const RasterPoint& upper, const RasterPoint& lower, std::int32_t sign,
                       OutlineEdge& edge) {
    edge.upper_line = upper.line;
    edge.upper_element = upper.element;
    edge.lower_line = lower.line;
    edge.lower_element = lower.element;
    edge.first_border = (upper.line + 255) >> 8;
    edge.sign = sign;
    const std::int64_t height = lower.line - upper.line;
    const std::int64_t width = static_cast<std::int64_t>(lower.element) - upper.element;
    const std::int64_t down = std::int64_t{edge.first_border} * 256 - upper.line;
    constexpr std::uint64_t half = std::uint64_t{1} << (fraction_bits - 1);
    edge.start =
        static_cast<std::int64_t>((static_cast<std::uint64_t>(std::int64_t{upper.element}) << fraction_bits) +
                                  fixed_quotient(down * width, height) + half);
    edge.slope = static_cast<std::int64_t>(fixed_quotient(width * 256, height));
}

/// A face that touches no line yet; `edges_made` stand before its own.
EdgeFace face_without_edges(const ProjectedFace& face, std::size_t edges_made, std::int32_t lines) {
    EdgeFace made;
    made.first_edge = static_cast<std::uint32_t>(edges_made);
    made.first_line = lines;
    made.additive = face.added_to >= 0;
    made.opacity = face.opacity;
    made.fade = face.fade;
    made.level = face.level;
    made.blends = blends(face);
    return made;
}

/// Of a face that has the same intensity everywhere.
FaceShading level_shading(const ProjectedFace& face) {
    return {.plane = {.value = static_cast<std::uint32_t>(face.intensity),
                      .least = face.intensity,
                      .greatest = face.intensity},
            .colour = face.colour};
}

class EdgeMaker {
public:
    EdgeMaker(const ProjectedFaces& projected, const Raster& raster, bool smoothing, FaceEdges& out)
        : projected_(projected), lines_(static_cast<std::int32_t>(raster.lines())),
          elements_(static_cast<std::int32_t>(raster.elements())), smoothing_(smoothing), out_(out) {}

    void run() {
        out_.faces.resize(projected_.faces.size()); // each is written anew
        out_.shadings.resize(projected_.faces.size());
        for (std::size_t rank = 0; rank < projected_.faces.size();) {
            const std::size_t together = smoothing_ ? 0 : put_together(rank);
            if (together == 0) put(rank);
            rank += std::max<std::size_t>(together, 1);
        }
        out_.edges.resize(edges_made_);
    }

private:
    std::size_t put_together(std::size_t rank) {
        return make_edges_together(projected_, rank, lines_, elements_, out_, edges_made_);
    }

    void put(std::size_t rank) {
        const ProjectedFace& face = projected_.faces[rank];
        const RasterPoint* points = projected_.points.data() + face.first_point;
        EdgeFace& made = out_.faces[rank];
        made = face_without_edges(face, edges_made_, lines_);
        put_extent(points, face.point_count, made);
        if (spans_a_centre(points, face.point_count)) put_crossings(points, face.point_count, made);
        put_shading(face, points[0], made, out_.shadings[rank]);
        if (smoothing_) put_outline(points, face.point_count, made);
    }

    /// Far faces are often too low for any line.
    static bool spans_a_centre(const RasterPoint* points, std::size_t count) {
        const std::int32_t line = first_line_at(points[0].line);
        for (std::size_t k = 1; k < count; ++k)
            if (first_line_at(points[k].line) != line) return true;
        return false;
    }

    void put_extent(const RasterPoint* points, std::size_t count, EdgeFace& made) const {
        std::int32_t leftmost = points[0].element;
        std::int32_t rightmost = points[0].element;
        for (std::size_t k = 1; k < count; ++k) {
            leftmost = std::min(leftmost, points[k].element);
            rightmost = std::max(rightmost, points[k].element);
        }
        made.first_element = std::clamp(leftmost >> 8, 0, elements_);
        made.end_element = std::clamp((rightmost >> 8) + 1, 0, elements_);
    }

    /// Of a polygon of positive area the edges that run up the lines begin it on a line, those that run down end it.
    void put_crossings(const RasterPoint* points, std::size_t count, EdgeFace& made) {
        Edge* edge = room_for_edges(out_, edges_made_, count);
        std::int32_t face_begin = lines_;
        std::int32_t face_end = 0;
        for (const bool leading : {true, false}) {
            for (std::size_t k = 0; k < count; ++k) {
                const RasterPoint& from = points[k];
                const RasterPoint& to = points[k + 1 == count ? 0 : k + 1];
                if (from.line == to.line || (to.line < from.line) != leading) continue;
                const RasterPoint& upper = leading ? to : from;
                const RasterPoint& lower = leading ? from : to;
                const std::int32_t first_line = std::max(first_line_at(upper.line), 0);
                const std::int32_t end_line = std::min(first_line_at(lower.line), lines_);
                if (first_line >= end_line) continue;
                make_edge(upper, lower, first_line, end_line, *edge++);
                ++(leading ? made.leading : made.trailing);
                face_begin = std::min(face_begin, first_line);
                face_end = std::max(face_end, end_line);
            }
        }
        made.first_line = face_begin;
        made.end_line = face_end;
        edges_made_ += std::size_t{made.leading} + made.trailing;
    }

    /// The plane's reference is a pixel of the face, so that values stay small.
    void put_shading(const ProjectedFace& face, const RasterPoint& corner, const EdgeFace& made,
                     FaceShading& shading) {
        shading = level_shading(face);
        if (face.triangle < 0) return;
        std::int32_t line = made.first_line;
        std::int32_t element = 0;
        for (std::uint32_t k = 0; k < made.leading; ++k) {
            const Edge& edge = out_.edges[made.first_edge + k];
            if (edge.first_line == line) element = first_element(edge, line);
        }
        if (made.leading == 0) { // touches no line's centre
            line = std::clamp(corner.line >> 8, 0, lines_ - 1);
            element = corner.element >> 8;
        }
        element = std::clamp(element, 0, elements_ - 1);
        const IntensityTriangle* const triangle =
            projected_.triangles.data() + static_cast<std::size_t>(face.triangle);
        shading.coloured = face.colour_step != 0;
        if (!shading.coloured) {
            make_plane(*triangle, line, element, shading.plane);
            return;
        }
        shading.plane = {.value = static_cast<std::uint32_t>(out_.tints.size())};
        TintPlanes& tint = out_.tints.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            make_plane(triangle[k * face.colour_step], line, element, tint[k]);
    }

    void put_outline(const RasterPoint* points, std::size_t count, EdgeFace& made) {
        made.first_outline = static_cast<std::uint32_t>(out_.outlines.size());
        std::int32_t least = points[0].line;
        std::int32_t greatest = points[0].line;
        for (std::size_t k = 0; k < count; ++k) {
            const RasterPoint& from = points[k];
            const RasterPoint& to = points[k + 1 == count ? 0 : k + 1];
            least = std::min(least, from.line);
            greatest = std::max(greatest, from.line);
            if (from.line == to.line) continue;
            const bool begins = to.line < from.line;
            const RasterPoint& upper = begins ? to : from;
            const RasterPoint& lower = begins ? from : to;
            if (lower.line <= 0 || upper.line >= 256 * lines_) continue;
            make_outline_edge(upper, lower, begins ? 1 : -1, out_.outlines.emplace_back());
        }
        made.outlines = static_cast<std::uint16_t>(out_.outlines.size() - made.first_outline);
        made.first_line = std::clamp(least >> 8, 0, lines_);
        made.end_line = std::clamp((greatest + 255) >> 8, 0, lines_);
    }

    const ProjectedFaces& projected_;
    std::int32_t lines_;
    std::int32_t elements_;
    bool smoothing_;
    FaceEdges& out_;
    std::size_t edges_made_ = 0; ///< behind them the vector still has the last frame's
};

} // namespace

void make_edges(const ProjectedFaces& projected, const Raster& raster, bool smoothing, FaceEdges& out) {
    out.outlines.clear();
    out.tints.clear();
    EdgeMaker(projected, raster, smoothing, out).run();
}

void append(const FaceEdges& part, FaceEdges& all) {
    const auto first_edge = static_cast<std::uint32_t>(all.edges.size());
    const auto first_outline = static_cast<std::uint32_t>(all.outlines.size());
    const auto first_tint = static_cast<std::uint32_t>(all.tints.size());
    all.faces.reserve(all.faces.size() + part.faces.size());
    for (const EdgeFace& face : part.faces) {
        EdgeFace& added = all.faces.emplace_back(face);
        added.first_edge += first_edge;
        added.first_outline += first_outline;
    }
    const std::size_t first_shading = all.shadings.size();
    all.shadings.insert(all.shadings.end(), part.shadings.begin(), part.shadings.end());
    for (std::size_t k = first_shading; k < all.shadings.size() && !part.tints.empty(); ++k)
        if (all.shadings[k].coloured) all.shadings[k].plane.value += first_tint;
    all.edges.insert(all.edges.end(), part.edges.begin(), part.edges.end());
    all.outlines.insert(all.outlines.end(), part.outlines.begin(), part.outlines.end());
    all.tints.insert(all.tints.end(), part.tints.begin(), part.tints.end());
}

} // namespace linkdig::ig
