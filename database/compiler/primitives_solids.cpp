/// Box, prism and loft.

#include "database/compiler/primitives.h"
#include "database/model/units.h"
#include "database/text/value_reading.h"

#include <fmt/format.h>

#include <map>
#include <tuple>

namespace linkdig::database {

const std::vector<std::string>& box_sides() {
    static const std::vector<std::string> names{"bow", "stern", "port", "starboard", "top", "bottom"};
    return names;
}

const std::vector<std::string>& prism_sides() {
    static const std::vector<std::string> names{"top", "bottom", "sides"};
    return names;
}

Shape box_shape(TableReader& reader) {
    const Mistakes mistakes(reader);
    const Vec3d from = reader.point_m("from");
    const Vec3d to = reader.point_m("to");
    if (mistakes.any()) return {};
    const Vec3d low = glm::min(from, to);
    const Vec3d high = glm::max(from, to);
    for (int i = 0; i < 3; ++i) {
        if (high[i] - low[i] >= plane_tolerance_m) continue;
        reader.error_at("to_m", fmt::format("{} has no extent in {}; expected at least {} m", reader.what(),
                                            "xyz"[i], plane_tolerance_m));
        return {};
    }
    Shape shape;
    for (const double z : {low.z, high.z})
        for (const double y : {low.y, high.y})
            for (const double x : {low.x, high.x})
                shape.points.emplace_back(x, y, z);
    // Point numbers: +1 is x, +2 is y, +4 is z.
    shape.add({1, 3, 7, 5}, 0);
    shape.add({2, 0, 4, 6}, 1);
    shape.add({3, 2, 6, 7}, 2);
    shape.add({0, 1, 5, 4}, 3);
    shape.add({4, 5, 7, 6}, 4);
    shape.add({2, 3, 1, 0}, 5);
    return shape;
}

Shape prism_shape(TableReader& reader) {
    const Mistakes mistakes(reader);
    const std::vector<Vec2d> base = reader.points2_m("base");
    const double bottom = reader.length_m("bottom");
    const double top = reader.length_m("top");
    reader.describe("top_base_m", "array of [x, y]; or `top_base_ft`", "`base_m`");
    const bool tapered = reader.has("top_base_m") || reader.has("top_base_ft");
    const std::vector<Vec2d> top_base = tapered ? reader.points2_m("top_base") : base;
    if (mistakes.any()) return {};
    if (base.size() < 3 || base.size() > most_corners) {
        reader.error_at("base_m",
                        fmt::format("the base has {} corners; expected 3 to {}", base.size(), most_corners));
        return {};
    }
    if (top_base.size() != base.size()) {
        reader.error_at("top_base_m",
                        fmt::format("the top has {} corners and the base {}; expected equal numbers",
                                    top_base.size(), base.size()));
        return {};
    }
    if (top - bottom < plane_tolerance_m) {
        reader.error_at("top_m", "the top is not above the bottom; expected top_m > bottom_m");
        return {};
    }
    double area = 0;
    for (std::size_t i = 1; i + 1 < base.size(); ++i) {
        const Vec2d a = base[i] - base[0];
        const Vec2d b = base[i + 1] - base[0];
        area += a.x * b.y - a.y * b.x;
    }
    if (area <= 0) {
        reader.error_at("base_m", "the base runs clockwise; expected counter-clockwise seen from above");
        return {};
    }
    Shape shape;
    const auto n = static_cast<std::uint32_t>(base.size());
    for (const Vec2d& p : base)
        shape.points.emplace_back(p.x, p.y, bottom);
    for (const Vec2d& p : top_base)
        shape.points.emplace_back(p.x, p.y, top);
    std::vector<std::uint32_t> upper, lower;
    for (std::uint32_t i = 0; i < n; ++i) {
        upper.push_back(n + i);
        lower.push_back(n - 1 - i);
    }
    shape.add(std::move(upper), 0);
    shape.add(std::move(lower), 1);
    for (std::uint32_t i = 0; i < n; ++i)
        shape.add_quad(i, (i + 1) % n, n + (i + 1) % n, n + i, 2);
    return shape;
}

namespace {

/// One vertex per place, so that normals average across seams.
class SharedPoints {
public:
    explicit SharedPoints(Shape& shape) : shape_(&shape) {}
    std::uint32_t add(const Vec3d& point) {
        const Vec4d key = as_float(point);
        const auto [found, is_new] = index_.emplace(std::make_tuple(key.x, key.y, key.z),
                                                    static_cast<std::uint32_t>(shape_->points.size()));
        if (is_new) shape_->points.push_back(point);
        return found->second;
    }

private:
    Shape* shape_;
    std::map<std::tuple<double, double, double>, std::uint32_t> index_;
};

/// One section of a loft: an array of [x, y, z].
std::vector<Vec3d> read_section(TableReader& reader, const toml::node& node, double unit) {
    std::vector<Vec3d> points;
    const toml::array* array = node.as_array();
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
        const std::optional<Vec3d> point = point_of_node(*array->get(i));
        if (!point) {
            reader.diagnostics().error(
                location_of(*array->get(i), reader.file()),
                "a section holds something else; expected [x, y, z], three finite numbers");
            return {};
        }
        points.push_back(*point * unit);
    }
    if (points.size() < 2)
        reader.diagnostics().error(
            location_of(node, reader.file()),
            fmt::format("the section has {} points; expected at least 2", points.size()));
    return points;
}

std::vector<std::vector<Vec3d>> read_sections(TableReader& reader) {
    const bool feet = reader.has("sections_ft") && !reader.has("sections_m");
    reader.describe("sections_m", "array of arrays of [x, y, z]; or `sections_ft`", {});
    const toml::node* node = reader.node(feet ? "sections_ft" : "sections_m");
    const toml::array* array = node == nullptr ? nullptr : node->as_array();
    if (array == nullptr || array->size() < 2) {
        reader.error_at(
            feet ? "sections_ft" : "sections_m",
            fmt::format("{} needs \"sections_m\" or \"sections_ft\"; expected an array of at least two "
                        "arrays of [x, y, z]",
                        reader.what()));
        return {};
    }
    std::vector<std::vector<Vec3d>> sections;
    for (const toml::node& each : *array) {
        sections.push_back(read_section(reader, each, feet ? metres_per_foot : 1.0));
        if (sections.back().size() < 2) return {};
        if (sections.back().size() == sections.front().size()) continue;
        reader.diagnostics().error(
            location_of(each, reader.file()),
            fmt::format("the section has {} points and the first one {}; expected equal numbers",
                        sections.back().size(), sections.front().size()));
        return {};
    }
    return sections;
}

} // namespace

Shape loft_shape(TableReader& reader) {
    const bool flip = reader.boolean("flip", false);
    const std::vector<std::vector<Vec3d>> sections = read_sections(reader);
    Shape shape;
    SharedPoints shared(shape);
    std::vector<std::vector<std::uint32_t>> indices;
    for (const std::vector<Vec3d>& section : sections) {
        indices.emplace_back();
        for (const Vec3d& point : section)
            indices.back().push_back(shared.add(point));
    }
    for (std::size_t s = 0; s + 1 < indices.size(); ++s)
        for (std::size_t p = 0; p + 1 < indices[s].size(); ++p) {
            const std::uint32_t a = indices[s][p], b = indices[s][p + 1];
            const std::uint32_t c = indices[s + 1][p + 1], d = indices[s + 1][p];
            if (flip)
                shape.add_quad(a, d, c, b);
            else
                shape.add_quad(a, b, c, d);
        }
    return shape;
}

} // namespace linkdig::database
