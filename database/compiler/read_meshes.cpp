#include "database/compiler/read_meshes.h"

#include "database/mesh/read_mesh.h"
#include "database/model/mathematics.h"
#include "database/model/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace linkdig::database {

namespace {

struct Unit {
    const char* name;
    double metres;
};
constexpr std::array<Unit, 5> units{
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"ft", metres_per_foot}, {"in", metres_per_foot / 12.0}}};

class MeshTableReader {
public:
    MeshTableReader(AuthoredTable table, const Reading& reading)
        : reading_(reading), at_(place_of(*table.table, table.file)),
          reader_(reader_of(table, *reading.sources, "mesh", *reading.diagnostics)) {}

    void read(std::vector<ModelObject>& objects, MeshFiles& files) {
        const std::size_t errors_before = reading_.diagnostics->all().size();
        describe();
        statistics_.name = reader_.text("name");
        const std::string path = path_of(reader_.text("file"));
        read_membership(reader_, reading_, false, pattern_);
        read_alternative(reader_, pattern_);
        style_ = read_style(reader_, reading_, {});
        read_placement();
        if (!path.empty()) files.tried.push_back(path);
        const std::optional<Mesh> mesh = path.empty() ? std::nullopt : opened(path);
        if (mesh) {
            read_colours(*mesh);
            read_names(*mesh);
        }
        reader_.finish();
        if (!mesh || reading_.diagnostics->all().size() != errors_before) return;
        add(*mesh, objects);
        files.statistics.push_back(statistics_);
    }

private:
    /// What is read only where a file can be opened, and what excludes each other, is known all the same.
    void describe() {
        std::string names;
        for (const Unit& unit : units)
            names += fmt::format("{}\"{}\"", names.empty() ? "" : " or ", unit.name);
        reader_.describe("unit", names, "none; it or `metres_per_unit` is required");
        reader_.describe("metres_per_unit", "number, 1e-06 to 1e+06", "none; it or `unit` is required");
        reader_.describe("colours", "table of material names, each the name of a [[colour]]",
                         "the colour of the material's name");
        reader_.describe("objects", "table of node names, each an object's name", "none");
        reader_.describe("two_sided", "true or false", "the materials'");
        reader_.describe("opacity", "number, 0.00390625 to 1", "the materials', where a glTF blends them");
    }

    /// Relative to the file that names it.
    std::string path_of(const std::string& name) {
        if (name.empty()) return {};
        if (std::filesystem::path(name).is_absolute()) {
            reader_.error_at("file", fmt::format("cannot read the mesh \"{}\"; expected a path relative to "
                                                 "this file",
                                                 name));
            return {};
        }
        return reader_.beside(name);
    }

    std::optional<Mesh> opened(const std::string& path) {
        MeshResult result = read_mesh(path);
        if (!result.mesh)
            reader_.error_at("file",
                             fmt::format("cannot read the mesh \"{}\": {}; expected a glTF or OBJ file "
                                         "with faces",
                                         path, result.error));
        return std::move(result.mesh);
    }

    void read_placement() {
        read_unit();
        // In glTF's axes y is up, z forward and x to port; the shift of coordinates is a turn, not a mirror.
        if (reader_.choice("up", 0, {"y", "z"}) == 0)
            placement_.turn = Mat3d(Vec3d(0, 1, 0), Vec3d(0, 0, 1), Vec3d(1, 0, 0));
        const double heading = reader_.angle_rad("heading", 0.0);
        const double c = cosine(heading);
        const double s = sine(heading);
        if (heading != 0)
            placement_.turn = Mat3d(Vec3d(c, s, 0), Vec3d(-s, c, 0), Vec3d(0, 0, 1)) * placement_.turn;
        placement_.position_m = reader_.point_m("position", Vec3d(0.0));
    }

    void read_unit() {
        if (reader_.has("metres_per_unit")) {
            placement_.metres_per_unit = reader_.number("metres_per_unit", Range{1e-6, 1e6});
            if (reader_.node("unit") != nullptr)
                reader_.error_at("unit", fmt::format("both \"unit\" and \"metres_per_unit\" stand in {}; "
                                                     "expected one of them",
                                                     reader_.what()));
            return;
        }
        reader_.node("metres_per_unit");
        if (!reader_.has("unit")) {
            reader_.node("unit");
            reader_.error_at("unit", fmt::format("{} lacks the key \"unit\" or \"metres_per_unit\": a mesh "
                                                 "file does not say how long its unit is",
                                                 reader_.what()));
            return;
        }
        std::vector<std::string> names;
        for (const Unit& unit : units)
            names.emplace_back(unit.name);
        placement_.metres_per_unit = units[reader_.choice("unit", 0, names)].metres;
    }

