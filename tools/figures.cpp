/// linkdig figures: the report's figures, each with a check.

#include "tools/figures/figures.h"
#include "tools/sheet/text.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

namespace linkdig::tools {
namespace {

struct FiguresOptions {
    std::string out = "out/figures";
    bool json = false;
    bool no_film = false;
    bool quick = false;
};

int run(const FiguresOptions& options) {
    require_fonts();
    Findings findings(options.out, options.quick);
    for (const auto& draw : {static_seas, stepping, sea_states, ocean_sun, squares, directions, bow_wakes,
                             churned_water, occulting, costs})
        draw(findings);
    if (!options.no_film && !options.quick) film(findings, 60.0);
    std::ofstream(options.out + "/figures.json") << findings.json() << '\n';
    fmt::print("{}{}", options.json ? findings.json() : findings.text(), options.json ? "\n" : "");
    return findings.passed() ? ExitCode::done : ExitCode::differs;
}

} // namespace

void add_figures(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<FiguresOptions>();
    CLI::App* command =
        app.add_subcommand("figures", "Draw the report's figures and check each; exit code 1 if one fails");
    command->add_option("--out", options->out, "Folder of the pictures and the film")->capture_default_str();
    command->add_flag("--json", options->json, "Print the checks and tables as JSON");
    command->add_flag("--no-film", options->no_film, "Leave the film away");
    command->add_flag("--quick", options->quick, "Every check from fewer pictures, without the film");
    command->footer("Example:\n  linkdig figures --out out/figures --json");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
