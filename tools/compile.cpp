/// linkdig compile: an authoring file becomes a compiled database.

#include "database/compiler/compile.h"
#include "database/compiler/schema.h"
#include "database/format/validate.h"
#include "database/format/write.h"
#include "tools/flight/output_name.h"
#include "tools/subcommands.h"
#include "tools/watch/file_watch.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

namespace linkdig::tools {

namespace {

struct Arguments {
    std::string source;
    std::string output;
    bool json = false;
    bool watch = false;
    bool schema = false;
};

nlohmann::json as_json(const database::ListStatistics& list) {
    return {{"name", list.name},
            {"objects", list.objects},
            {"faces", list.faces},
            {"faces_at_once", list.faces_at_once},
            {"edges", list.edges},
            {"edges_at_once", list.edges_at_once},
            {"edge_budget", list.edge_budget},
            {"vertices", list.vertices},
            {"planes", list.planes},
            {"splits", list.splits},
            {"lights", list.lights},
            {"runs", list.runs}};
}

nlohmann::json as_json(const database::MeshStatistics& mesh) {
    return {{"name", mesh.name},      {"objects", mesh.objects}, {"polygons", mesh.polygons},
            {"faces", mesh.faces},    {"cut", mesh.cut},         {"without_area", mesh.without_area},
            {"doubled", mesh.doubled}};
}

std::string json_text(const database::CompileResult& result) {
    nlohmann::json lists = nlohmann::json::array();
    for (const database::ListStatistics& list : result.statistics.lists)
        lists.push_back(as_json(list));
    nlohmann::json total = as_json(result.statistics.total());
    total["name"] = result.database->name;
    nlohmann::json meshes = nlohmann::json::array();
    for (const database::MeshStatistics& mesh : result.statistics.meshes)
        meshes.push_back(as_json(mesh));
    return nlohmann::json{{"total", total},
                          {"priority_planes", result.statistics.priority_planes},
                          {"lists", lists},
                          {"meshes", meshes}}
        .dump(2);
}

std::string mesh_text(const database::CompileResult& result) {
    std::string text;
    for (const database::MeshStatistics& mesh : result.statistics.meshes)
        text += fmt::format(
            "\nmesh {}: {} polygons, {} faces in {} objects; {} polygons cut into triangles, {} faces "
            "without area and {} doubled ones left out",
            mesh.name, mesh.polygons, mesh.faces, mesh.objects, mesh.cut, mesh.without_area, mesh.doubled);
    return text;
}

std::string budget_text(const database::CompileResult& result) {
    std::string text;
    for (const database::ListStatistics& list : result.statistics.lists)
        if (list.edge_budget != 0)
            text += fmt::format("\nlist {}: {} of {} edges at most at once", list.name, list.edges_at_once,
                                list.edge_budget);
    if (result.statistics.edge_budget != 0)
        text += fmt::format("\ndatabase: {} of {} edges at most at once",
                            result.statistics.total().edges_at_once, result.statistics.edge_budget);
    return text;
}

std::string line_text(const database::CompileResult& result) {
    const database::ListStatistics total = result.statistics.total();
    return fmt::format("{}: {} faces ({} at most at once), {} edges, {} vertices, {} light points, {} "
                       "planes, {} faces cut, in {} lists and "
                       "{} clusters",
                       result.database->name, total.faces, total.faces_at_once, total.edges, total.vertices,
                       total.lights, total.planes + result.statistics.priority_planes, total.splits,
                       result.database->lists.size(), result.database->clusters.size()) +
           mesh_text(result) + budget_text(result);
}

/// Would the output take the place of a file that the database is made of? Then says so.
bool takes_a_source(const Arguments& arguments, const database::CompileResult& result) {
    const bool takes = std::ranges::any_of(
        result.files, [&](const std::string& file) { return same_file(file, arguments.output); });
    if (takes)
        fmt::print(stderr,
                   "linkdig: error: {} is a file that the database is made of; expected another output\n",
                   arguments.output);
    return takes;
}

int compile_once(const Arguments& arguments, const database::CompileResult& result) {
    if (!result.database) {
        fmt::print(stderr, "{}", result.diagnostics.text());
        return bad_input;
    }
    // Bounds of the whole that no single line breaks: a name directory too long, a tree too deep.
    if (const std::string reason = database::validate(*result.database); !reason.empty()) {
        fmt::print(stderr, "{}:0:0: error: the machine would refuse this database: {}\n", arguments.source,
                   reason);
        return bad_input;
    }
    try {
        database::write_database(*result.database, arguments.output);
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "linkdig: error: {}\n", error.what());
        return environment;
    }
    fmt::print("{}\n", arguments.json ? json_text(result) : line_text(result));
    return done;
}

/// Compiles, then again whenever a file changes that the result depends on; ends when it is interrupted.
int compile_and_watch(const Arguments& arguments) {
    FileWatch watch;
    for (;;) {
        const database::CompileResult result = database::compile_file(arguments.source);
        if (takes_a_source(arguments, result)) return bad_input;
        compile_once(arguments, result);
        std::fflush(stdout);
        watch.set(result.files);
        while (!watch.changed())
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
        std::this_thread::sleep_for(std::chrono::milliseconds(50)); // an editor may still be writing
        watch.changed();
    }
}

nlohmann::json schema_json() {
    nlohmann::json tables = nlohmann::json::array();
    for (const database::TableUse& table : database::schema()) {
        nlohmann::json keys = nlohmann::json::array();
        for (const database::KeyUse& use : table.keys) {
            nlohmann::json key = {{"key", use.key}, {"value", use.value}, {"required", !use.fallback}};
            if (use.fallback) key["default"] = *use.fallback;
            keys.push_back(std::move(key));
        }
        tables.push_back({{"table", table.table}, {"keys", std::move(keys)}});
    }
    return tables;
}

int print_schema(const Arguments& arguments) {
    fmt::print("{}", arguments.json ? schema_json().dump(2) + "\n" : database::schema_markdown());
    return done;
}

int compile(const Arguments& arguments) {
    if (arguments.schema) return print_schema(arguments);
    if (arguments.source.empty() || arguments.output.empty())
        throw std::invalid_argument("SRC and --output are required");
    require_ending(arguments.output, "a compiled database", {".igdb"});
    if (arguments.watch) return compile_and_watch(arguments);
    const database::CompileResult result = database::compile_file(arguments.source);
    return takes_a_source(arguments, result) ? bad_input : compile_once(arguments, result);
}

} // namespace

void add_compile(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("compile", "Compile an authoring file into a visual database");
    const auto arguments = std::make_shared<Arguments>();
    command->add_option("SRC", arguments->source, "authoring file (.toml)");
    command->add_option("-o,--output", arguments->output, "compiled database to write (.igdb)");
    command->add_flag("--json", arguments->json, "print the counts, list by list, as JSON");
    command->add_flag("--watch", arguments->watch,
                      "stay, and compile again whenever SRC or a file that it includes is saved");
    command
        ->add_flag("--schema", arguments->schema,
                   "print every table and key of the authoring language, as Markdown or JSON")
        ->excludes("SRC", "--output", "--watch");
    command->footer(
        "Example: linkdig compile database/scenes/first_flight/first_flight.toml -o first_flight.igdb");
    command->callback([arguments, &exit_code] { exit_code = compile(*arguments); });
}

} // namespace linkdig::tools
