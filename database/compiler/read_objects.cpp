#include "database/compiler/model_object.h"
#include "database/compiler/primitives.h"
#include "database/compiler/read_lights.h"
#include "database/compiler/read_meshes.h"
#include "database/model/mathematics.h"
#include "database/model/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace linkdig::database {

namespace {

/// What makes faces inside an object takes the object's style.
void describe_style(TableReader& reader) {
    if (reader.what().find(" of [[object]]") == std::string::npos) return;
    reader.describe("colour", "name of a [[colour]]", "the object's");
    reader.describe("shading", R"("none" or "face" or "vertex")", "the object's");
    reader.describe("two_sided", "true or false", "the object's");
    reader.describe("layer", "whole number, -10000 to 10000", "the object's");
    reader.describe("opacity", "number, 0.00390625 to 1", "the object's");
}

} // namespace

FaceStyle read_style(TableReader& reader, const Reading& reading, const FaceStyle& inherited) {
    FaceStyle style = inherited;
    describe_style(reader);
    if (const auto colour = named(reader, "colour", reading.registry->colour_names, false))
        style.colour = static_cast<std::uint16_t>(*colour);
    else if (reader.has("colour"))
        style.colour = 0; // reported; one mistake is not told twice
    style.shading = static_cast<Shading>(
        reader.choice("shading", static_cast<std::size_t>(inherited.shading), {"none", "face", "vertex"}));
    style.two_sided = reader.boolean("two_sided", inherited.two_sided);
    style.layer = static_cast<std::int32_t>(reader.integer("layer", inherited.layer, -10000, 10000));
    const double opacity = reader.number("opacity", inherited.opacity / 256.0, {1.0 / 256.0, 1.0});
    style.opacity = static_cast<std::uint16_t>(std::floor(opacity * 256.0 + 0.5));
    return style;
}

bool read_mirror(TableReader& reader) {
    reader.describe("mirror", R"("y")", "none");
    if (!reader.has("mirror")) return false;
    return reader.choice("mirror", 0, {"y"}) == 0;
}

namespace {

/// detail and level.
void read_level(TableReader& reader, const Reading& reading, ModelObject& object) {
    const Registry& registry = *reading.registry;
    const auto detail = named(reader, "detail", registry.details, false);
    reader.describe("level", fmt::format("whole number, 0 to {}; beside `detail`", most_alternatives),
                    "none");
    if (!reader.has("detail")) {
        if (reader.node("level") != nullptr)
            reader.error_at("level", "\"level\" stands without \"detail\"; expected both or neither");
        return;
    }
    object.level = static_cast<std::uint32_t>(reader.integer("level", 0, most_alternatives));
    object.resolved = object.resolved && detail;
    if (!detail) return;
    object.detail = static_cast<std::int32_t>(*detail);
    const AuthoredDetail& named_detail = registry.authored_details[*detail];
    const AuthoredList& list = registry.lists[object.list];
    if (object.resolved && named_detail.resolved && list.list.cluster != named_detail.detail.cluster)
        reader.error_at("detail",
                        fmt::format("the detail \"{}\" belongs to the cluster \"{}\", the object to \"{}\"; "
                                    "expected one cluster",
                                    registry.details.names()[*detail],
                                    registry.cluster_names.names()[named_detail.detail.cluster],
                                    registry.cluster_names.names()[list.list.cluster]));
}

} // namespace

void read_membership(TableReader& reader, const Reading& reading, bool slot_required, ModelObject& object) {
    const auto list = named(reader, "list", reading.registry->list_names, true);
    const auto slot = named(reader, "slot", reading.registry->slots, slot_required);
    object.list = list.value_or(0);
    object.slot = slot ? static_cast<std::int32_t>(*slot) : none;
    object.resolved = list && reading.registry->lists[*list].resolved && (slot || !reader.has("slot"));
    if (slot_required) object.resolved = object.resolved && slot;
    read_level(reader, reading, object);
}

void read_alternative(TableReader& reader, ModelObject& object) {
    reader.describe("alternative", fmt::format("whole number, 0 to {}; beside `slot`", most_alternatives - 1),
                    "none");
    if (reader.has("slot")) {
        object.alternative =
            static_cast<std::uint32_t>(reader.integer("alternative", 0, most_alternatives - 1));
    } else if (reader.node("alternative") != nullptr) {
        reader.error_at("alternative", "\"alternative\" stands without \"slot\"; expected both or neither");
    }
}