    /// The file's name for something, as a key of the table: an unknown one is reported.
    bool known(const char* key, TableReader& table, std::string_view name, const std::set<std::string>& names,
               const char* kind) {
        if (names.count(std::string(name)) != 0) return true;
        const std::vector<std::string> all(names.begin(), names.end());
        const std::string closest = suggestion(name, all);
        table.error_at(name, fmt::format("\"{}\" names no {} of the mesh; {}", name, kind,
                                         closest.empty() ? fmt::format("expected in \"{}\" one of: {}", key,
                                                                       fmt::join(all, ", "))
                                                         : fmt::format("did you mean {}?", closest)));
        return false;
    }

    /// A style for each material in use: by `colours`, else by the colour of that name, else the table's own.
    void read_colours(const Mesh& mesh) {
        std::set<std::string> names;
        std::vector<bool> used(mesh.materials.size(), false);
        for (const MeshNode& node : mesh.nodes)
            for (const MeshFace& face : node.faces)
                used[face.material] = true;
        for (std::size_t i = 0; i < used.size(); ++i)
            if (used[i]) names.insert(mesh.materials[i].name);
        std::map<std::string, std::uint16_t> authored;
        if (const toml::table* table = reader_.table("colours")) {
            TableReader colours(*table, reader_.file(), "colours of " + reader_.what(),
                                *reading_.diagnostics);
            for (auto&& [name, node] : *table) {
                const auto colour = named(colours, name.str(), reading_.registry->colour_names, true);
                if (known("colours", colours, name.str(), names, "material"))
                    authored[std::string(name.str())] = static_cast<std::uint16_t>(colour.value_or(0));
            }
        }
        styles_.resize(mesh.materials.size());
        for (std::size_t i = 0; i < used.size(); ++i)
            if (used[i]) styles_[i] = style_of(mesh.materials[i], authored);
    }

    FaceStyle style_of(const MeshMaterial& material, const std::map<std::string, std::uint16_t>& authored) {
        FaceStyle style = style_;
        style.two_sided = reader_.has("two_sided") ? style_.two_sided : material.two_sided;
        if (!reader_.has("opacity"))
            style.opacity =
                static_cast<std::uint16_t>(std::max(1.0, std::floor(material.opacity * 256.0 + 0.5)));
        if (const auto found = authored.find(material.name); found != authored.end()) {
            style.colour = found->second;
        } else if (const auto same = reading_.registry->colour_names.find(material.name)) {
            style.colour = static_cast<std::uint16_t>(*same);
        } else if (!style.colour && told_.insert(material.name).second) {
            reader_.error_at("colours", fmt::format("the material \"{}\" of {} has no colour; expected it in "
                                                    "`colours`, a colour code of that name, or `colour`",
                                                    material.name, reader_.what()));
        }
        return style;
    }

    void read_names(const Mesh& mesh) {
        const toml::table* table = reader_.table("objects");
        if (table == nullptr) return;
        std::set<std::string> names;
        for (const MeshNode& node : mesh.nodes)
            names.insert(node.name);
        TableReader objects(*table, reader_.file(), "objects of " + reader_.what(), *reading_.diagnostics);
        for (auto&& [name, node] : *table) {
            const std::string object = objects.text(name.str());
            if (known("objects", objects, name.str(), names, "node"))
                names_[std::string(name.str())] = object;
        }
    }

    /// Nodes that are given one name make one object; nodes of one name in the file do not.
    void add(const Mesh& mesh, std::vector<ModelObject>& objects) {
        std::map<std::string, std::size_t> authored; // object by its authored name
        std::map<std::string, std::uint32_t> count;
        for (const MeshNode& node : mesh.nodes) {
            const auto renamed = names_.find(node.name);
            std::string name = statistics_.name;
            if (renamed != names_.end())
                name = renamed->second;
            else if (mesh.nodes.size() > 1)
                name += "." + (node.name.empty() ? "node" : node.name);
            if (renamed == names_.end() && ++count[name] > 1) name += fmt::format(".{}", count[name]);
            std::size_t index = objects.size();
            if (renamed != names_.end()) index = authored.emplace(name, index).first->second;
            if (index == objects.size()) {
                objects.push_back(pattern_);
                objects.back().name = name;
                objects.back().at = at_;
                objects.back().of_mesh = true;
                ++statistics_.objects;
            }
            add_node(node, placement_, at_, styles_, objects[index], statistics_);
        }
        if (statistics_.faces == 0)
            reading_.error(at_,
                           fmt::format("no face of {} has an area; expected a larger mesh, or another unit",
                                       reader_.what()));
    }

    Reading reading_;
    Place at_;
    TableReader reader_;
    ModelObject pattern_; ///< what the table says of every object
    FaceStyle style_;
    MeshPlacement placement_;
    std::vector<FaceStyle> styles_; ///< by material
    std::map<std::string, std::string> names_;
    std::set<std::string> told_;
    MeshStatistics statistics_;
};

} // namespace

void read_mesh_objects(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects,
                       MeshFiles& files) {
    MeshTableReader(table, reading).read(objects, files);
}

} // namespace linkdig::database
