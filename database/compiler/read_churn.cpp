/// Churned water (report, 3.2.3): the sea's own method, smooth-shaded squares with random normals at a fixed
/// vertical angle, in small squares on a strip of the water and under a sun that turns fast. Towards the rims the
/// normals shrink to nothing, and with them the light that is added to the sea's: the strip has no hard border.

#include "database/compiler/model_object.h"
#include "database/compiler/primitives.h"
#include "database/compiler/square_grid.h"
#include "database/model/mathematics.h"
#include "database/water/sea_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace linkdig::database {

namespace {

constexpr double most_strip_squares = 1000000;

struct Strip {
    std::vector<Vec2d> left, right; ///< its rims, metres, from its start to its end
    std::size_t along = 0, across = 0;
    double fade_start = 0, fade_end = 0, fade_sides = 0; ///< squares over which it fades
};

double length_of(const std::vector<Vec2d>& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        sum += glm::distance(line[i - 1], line[i]);
    return sum;
}

/// The point at a part, 0 to 1, of the line's length.
Vec2d point_at(const std::vector<Vec2d>& line, double part) {
    double rest = part * length_of(line);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double step = glm::distance(line[i - 1], line[i]);
        if (rest <= step && step > 0) return line[i - 1] + (rest / step) * (line[i] - line[i - 1]);
        rest -= step;
    }
    return line.back();
}

/// 0 on the rim, 1 from `fade` squares inside.
double weight(std::size_t squares_inside, double fade) {
    return fade > 0 ? std::min(1.0, static_cast<double>(squares_inside) / fade) : 1.0;
}

double weight(const Strip& strip, std::size_t row, std::size_t column) {
    const double ends = std::min(weight(row, strip.fade_start), weight(strip.along - row, strip.fade_end));
    return ends * weight(std::min(column, strip.across - column), strip.fade_sides);
}

void add_vertices(const Strip& strip, const std::vector<Vec3f>& normals, ModelObject& object) {
    for (std::size_t row = 0; row <= strip.along; ++row) {
        const double part = static_cast<double>(row) / static_cast<double>(strip.along);
        const Vec2d left = point_at(strip.left, part), right = point_at(strip.right, part);
        for (std::size_t column = 0; column <= strip.across; ++column) {
            const Vec2d at =
                left + (static_cast<double>(column) / static_cast<double>(strip.across)) * (right - left);
            const Vec3d normal = weight(strip, row, column) * Vec3d(normals[object.vertices.size()]);
            object.vertices.push_back({as_float({at.x, at.y, 0.0}), normal, {}, object.at});
        }
    }
}

/// Twice the area of the strip's outline, positive if it runs counter-clockwise: out on the right, home on the left.
double area_of(const Strip& strip) {
    std::vector<Vec2d> outline = strip.right;
    outline.insert(outline.end(), strip.left.rbegin(), strip.left.rend());
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

Strip read_strip(TableReader& reader) {
    Strip strip;
    const Mistakes mistakes(reader);
    strip.left = reader.points2_m("left");
    strip.right = reader.points2_m("right");
    const double square_m = reader.length_m("square", {}, {0.1, 1e4});
    strip.fade_start = reader.number("fade_start", 0, {0, 1000});
    strip.fade_end = reader.number("fade_end", 0, {0, 1000});
    strip.fade_sides = reader.number("fade_sides", 0, {0, 1000});
    if (mistakes.any()) return strip;
    for (const auto& [key, rim] : {std::pair{"left_m", strip.left}, std::pair{"right_m", strip.right}})
        if (rim.size() < 2 || length_of(rim) <= 0)
            reader.error_at(key,
                            fmt::format("the rim \"{}\" has no length; expected two or more points", key));
    if (!mistakes.any() && area_of(strip) <= 0)
        reader.error_at("left_m",
                        "the strip runs the wrong way round; expected left_m to the left on the way");
    if (mistakes.any()) return strip;
    const double ends = glm::distance(strip.left.front(), strip.right.front()) +
                        glm::distance(strip.left.back(), strip.right.back());
    const double along = std::floor(0.5 * (length_of(strip.left) + length_of(strip.right)) / square_m + 0.5);
    const double across = std::floor(0.5 * ends / square_m + 0.5);
    if (std::max(along, 1.0) * std::max(across, 1.0) > most_strip_squares) {
        reader.error_at("square_m", fmt::format("{} makes more than {} squares; expected larger ones",
                                                reader.what(), most_strip_squares));
        return strip;
    }
    strip.along = static_cast<std::size_t>(std::max(along, 1.0));
    strip.across = static_cast<std::size_t>(std::max(across, 1.0));
    return strip;
}

} // namespace

void read_churn(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects) {
    TableReader reader = reader_of(table, *reading.sources, "churn", *reading.diagnostics);
    const Mistakes mistakes(reader);
    ModelObject object = begin_object(reader, table, reading);
    FaceStyle style;
    style.shading = Shading::vertex;
    if (const auto colour = named(reader, "colour", reading.registry->colour_names, true))
        style.colour = static_cast<std::uint16_t>(*colour);
    style.layer = static_cast<std::int32_t>(reader.integer("layer", 0, -10000, 10000));
    const bool mirrored = read_mirror(reader);
    const double vertical_angle_rad = reader.angle_rad("vertical_angle", {}, {0, 90});
    const auto seed =
        static_cast<std::uint64_t>(reader.integer("seed", 0, std::numeric_limits<std::int64_t>::max()));
    const Strip strip = read_strip(reader);
    reader.finish();
    if (mistakes.any()) return;
    const std::size_t vertices = (strip.along + 1) * (strip.across + 1);
    add_vertices(strip, random_normals(seed, NormalStream::vertices, vertices, vertical_angle_rad), object);
    const std::vector<Vec3f> normals =
        random_normals(seed, NormalStream::faces, strip.along * strip.across, vertical_angle_rad);
    add_squares(static_cast<std::uint32_t>(strip.across), static_cast<std::uint32_t>(strip.along), object,
                [&](ModelFace& face, std::uint32_t number) {
                    face.style = style;
                    face.light_normal = Vec3d(normals[number]);
                });
    if (mirrored) add_mirror_image(object);
    objects.push_back(std::move(object));
}

} // namespace linkdig::database
