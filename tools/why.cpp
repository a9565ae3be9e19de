/// linkdig why: which face won a pixel, by which planes, and how it got its colour.

#include "tools/flight/arguments.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/flight.h"
#include "tools/flight/number_options.h"
#include "tools/reasons/reasons.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace linkdig::tools {
namespace {

struct WhyOptions {
    std::string scenario;
    std::uint64_t frame = 0;
    std::string at;
    std::size_t channel = 0;
    std::optional<std::string> size;
    std::string profile = "modern";
    bool no_smoothing = false;
    double frames_per_second = 30.0;
    bool json = false;
};

/// COLUMN,ROW from the upper left corner.
void parse_pixel(const std::string& text, const ig::VideoFrame& picture, std::uint32_t& column,
                 std::uint32_t& row) {
    int used = 0;
    const bool read = std::sscanf(text.c_str(), "%9u,%9u%n", &column, &row, &used) == 2 &&
                      static_cast<std::size_t>(used) == text.size() && text.find('-') == std::string::npos;
    if (!read || column >= picture.width || row >= picture.height) {
        throw BadInput(fmt::format("linkdig: error: --at {}: expected COLUMN,ROW inside the {} x {} picture",
                                   text, picture.width, picture.height));
    }
}

int run(const WhyOptions& options) {
    FlightRequest request;
    request.scenario_path = options.scenario;
    request.configuration =
        configuration_of(options.profile, options.size, options.frames_per_second, 0, options.no_smoothing);
    Flight flight(request);
    if (options.channel >= flight.scenario().channels.size()) {
        throw BadInput(
            fmt::format("linkdig: error: there is no channel {}; the scenario has {}, numbered from 0",
                        options.channel, flight.scenario().channels.size()));
    }
    flight.lead_in(options.frame, {});
    flight.draw(options.frame, {});
    const ig::VideoFrame& picture = flight.machine().picture(options.channel);
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    parse_pixel(options.at, picture, column, row);
    const std::uint32_t pixel = picture.pixels[std::size_t{row} * picture.width + column];
    const auto reasons = flight.machine().explain(options.channel, column, row);
    if (!reasons) throw std::logic_error("a pixel of the picture that was drawn has no reasons");
    if (!options.json) {
        fmt::print("{}", reasons_text(flight.database(), *reasons, pixel));
        return ExitCode::done;
    }
    nlohmann::ordered_json json{
        {"frame", options.frame}, {"channel", options.channel}, {"at", nlohmann::json::array({column, row})}};
    json.update(reasons_json(flight.database(), *reasons, pixel));
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
}

} // namespace

void add_why(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<WhyOptions>();
    CLI::App* why = app.add_subcommand("why", "Tell why a pixel looks as it does");
    why->add_option("scenario", options->scenario, "Scenario file (.toml)")->required();
    why->add_option("--frame", options->frame, "Frame of the scenario")
        ->transform(whole_number())
        ->capture_default_str();
    why->add_option("--at", options->at, "COLUMN,ROW of the pixel, from the upper left corner")->required();
    why->add_option("--channel", options->channel, "Channel of the scenario, from 0")
        ->transform(whole_number())
        ->capture_default_str();
    why->add_option("--size", options->size, "Picture, WIDTHxHEIGHT pixels; default: the profile's");
    why->add_flag("--no-smoothing", options->no_smoothing,
                  "Show faces by pixel centres, without smoothed edges");
    why->add_option("--profile", options->profile, "Machine profile")
        ->check(CLI::IsMember({"ames", "modern"}))
        ->capture_default_str();
    why->add_option("--fps", options->frames_per_second, "Frames a second of simulated time")
        ->check(CLI::Range(1, 240))
        ->capture_default_str();
    why->add_flag("--json", options->json, "As JSON: every layer in full");
    why->footer(
        "Tells the list, object, face and authoring line that won the pixel, the planes and sides that "
        "decided,\n"
        "the arithmetic of its intensity, the shares, air and light points that its colour is made of, and "
        "what\n"
        "lies before and behind it in order.\n"
        "Example:\n  linkdig why database/scenes/first_flight/approach.toml --frame 300 --at 512,600");
    why->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
