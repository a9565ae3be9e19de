#pragma once
/// The one binary's subcommands: each file of tools/ adds its own, and sets the exit code when it is the one called.

#include <CLI/CLI.hpp>

namespace linkdig::tools {

/// Exit codes of every subcommand (compare has finer ones of its own).
enum ExitCode : int {
    done = 0,
    differs = 1,     ///< or a check failed
    bad_input = 2,   ///< or bad usage
    environment = 3, ///< a file cannot be written, no display, no device
};

void add_compile(CLI::App& app, int& exit_code);
void add_inspect(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_preview(CLI::App& app, int& exit_code);
void add_demo(CLI::App& app, int& exit_code);
void add_render(CLI::App& app, int& exit_code);
void add_figures(CLI::App& app, int& exit_code);
void add_fly(CLI::App& app, int& exit_code);
void add_panel(CLI::App& app, int& exit_code);
void add_record(CLI::App& app, int& exit_code);
void add_replay(CLI::App& app, int& exit_code);
void add_convert(CLI::App& app, int& exit_code);
void add_wake(CLI::App& app, int& exit_code);
void add_why(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_bench(CLI::App& app, int& exit_code);

} // namespace linkdig::tools
