/// Mounds: irregular low pyramids over a field, as hills are modelled. The report's 3D waves were such mounds, scaled down
/// and coded blue (3.1.1); scaled up and coded green they are hills.

#include "database/compiler/model_object.h"
#include "database/compiler/primitives.h"
#include "database/model/mathematics.h"
#include "database/model/random.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace linkdig::database {

namespace {

constexpr std::int64_t least_sides = 3;
constexpr std::int64_t most_sides = 16;
/// Random numbers that a mound may ask for: places of the generator, so that no mound depends on another.
constexpr std::uint64_t numbers_per_mound = 4 + 2 * most_sides;

struct Field {
    Vec3d from_m{0};
    Vec2d size_m{0};
    double spacing_m = 1.0;
    std::array<double, 2> radius_m{};
    std::array<double, 2> height_m{};
    std::array<double, 2> sides{};
    std::uint64_t seed = 0;
    bool staggered = false; ///< every second row half a square to the right, and one mound shorter
    std::uint64_t columns = 0;
    std::uint64_t rows = 0;

    double shift(std::uint64_t row) const { return staggered && row % 2 == 1 ? 0.5 : 0.0; }
    std::uint64_t mounds_in(std::uint64_t row) const { return shift(row) > 0.0 ? columns - 1 : columns; }
};

/// Looks of the faces: every second one may have another colour, and all an outline.
struct Looks {
    FaceStyle style;
    std::optional<std::uint16_t> second_colour;
    std::optional<std::uint16_t> outline_colour;
    double outline_m = 0.0;
};

class Rolls {
public:
    Rolls(std::uint64_t seed, std::uint64_t mound) : seed_(seed), next_(mound * numbers_per_mound) {}
    double between(double least, double greatest) {
        return least + (greatest - least) * random_unit(seed_, next_++);
    }
    double between(const std::array<double, 2>& range) { return between(range[0], range[1]); }

private:
    std::uint64_t seed_;
    std::uint64_t next_;
};

/// Does `place` lie well inside the convex `base`, seen from above, so that a top over it leans over no side?
bool stands_over(const std::vector<Vec3d>& base, const Vec3d& place) {
    constexpr double least_share = 0.05; // of the side's length: steeper sides would be upright to the eye
    for (std::size_t i = 0; i < base.size(); ++i) {
        const Vec3d side = base[(i + 1) % base.size()] - base[i];
        const Vec3d inward = place - base[i];
        if (side.x * inward.y - side.y * inward.x < least_share * (side.x * side.x + side.y * side.y))
            return false;
    }
    return true;
}

Vec3d middle_of(const std::vector<Vec3d>& points) {
    Vec3d sum(0.0);
    for (const Vec3d& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

/// Corners of a mound's base, then its top. It stays inside its square of the field, so that a plane passes between any two.
std::vector<Vec3d> mound(const Field& field, std::uint64_t column, std::uint64_t row) {
    Rolls roll(field.seed, row * field.columns + column);
    const double radius = roll.between(field.radius_m);
    const double height = roll.between(field.height_m);
    const auto sides = static_cast<int>(std::floor(roll.between(field.sides[0], field.sides[1] + 1.0)));
    const double room = 0.5 * field.spacing_m - radius;
    const double square_x =
        field.from_m.x + (static_cast<double>(column) + 0.5 + field.shift(row)) * field.spacing_m;
    const double square_y = field.from_m.y + (static_cast<double>(row) + 0.5) * field.spacing_m;
    const Vec3d centre(square_x + roll.between(-room, room), square_y + roll.between(-room, room),
                       field.from_m.z);
    const double turn = roll.between(0.0, two_pi);
    std::vector<Vec3d> points;
    for (int i = 0; i < sides; ++i) {
        const SineCosine a = sine_cosine(turn + two_pi * (i + roll.between(-0.2, 0.2)) / sides);
        points.push_back(centre + radius * roll.between(0.65, 1.0) * Vec3d(a.cosine, a.sine, 0.0));
    }
    const SineCosine lean = sine_cosine(roll.between(0.0, two_pi));
    const Vec3d top = centre + radius * roll.between(0.0, 0.25) * Vec3d(lean.cosine, lean.sine, 0.0);
    points.push_back((stands_over(points, top) ? top : middle_of(points)) + Vec3d(0.0, 0.0, height));
    return points;
}

/// The triangle drawn in by `width` on every side, towards the middle of its inscribed circle; nothing if it is too small.
std::optional<std::array<Vec3d, 3>> drawn_in(const std::array<Vec3d, 3>& corners, double width_m) {
    const double a = glm::distance(corners[1], corners[2]);
    const double b = glm::distance(corners[2], corners[0]);
    const double c = glm::distance(corners[0], corners[1]);
    const double around = a + b + c;
    const Vec3d middle = (a * corners[0] + b * corners[1] + c * corners[2]) / around;
    const double area = 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const double shrunk = 1.0 - width_m * around / (2.0 * area); // the circle's radius is 2 area / around
    if (!(shrunk > 0.0)) return std::nullopt;
    std::array<Vec3d, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = middle + shrunk * (corners[i] - middle);
    return result;
}

class MoundBuilder {
public:
    MoundBuilder(const Looks& looks, ModelObject& object) : looks_(looks), object_(object) {}

    void add(const std::vector<Vec3d>& points) {
        const auto first = static_cast<std::uint32_t>(object_.vertices.size());
        const auto sides = static_cast<std::uint32_t>(points.size()) - 1;
        // A foot lies in the flat ground, so its normal is the ground's: a smooth-shaded mound meets it without a step.
        for (std::uint32_t i = 0; i < sides; ++i)
            object_.vertices.push_back({as_float(points[i]), Vec3d(0.0, 0.0, 1.0), {}, object_.at});
        object_.vertices.push_back({as_float(points[sides]), {}, {}, object_.at});
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t next = (i + 1) % sides;
            FaceStyle style = looks_.style;
            if (looks_.second_colour && i % 2 == 1) style.colour = looks_.second_colour;
            add_face({first + i, first + next, first + sides}, style);
            if (looks_.outline_colour) outline({points[i], points[next], points[sides]});
        }
    }

private:
    void add_face(std::vector<std::uint32_t> corners, const FaceStyle& style) {
        ModelFace face;
        face.corners = std::move(corners);
        face.style = style;
        face.at = object_.at;
        object_.faces.push_back(std::move(face));
    }

    /// The face just made becomes the outline; what is inside it lies one layer higher.
    void outline(const std::array<Vec3d, 3>& corners) {
        FaceStyle inner = object_.faces.back().style;
        object_.faces.back().style.colour = looks_.outline_colour;
        const auto inside = drawn_in(corners, looks_.outline_m);
        if (!inside) return;
        ++inner.layer;
        const auto first = static_cast<std::uint32_t>(object_.vertices.size());
        for (const Vec3d& corner : *inside)
            object_.vertices.push_back({as_float(corner), {}, {}, object_.at});
        add_face({first, first + 1, first + 2}, inner);
    }

    const Looks& looks_;
    ModelObject& object_;
};

void read_sides(TableReader& reader, Field& field) {
    field.sides[0] = static_cast<double>(reader.integer("least_sides", 5, least_sides, most_sides));
    field.sides[1] = static_cast<double>(reader.integer("greatest_sides", 7, least_sides, most_sides));
    if (field.sides[0] > field.sides[1])
        reader.error_at("least_sides", "\"least_sides\" is above \"greatest_sides\"");
}

Field read_field(TableReader& reader) {
    const Mistakes mistakes(reader);
    Field field;
    field.from_m = reader.point_m("from");
    const Vec3d to_m = reader.point_m("to");
    field.size_m = Vec2d(to_m - field.from_m);
    field.spacing_m = reader.length_m("spacing", {}, {0.1, 1e6});
    field.radius_m = reader.range_m("radius", {0.001, 1e6});
    field.height_m = reader.range_m("height", {0.001, 1e6});
    read_sides(reader, field);
    field.staggered = reader.boolean("staggered", false);
    field.seed =
        static_cast<std::uint64_t>(reader.integer("seed", 0, std::numeric_limits<std::int64_t>::max()));
    if (mistakes.any()) return field;
    if (field.radius_m[1] > 0.5 * field.spacing_m)
        reader.error_at("radius_m",
                        fmt::format("the greatest radius is {:.6g} m and the spacing {:.6g} m; expected "
                                    "at most half the spacing, so that no mound meets another",
                                    field.radius_m[1], field.spacing_m));
    const Vec2d whole = glm::floor(field.size_m / field.spacing_m + 1e-9);
    if (!(whole.x >= 1.0 && whole.y >= 1.0) || to_m.z != field.from_m.z)
        reader.error_at(
            "to_m", "the field holds no mound; expected \"to_m\" beyond \"from_m\" by at least the spacing "
                    "in x and y, at the same height");
    else if (whole.x * whole.y * field.sides[1] > static_cast<double>(most_mound_faces))
        reader.error_at("spacing_m", fmt::format("the field makes up to {:.0f} faces; expected at most {}",
                                                 whole.x * whole.y * field.sides[1], most_mound_faces));
    if (mistakes.any()) return field;
    field.columns = static_cast<std::uint64_t>(whole.x);
    field.rows = static_cast<std::uint64_t>(whole.y);
    return field;
}

Looks read_looks(TableReader& reader, const Reading& reading) {
    Looks looks;
    reader.describe("colour", reading.registry->colour_names.reference(), {});
    reader.describe("outline_width_m",
                    "number, 0.001 to 100000, beside `outline_colour`; or `outline_width_ft`", "none");
    looks.style = read_style(reader, reading, {});
    if (!looks.style.colour) reader.text("colour"); // reports the missing key
    const auto optional_colour = [&](const char* key) -> std::optional<std::uint16_t> {
        const auto colour = named(reader, key, reading.registry->colour_names, false);
        if (!colour) return std::nullopt;
        return static_cast<std::uint16_t>(*colour);
    };
    looks.second_colour = optional_colour("second_colour");
    looks.outline_colour = optional_colour("outline_colour");
    if (reader.has("outline_colour")) looks.outline_m = reader.length_m("outline_width", {}, {0.001, 1e5});
    return looks;
}

} // namespace

void read_mounds(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects) {
    TableReader reader = reader_of(table, *reading.sources, "mounds", *reading.diagnostics);
    const Mistakes mistakes(reader);
    ModelObject object = begin_object(reader, table, reading);
    const Looks looks = read_looks(reader, reading);
    const Field field = read_field(reader);
    reader.finish();
    if (mistakes.any()) return;
    MoundBuilder builder(looks, object);
    for (std::uint64_t row = 0; row < field.rows; ++row)
        for (std::uint64_t column = 0; column < field.mounds_in(row); ++column)
            builder.add(mound(field, column, row));
    objects.push_back(std::move(object));
}

} // namespace linkdig::database
