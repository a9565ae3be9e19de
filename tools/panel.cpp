/// linkdig panel: the cockpit panels that are plugged in, and what a mapping file does with them.

#include "host/panel/panel_link.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/number_options.h"
#include "tools/panel/lamp_test.h"
#include "tools/panel/monitor.h"
#include "tools/panel/shipped_mappings.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace linkdig::tools {
namespace {

struct PanelOptions {
    bool json = false;
    double seconds = 0.0;
    std::uint64_t events = 0;
    double step_s = 0.5;
    std::string mapping;
};

volatile std::sig_atomic_t interrupted = 0;

/// Ctrl-C ends the link in good order: the panels go dark, and the kernel has them back.
void stop_when_interrupted() {
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
}

panel::Tell to_stderr() {
    return [](const std::string& words) { fmt::print(stderr, "panel: {}\n", words); };
}

/// Sleeps in small pieces until `over` or interrupted, but not for longer than `seconds` (0: no limit).
template <typename Over>
void wait(double seconds, const Over& over) {
    const auto begin = std::chrono::steady_clock::now();
    const auto passed_s = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    while (interrupted == 0 && !over() && (seconds == 0.0 || passed_s() < seconds))
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

void require_link() {
    if (const std::string why = panel::no_panels_because(); !why.empty()) throw std::runtime_error(why);
}

nlohmann::json place_json(const panel::PanelPlace& place) {
    return {{"port", place.port}, {"panel", panel::layout_of(place.kind).name}};
}

int list(const PanelOptions& options) {
    const std::vector<panel::FoundPanel> found = panel::find_panels();
    nlohmann::json all = nlohmann::json::array();
    for (const panel::FoundPanel& each : found) {
        const panel::PanelLayout& layout = panel::layout_of(each.place.kind);
        if (!options.json)
            fmt::print("{:<8} {:04x}:{:04x}  {} panel  {}\n", each.place.port, panel::vendor_id,
                       layout.product_id, layout.name, each.trouble.empty() ? "ready" : each.trouble);
        nlohmann::json row = place_json(each.place);
        row["vendor"] = fmt::format("{:04x}", panel::vendor_id);
        row["product"] = fmt::format("{:04x}", layout.product_id);
        row["ready"] = each.trouble.empty();
        row["trouble"] = each.trouble;
        all.push_back(row);
    }
    if (options.json)
        fmt::print("{}\n", all.dump(2));
    else if (found.empty())
        fmt::print("no panel is plugged in\n");
    return ExitCode::done;
}

void print_news(const PanelNews& news, bool json) {
    if (json) {
        nlohmann::json row = place_json(news.place);
        if (!news.control.empty()) row["control"] = news.control;
        row["what"] = news.what;
        row["fresh"] = news.fresh;
        fmt::print("{}\n", row.dump());
    } else {
        fmt::print("{:<8} {:<7} {}{}{}\n", news.place.port, panel::layout_of(news.place.kind).name,
                   news.control, news.control.empty() ? news.what : " " + news.what,
                   news.fresh ? "" : "  (so it stands)");
    }
    std::fflush(stdout);
}

int monitor(const PanelOptions& options) {
    stop_when_interrupted();
    std::atomic<std::uint64_t> events{0};
    const auto enough = [&] { return options.events != 0 && events >= options.events; };
    PanelMonitor user([&](const PanelNews& news) {
        if (enough()) return;
        print_news(news, options.json);
        ++events;
    });
    const panel::PanelLink link(user, to_stderr());
    wait(options.seconds, enough);
    return ExitCode::done;
}

int test(const PanelOptions& options) {
    require_link();
    stop_when_interrupted();
    LampTest user(options.step_s);
    {
        const panel::PanelLink link(user, to_stderr());
        constexpr double appear_within_s = 3.0;
        wait(appear_within_s, [&] { return user.running() + user.done() > 0; });
        wait(0.0, [&] { return user.running() == 0; });
    }
    if (user.done() == 0) {
        fmt::print(stderr,
                   "linkdig: error: no panel to test; 'linkdig panel list' says what is plugged in\n");
        return ExitCode::environment;
    }
    fmt::print("{} panel{}: every lamp and digit was lit\n", user.done(), user.done() == 1 ? "" : "s");
    return ExitCode::done;
}

int map(const PanelOptions& options) {
    panel::MappingResult result = panel::load_mapping(options.mapping);
    if (!result.mapping) throw BadInput(result.diagnostics.text());
    const panel::Mapping& mapping = *result.mapping;
    fmt::print("{}: {} panel{}\n", mapping.path, panel::layout_of(mapping.kind).name,
               mapping.port.empty() ? "" : " at " + mapping.port);
    for (const std::string& line : panel::mapping_lines(mapping))
        fmt::print("  {}\n", line);
    return ExitCode::done;
}

} // namespace

void add_panel(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<PanelOptions>();
    CLI::App* command =
        app.add_subcommand("panel", "Cockpit panels on USB: list, watch and test them, check a mapping");
    command->require_subcommand(1);
    command->footer("linkdig fly SCENARIO --panel flies with them.\nExample:\n  linkdig panel list");

    CLI::App* listing = command->add_subcommand("list", "The panels that are plugged in, by port");
    listing->add_flag("--json", options->json, "As JSON");
    listing->footer("Example:\n  linkdig panel list --json");
    listing->callback([options, &exit_code] { exit_code = list(*options); });

    CLI::App* watching = command->add_subcommand("monitor", "Print what is done at the panels, until Ctrl-C");
    watching->add_flag("--json", options->json, "A JSON object a line");
    watching->add_option("--seconds", options->seconds, "Stop after so long")
        ->check(finite_number(0.1, 86400.0));
    watching->add_option("--events", options->events, "Stop after so many lines")
        ->check(CLI::Range(1, 1000000));
    watching->footer("Example:\n  linkdig panel monitor --seconds 30");
    watching->callback([options, &exit_code] { exit_code = monitor(*options); });

    CLI::App* lamps =
        command->add_subcommand("test", "Light every lamp and every digit, one after the other");
    lamps->add_option("--step", options->step_s, "Seconds for each")
        ->check(finite_number(0.05, 60.0))
        ->capture_default_str();
    lamps->footer("Example:\n  linkdig panel test --step 0.2");
    lamps->callback([options, &exit_code] { exit_code = test(*options); });

    CLI::App* mapping = command->add_subcommand("map", "Check a mapping file, and say in words what it does");
    mapping->add_option("file", options->mapping, "Mapping file (.toml)")->required();
    mapping->footer("Example:\n  linkdig panel map host/panel/mappings/switch.toml");
    mapping->callback([options, &exit_code] { exit_code = map(*options); });
}

} // namespace linkdig::tools
