/// `linkdig inspect`: what is in a compiled visual database.

#include "database/format/dump.h"
#include "database/format/read.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

namespace linkdig::tools {

namespace {

struct InspectOptions {
    std::string path;
    bool json = false;
    bool objects = false;
};

int inspect(const InspectOptions& options) {
    const database::ReadResult read = database::read_database(options.path);
    if (!read.database) {
        fmt::print(stderr, "linkdig: error: {}\n", read.error);
        return ExitCode::bad_input;
    }
    fmt::print("{}", options.json ? database::dump_json(*read.database, read.id)
                                  : database::dump_text(*read.database, read.id, options.objects));
    return ExitCode::done;
}

} // namespace

void add_inspect(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App* command = app.add_subcommand("inspect", "Show what is in a compiled visual database");
    command->add_option("database", options->path, "Compiled visual database (.igdb)")->required();
    command->add_flag("--json", options->json, "Write JSON: lists, objects, face counts, budgets, extents");
    command->add_flag("--objects", options->objects, "List the objects of each list too");
    command->footer("Example:\n  linkdig inspect first_flight.igdb --json");
    command->callback([options, &exit_code] { exit_code = inspect(*options); });
}

} // namespace linkdig::tools
