/// Flat markings that face up: rectangle, disc, ring, stripe, path, numeral.

#include "database/compiler/primitives.h"
#include "database/model/mathematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace linkdig::database {

namespace {

constexpr Range positive_length{plane_tolerance_m, 1e7};

/// Axes of a marking: `along` its heading (counter-clockwise from +x), and `port` of it.
struct Heading {
    Vec3d along;
    Vec3d port;
};

Heading heading_of(double heading_rad) {
    const SineCosine h = sine_cosine(heading_rad);
    return {{h.cosine, h.sine, 0}, {-h.sine, h.cosine, 0}};
}

/// Rectangle from (x0, y0) to (x1, y1) in the heading's axes about the centre.
void add_bar(Shape& shape, const Vec3d& centre, const Heading& axes, const Vec2d& low, const Vec2d& high) {
    const auto at = [&](double x, double y) { return centre + x * axes.along + y * axes.port; };
    shape.add_points({at(low.x, low.y), at(high.x, low.y), at(high.x, high.y), at(low.x, high.y)});
}

std::vector<Vec3d> circle(const Vec3d& centre, double radius_m, std::int64_t sides) {
    std::vector<Vec3d> points;
    for (std::int64_t i = 0; i < sides; ++i) {
        const SineCosine a = sine_cosine(two_pi * static_cast<double>(i) / static_cast<double>(sides));
        points.push_back(centre + radius_m * Vec3d(a.cosine, a.sine, 0));
    }
    return points;
}

/// Strokes of the digits, as on a seven-segment display: top, middle, bottom bars; upper left, upper right,
/// lower left, lower right posts.
struct Strokes {
    bool top, middle, bottom, upper_left, upper_right, lower_left, lower_right;
};

constexpr Strokes digit_strokes[10] = {
    {true, false, true, true, true, true, true},   {false, false, false, false, false, false, false},
    {true, true, true, false, true, true, false},  {true, true, true, false, true, false, true},
    {false, true, false, true, true, false, true}, {true, true, true, true, false, false, true},
    {true, true, true, true, false, true, true},   {true, false, false, false, true, false, true},
    {true, true, true, true, true, true, true},    {true, true, true, true, true, false, true},
};

/// One digit's box: x up the digit, y to its left, centre at the origin of `centre`.
struct DigitBox {
    Vec3d centre;
    Heading axes;
    double half_height;
    double half_width;
    double stroke;
};

/// Left or right post: the bars own the corners where they stand, so that strokes meet without overlapping.
void add_posts(Shape& shape, const DigitBox& box, const Strokes& strokes, bool left) {
    const bool upper = left ? strokes.upper_left : strokes.upper_right;
    const bool lower = left ? strokes.lower_left : strokes.lower_right;
    const double y0 = left ? box.half_width - box.stroke : -box.half_width;
    const double y1 = y0 + box.stroke;
    const double top = box.half_height - (strokes.top ? box.stroke : 0);
    const double bottom = -box.half_height + (strokes.bottom ? box.stroke : 0);
    const double middle = strokes.middle ? box.stroke / 2 : 0;
    const auto post = [&](double x0, double x1) { add_bar(shape, box.centre, box.axes, {x0, y0}, {x1, y1}); };
    if (upper && lower && !strokes.middle) return post(bottom, top);
    if (upper) post(middle, top);
    if (lower) post(bottom, -middle);
}

void add_digit(Shape& shape, const DigitBox& box, char digit) {
    if (digit == '1') // one stroke, centred
        return add_bar(shape, box.centre, box.axes, {-box.half_height, -box.stroke / 2},
                       {box.half_height, box.stroke / 2});
    const Strokes& strokes = digit_strokes[digit - '0'];
    const auto bar = [&](double x0) {
        add_bar(shape, box.centre, box.axes, {x0, -box.half_width}, {x0 + box.stroke, box.half_width});
    };
    if (strokes.top) bar(box.half_height - box.stroke);
    if (strokes.middle) bar(-box.stroke / 2);
    if (strokes.bottom) bar(-box.half_height);
    add_posts(shape, box, strokes, true);
    add_posts(shape, box, strokes, false);
}

} // namespace

Shape rectangle_shape(TableReader& reader) {
    const Vec3d centre = reader.point_m("centre");
    reader.describe("size_m", "[length, width]", {});
    const toml::node* node = reader.node("size_m");
    const double heading = reader.angle_rad("heading", 0.0, {-360, 360});
    const toml::array* size = node == nullptr ? nullptr : node->as_array();
    const auto side = [&](std::size_t i) { return size->get(i)->value<double>().value_or(0.0); };
    if (size == nullptr || size->size() != 2 || !(side(0) >= plane_tolerance_m && side(0) <= 1e7) ||
        !(side(1) >= plane_tolerance_m && side(1) <= 1e7)) {
        reader.error_at(
            "size_m",
            fmt::format("{} needs \"size_m\"; expected [length, width], two lengths above 0", reader.what()));
        return {};
    }
    Shape shape;
    add_bar(shape, centre, heading_of(heading), {-side(0) / 2, -side(1) / 2}, {side(0) / 2, side(1) / 2});
    return shape;
}

Shape disc_shape(TableReader& reader) {
    const Vec3d centre = reader.point_m("centre");
    const double radius = reader.length_m("radius", {}, positive_length);
    const std::int64_t sides = reader.integer("sides", 12, 3, 1000);
    Shape shape;
    shape.add_points(circle(centre, radius, sides));
    return shape;
}

