/// linkdig compile: an authoring file becomes a compiled database.

#include "database/compiler/compile.h"
#include "database/format/validate.h"
#include "database/format/write.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace linkdig::tools {

namespace {

struct Arguments {
    std::string source;
    std::string output;
    bool json = false;
};

nlohmann::json as_json(const database::ListStatistics& list) {
    return {{"name", list.name},     {"objects", list.objects},
            {"faces", list.faces},   {"faces_at_once", list.faces_at_once},
            {"edges", list.edges},   {"vertices", list.vertices},
            {"planes", list.planes}, {"splits", list.splits},
            {"lights", list.lights}, {"runs", list.runs}};
}

std::string json_text(const database::CompileResult& result) {
    nlohmann::json lists = nlohmann::json::array();
    for (const database::ListStatistics& list : result.statistics.lists)
        lists.push_back(as_json(list));
    nlohmann::json total = as_json(result.statistics.total());
    total["name"] = result.database->name;
    return nlohmann::json{
        {"total", total}, {"priority_planes", result.statistics.priority_planes}, {"lists", lists}}
        .dump(2);
}

std::string line_text(const database::CompileResult& result) {
    const database::ListStatistics total = result.statistics.total();
    return fmt::format("{}: {} faces ({} at most at once), {} edges, {} vertices, {} light points, {} "
                       "planes, {} faces cut, in {} lists and "
                       "{} clusters",
                       result.database->name, total.faces, total.faces_at_once, total.edges, total.vertices,
                       total.lights, total.planes + result.statistics.priority_planes, total.splits,
                       result.database->lists.size(), result.database->clusters.size());
}

int compile(const Arguments& arguments) {
    const database::CompileResult result = database::compile_file(arguments.source);
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
        fmt::print(stderr, "error: {}\n", error.what());
        return environment;
    }
    fmt::print("{}\n", arguments.json ? json_text(result) : line_text(result));
    return done;
}

} // namespace

void add_compile(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("compile", "Compile an authoring file into a visual database");
    const auto arguments = std::make_shared<Arguments>();
    command->add_option("SRC", arguments->source, "authoring file (.toml)")->required();
    command->add_option("-o,--output", arguments->output, "compiled database to write (.igdb)")->required();
    command->add_flag("--json", arguments->json, "print the counts, list by list, as JSON");
    command->footer(
        "Example: linkdig compile database/scenes/first_flight/first_flight.toml -o first_flight.igdb");
    command->callback([arguments, &exit_code] { exit_code = compile(*arguments); });
}

} // namespace linkdig::tools
