#include "tools/flight/fly_files.h"

#include "tools/film/film.h"
#include "tools/flight/capacity_options.h"
#include "tools/flight/dump.h"
#include "tools/flight/progress.h"

#include <fmt/format.h>

#include <cmath>

namespace linkdig::tools {

void write_files(const FilesRequest& request, const ig::Configuration& configuration,
                 double frames_per_second, const std::function<const ig::VideoFrame&(std::uint64_t)>& draw) {
    DumpRequest dump;
    dump.folder = request.folder;
    dump.film_name = video_files() ? request.name : "";
    dump.first = request.first;
    dump.frames = request.frames;
    dump.frames_per_second = static_cast<std::uint32_t>(std::lround(frames_per_second));
    const ig::Raster& raster = configuration.raster;
    dump.width = request.width != 0 ? request.width : raster.width;
    dump.height = request.height != 0 ? request.height : raster.height;
    dump.heading = fmt::format("{}, {} frames, {} x {}, profile {}", request.heading, dump.frames,
                               raster.width, raster.height, configuration.name);
    dump.progress = stderr_is_terminal();
    dump_flight(dump, draw);
    fmt::print("{}: frame_{:06}.png to frame_{:06}.png, {}contact.png\n", dump.folder, dump.first,
               dump.first + dump.frames - 1, dump.film_name.empty() ? "" : dump.film_name + ".mp4, ");
}

void fly_as_files(Flight& flight, FilesRequest request, RetroDisplay* display) {
    if (request.frames == 0) request.frames = flight.loop().frames();
    const std::uint32_t fields = display == nullptr ? 1 : display->fields();
    request.frames *= fields;
    request.width = display == nullptr ? 0 : display->width();
    request.height = display == nullptr ? 0 : display->height();
    const host::SignalValues as_the_scenario_says;
    write_files(request, flight.configuration(), fields * flight.loop().update_rate_hz(),
                [&](std::uint64_t frame) -> const ig::VideoFrame& {
                    if (frame % fields == 0) flight.draw(frame / fields, as_the_scenario_says);
                    const ig::VideoFrame& picture = flight.machine().picture(0);
                    return display == nullptr
                               ? picture
                               : display->show(picture, static_cast<std::uint32_t>(frame % fields));
                });
}

void summarise(const Flight& flight, std::uint64_t overruns) {
    const FlightCosts& costs = flight.costs();
    const double mean_ms =
        costs.frames == 0 ? 0.0 : 1000.0 * costs.machine_s / static_cast<double>(costs.frames);
    fmt::print("{} frames at {:g} Hz; image generator {:.2f} ms a frame, at most {:.2f} ms; {} overruns; "
               "at most {} edges in a frame\n",
               costs.frames, flight.loop().update_rate_hz(), mean_ms, 1000.0 * costs.worst_s, overruns,
               costs.most_edges);
    print_overload(costs);
}

} // namespace linkdig::tools
