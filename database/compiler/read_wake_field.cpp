/// Water with the wakes of a specification on it: flat smooth squares whose normals are those of the field.

#include "database/compiler/model_object.h"
#include "database/compiler/primitives.h"
#include "database/compiler/square_grid.h"
#include "database/compiler/wake_spec.h"
#include "database/model/mathematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace linkdig::database {

namespace {

constexpr std::int64_t most_squares = 512; // a side

/// Towards the rim of the field waves sink over this part of its side, so that none ends at a wall. Chosen by eye.
constexpr double rim = 0.08;

struct Patch {
    Vec3d corner_m{0};
    std::uint32_t squares = 128;
    double steepness_rad = 0.0;
    WakeSpec spec;
};

/// Mean of the cells whose middles lie within half a square of a point; beyond the field the water is still.
double height_at(const WaveField& field, double column, double row, double reach) {
    const auto from = [](double middle, double by) {
        return static_cast<std::int64_t>(std::ceil(middle - by - 0.5));
    };
    const auto to = [](double middle, double by) {
        return static_cast<std::int64_t>(std::floor(middle + by - 0.5));
    };
    const auto size = static_cast<std::int64_t>(field.size);
    double sum = 0.0;
    double count = 0.0;
    for (std::int64_t j = from(row, reach); j <= to(row, reach); ++j) {
        for (std::int64_t i = from(column, reach); i <= to(column, reach); ++i) {
            count += 1.0;
            if (i >= 0 && j >= 0 && i < size && j < size)
                sum += static_cast<double>(field.heights[static_cast<std::size_t>(j * size + i)]);
        }
    }
    return count > 0.0 ? sum / count : 0.0;
}

double left_at(std::uint32_t place, std::uint32_t squares) {
    const double from_rim = std::min(place, squares - place) / static_cast<double>(squares);
    return smooth_step(from_rim / rim);
}

/// Slopes at the corners of the squares, row by row, in heights of the field a metre. On the rim there are none: the
/// water there meets what lies around it.
std::vector<Vec2d> slopes_of(const WaveField& field, std::uint32_t squares) {
    const std::uint32_t corners = squares + 1;
    const double cells = static_cast<double>(field.size) / squares;
    const double square_m = cells * field.cell;
    const double reach = std::max(0.5 * cells, 0.5);
    std::vector<double> heights;
    for (std::uint32_t row = 0; row < corners; ++row)
        for (std::uint32_t column = 0; column < corners; ++column)
            heights.push_back(height_at(field, column * cells, row * cells, reach));
    std::vector<Vec2d> slopes(heights.size(), Vec2d(0.0));
    for (std::uint32_t row = 1; row < squares; ++row) {
        for (std::uint32_t column = 1; column < squares; ++column) {
            const std::size_t at = std::size_t{row} * corners + column;
            const Vec2d rise(heights[at + 1] - heights[at - 1],
                             heights[at + corners] - heights[at - corners]);
            slopes[at] = left_at(column, squares) * left_at(row, squares) / (2.0 * square_m) * rise;
        }
    }
    return slopes;
}

double rms_slope(const std::vector<Vec2d>& slopes) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Vec2d& slope : slopes) {
        if (slope == Vec2d(0.0)) continue; // still water says nothing about how steep the waves are
        sum += glm::dot(slope, slope);
        ++count;
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

void add_water(const Patch& patch, const FaceStyle& style, ModelObject& object) {
    const WaveField field = wake_field(patch.spec).kelvin.field;
    const std::vector<Vec2d> slopes = slopes_of(field, patch.squares);
    const double rms = rms_slope(slopes);
    const double scale = rms > 0.0 ? tangent(patch.steepness_rad) / rms : 0.0;
    const double square_m = patch.spec.wakes.side / patch.squares;
    const std::uint32_t corners = patch.squares + 1;
    for (std::uint32_t row = 0; row < corners; ++row) {
        for (std::uint32_t column = 0; column < corners; ++column) {
            const Vec2d slope = scale * slopes[std::size_t{row} * corners + column];
            const Vec3d at = patch.corner_m + Vec3d(column * square_m, row * square_m, 0.0);
            object.vertices.push_back(
                {as_float(at), glm::normalize(Vec3d(-slope.x, -slope.y, 1.0)), {}, object.at});
        }
    }
    add_squares(patch.squares, patch.squares, object,
                [&](ModelFace& face, std::uint32_t) { face.style = style; });
}

/// The specification's own mistakes are told with its lines.
std::optional<WakeSpec> read_spec(TableReader& reader, std::vector<std::string>& tried) {
    const std::string name = reader.text("spec");
    if (name.empty()) return std::nullopt;
    tried.push_back(reader.beside(name));
    return read_wake_spec(tried.back(), reader.diagnostics());
}

} // namespace

void read_wake_field(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects,
                     std::vector<std::string>& tried) {
    TableReader reader = reader_of(table, *reading.sources, "wake_field", *reading.diagnostics);
    const Mistakes mistakes(reader);
    ModelObject object = begin_object(reader, table, reading);
    FaceStyle inherited;
    inherited.shading = Shading::vertex;
    const FaceStyle style = read_style(reader, reading, inherited);
    if (!style.colour) reader.text("colour"); // reports the missing key
    Patch patch;
    patch.corner_m = reader.point_m("corner");
    patch.squares = static_cast<std::uint32_t>(reader.integer("squares", 128, 4, most_squares));
    patch.steepness_rad = reader.angle_rad("steepness", 8.0, {0.0, 60.0});
    const std::optional<WakeSpec> spec = read_spec(reader, tried);
    reader.finish();
    if (mistakes.any() || !spec) return;
    patch.spec = *spec;
    add_water(patch, style, object);
    objects.push_back(std::move(object));
}

} // namespace linkdig::database
