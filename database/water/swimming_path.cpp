#include "database/water/swimming_path.h"

#include "database/model/mathematics.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace linkdig::database {

namespace {

constexpr int parts_of_piece = 64;

PathPlace place(const LinePiece& line, double t) {
    return {line.from + t * (line.to - line.from), line.to - line.from};
}

PathPlace place(const ArcPiece& arc, double t) {
    const double turn = arc.to_rad - arc.from_rad;
    const double growth = arc.to_radius - arc.from_radius;
    const SineCosine a = sine_cosine(arc.from_rad + t * turn);
    const Vec2d outward(a.cosine, a.sine);
    const Vec2d around(-a.sine, a.cosine);
    const double radius = arc.from_radius + t * growth;
    return {arc.centre + radius * outward, growth * outward + radius * turn * around};
}

PathPlace place(const BezierPiece& curve, double t) {
    const auto& p = curve.points;
    const double r = 1.0 - t;
    return {r * r * r * p[0] + 3.0 * r * r * t * p[1] + 3.0 * r * t * t * p[2] + t * t * t * p[3],
            3.0 * (r * r * (p[1] - p[0]) + 2.0 * r * t * (p[2] - p[1]) + t * t * (p[3] - p[2]))};
}

LinePiece part(const LinePiece& line, double from, double to) {
    return {place(line, from).point, place(line, to).point};
}

ArcPiece part(ArcPiece arc, double from, double to) {
    const ArcPiece whole = arc;
    arc.from_rad = whole.from_rad + from * (whole.to_rad - whole.from_rad);
    arc.to_rad = whole.from_rad + to * (whole.to_rad - whole.from_rad);
    arc.from_radius = whole.from_radius + from * (whole.to_radius - whole.from_radius);
    arc.to_radius = whole.from_radius + to * (whole.to_radius - whole.from_radius);
    return arc;
}

BezierPiece part(const BezierPiece& curve, double from, double to) {
    const PathPlace a = place(curve, from);
    const PathPlace b = place(curve, to);
    const double third = (to - from) / 3.0;
    return {{a.point, a.point + third * a.derivative, b.point - third * b.derivative, b.point}};
}

/// Length along a piece, tabulated over its parameter.
class LengthTable {
public:
    explicit LengthTable(const PathPiece& piece, int parts = parts_of_piece) : parts_(parts) {
        const auto speed = [&](double t) { return glm::length(place_on(piece, t).derivative); };
        lengths_.push_back(0.0);
        for (int i = 0; i < parts; ++i) {
            const double t = static_cast<double>(i) / parts;
            const double h = 1.0 / parts;
            lengths_.push_back(lengths_.back() +
                               h / 6.0 * (speed(t) + 4.0 * speed(t + 0.5 * h) + speed(t + h)));
        }
    }
    double total() const { return lengths_.back(); }
    /// The parameter at which `length` of the piece is behind.
    double parameter_at(double length) const {
        const auto above = std::ranges::upper_bound(lengths_, length);
        const auto i = std::clamp<std::ptrdiff_t>(above - lengths_.begin() - 1, 0, parts_ - 1);
        const double from = lengths_[static_cast<std::size_t>(i)];
        const double to = lengths_[static_cast<std::size_t>(i + 1)];
        const double share = to > from ? std::clamp((length - from) / (to - from), 0.0, 1.0) : 0.0;
        return (static_cast<double>(i) + share) / parts_;
    }

private:
    int parts_;
    std::vector<double> lengths_;
};

/// A curve may stand still at its ends (control points that coincide): it still has a direction just beside them.
Vec2d tangent_on(const PathPiece& piece, double t) {
    for (const double nearby : {t, t + 1e-6, t - 1e-6}) {
        const Vec2d d = place_on(piece, std::clamp(nearby, 0.0, 1.0)).derivative;
        const double length = glm::length(d);
        if (length > 1e-12) return d / length;
    }
    return {1.0, 0.0};
}

} // namespace

