/// linkdig replay: the pictures of a recording; no host, no scenario.

#include "tools/flight/replay.h"
#include "host/packet/recording.h"
#include "ig/machine/machine.h"
#include "ig/sink/hash_sink.h"
#include "ig/sink/image_file.h"
#include "tools/flight/arguments.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/fly_files.h"
#include "tools/flight/number_options.h"
#include "tools/flight/open_database.h"
#include "tools/flight/output_name.h"
#include "tools/flight/progress.h"
#include "tools/sheet/text.h"
#include "tools/subcommands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace linkdig::tools {
namespace {

struct ReplayOptions {
    std::string recording;
    std::string database;
    std::uint64_t from = 0;
    std::optional<std::uint64_t> frames;
    bool hashes = false;
    std::string out = "out/replay";
    std::optional<std::string> save;
    std::optional<std::string> size;
    std::string profile = "modern";
    std::uint32_t threads = 0;
};

/// Views are made for a picture of some shape: in one of another, all is squashed.
void warn_of_shape(const FramePacket& packet, const ig::Raster& raster) {
    const auto shown = std::ranges::find(packet.channels, true, &ChannelView::on);
    if (shown == packet.channels.end()) return;
    const double shape =
        (shown->right_tangent - shown->left_tangent) / (shown->top_tangent - shown->bottom_tangent);
    const double squashed = shape * raster.height / raster.width;
    constexpr double rounding = 0.01; // a picture has whole pixels
    if (std::fabs(squashed - 1.0) > rounding)
        fmt::print(stderr,
                   "linkdig: warning: the recording's views are made for pictures {:.3g} times as wide as "
                   "high, not for {} x "
                   "{} (linkdig record --size)\n",
                   shape, raster.width, raster.height);
}

void print_hashes(Replay& replay, std::uint64_t frames) {
    for (std::uint64_t i = 0; i < frames; ++i) {
        const FramePacket& packet = replay.draw();
        if (i == 0) warn_of_shape(packet, replay.configuration().raster);
        fmt::print("{} {:016x}\n", packet.frame, ig::picture_hash(replay.machine().picture(0)));
    }
}

void write_pictures(Replay& replay, std::uint64_t frames, const ReplayOptions& options) {
    require_fonts();
    const std::uint64_t first = replay.frame_number(options.from);
    const auto draw = [&](std::uint64_t frame) -> const ig::VideoFrame& {
        const FramePacket& packet = replay.draw();
        if (frame == first) warn_of_shape(packet, replay.configuration().raster);
        return replay.machine().picture(0);
    };
    write_files({.folder = options.out,
                 .name = std::filesystem::path(options.recording).stem().string(),
                 .heading = "linkdig replay: " + std::filesystem::path(options.recording).filename().string(),
                 .first = first,
                 .frames = frames},
                replay.configuration(), replay.header().update_rate_hz, draw);
}

int run(const ReplayOptions& options) {
    if (options.save) {
        require_recording_name(*options.save);
        require_other_file(*options.save, options.recording);
    }
    const ig::Configuration configuration =
        configuration_of(options.profile, options.size, std::nullopt, options.threads, false);
    Replay replay(options.recording, options.database, configuration);
    replay.skip_to(options.from);
    const std::uint64_t left = replay.packets() - options.from;
    const std::uint64_t frames = std::min(left, options.frames.value_or(left));
    if (options.save)
        replay.save_state(*options.save);
    else if (options.hashes)
        print_hashes(replay, frames);
    else
        write_pictures(replay, frames, options);
    return ExitCode::done;
}

} // namespace

void add_replay(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = app.add_subcommand("replay", "Draw the pictures of a recording");
    command->add_option("recording", options->recording, "Recording, or saved state")->required();
    command->add_option("--from", options->from, "Begin with this packet, from 0")
        ->transform(whole_number())
        ->capture_default_str();
    command->add_option("--frames", options->frames, "So many pictures; default: all that follow")
        ->check(CLI::Range(1, 10000000));
    command->add_option("--database", options->database,
                        "Database (.toml or .igdb); default: the recording's own");
    command->add_option("--out", options->out, "Folder of the files")->capture_default_str();
    command
        ->add_flag("--hashes", options->hashes,
                   "Print each picture's frame number and XXH64, and write no files")
        ->excludes("--out");
    command
        ->add_option("--save-state", options->save,
                     "Write the state before packet --from to this file, and stop")
        ->excludes("--hashes", "--frames", "--out");
    command->add_option("--size", options->size, "Picture, WIDTHxHEIGHT pixels; default: the profile's");
    command->add_option("--profile", options->profile, "Machine profile")
        ->check(CLI::IsMember({"ames", "modern"}))
        ->capture_default_str();
    command
        ->add_option("--threads", options->threads,
                     "Threads of the image generator; 0: as many as the machine has")
        ->check(CLI::Range(0, 256));
    command->footer("Example:\n  linkdig replay flight.rec --from 300 --hashes");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
