/// linkdig render: frames of a scenario as pictures, and as planes that explain them.

#include "ig/sink/image_file.h"
#include "tools/display/retro_display.h"
#include "tools/flight/arguments.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/capacity_options.h"
#include "tools/flight/flight.h"
#include "tools/flight/number_options.h"
#include "tools/flight/planes.h"
#include "tools/flight/progress.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace linkdig::tools {
namespace {

struct RenderOptions {
    std::string scenario;
    std::string frames = "0";
    std::size_t channel = 0;
    std::string planes = "colour";
    std::string out = "out/render";
    std::optional<std::string> size;
    std::string profile = "modern";
    bool no_smoothing = false;
    std::string display = "plain";
    double frames_per_second = 30.0;
    std::uint32_t threads = 0;
    ig::Capacity capacity;
};

FlightRequest request_of(const RenderOptions& options) {
    FlightRequest request;
    request.scenario_path = options.scenario;
    request.configuration = configuration_of(options.profile, options.size, options.frames_per_second,
                                             options.threads, options.no_smoothing);
    request.configuration.capacity = options.capacity;
    return request;
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw std::runtime_error(fmt::format("{}: cannot be made: {}", folder, error.message()));
}

/// Writes a channel's picture as a camera sees it on a monitor of the period.
class Photographer {
public:
    explicit Photographer(const ig::Configuration& built_as) : display_(built_as.raster, built_as.fields) {}

    void take(const ig::VideoFrame& picture, const std::string& folder, std::uint64_t frame) {
        for (; warm_up_ > 0; --warm_up_) // the first picture has stood there for a while
            display_.photograph(picture);
        ig::write_png(fmt::format("{}/colour_{:06}.png", folder, frame), display_.photograph(picture));
    }

private:
    RetroDisplay display_;
    int warm_up_ = 10;
};

/// They can be drawn, but a recording of the scenario and a flight as files do not have them.
void tell_of_frames_after_the_end(const FrameRange& range, const Flight& flight) {
    const std::uint64_t frames = flight.loop().frames();
    if (range.last >= frames)
        fmt::print(stderr,
                   "linkdig: warning: --frames {}:{}: the scenario ends with frame {}, after {:g} s\n",
                   range.first, range.last, frames - 1, flight.scenario().duration_s);
}

int run(const RenderOptions& options) {
    const FrameRange range = parse_frames(options.frames);
    const std::vector<ig::Plane> planes = parse_planes(options.planes);
    const auto wanted = [&](ig::Plane plane) { return std::ranges::find(planes, plane) != planes.end(); };
    if (options.display == "retro" && !wanted(ig::Plane::colour))
        throw std::invalid_argument(
            "--display retro photographs the colour plane; expected colour among --planes");
    Flight flight(request_of(options));
    if (options.channel >= flight.scenario().channels.size())
        throw BadInput(
            fmt::format("linkdig: error: there is no channel {}; the scenario has {}, numbered from 0",
                        options.channel, flight.scenario().channels.size()));
    const bool numbers = std::ranges::any_of(
        planes, [](ig::Plane plane) { return plane != ig::Plane::colour && plane != ig::Plane::intensity; });
    flight.machine().draw_planes(wanted(ig::Plane::intensity), numbers);
    make_folder(options.out);
    tell_of_frames_after_the_end(range, flight);
    std::optional<Photographer> photographer;
    if (options.display == "retro") photographer.emplace(flight.configuration());
    Progress progress(stderr_is_terminal(), range.last - range.first + 1);
    flight.lead_in(range.first, {});
    for (std::uint64_t frame = range.first; frame <= range.last; ++frame) {
        flight.draw(frame, {});
        for (const ig::Plane plane : planes)
            if (plane == ig::Plane::colour && photographer)
                photographer->take(flight.machine().picture(options.channel), options.out, frame);
            else
                write_plane(plane, flight.database(), flight.machine(), options.channel, options.out, frame);
        progress.at(frame - range.first + 1);
    }
    progress.finish();
    print_overload(flight.costs());
    return ExitCode::done;
}

} // namespace

void add_render(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* render =
        app.add_subcommand("render", "Draw frames of a scenario, and planes that explain them");
    render->add_option("scenario", options->scenario, "Scenario file (.toml)")->required();
    render->add_option("--frames", options->frames, "FIRST:LAST, both drawn, or one frame")
        ->capture_default_str();
    render->add_option("--channel", options->channel, "Channel of the scenario, from 0")
        ->transform(whole_number())
        ->capture_default_str();
    render
        ->add_option("--planes", options->planes, "Some of colour,intensity,rank,list,object,face,edges,flat")
        ->capture_default_str();
    render->add_option("--out", options->out, "Folder of the files")->capture_default_str();
    render->add_option("--size", options->size, "Picture, WIDTHxHEIGHT pixels; default: the profile's");
    render->add_flag("--no-smoothing", options->no_smoothing,
                     "Show faces by pixel centres, without smoothed edges");
    render
        ->add_option("--display", options->display,
                     "plain, or retro: the colour plane as photographed from a monitor of the period")
        ->check(CLI::IsMember({"plain", "retro"}))
        ->capture_default_str();
    render->add_option("--profile", options->profile, "Machine profile")
        ->check(CLI::IsMember({"ames", "modern"}))
        ->capture_default_str();
    render->add_option("--fps", options->frames_per_second, "Frames a second of simulated time")
        ->check(CLI::Range(1, 240))
        ->capture_default_str();
    render
        ->add_option("--threads", options->threads,
                     "Threads of the image generator; 0: as many as the machine has")
        ->check(CLI::Range(0, 256));
    add_capacity_options(*render, options->capacity);
    render->footer(
        "colour, edges (the borders of what is seen over it) and flat (each face in one colour) are PNG, the "
        "other\n"
        "planes OpenEXR: intensity as 32-bit floats 0 to 1, the rest as 32-bit\n"
        "numbers (rank on the channel; indices into the database's lists, objects and faces), 4294967295\n"
        "where no face is seen, 4294967294 for a face that the machine made itself (the sea's copies).\n"
        "Example:\n  linkdig render database/scenes/first_flight/approach.toml --frames 10:20 "
        "--planes colour,object --out D");
    render->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
