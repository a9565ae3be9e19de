#include "tests/support/painter.h"

#include <algorithm>
#include <array>

namespace linkdig::support {

namespace {

/// Where an edge crosses the centre of a line: element = numerator / denominator in 1/256 pixel, denominator
/// > 0.
struct Crossing {
    Wide numerator = 0;
    Wide denominator = 1;
    int winding = 0; ///< +1 leading, -1 trailing
};

/// The crossings of a polygon with one line.
std::vector<Crossing> crossings(std::span<const ig::RasterPoint> points, std::int64_t centre) {
    std::vector<Crossing> found;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ig::RasterPoint from = points[i];
        const ig::RasterPoint to = points[(i + 1) % points.size()];
        const ig::RasterPoint low = from.line < to.line ? from : to;
        const ig::RasterPoint high = from.line < to.line ? to : from;
        if (centre < low.line || centre >= high.line) continue;
        const Wide height = Wide{high.line} - low.line;
        const Wide numerator =
            low.element * height + (centre - low.line) * (Wide{high.element} - low.element);
        found.push_back({numerator, height, from.line > to.line ? 1 : -1});
    }
    return found;
}

bool covers(std::span<const Crossing> cut, std::int64_t centre) {
    int sum = 0;
    for (const Crossing& crossing : cut)
        if (crossing.numerator <= centre * crossing.denominator) sum += crossing.winding;
    return sum > 0;
}

std::span<const ig::RasterPoint> points_of(const ig::ProjectedFaces& projected,
                                           const ig::ProjectedFace& face) {
    return std::span(projected.points).subspan(face.first_point, face.point_count);
}

/// Calls visit(line, element) for every covered pixel of a polygon.
template <typename Visit>
void for_each_covered(std::span<const ig::RasterPoint> points, const ig::Raster& raster, Visit visit) {
    std::int32_t least = INT32_MAX;
    std::int32_t greatest = INT32_MIN;
    for (const ig::RasterPoint& point : points) {
        least = std::min(least, point.line);
        greatest = std::max(greatest, point.line);
    }
    for (std::uint32_t line = 0; line < raster.lines(); ++line) {
        if (centre_of(line) < least || centre_of(line) >= greatest) continue;
        const std::vector<Crossing> cut = crossings(points, centre_of(line));
        for (std::uint32_t element = 0; element < raster.elements(); ++element)
            if (covers(cut, centre_of(element))) visit(line, element);
    }
}

/// A point of an edge on the pixel's line, with the intensity interpolated along the edge to there.
struct EdgePoint {
    long double element = 0;
    long double intensity = 0;
};

/// Leftmost and rightmost point of the triangle's border on a line that it reaches.
std::array<EdgePoint, 2> border_on_line(const ig::IntensityTriangle& triangle, long double line) {
    std::array<EdgePoint, 2> border;
    bool any = false;
    const auto widen = [&](EdgePoint point) {
        if (!any || point.element < border[0].element) border[0] = point;
        if (!any || point.element > border[1].element) border[1] = point;
        any = true;
    };
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const long double from_line = triangle.line[i];
        const long double to_line = triangle.line[j];
        if (line == from_line) widen({triangle.element[i], static_cast<long double>(triangle.intensity[i])});
        if (line <= std::min(from_line, to_line) || line >= std::max(from_line, to_line)) continue;
        const long double t = (line - from_line) / (to_line - from_line);
        const long double from_element = triangle.element[i];
        const long double from_intensity = triangle.intensity[i];
        widen({from_element + t * (triangle.element[j] - from_element),
               from_intensity + t * (triangle.intensity[j] - from_intensity)});
    }
    return border;
}

} // namespace

bool covers(std::span<const ig::RasterPoint> points, std::uint32_t line, std::uint32_t element) {
    return covers(crossings(points, centre_of(line)), centre_of(element));
}

std::int32_t gouraud(const ig::IntensityTriangle& triangle, std::uint32_t line, std::uint32_t element) {
    const auto [first, last] = std::minmax_element(triangle.line, triangle.line + 3);
    const long double on_line = std::clamp(static_cast<long double>(centre_of(line)),
                                           static_cast<long double>(*first), static_cast<long double>(*last));
    const auto [left, right] = border_on_line(triangle, on_line);
    long double intensity = left.intensity;
    if (right.element > left.element) {
        const long double t =
            (static_cast<long double>(centre_of(element)) - left.element) / (right.element - left.element);
        intensity += t * (right.intensity - left.intensity);
    }
    const auto [least, greatest] = std::minmax_element(triangle.intensity, triangle.intensity + 3);
    intensity = std::clamp(intensity, static_cast<long double>(*least), static_cast<long double>(*greatest));
    return static_cast<std::int32_t>(intensity + 0.5L); // intensities are never negative
}

ig::VideoFrame paint(const ig::ProjectedFaces& projected, const ig::Raster& raster,
                     std::span<const Colour> colours, std::uint32_t background) {
    ig::VideoFrame frame = empty_picture(raster, background);
    for (std::size_t rank = projected.faces.size(); rank-- > 0;) {
        const ig::ProjectedFace& face = projected.faces[rank];
        for_each_covered(points_of(projected, face), raster, [&](std::uint32_t line, std::uint32_t element) {
            if (face.colour_step != 0) {
                std::array<std::int32_t, 3> tint{};
                for (std::size_t k = 0; k < 3; ++k)
                    tint[k] = gouraud(
                        projected.triangles[static_cast<std::size_t>(face.triangle) + k * face.colour_step],
                        line, element);
                const auto component = [&](std::size_t k) {
                    return shaded({255, 255, 255}, tint[k]) >> (8 * k) & 255U;
                };
                const std::size_t at = place(raster, line, element);
                frame.pixels[at] = component(0) | component(1) << 8U | component(2) << 16U | 0xff000000U;
                frame.intensity[at] = std::max({tint[0], tint[1], tint[2]});
                frame.rank[at] = static_cast<std::int32_t>(rank);
                return;
            }
            const std::int32_t intensity =
                face.triangle < 0
                    ? face.intensity
                    : gouraud(projected.triangles[static_cast<std::size_t>(face.triangle)], line, element);
            const std::size_t at = place(raster, line, element);
            frame.pixels[at] = shaded(colours[face.colour], intensity);
            frame.intensity[at] = intensity;
            frame.rank[at] = static_cast<std::int32_t>(rank);
        });
    }
    return frame;
}

std::vector<std::uint32_t> coverage(const ig::ProjectedFaces& projected, const ig::Raster& raster) {
    std::vector<std::uint32_t> count(std::size_t{raster.width} * raster.height, 0);
    for (const ig::ProjectedFace& face : projected.faces)
        for_each_covered(points_of(projected, face), raster, [&](std::uint32_t line, std::uint32_t element) {
            ++count[place(raster, line, element)];
        });
    return count;
}

} // namespace linkdig::support