ModelObject begin_object(TableReader& reader, const AuthoredTable& table, const Reading& reading) {
    ModelObject object;
    object.name = reader.text("name");
    object.at = place_of(*table.table, table.file);
    read_membership(reader, reading, false, object);
    read_alternative(reader, object);
    return object;
}

namespace {

/// Turns and moves the object from its own axes to those of its list.
void place(ModelObject& object, const Vec3d& at_m, double turned_rad) {
    const SineCosine turn = sine_cosine(turned_rad);
    const auto turned = [&](const Vec3d& v) {
        return Vec3d(turn.cosine * v.x - turn.sine * v.y, turn.sine * v.x + turn.cosine * v.y, v.z);
    };
    for (ModelVertex& vertex : object.vertices) {
        const double w = vertex.position.w;
        vertex.position = as_float(turned(Vec3d(vertex.position)) + w * at_m);
        vertex.position.w = w;
        if (vertex.normal) vertex.normal = turned(*vertex.normal);
    }
    for (ModelLight& light : object.lights) {
        light.point.position = Vec3f(turned(Vec3d(light.point.position)) + at_m);
        for (Vec3f* vector : {&light.point.direction, &light.point.side})
            *vector = Vec3f(turned(Vec3d(*vector)));
    }
}

} // namespace

void add_mirror_image(ModelObject& object) {
    std::vector<std::uint32_t> image(object.vertices.size());
    const std::size_t vertices = object.vertices.size();
    for (std::size_t i = 0; i < vertices; ++i) {
        ModelVertex vertex = object.vertices[i];
        image[i] = static_cast<std::uint32_t>(i);
        if (vertex.position.y == 0) continue;
        vertex.position.y = -vertex.position.y;
        if (vertex.normal) vertex.normal->y = -vertex.normal->y;
        image[i] = static_cast<std::uint32_t>(object.vertices.size());
        object.vertices.push_back(std::move(vertex));
    }
    const std::size_t faces = object.faces.size();
    for (std::size_t i = 0; i < faces; ++i) {
        ModelFace face = object.faces[i];
        for (std::uint32_t& corner : face.corners)
            corner = image[corner];
        std::reverse(face.corners.begin() + 1, face.corners.end()); // the fan starts at the same corner
        face.light_normal.y = -face.light_normal.y;
        object.faces.push_back(std::move(face));
    }
    const std::size_t lights = object.lights.size();
    for (std::size_t i = 0; i < lights; ++i) {
        ModelLight light = object.lights[i];
        if (light.point.position.y == 0.0F) continue; // one that stands on the plane is its own image
        for (Vec3f* vector : {&light.point.position, &light.point.direction, &light.point.side})
            vector->y = -vector->y;
        object.lights.push_back(light);
    }
}

namespace {

class ObjectReader {
public:
    ObjectReader(AuthoredTable table, const Reading& reading)
        : table_(table), reading_(reading),
          reader_(reader_of(table, *reading.sources, "object", *reading.diagnostics)) {}

    ModelObject read() {
        describe_vertices();
        object_ = begin_object(reader_, table_, reading_);
        style_ = read_style(reader_, reading_, {});
        const bool mirrored = read_mirror(reader_);
        read_points("vertices_m", 1.0, false);
        read_points("vertices_ft", metres_per_foot, false);
        read_points("directions", 1.0, true);
        read_normals();
        read_vertex_colours();
        for (const toml::table* face : reader_.tables("face"))
            read_face(*face);
        read_primitives(reader_, table_.file, reading_, style_, object_);
        read_lights(reader_, table_.file, reading_, style_.colour, object_);
        if (object_.faces.empty() && object_.lights.empty() && object_.slot == none && reading_clean())
            reading_.error(object_.at, fmt::format("{} has no faces; expected at least one", reader_.what()));
        if (mirrored) add_mirror_image(object_);
        read_place();
        reader_.finish();
        return std::move(object_);
    }

private:
    /// Faces with mistakes are dropped: then their absence is no second mistake.
    bool reading_clean() const { return reading_.diagnostics->all().size() == errors_before_; }

