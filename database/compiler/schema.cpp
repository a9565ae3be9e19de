#include "database/compiler/schema.h"

#include "database/compiler/model_object.h"
#include "database/compiler/priority_planes.h"
#include "database/compiler/read_tiles.h"
#include "database/compiler/sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace linkdig::database {
namespace {

/// One table of each kind, and one for each way that a reader may take.
constexpr std::string_view one_of_each = R"(
[database]
[[colour]]
name = "c"
rgb = [1, 2, 3]
[[sun]]
name = "s"
[[moving_object]]
name = "m"
[[slot]]
name = "slot"
alternatives = 2
[[cluster]]
name = "k"
priority = 1
[[cluster_plane]]
cluster = "k"
[[group_plane]]
priority = 1
[[detail]]
name = "d"
cluster = "k"
to_m = [1]
[[object_list]]
name = "l"
cluster = "k"
sun = "s"
[[object_list]]
name = "t"
cluster = "k"
sun = "s"
[[object]]
name = "o"
list = "l"
[[object.face]]
[[object.box]]
repeat = { count = 2 }
[[object.prism]]
[[object.loft]]
[[object.rectangle]]
[[object.disc]]
[[object.ring]]
[[object.stripe]]
[[object.path]]
[[object.numeral]]
[[object.light]]
[[object.light_string]]
[[mesh]]
name = "n"
[[sequence]]
name = "q"
list = "l"
slot = "slot"
[[sequence.key]]
[[churn]]
[[mounds]]
outline_colour = "c"
[[patchwork]]
[[wake_field]]
[[tile]]
list = "t"
pattern = "random"
[[tile]]
pattern = "sine"
[[tile]]
pattern = "two_waves"
[[tile]]
pattern = "levels"
)";

/// Their keys are names that the author gives.
bool has_free_keys(const TableUse& use) {
    constexpr std::array kinds{"colours of ", "normals of ", "vertices_m of ", "directions of ",
                               "objects of "};
    return std::ranges::any_of(kinds, [&](const char* kind) { return use.table.starts_with(kind); });
}

} // namespace

std::vector<TableUse> schema() {
    KeyLog log;
    Diagnostics diagnostics; // full of what the tables above lack
    diagnostics.note_keys(&log);
    Sources sources;
    sources.files.push_back({.path = {}, .name = {}, .root = toml::parse(one_of_each)});
    const AuthoredTables tables = gather_tables(sources, diagnostics);
    const Registry registry = read_registry(tables, sources, diagnostics);
    const Reading reading{&sources, &registry, &diagnostics};
    MeshFiles meshes;
    const std::vector<ModelObject> objects = read_objects(tables, reading, meshes);
    read_priority_planes(tables, reading);
    read_tiles(tables, objects, reading);
    std::vector<TableUse> uses = log.tables();
    std::erase_if(uses, has_free_keys);
    return uses;
}

std::string schema_markdown() {
    std::string text = "# Reference of the authoring language\n\n"
                       "Every table and key that the compiler reads, printed by `linkdig compile --schema` "
                       "from what its readers ask for;\n"
                       "[authoring.md](authoring.md) says what they mean. A key without a default is "
                       "required. Lengths are metres, and angles\n"
                       "degrees; where a second key stands beside a value, one of the two may be written.\n";
    for (const TableUse& table : schema()) {
        const bool bracketed = table.table.find('[') != std::string::npos;
        text += fmt::format("\n## {}\n\n| key | value | default |\n| --- | --- | --- |\n",
                            bracketed ? "`" + table.table + "`" : table.table);
        for (const KeyUse& use : table.keys)
            text += fmt::format("| `{}` | {} | {} |\n", use.key, use.value, use.fallback.value_or(""));
    }
    return text;
}

} // namespace linkdig::database
