#include "tests/support/active_edge_loop.h"

#include <algorithm>
#include <set>

namespace linkdig::support {

namespace {

/// a / b rounded down and up, b > 0.
std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }
std::int64_t ceil_divide(std::int64_t a, std::int64_t b) { return -floor_divide(-a, b); }

/// An edge in the active edge table. `element` is the first whose centre is at or beyond the crossing; with
/// the remainder (0 <= remainder < denominator) it is exact on every line.
struct ActiveEdge {
    std::int64_t first_line = 0;
    std::int64_t end_line = 0;
    std::int64_t element = 0;
    std::int64_t remainder = 0;
    std::int64_t step = 0;
    std::int64_t step_remainder = 0;
    std::int64_t denominator = 1;
    std::uint32_t rank = 0;
    int winding = 0;

    void next_line() {
        element += step;
        remainder += step_remainder;
        if (remainder < denominator) return;
        remainder -= denominator;
        ++element;
    }
};

/// The crossing of line n lies at X = low.element + (centre - low.line) * width / height; the first centre at
/// or beyond it is ceil((X - 128) / 256) = floor((256 height (X - 128) / 256 + 256 height - 1) / (256
/// height)).
ActiveEdge make_edge(ig::RasterPoint from, ig::RasterPoint to, std::uint32_t rank) {
    const ig::RasterPoint low = from.line < to.line ? from : to;
    const ig::RasterPoint high = from.line < to.line ? to : from;
    const std::int64_t half = ig::subpixels / 2;
    const std::int64_t height = std::int64_t{high.line} - low.line;
    const std::int64_t width = std::int64_t{high.element} - low.element;
    ActiveEdge edge;
    edge.rank = rank;
    edge.winding = from.line > to.line ? 1 : -1;
    edge.first_line = std::max<std::int64_t>(ceil_divide(low.line - half, ig::subpixels), 0);
    edge.end_line = ceil_divide(high.line - half, ig::subpixels);
    if (height == 0) return edge;
    edge.denominator = height * ig::subpixels;
    const std::int64_t numerator = (low.element - half) * height +
                                   (centre_of(edge.first_line) - low.line) * width + edge.denominator - 1;
    edge.element = floor_divide(numerator, edge.denominator);
    edge.remainder = numerator - edge.element * edge.denominator;
    edge.step = floor_divide(width * ig::subpixels, edge.denominator);
    edge.step_remainder = width * ig::subpixels - edge.step * edge.denominator;
    return edge;
}

/// All edges that some line of the raster crosses, by first line.
std::vector<std::vector<ActiveEdge>> edge_buckets(const ig::ProjectedFaces& projected,
                                                  const ig::Raster& raster) {
    std::vector<std::vector<ActiveEdge>> buckets(raster.lines());
    for (std::uint32_t rank = 0; rank < projected.faces.size(); ++rank) {
        const ig::ProjectedFace& face = projected.faces[rank];
        for (std::uint32_t i = 0; i < face.point_count; ++i) {
            const ig::RasterPoint from = projected.points[face.first_point + i];
            const ig::RasterPoint to = projected.points[face.first_point + (i + 1) % face.point_count];
            const ActiveEdge edge = make_edge(from, to, rank);
            if (edge.first_line < edge.end_line && edge.first_line < std::int64_t{raster.lines()})
                buckets[static_cast<std::size_t>(edge.first_line)].push_back(edge);
        }
    }
    return buckets;
}

/// The faces that are open at the beam, by rank.
class OpenFaces {
public:
    explicit OpenFaces(std::size_t faces) : winding_(faces, 0) {}
    void cross(const ActiveEdge& edge) {
        const int before = winding_[edge.rank];
        winding_[edge.rank] += edge.winding;
        if (before <= 0 && winding_[edge.rank] > 0) open_.insert(edge.rank);
        if (before > 0 && winding_[edge.rank] <= 0) open_.erase(edge.rank);
    }
    std::int32_t winner() const { return open_.empty() ? none : static_cast<std::int32_t>(*open_.begin()); }

private:
    std::vector<int> winding_;
    std::set<std::uint32_t> open_;
};

/// What a run of elements needs to be written.
struct Output {
    const ig::ProjectedFaces& projected;
    const ig::FaceEdges& edges;
    const ig::Raster& raster;
    std::span<const Colour> colours;
    ig::VideoFrame frame;

    void write(std::int32_t rank, std::uint32_t line, std::int64_t first, std::int64_t end) {
        if (rank == none) return;
        const ig::ProjectedFace& face = projected.faces[static_cast<std::size_t>(rank)];
        const ig::IntensityPlane& plane = edges.shadings[static_cast<std::size_t>(rank)].plane;
        const std::int64_t last = std::min<std::int64_t>(end, raster.elements());
        for (std::int64_t element = std::max<std::int64_t>(first, 0); element < last; ++element) {
            const std::int32_t intensity = face.triangle < 0
                                               ? face.intensity
                                               : plane_intensity(plane, static_cast<std::int32_t>(line),
                                                                 static_cast<std::int32_t>(element));
            const std::size_t at = place(raster, line, static_cast<std::uint32_t>(element));
            frame.pixels[at] = shaded_with_15_bits(colours[face.colour], intensity);
            frame.intensity[at] = intensity;
            frame.rank[at] = rank;
        }
    }
};

} // namespace

std::int32_t plane_intensity(const ig::IntensityPlane& plane, std::int32_t line, std::int32_t element) {
    const auto along = static_cast<std::uint32_t>(element - plane.reference_element) * plane.along;
    const auto across = static_cast<std::uint32_t>(line - plane.reference_line) * plane.across;
    return std::clamp(static_cast<std::int32_t>(plane.value + along + across), plane.least, plane.greatest);
}

ig::VideoFrame active_edge_loop(const ig::ProjectedFaces& projected, const ig::FaceEdges& edges,
                                const ig::Raster& raster, std::span<const Colour> colours,
                                std::uint32_t background) {
    Output output{projected, edges, raster, colours, empty_picture(raster, background)};
    const std::vector<std::vector<ActiveEdge>> buckets = edge_buckets(projected, raster);
    std::vector<ActiveEdge> active;
    for (std::uint32_t line = 0; line < raster.lines(); ++line) {
        for (ActiveEdge& edge : active)
            edge.next_line();
        std::erase_if(active, [line](const ActiveEdge& edge) { return edge.end_line <= std::int64_t{line}; });
        active.insert(active.end(), buckets[line].begin(), buckets[line].end());
        std::sort(active.begin(), active.end(),
                  [](const ActiveEdge& a, const ActiveEdge& b) { return a.element < b.element; });
        OpenFaces open(projected.faces.size());
        for (std::size_t i = 0; i < active.size(); ++i) {
            open.cross(active[i]);
            const std::int64_t end = i + 1 < active.size() ? active[i + 1].element : active[i].element;
            output.write(open.winner(), line, active[i].element, end);
        }
    }
    return std::move(output.frame);
}

} // namespace linkdig::support