    void describe_vertices() {
        reader_.describe("vertices_m", "table of vertex names, each [x, y, z]; or `vertices_ft`", "none");
        reader_.describe("directions", "table of vertex names, each [x, y, z]", "none");
        reader_.describe("normals", "table of vertex names, each [x, y, z]",
                         "means of the adjacent faces' normals");
        reader_.describe(
            "colours", "table of vertex names, each the name of a [[colour]] or [red, green, blue], 0 to 255",
            "the faces' colours");
    }

    void read_place() {
        const bool placed = reader_.has("at_m") || reader_.has("at_ft") || reader_.has("turned_deg");
        const Vec3d at_m = reader_.point_m("at", Vec3d(0.0));
        const double turned_rad = reader_.angle_rad("turned", 0.0, {-360, 360});
        if (placed) place(object_, at_m, turned_rad);
    }

    void read_points(const char* key, double unit, bool directions) {
        const toml::table* table = reader_.table(key);
        if (table == nullptr) return;
        TableReader points(*table, reader_.file(), fmt::format("{} of {}", key, reader_.what()),
                           *reading_.diagnostics);
        for (auto&& [name, node] : *table) {
            const Vec3d value = points.vector(name.str()) * unit;
            ModelVertex vertex{as_float(value), {}, std::string(name.str()), place_of(node, table_.file)};
            if (directions) vertex.position = direction_of(value, points, name.str());
            const auto index = static_cast<std::uint32_t>(object_.vertices.size());
            if (!index_.emplace(vertex.name, index).second)
                points.error_at(name.str(), fmt::format("the vertex \"{}\" stands twice in {}", vertex.name,
                                                        reader_.what()));
            object_.vertices.push_back(std::move(vertex));
        }
    }

    static Vec4d direction_of(const Vec3d& value, TableReader& points, std::string_view name) {
        const double length = glm::length(value);
        if (length < 1e-9) {
            points.error_at(name, fmt::format("the direction \"{}\" has no length; expected a vector", name));
            return {1, 0, 0, 0};
        }
        Vec4d result = as_float(value / length);
        result.w = 0;
        return result;
    }

    void read_normals() {
        const toml::table* table = reader_.table("normals");
        if (table == nullptr) return;
        TableReader normals(*table, reader_.file(), "normals of " + reader_.what(), *reading_.diagnostics);
        for (auto&& [name, node] : *table) {
            const Vec3d value = normals.vector(name.str());
            const std::optional<std::uint32_t> vertex =
                vertex_named(std::string(name.str()), place_of(node, table_.file));
            if (glm::length(value) < 1e-9)
                normals.error_at(
                    name.str(),
                    fmt::format("the normal of \"{}\" has no length; expected a vector", name.str()));
            else if (vertex)
                object_.vertices[*vertex].normal = glm::normalize(value);
        }
    }

    /// A colour's name, or three whole numbers.
    void read_vertex_colours() {
        const toml::table* table = reader_.table("colours");
        if (table == nullptr) return;
        TableReader colours(*table, reader_.file(), "colours of " + reader_.what(), *reading_.diagnostics);
        for (auto&& [name, node] : *table) {
            const std::optional<std::uint32_t> vertex =
                vertex_named(std::string(name.str()), place_of(node, table_.file));
            Vec3d colour(0.0);
            if (node.is_array()) {
                colour = read_rgb(colours, name.str());
            } else if (const auto index = named(colours, name.str(), reading_.registry->colour_names, true)) {
                const Colour code = reading_.registry->colours[*index];
                colour = {code.red, code.green, code.blue};
            }
            if (vertex) object_.vertices[*vertex].colour = colour;
        }
    }

    std::optional<std::uint32_t> vertex_named(const std::string& name, Place at) {
        const auto found = index_.find(name);
        if (found != index_.end()) return found->second;
        std::vector<std::string> names;
        for (const auto& [each, index] : index_)
            names.push_back(each);
        const std::string closest = suggestion(name, names);
        reading_.error(at,
                       fmt::format("{} has no vertex \"{}\"; {}", reader_.what(), name,
                                   closest.empty() ? "expected one of vertices_m, vertices_ft or directions"
                                                   : fmt::format("did you mean {}?", closest)));
        return std::nullopt;
    }