Shape ring_shape(TableReader& reader) {
    const Mistakes mistakes(reader);
    const Vec3d centre = reader.point_m("centre");
    const double radius = reader.length_m("radius", {}, positive_length);
    const double width = reader.length_m("width", {}, positive_length);
    const std::int64_t sides = reader.integer("sides", 16, 3, 1000);
    if (mistakes.any()) return {};
    if (width >= radius) {
        reader.error_at("width_m", fmt::format("the ring is {} m wide and its radius {} m; expected less",
                                               width, radius));
        return {};
    }
    Shape shape;
    shape.points = circle(centre, radius, sides);
    const std::vector<Vec3d> inner = circle(centre, radius - width, sides);
    shape.points.insert(shape.points.end(), inner.begin(), inner.end());
    const auto n = static_cast<std::uint32_t>(sides);
    for (std::uint32_t i = 0; i < n; ++i)
        shape.add({i, (i + 1) % n, n + (i + 1) % n, n + i});
    return shape;
}

Shape stripe_shape(TableReader& reader) {
    const Mistakes mistakes(reader);
    const Vec3d from = reader.point_m("from");
    const Vec3d to = reader.point_m("to");
    const double width = reader.length_m("width", {}, positive_length);
    const double dash = reader.length_m("dash", 0.0, {0.0, 1e7});
    const double gap = reader.length_m("gap", 0.0, {0.0, 1e7});
    if (mistakes.any()) return {};
    const double length = glm::distance(from, to);
    if (from.z != to.z || length < plane_tolerance_m) {
        reader.error_at(
            "to_m", "the stripe's ends differ in height or not at all; expected two points at the same z");
        return {};
    }
    if ((dash > 0) != (gap > 0)) {
        reader.error_at(dash > 0 ? "dash_m" : "gap_m",
                        "\"dash_m\" and \"gap_m\" make a dashed stripe together; expected both above 0");
        return {};
    }
    if (dash > 0 && length / (dash + gap) > static_cast<double>(most_copies)) {
        reader.error_at("dash_m",
                        fmt::format("the stripe has more than {} dashes; expected fewer", most_copies));
        return {};
    }
    const Vec3d along = (to - from) / length;
    const Heading axes{along, {-along.y, along.x, 0}};
    Shape shape;
    const double step = dash > 0 ? dash + gap : length;
    for (int i = 0; i * step < length - plane_tolerance_m; ++i) {
        const double end = dash > 0 ? std::min(length, i * step + dash) : length;
        add_bar(shape, from, axes, {i * step, -width / 2}, {end, width / 2});
    }
    return shape;
}

namespace {

/// Sharper bends than this (cosine of half the turn) have mitres that reach far out.
constexpr double least_half_turn_cosine = 0.5;

/// Where the port edge of the band stands beside point i, per half width; nothing where the bend is too sharp.
std::optional<Vec3d> mitre(const std::vector<Vec3d>& points, std::size_t i) {
    const auto port_of = [&](std::size_t from) {
        const Vec3d along = glm::normalize(points[from + 1] - points[from]);
        return Vec3d(-along.y, along.x, 0);
    };
    const Vec3d before = port_of(i == 0 ? 0 : i - 1);
    const Vec3d after = port_of(i + 1 == points.size() ? i - 1 : i);
    const double half_turn_cosine = 0.5 * glm::length(before + after);
    if (half_turn_cosine < least_half_turn_cosine) return std::nullopt;
    return 0.5 * (before + after) / (half_turn_cosine * half_turn_cosine);
}

bool is_level_line(const std::vector<Vec3d>& points) {
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].z != points[0].z || glm::distance(points[i], points[i - 1]) < plane_tolerance_m)
            return false;
    return points.size() >= 2;
}

} // namespace

Shape path_shape(TableReader& reader) {
    const Mistakes mistakes(reader);
    const std::vector<Vec3d> points = reader.points_m("points");
    const double width = reader.length_m("width", {}, positive_length);
    if (mistakes.any()) return {};
    const char* key = reader.has("points_m") ? "points_m" : "points_ft";
    if (!is_level_line(points)) {
        reader.error_at(
            key, "the path has no length, or its points differ in height; expected two or more points, "
                 "apart, at the same z");
        return {};
    }
    Shape shape;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::optional<Vec3d> port = mitre(points, i);
        if (!port) {
            reader.error_at(
                key, fmt::format("the path turns by more than 120 degrees at point {}; expected more points "
                                 "around the bend",
                                 i + 1));
            return {};
        }
        shape.points.push_back(points[i] - 0.5 * width * *port);
        shape.points.push_back(points[i] + 0.5 * width * *port);
    }
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i)
        shape.add({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    return shape;
}

Shape numeral_shape(TableReader& reader) {
    const Mistakes mistakes(reader);
    const std::string text = reader.text("text");
    const Vec3d centre = reader.point_m("centre");
    const double height = reader.length_m("height", {}, positive_length);
    const double stroke = reader.length_m("stroke", {}, positive_length);
    const Heading axes = heading_of(reader.angle_rad("heading", 0.0, {-360, 360}));
    if (mistakes.any()) return {};
    const double width = 0.6 * height;
    const bool digits = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (text.empty() || !digits || text.size() > 8) {
        reader.error_at("text", fmt::format("the numeral is \"{}\"; expected one to eight digits", text));
        return {};
    }
    if (stroke > width / 3) {
        reader.error_at(
            "stroke_m",
            fmt::format("the stroke is {} m wide; expected at most a fifth of the height", stroke));
        return {};
    }
    const double advance = width + std::max(stroke, 0.25 * width);
    Shape shape;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const double to_left = (static_cast<double>(text.size() - 1) / 2 - static_cast<double>(i)) * advance;
        add_digit(shape, {centre + to_left * axes.port, axes, height / 2, width / 2, stroke}, text[i]);
    }
    return shape;
}

} // namespace linkdig::database