std::vector<BezierPiece> natural_spline(const std::vector<Vec2d>& points) {
    // Derivatives d_i from d_{i-1} + 4 d_i + d_{i+1} = 3 (p_{i+1} - p_{i-1}), 2 d_0 + d_1 = 3 (p_1 - p_0) and its mirror image.
    const std::size_t n = points.size();
    std::vector<double> above(n);
    std::vector<Vec2d> d(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool end = i == 0 || i + 1 == n;
        const Vec2d right = 3.0 * (points[std::min(i + 1, n - 1)] - points[i == 0 ? 0 : i - 1]);
        const double below = i == 0 ? 0.0 : 1.0;
        const double pivot = (end ? 2.0 : 4.0) - below * (i == 0 ? 0.0 : above[i - 1]);
        above[i] = 1.0 / pivot;
        d[i] = (right - below * (i == 0 ? Vec2d(0.0) : d[i - 1])) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;)
        d[i] -= above[i] * d[i + 1];
    std::vector<BezierPiece> curves;
    for (std::size_t i = 0; i + 1 < n; ++i)
        curves.push_back(
            {{points[i], points[i] + d[i] / 3.0, points[i + 1] - d[i + 1] / 3.0, points[i + 1]}});
    return curves;
}

PathPlace place_on(const PathPiece& piece, double t) {
    return std::visit([&](const auto& p) { return place(p, t); }, piece);
}

PathPiece part_of(const PathPiece& piece, double from, double to) {
    return std::visit([&](const auto& p) { return PathPiece(part(p, from, to)); }, piece);
}

double path_length(const std::vector<PathPiece>& pieces) {
    double length = 0.0;
    for (std::size_t i = pieces.size(); i-- > 0;) // from the end, as the samples run
        length += LengthTable(pieces[i]).total();
    return length;
}

std::string path_mistake(const std::vector<PathPiece>& pieces) {
    if (pieces.empty()) return "has no piece; expected at least one";
    const double size = path_length(pieces);
    if (!std::isfinite(size)) return "has numbers that are not finite";
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!(LengthTable(pieces[i]).total() > 1e-9 * size))
            return fmt::format("piece {} has no length", i + 1);
        if (i == 0) continue;
        const Vec2d end = place_on(pieces[i - 1], 1.0).point;
        const Vec2d begin = place_on(pieces[i], 0.0).point;
        if (glm::distance(end, begin) > 1e-6 * size)
            return fmt::format(
                "piece {} begins at ({:g}, {:g}); expected ({:g}, {:g}), where the piece before it ends",
                i + 1, begin.x, begin.y, end.x, end.y);
    }
    return "";
}

SampledPath sample_path(const std::vector<PathPiece>& pieces, double step, double reach) {
    SampledPath path;
    path.step = step;
    double before = 0.0; // length of the pieces after the one at hand
    std::size_t next = 0;
    for (std::size_t i = pieces.size(); i-- > 0;) {
        const PathPiece& piece = pieces[i];
        const double rough = LengthTable(piece).total();
        const LengthTable table(piece, std::clamp(static_cast<int>(rough / step), parts_of_piece, 1 << 16));
        for (; static_cast<double>(next) * step <= before + table.total(); ++next) {
            const double t = table.parameter_at(table.total() - (static_cast<double>(next) * step - before));
            path.points.push_back(place_on(piece, t).point);
            path.tangents.push_back(tangent_on(piece, t));
        }
        before += table.total();
    }
    path.length = before;
    const Vec2d begin = place_on(pieces.front(), 0.0).point;
    const Vec2d way = tangent_on(pieces.front(), 0.0);
    for (;; ++next) {
        const double s = static_cast<double>(next) * step;
        path.points.push_back(begin - (s - before) * way);
        path.tangents.push_back(way);
        if (s > reach && s > before) break;
    }
    return path;
}

} // namespace linkdig::database
