#pragma once
/// Where a swimmer swam: short pieces stitched together, sampled backwards from where it is now.

#include "database/model/vectors.h"

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace linkdig::database {

/// Coordinates are units of the field (metres at physical scale), angles counter-clockwise from +x.
struct LinePiece {
    Vec2d from{0};
    Vec2d to{0};
};

/// A circular arc, or with two radii a spiral whose radius changes evenly with the angle.
struct ArcPiece {
    Vec2d centre{0};
    double from_radius = 0.0;
    double to_radius = 0.0;
    double from_rad = 0.0;
    double to_rad = 0.0; ///< less than from_rad: clockwise
};

struct BezierPiece {
    std::array<Vec2d, 4> points{};
};

using PathPiece = std::variant<LinePiece, ArcPiece, BezierPiece>;

/// The natural cubic spline through two or more points, as Bézier curves; its parameter runs evenly from point to point.
std::vector<BezierPiece> natural_spline(const std::vector<Vec2d>& points);

struct PathPlace {
    Vec2d point{0};
    Vec2d derivative{0}; ///< to the parameter
};
/// t in [0, 1].
PathPlace place_on(const PathPiece& piece, double t);

/// The part of a piece between two parameters, 0 <= from < to <= 1.
PathPiece part_of(const PathPiece& piece, double from, double to);

/// A path by the distance swum: sample k lies k steps before the path's end. Before its beginning the path is continued straight.
struct SampledPath {
    double length = 0.0;         ///< of the pieces, along the path
    double step = 0.0;           ///< between samples
    std::vector<Vec2d> points;   ///< from the end backwards
    std::vector<Vec2d> tangents; ///< unit vectors, the way it swam
};

/// What is wrong with a path, or nothing: no piece, a piece without length, ends that do not meet (by more than a millionth of the
/// path), numbers that are not finite. `length` of a line is exact; others are Simpson's rule over 64 or more parts.
std::string path_mistake(const std::vector<PathPiece>& pieces);

/// Along the path, from end to end.
double path_length(const std::vector<PathPiece>& pieces);

/// Samples up to `reach` from the end, at least up to the beginning. Pieces without mistake; step > 0.
SampledPath sample_path(const std::vector<PathPiece>& pieces, double step, double reach);

} // namespace linkdig::database
