/// linkdig check: does every pixel show the face that is nearest, as an independent ray caster sees it?

#include "tools/check/check.h"
#include "ig/sink/image_file.h"
#include "tools/check/cast_scene.h"
#include "tools/flight/arguments.h"
#include "tools/flight/number_options.h"
#include "tools/flight/open_database.h"
#include "tools/flight/output_name.h"
#include "tools/flight/progress.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace linkdig::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t most_views = 1000000; ///< numbered from 0

struct CheckOptions {
    std::string database;
    std::uint64_t views = 60;
    std::uint64_t seed = 1;
    std::optional<std::uint64_t> view;
    std::string size = "512x512";
    std::string manifest;
    std::string picture;
    double allow_percent = 0.05;
    bool json = false;
};

std::string place_text(const FacePlace& place) {
    if (place.list.empty()) return "the background";
    return fmt::format("{}, object \"{}\" ({}:{})", place.list, place.object, place.file, place.line);
}

std::string how_text(const Finding& finding) {
    if (finding.gone) return "which is not in the active data base there";
    if (finding.nearer_by_m >= 0.5 * endless_m)
        return "which the ray does not meet at all, or only at infinity";
    return fmt::format("which is up to {:.2f} m farther", finding.nearer_by_m);
}

void print_text(const CheckOptions& options, const CheckRequest& request, const VisualDatabase& database,
                const CheckResult& result) {
    fmt::print(
        "{}: {} views of {} x {} pixels, seed {}: {} interior pixels, {} wrong ({:.4f} %; allowed {} %)\n",
        database.name, result.views, request.raster.width, request.raster.height, request.seed,
        result.interior, result.wrong, 100.0 * result.wrong_share(), options.allow_percent);
    if (result.ambiguous > 0)
        fmt::print("undecided {} pairs of clusters that no plane parts\n", result.ambiguous);
    for (std::size_t i = 0; i < request.exceptions.size(); ++i) {
        const DesignException& exception = request.exceptions[i];
        const std::string limit = std::isfinite(exception.by_at_most_m)
                                      ? fmt::format(" by at most {} m", exception.by_at_most_m)
                                      : std::string();
        fmt::print("excepted  {} pixels: {} in front of {}{}: {}\n", result.excepted[i],
                   fmt::join(exception.front_names, ", "), fmt::join(exception.behind_names, ", "), limit,
                   exception.reason);
    }
    for (const Finding& finding : result.findings) {
        fmt::print("wrong     {} pixels show {},\n          {}, instead of\n          {}\n", finding.pixels,
                   place_text(finding.shown), how_text(finding), place_text(finding.nearest));
        fmt::print("          first at {},{}: linkdig check {} --seed {} --view {}{} --picture wrong.png\n",
                   finding.column, finding.row, options.database, request.seed, finding.view,
                   options.size == "512x512" ? "" : " --size " + options.size);
    }
}

Json place_json(const FacePlace& place) {
    if (place.list.empty()) return nullptr;
    return {{"list", place.list}, {"object", place.object}, {"file", place.file}, {"line", place.line}};
}

Json finding_json(const Finding& finding) {
    Json json{{"pixels", finding.pixels},
              {"shown", place_json(finding.shown)},
              {"nearest", place_json(finding.nearest)},
              {"nearer_by_m", nullptr},
              {"not_present", finding.gone},
              {"view", finding.view},
              {"at", Json::array({finding.column, finding.row})}};
    if (finding.nearer_by_m < 0.5 * endless_m) json["nearer_by_m"] = finding.nearer_by_m;
    return json;
}

void print_json(const CheckOptions& options, const CheckRequest& request, const VisualDatabase& database,
                const CheckResult& result) {
    Json json{{"database", database.name},
              {"seed", request.seed},
              {"first_view", request.first_view},
              {"views", result.views},
              {"width", request.raster.width},
              {"height", request.raster.height},
              {"interior_pixels", result.interior},
              {"equally_near_pixels", result.as_near},
              {"wrong_pixels", result.wrong},
              {"wrong_percent", 100.0 * result.wrong_share()},
              {"allowed_percent", options.allow_percent},
              {"undecided_pairs", result.ambiguous},
              {"exceptions", Json::array()},
              {"findings", Json::array()}};
    for (std::size_t i = 0; i < request.exceptions.size(); ++i)
        json["exceptions"].push_back({{"front", request.exceptions[i].front_names},
                                      {"behind", request.exceptions[i].behind_names},
                                      {"by_at_most_m", request.exceptions[i].by_at_most_m}, // null: no limit
                                      {"reason", request.exceptions[i].reason},
                                      {"pixels", result.excepted[i]}});
    for (const Finding& finding : result.findings)
        json["findings"].push_back(finding_json(finding));
    fmt::print("{}\n", json.dump(2));
}

void tell_view(const CheckView& view) {
    const Vec3d& eye = view.packet.channels[0].eye_m;
    fmt::print("view {}   {} {}, from {:.2f} {:.2f} {:.2f} m\n", view.number, view.range, view.target, eye.x,
               eye.y, eye.z);
}

int run(const CheckOptions& options) {
    if (!options.picture.empty()) require_ending(options.picture, "a PNG picture", {".png"});
    const OpenedDatabase opened = open_database(options.database);
    CheckRequest request;
    request.seed = options.seed;
    request.views = options.views;
    const PictureSize size = parse_size(options.size);
    request.raster = {size.width, size.height, ig::Scan::horizontal};
    if (options.view) {
        request.first_view = *options.view;
        request.views = 1;
    }
    const std::string manifest =
        options.manifest.empty() ? manifest_beside(options.database) : options.manifest;
    if (!manifest.empty()) request.exceptions = read_exceptions(manifest, opened.database);
    Progress progress(stderr_is_terminal(), request.views);
    const CheckResult result = check_database(opened.database, request, [&](const CheckedView& checked) {
        progress.at(checked.view.number - request.first_view + 1);
        if (!options.picture.empty()) ig::write_png(options.picture, checked.picture);
        if (options.view && !options.json) tell_view(checked.view);
    });
    progress.finish();
    (options.json ? print_json : print_text)(options, request, opened.database, result);
    return 100.0 * result.wrong_share() > options.allow_percent ? ExitCode::differs : ExitCode::done;
}

} // namespace

void add_check(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<CheckOptions>();
    CLI::App* command =
        app.add_subcommand("check", "Hold a database's priorities against an independent ray caster");
    command->add_option("database", options->database, "Visual database (.toml or .igdb)")->required();
    command->add_option("--views", options->views, "Seeded views")
        ->transform(whole_number(1, most_views))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "Of the views")
        ->transform(whole_number())
        ->capture_default_str();
    command->add_option("--view", options->view, "This view alone")
        ->transform(whole_number(0, most_views - 1));
    command->add_option("--size", options->size, "Picture, WIDTHxHEIGHT pixels")->capture_default_str();
    command->add_option("--exceptions", options->manifest,
                        "What differs by design; default: check.toml beside the database");
    command
        ->add_option("--picture", options->picture,
                     "With --view: write the picture as PNG, its wrong pixels red")
        ->needs("--view");
    command->add_option("--allow", options->allow_percent, "Percent of interior pixels that may be wrong")
        ->check(finite_number(0.0, 100.0))
        ->capture_default_str();
    command->add_flag("--json", options->json, "As JSON");
    command->footer(
        "Draws each view and casts a ray through the middle of every pixel. Where a pixel is more than one\n"
        "from every edge, both must show the same face. Exit code 1 if more than --allow differ.\n"
        "Example:\n  linkdig check database/scenes/first_flight/first_flight.toml --views 20");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
