/// The one binary: each subcommand stands in a file of its own.

#include "tools/flight/bad_input.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace {

using linkdig::tools::ExitCode;

std::vector<std::string> subcommand_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(subcommand->get_name());
    return names;
}

/// CLI11's own message for an unknown word speaks of "arguments"; the author of the line meant a subcommand.
std::string mistake(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
    const std::string first = argc > 1 ? argv[1] : "";
    const std::vector<std::string> known = subcommand_names(app);
    if (!first.empty() && first[0] != '-' && std::ranges::find(known, first) == known.end())
        return fmt::format("unknown subcommand '{}'; expected one of: {}", first, fmt::join(known, ", "));
    return error.what();
}

int run(int argc, char** argv) {
    CLI::App app{"linkdig: the LINK digital image generator, brought back", "linkdig"};
    app.set_version_flag("--version", std::string("linkdig ") + LINKDIG_VERSION);
    app.require_subcommand(1);
    app.footer("Example:\n  linkdig demo\nEach subcommand has a --help of its own.");
    int exit_code = ExitCode::done;
    linkdig::tools::add_demo(app, exit_code);
    linkdig::tools::add_compile(app, exit_code);
    linkdig::tools::add_inspect(app, exit_code);
    linkdig::tools::add_export(app, exit_code);
    linkdig::tools::add_preview(app, exit_code);
    linkdig::tools::add_render(app, exit_code);
    linkdig::tools::add_figures(app, exit_code);
    linkdig::tools::add_fly(app, exit_code);
    linkdig::tools::add_panel(app, exit_code);
    linkdig::tools::add_record(app, exit_code);
    linkdig::tools::add_replay(app, exit_code);
    linkdig::tools::add_convert(app, exit_code);
    linkdig::tools::add_wake(app, exit_code);
    linkdig::tools::add_why(app, exit_code);
    linkdig::tools::add_check(app, exit_code);
    linkdig::tools::add_compare(app, exit_code);
    linkdig::tools::add_bench(app, exit_code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return app.exit(asked); // --help, --version
    } catch (const CLI::ParseError& error) {
        const std::string first = argc > 1 ? argv[1] : "";
        const std::string known = std::ranges::count(subcommand_names(app), first) > 0 ? first + " " : "";
        fmt::print(stderr, "linkdig: error: {}\nTry 'linkdig {}--help'.\n", mistake(app, error, argc, argv),
                   known);
        return ExitCode::bad_input;
    }
    return exit_code;
}

/// What stands in the buffer may meet a full disk only now; the C++ run-time would not tell. Who closed a pipe early, as head
/// does, has what he wanted.
void require_output_written() {
    if (std::fflush(stdout) != 0 && errno != EPIPE)
        throw std::system_error(errno, std::generic_category(), "the output cannot be written");
}

} // namespace

int main(int argc, char** argv) {
    try {
        const int exit_code = run(argc, argv);
        require_output_written();
        return exit_code;
    } catch (const linkdig::tools::BadInput& mistakes) {
        const std::string text = mistakes.what();
        fmt::print(stderr, "{}{}", text, text.ends_with('\n') ? "" : "\n");
        return ExitCode::bad_input;
    } catch (const std::invalid_argument& mistake) { // a value on the command line
        fmt::print(stderr, "linkdig: error: {}\n", mistake.what());
        return ExitCode::bad_input;
    } catch (const std::exception& error) {
        fmt::print(stderr, "linkdig: error: {}\n", error.what());
        return ExitCode::environment;
    }
}
