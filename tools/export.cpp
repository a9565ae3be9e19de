/// linkdig export: a database as glTF, for Blender and whatever else reads it.

#include "database/mesh/mesh_of_database.h"
#include "database/mesh/write_mesh.h"
#include "tools/flight/open_database.h"
#include "tools/flight/output_name.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace linkdig::tools {

namespace {

struct ExportOptions {
    std::string database;
    std::string output;
};

int export_database(const ExportOptions& options) {
    require_ending(options.output, "a glTF file", {".gltf", ".glb"});
    const OpenedDatabase opened = open_database(options.database);
    const database::DatabaseMesh made = database::mesh_of(opened.database);
    database::write_mesh(made.mesh, options.output);
    fmt::print("{}: {} faces, {} nodes, {} materials", options.output, made.faces, made.mesh.nodes.size(),
               made.mesh.materials.size());
    if (made.at_infinity != 0) fmt::print("; {} faces at infinity left out", made.at_infinity);
    if (made.tiles != 0) fmt::print("; {} repeated tiles left out", made.tiles);
    fmt::print("\n");
    return ExitCode::done;
}

} // namespace

void add_export(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = app.add_subcommand("export", "Write a visual database as glTF");
    command->add_option("database", options->database, "Visual database (.igdb, or .toml to compile)")
        ->required();
    command->add_option("-o,--output", options->output, "glTF file to write (.gltf or .glb)")->required();
    command->footer(
        "Clusters, object lists and objects become nodes, colour codes materials. Metres; glTF's y is up.\n"
        "A .gltf has its numbers in a .bin file beside it; a .glb is one file.\n"
        "Example:\n  linkdig export first_flight.igdb -o first_flight.glb");
    command->callback([options, &exit_code] { exit_code = export_database(*options); });
}

} // namespace linkdig::tools
