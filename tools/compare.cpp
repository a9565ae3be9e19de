/// linkdig compare: two pictures, folders of frames or recordings: what changed and why.

#include "tools/compare/compare.h"
#include "database/format/replace_file.h"
#include "tools/compare/manifest.h"
#include "tools/compare/read_picture.h"
#include "tools/compare/report_html.h"
#include "tools/compare/report_json.h"
#include "tools/compare/report_text.h"
#include "tools/compare/update.h"
#include "tools/flight/arguments.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/open_database.h"
#include "tools/flight/output_name.h"
#include "tools/flight/progress.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::tools {
namespace {

using namespace compare;

struct CompareOptions {
    std::string expected, actual;
    std::vector<std::string> tolerance, include, ignore, databases;
    std::string mask, manifest, case_name, frames, background, report, junit;
    std::string scan = "horizontal";
    std::optional<std::string> size;
    std::string profile = "modern";
    bool no_smoothing = false, json = false, update = false, exact = false, perceptual = false;
    std::size_t worst = 8;
    std::uint32_t threads = 0;
};

Case case_of(const CompareOptions& options) {
    Case result;
    result.expected = options.expected;
    result.actual = options.actual;
    result.tolerance = parse_tolerance(options.tolerance);
    for (const std::string& text : options.include)
        result.regions.include.push_back(parse_rectangle(text));
    for (const std::string& text : options.ignore)
        result.regions.ignore.push_back(parse_rectangle(text));
    if (!options.mask.empty()) {
        ReadPicture read = read_picture(options.mask);
        if (!read.picture) throw BadInput("linkdig: error: " + read.error);
        result.regions.mask = std::move(read.picture);
    }
    if (!options.frames.empty()) result.frames = parse_frames(options.frames);
    if (!options.background.empty()) result.background = parse_colour(options.background);
    return result;
}

std::vector<Case> cases_of(const CompareOptions& options) {
    if (options.manifest.empty()) {
        if (options.actual.empty())
            throw BadInput("linkdig: error: expected two things to compare, or --manifest FILE");
        return {case_of(options)};
    }
    if (!options.expected.empty() && options.actual.empty())
        throw BadInput("linkdig: error: with --manifest, expected two folders that hold the cases, or none");
    std::optional<Roots> roots;
    if (!options.actual.empty()) roots = Roots{options.expected, options.actual};
    std::vector<Case> cases = read_manifest(options.manifest, roots);
    if (options.case_name.empty()) return cases;
    std::erase_if(cases, [&](const Case& each) { return each.name != options.case_name; });
    if (cases.empty())
        throw BadInput(
            fmt::format("linkdig: error: {}: there is no case '{}'", options.manifest, options.case_name));
    return cases;
}

void write_text(const std::string& path, const std::string& text) {
    database::replace_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// The databases that name what is seen and draw recordings: one for both sides, or one for each.
std::vector<OpenedDatabase> open_databases(const CompareOptions& options) {
    std::vector<OpenedDatabase> opened;
    for (const std::string& path : options.databases)
        opened.push_back(open_database(path));
    return opened;
}

Settings settings_of(const CompareOptions& options, const std::vector<OpenedDatabase>& databases) {
    Settings settings;
    const ig::Configuration configuration =
        configuration_of(options.profile, options.size, std::nullopt, options.threads, options.no_smoothing);
    settings.expected_frames.configuration = configuration;
    settings.actual_frames.configuration = configuration;
    if (!databases.empty()) {
        settings.expected_frames.database = &databases.front().database;
        settings.actual_frames.database = &databases.back().database;
    }
    settings.scan = options.scan == "vertical" ? ig::Scan::vertical : ig::Scan::horizontal;
    settings.threads = options.threads;
    settings.worst = options.worst;
    settings.pictures = !options.report.empty();
    settings.empty_references = options.update;
    settings.perceptual = options.perceptual;
    settings.progress = stderr_is_terminal();
    return settings;
}

int run(const CompareOptions& options) {
    if (!options.report.empty()) require_ending(options.report, "a page", {".html"});
    if (!options.junit.empty()) require_ending(options.junit, "a JUnit file", {".xml"});
    const std::vector<Case> cases = cases_of(options);
    const std::vector<OpenedDatabase> databases = open_databases(options);
    const Settings settings = settings_of(options, databases);
    std::vector<CaseResult> results;
    JunitFile junit;
    std::uint64_t updated = 0;
    int exit_code = 0;
    for (const Case& each : cases) {
        if (options.update && !std::filesystem::is_directory(each.expected) && is_recording(each.expected))
            throw BadInput("linkdig: error: " + each.expected +
                           ": is a recording; --update rewrites pictures");
        junit.begin(each.name.empty() ? "compare" : each.name);
        results.push_back(compare_case(each, settings, [&](const FrameResult& frame) {
            if (!options.junit.empty()) junit.take(frame, settings.scan);
            if (options.update && update_reference(frame, each.expected)) ++updated;
        }));
        junit.end(results.back());
        exit_code = heavier(exit_code, results.back().exit_code());
        if (!options.json) fmt::print("{}", text_of(results.back(), settings.scan));
    }
    if (!options.junit.empty()) write_text(options.junit, junit.text());
    if (!options.report.empty()) write_text(options.report, html_of_results(results, settings.scan));
    if (options.update) fmt::print(stderr, "updated: {} references\n", updated);
    fmt::print("{}\n", options.json ? json_of_results(results, settings.scan) : closing_line(results));
    return exit_code;
}

void add_what(CLI::App& compare, CompareOptions& options) {
    compare.add_option("expected", options.expected, "Picture, folder of frames, or recording");
    compare.add_option("actual", options.actual, "The same, to be held against it");
    compare.add_option("--manifest", options.manifest, "Cases with tolerances and regions (.toml)");
    compare.add_option("--case", options.case_name, "This case of the manifest alone");
    compare.add_option("--frames", options.frames, "FIRST:LAST, both compared, or one frame");
    CLI::Option* exact = compare.add_flag("--exact", options.exact, "Any difference counts (the default)");
    compare.add_option("--tolerance", options.tolerance, "Buckets of pixels, as in '<=1:*,<=5:100'")
        ->allow_extra_args(false)
        ->excludes(exact);
    compare
        .add_option("--include", options.include,
                    "X,Y,WIDTH,HEIGHT: only what is inside counts; may be repeated")
        ->allow_extra_args(false);
    compare
        .add_option("--ignore", options.ignore,
                    "X,Y,WIDTH,HEIGHT: what is inside does not count; may be repeated")
        ->allow_extra_args(false);
    compare.add_option("--mask", options.mask,
                       "Picture of the frames' size: what is black in it does not count");
    compare.add_option("--background", options.background,
                       "R,G,B: pixels of this colour are not drawn, for percentages");
    compare
        .add_option("--scan", options.scan, "Which way lines run, for the first differing line and element")
        ->check(CLI::IsMember({"horizontal", "vertical"}))
        ->capture_default_str();
}

void add_drawing(CLI::App& compare, CompareOptions& options) {
    compare
        .add_option("--database", options.databases,
                    "Database (.igdb, .toml) that names faces and draws recordings; a second one is the "
                    "actual side's")
        ->expected(1, 2)
        ->allow_extra_args(false);
    compare.add_option("--profile", options.profile, "Machine profile for recordings")
        ->check(CLI::IsMember({"ames", "modern"}))
        ->capture_default_str();
    compare.add_option("--size", options.size,
                       "Picture of recordings, WIDTHxHEIGHT pixels; default: the profile's");
    compare.add_flag("--no-smoothing", options.no_smoothing, "Draw recordings without smoothed edges");
}

void add_answers(CLI::App& compare, CompareOptions& options) {
    compare.add_option("--report", options.report, "Write a page that shows the worst frames (.html)");
    compare.add_flag("--json", options.json, "Print JSON instead of text");
    compare.add_option("--junit", options.junit, "Write a JUnit file (.xml)");
    compare.add_flag("--update", options.update,
                     "Rewrite the expected pictures that failed from the actual ones");
    compare.add_option("--worst", options.worst, "How many of the worst frames are told of")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    compare.add_flag("--perceptual", options.perceptual,
                     "Count the pixels that a viewer tells apart in large pictures, too: seconds for each");
    compare.add_option("--threads", options.threads, "Threads; 0: as many as the machine has")
        ->check(CLI::Range(0, 256));
}

} // namespace

void add_compare(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* compare =
        app.add_subcommand("compare", "Tell what changed between two dumps of frames, and why");
    add_what(*compare, *options);
    add_drawing(*compare, *options);
    add_answers(*compare, *options);
    compare->footer(
        "Frames (.png, .exr, .tif) are paired by the number in their names. Planes of linkdig render that "
        "stand\n"
        "beside the colour (list, object, face) tell whose pixels differ.\n"
        "Exit codes: 0 same, 1 differs, 2 bad usage or unreadable, 3 missing or extra frames (or a\n"
        "file cannot be written), 4 size or channels differ; of several, the first of 2, 4, 3, 1.\n"
        "Example:\n  linkdig compare before after --tolerance '<=1:*' --report out.html");
    compare->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