    void read_face(const toml::table& table) {
        TableReader reader(table, reader_.file(), "[[object.face]] of " + reader_.what(),
                           *reading_.diagnostics);
        ModelFace face;
        reader.describe("corners", "array of vertex names, three or more", {});
        reader.describe("diagonal", "vertex name, or array of two", "the first corner");
        face.at = place_of(table, table_.file);
        face.style = read_style(reader, reading_, style_);
        bool complete = require_colour(reader, face.style);
        if (!reader.has("corners")) reader.text("corners"); // reports the missing key
        for (const std::string& name : reader.texts("corners")) {
            const auto vertex = vertex_named(name, place_of(*reader.node("corners"), table_.file));
            if (vertex)
                face.corners.push_back(*vertex);
            else
                complete = false;
        }
        complete = check_corners(reader, face) && complete;
        if (complete) complete = start_at_diagonal(reader, face);
        reader.node("diagonal");
        reader.finish();
        if (complete) object_.faces.push_back(std::move(face));
    }

    bool require_colour(TableReader& reader, FaceStyle& style) const {
        if (style.colour) return true;
        reading_.diagnostics->error(
            reader.here(),
            fmt::format("{} has no colour; expected `colour` here or in the object", reader.what()));
        style.colour = 0;
        return false;
    }

    bool check_corners(TableReader& reader, const ModelFace& face) {
        const auto* corners = reader.node("corners");
        const toml::array* array = corners == nullptr ? nullptr : corners->as_array();
        if (array == nullptr) return false;
        if (array->size() < 3 || array->size() > most_corners) {
            reader.error_at("corners", fmt::format("the face has {} corners; expected 3 to {}", array->size(),
                                                   most_corners));
            return false;
        }
        std::vector<std::uint32_t> sorted = face.corners;
        std::sort(sorted.begin(), sorted.end());
        const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
        if (twin == sorted.end()) return true;
        reader.error_at("corners", fmt::format("the corner \"{}\" stands twice; expected distinct corners",
                                               object_.vertices[*twin].name));
        return false;
    }

    /// Turns the corners so that the fan of the machine's triangulation begins at the stored diagonal (Figure
    /// 11).
    bool start_at_diagonal(TableReader& reader, ModelFace& face) {
        const toml::node* diagonal = reader.node("diagonal");
        if (diagonal == nullptr) return true;
        std::vector<std::string> ends;
        if (const auto start = diagonal->value_exact<std::string>())
            ends.push_back(*start);
        else
            ends = reader.texts("diagonal");
        std::vector<std::size_t> positions;
        for (const std::string& name : ends)
            for (std::size_t i = 0; i < face.corners.size(); ++i)
                if (object_.vertices[face.corners[i]].name == name) positions.push_back(i);
        const std::size_t n = face.corners.size();
        const std::size_t apart = positions.size() == 2 ? (positions[1] + n - positions[0]) % n : 2;
        if (positions.size() != ends.size() || ends.empty() || ends.size() > 2 ||
            (ends.size() == 2 && (apart < 2 || apart > n - 2))) {
            reader.error_at("diagonal",
                            "\"diagonal\" names no diagonal of the face; expected two corners that are not "
                            "neighbours, or the corner at which the fan starts");
            return false;
        }
        std::rotate(face.corners.begin(), face.corners.begin() + static_cast<std::ptrdiff_t>(positions[0]),
                    face.corners.end());
        return true;
    }

    AuthoredTable table_;
    Reading reading_;
    std::size_t errors_before_ = reading_.diagnostics->all().size();
    TableReader reader_;
    ModelObject object_;
    FaceStyle style_;
    std::map<std::string, std::uint32_t> index_;
};

} // namespace

std::vector<ModelObject> read_objects(const AuthoredTables& tables, const Reading& reading,
                                      MeshFiles& meshes) {
    std::vector<ModelObject> objects;
    for (const AuthoredTable each : tables.objects)
        objects.push_back(ObjectReader(each, reading).read());
    for (const AuthoredTable each : tables.meshes)
        read_mesh_objects(each, reading, objects, meshes);
    for (const AuthoredTable each : tables.sequences)
        read_sequence(each, reading, objects);
    for (const AuthoredTable each : tables.churns)
        read_churn(each, reading, objects);
    for (const AuthoredTable each : tables.mounds)
        read_mounds(each, reading, objects);
    for (const AuthoredTable each : tables.patchworks)
        read_patchwork(each, reading, objects);
    for (const AuthoredTable each : tables.wake_fields)
        read_wake_field(each, reading, objects, meshes.tried);
    NameTable names("object");
    for (const ModelObject& object : objects)
        names.add(object.name, object.at, *reading.sources, *reading.diagnostics);
    return objects;
}

} // namespace linkdig::database
