/// Patchworks: fields on flat ground, so that speed and height are seen over it.

#include "database/compiler/model_object.h"
#include "database/compiler/primitives.h"
#include "database/compiler/square_grid.h"
#include "database/model/random.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace linkdig::database {

namespace {

constexpr std::int64_t most_fields_per_side = 200;
/// Beyond a quarter of a side two displaced corners can make a field concave.
constexpr double most_disorder = 0.2;

struct Patchwork {
    Vec3d from_m{0};
    Vec3d to_m{0};
    std::uint64_t columns = 1;
    std::uint64_t rows = 1;
    double disorder = 0.0;
    std::uint64_t seed = 0;
    std::vector<std::uint16_t> colours;
};

/// Corner (column, row) of the fields, displaced, but on the border only along it.
Vec3d corner(const Patchwork& work, std::uint64_t column, std::uint64_t row) {
    const std::uint64_t number = 2 * (row * (work.columns + 1) + column);
    const auto part = [&](std::uint64_t index, std::uint64_t count, std::uint64_t roll) {
        const double shift = index == 0 || index == count ? 0.0 : 2.0 * random_unit(work.seed, roll) - 1.0;
        return (static_cast<double>(index) + work.disorder * shift) / static_cast<double>(count);
    };
    const Vec3d size = work.to_m - work.from_m;
    return work.from_m +
           Vec3d(size.x * part(column, work.columns, number), size.y * part(row, work.rows, number + 1), 0.0);
}

void add_fields(const Patchwork& work, FaceStyle style, ModelObject& object) {
    for (std::uint64_t row = 0; row <= work.rows; ++row)
        for (std::uint64_t column = 0; column <= work.columns; ++column)
            object.vertices.push_back({as_float(corner(work, column, row)), {}, {}, object.at});
    const std::uint64_t colour_seed = random_bits(work.seed, 0); // shares nothing with the corners' numbers
    add_squares(static_cast<std::uint32_t>(work.columns), static_cast<std::uint32_t>(work.rows), object,
                [&](ModelFace& face, std::uint32_t number) {
                    style.colour = work.colours[random_bits(colour_seed, number) % work.colours.size()];
                    face.style = style;
                });
}

std::vector<std::uint16_t> read_colours(TableReader& reader, const Reading& reading) {
    std::vector<std::uint16_t> colours;
    const Mistakes mistakes(reader);
    reader.describe("colours", "array of names of [[colour]]s", {});
    for (const std::string& name : reader.texts("colours")) {
        const auto colour = reading.registry->colour_names.find(name);
        if (!colour) reader.error_at("colours", reading.registry->colour_names.unknown(name));
        colours.push_back(static_cast<std::uint16_t>(colour.value_or(0)));
    }
    if (colours.empty() && !mistakes.any())
        reader.error_at("colours",
                        fmt::format("{} has no colours; expected at least one name", reader.what()));
    return colours;
}

Patchwork read_extent(TableReader& reader) {
    const Mistakes mistakes(reader);
    Patchwork work;
    work.from_m = reader.point_m("from");
    work.to_m = reader.point_m("to");
    work.columns = static_cast<std::uint64_t>(reader.integer("columns", 1, most_fields_per_side));
    work.rows = static_cast<std::uint64_t>(reader.integer("rows", 1, most_fields_per_side));
    work.disorder = reader.number("disorder", 0.15, {0.0, most_disorder});
    work.seed =
        static_cast<std::uint64_t>(reader.integer("seed", 0, std::numeric_limits<std::int64_t>::max()));
    const Vec3d size = work.to_m - work.from_m;
    if (!mistakes.any() && (!(size.x >= 1.0 && size.y >= 1.0) || size.z != 0.0))
        reader.error_at(
            "to_m", "the patchwork has no area; expected \"to_m\" beyond \"from_m\" by a metre or more in x "
                    "and y, at the same height");
    return work;
}

} // namespace

void read_patchwork(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects) {
    TableReader reader = reader_of(table, *reading.sources, "patchwork", *reading.diagnostics);
    const Mistakes mistakes(reader);
    ModelObject object = begin_object(reader, table, reading);
    const FaceStyle style = read_style(reader, reading, {});
    Patchwork work = read_extent(reader);
    work.colours = read_colours(reader, reading);
    reader.finish();
    if (mistakes.any()) return;
    add_fields(work, style, object);
    objects.push_back(std::move(object));
}

} // namespace linkdig::database
