#include "database/compiler/primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace linkdig::database {

void Shape::add_points(const std::vector<Vec3d>& corners, std::uint32_t side) {
    std::vector<std::uint32_t> indices;
    for (const Vec3d& corner : corners) {
        indices.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(corner);
    }
    add(std::move(indices), side);
}

void Shape::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t side) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t each : {a, b, c, d})
        if (corners.empty() || as_float(points[each]) != as_float(points[corners.back()]))
            corners.push_back(each);
    while (corners.size() > 1 && as_float(points[corners.front()]) == as_float(points[corners.back()]))
        corners.pop_back();
    if (corners.size() < 3) return;
    std::vector<Vec4d> positions;
    for (const std::uint32_t each : corners)
        positions.push_back(as_float(points[each]));
    if (corners.size() == 3 || examine(positions).fault != PolygonFault::not_planar) {
        if (examine(positions).fault != PolygonFault::zero_area) add(std::move(corners), side);
    } else if (glm::distance(points[a], points[c]) <= glm::distance(points[b], points[d])) {
        add({a, b, c}, side);
        add({a, c, d}, side);
    } else {
        add({b, c, d}, side);
        add({b, d, a}, side);
    }
}

namespace {

struct Kind {
    const char* key;
    Shape (*shape)(TableReader& reader);
    std::vector<std::string> sides; ///< that `omit` and `colours` may name
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"box", box_shape, box_sides()}, {"prism", prism_shape, prism_sides()},
        {"loft", loft_shape, {}},        {"rectangle", rectangle_shape, {}},
        {"disc", disc_shape, {}},        {"ring", ring_shape, {}},
        {"stripe", stripe_shape, {}},    {"path", path_shape, {}},
        {"numeral", numeral_shape, {}},
    };
    return all;
}

/// Singer's repeating pattern (US 4,213,252): copies at equal steps.
struct Repeat {
    std::int64_t count = 1;
    Vec3d step_m{0};
};

class PrimitiveReader {
public:
    PrimitiveReader(const toml::table& table, const Kind& kind, const TableReader& object_reader,
                    std::uint16_t file, const Reading& reading)
        : kind_(kind), reading_(reading), at_(place_of(table, file)),
          reader_(table, object_reader.file(),
                  fmt::format("[[object.{}]] of {}", kind.key, object_reader.what()), *reading.diagnostics),
          styles_(std::max<std::size_t>(1, kind.sides.size())), omitted_(styles_.size(), false) {}

    void read(const FaceStyle& inherited, ModelObject& object) {
        const bool sided = !kind_.sides.empty();
        reader_.describe("omit",
                         sided ? fmt::format("array of sides: \"{}\"", fmt::join(kind_.sides, "\", \""))
                               : "nothing: it has no sides",
                         "none");
        reader_.describe("colours",
                         sided ? "table of sides, each the name of a [[colour]]" : "nothing: it has no sides",
                         "none");
        reader_.describe("repeat", "table", "one copy");
        const std::size_t errors_before = reading_.diagnostics->all().size();
        std::fill(styles_.begin(), styles_.end(), read_style(reader_, reading_, inherited));
        read_omitted();
        read_colours();
        const Repeat repeat = read_repeat();
        const Shape shape = kind_.shape(reader_);
        reader_.finish();
        const std::size_t copies = static_cast<std::size_t>(repeat.count);
        if (shape.polygons.size() * copies > most_primitive_faces)
            reading_.error(at_, fmt::format("{} makes {} faces; expected at most {}", reader_.what(),
                                            shape.polygons.size() * copies, most_primitive_faces));
        if (reading_.diagnostics->all().size() != errors_before || !check_colours(shape)) return;
        for (std::size_t i = 0; i < copies; ++i)
            add(shape, static_cast<double>(i) * repeat.step_m, object);
    }

private:
    std::optional<std::size_t> side_named(std::string_view key, const std::string& name) {
        for (std::size_t i = 0; i < kind_.sides.size(); ++i)
            if (kind_.sides[i] == name) return i;
        reader_.error_at(key, kind_.sides.empty()
                                  ? fmt::format("a {} has no sides to name in \"{}\"", kind_.key, key)
                                  : fmt::format("a {} has no side \"{}\"; expected one of \"{}\"", kind_.key,
                                                name, fmt::join(kind_.sides, "\", \"")));
        return std::nullopt;
    }

    void read_omitted() {
        for (const std::string& name : reader_.texts("omit"))
            if (const auto side = side_named("omit", name)) omitted_[*side] = true;
    }

    void read_colours() {
        const toml::table* table = reader_.table("colours");
        if (table == nullptr) return;
        TableReader colours(*table, reader_.file(), "colours of " + reader_.what(), *reading_.diagnostics);
        for (auto&& [name, node] : *table) {
            const auto side = side_named("colours", std::string(name.str()));
            const auto colour = named(colours, name.str(), reading_.registry->colour_names, true);
            if (side) styles_[*side].colour = static_cast<std::uint16_t>(colour.value_or(0));
        }
    }

    Repeat read_repeat() {
        Repeat repeat;
        const toml::table* table = reader_.table("repeat");
        if (table == nullptr) return repeat;
        TableReader reader(*table, reader_.file(), "repeat of " + reader_.what(), *reading_.diagnostics);
        repeat.count = reader.integer("count", 1, most_copies);
        repeat.step_m = reader.point_m("step");
        if (repeat.count > 1 && glm::length(repeat.step_m) == 0)
            reader.error_at("step_m", "the copies stand in one place; expected a step");
        reader.finish();
        return repeat;
    }

    bool check_colours(const Shape& shape) {
        for (const Shape::Polygon& polygon : shape.polygons) {
            if (omitted_[polygon.side] || styles_[polygon.side].colour) continue;
            reading_.error(at_, fmt::format("{} has no colour; expected `colour` here or in the object",
                                            reader_.what()));
            return false;
        }
        return true;
    }

    void add(const Shape& shape, const Vec3d& offset, ModelObject& object) const {
        const auto first = static_cast<std::uint32_t>(object.vertices.size());
        for (const Vec3d& point : shape.points)
            object.vertices.push_back({as_float(point + offset), {}, {}, at_});
        for (const Shape::Polygon& polygon : shape.polygons) {
            if (omitted_[polygon.side]) continue;
            ModelFace face;
            face.corners = polygon.corners;
            for (std::uint32_t& corner : face.corners)
                corner += first;
            face.style = styles_[polygon.side];
            face.at = at_;
            object.faces.push_back(std::move(face));
        }
    }

    const Kind& kind_;
    Reading reading_;
    Place at_;
    TableReader reader_;
    std::vector<FaceStyle> styles_; ///< by side
    std::vector<bool> omitted_;
};

} // namespace

void read_primitives(TableReader& object_reader, std::uint16_t file, const Reading& reading,
                     const FaceStyle& inherited, ModelObject& object) {
    for (const Kind& kind : kinds())
        for (const toml::table* table : object_reader.tables(kind.key))
            PrimitiveReader(*table, kind, object_reader, file, reading).read(inherited, object);
    std::stable_sort(object.faces.begin(), object.faces.end(), [](const ModelFace& a, const ModelFace& b) {
        return std::tie(a.at.line, a.at.column) < std::tie(b.at.line, b.at.column);
    });
}

} // namespace linkdig::database
