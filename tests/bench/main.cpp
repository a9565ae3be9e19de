// Draws the same frames with linkdig and with the peer, in turns of a few frames, and prints the ratios of their times.
//
//   bench_peer THREADS SIZE ROUNDS SCENE...     a JSON list of rows on standard output
//
// The peer's threads come from LP_NUM_THREADS, which must be set before it starts: tools/bench.sh does.

#include "ig/machine/machine.h"
#include "tests/bench/peer.h"
#include "tools/bench/measure.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>

namespace linkdig::bench {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Frames of one side before it is the other's turn: a renderer draws frame after frame, and one whose caches the other
/// has emptied before each is measured by the other's size.
constexpr std::uint32_t turn_frames = 4;

/// Calls ours(frame) and theirs(frame) in turns of frames; `took` has both times of each frame, milliseconds. The first turns
/// of both warm up.
template <typename Ours, typename Theirs, typename Took>
void in_turns(std::uint32_t rounds, const Ours& ours, const Theirs& theirs, const Took& took) {
    for (std::uint32_t round = 0; round < rounds + 1; ++round) {
        std::array<double, turn_frames> ours_ms{}, theirs_ms{};
        const auto measured = [round](const auto& draw, auto& ms) {
            for (std::uint32_t k = 0; k < turn_frames; ++k) {
                const Clock::time_point begin = Clock::now();
                draw(round * turn_frames + k);
                ms[k] = ms_since(begin);
            }
        };
        measured(ours, ours_ms);
        measured(theirs, theirs_ms);
        for (std::uint32_t k = 0; round > 0 && k < turn_frames; ++k)
            took(ours_ms[k], theirs_ms[k]);
    }
}

/// Mean difference of the two pictures, levels: a check that both draw the same thing.
double difference(const ig::VideoFrame& ours, const std::vector<std::uint32_t>& theirs) {
    std::uint64_t sum = 0;
    for (std::uint32_t row = 0; row < ours.height; ++row) {
        for (std::uint32_t column = 0; column < ours.width; ++column) {
            const std::uint32_t a = ours.pixels[std::size_t{row} * ours.width + column];
            const std::uint32_t b = theirs[std::size_t{ours.height - 1 - row} * ours.width + column];
            for (std::uint32_t shift = 0; shift < 24; shift += 8) {
                const auto x = static_cast<std::int32_t>(a >> shift & 255U);
                const auto y = static_cast<std::int32_t>(b >> shift & 255U);
                sum += static_cast<std::uint64_t>(std::abs(x - y));
            }
        }
    }
    return static_cast<double>(sum) / (3.0 * static_cast<double>(ours.pixels.size()));
}

struct Contest {
    std::string peer;
    double difference = 0.0;
    std::vector<double> ours_ms, theirs_ms;
};

/// A second of the scene.
std::vector<FramePacket> packets_of(const Scene& scene) {
    std::vector<FramePacket> packets;
    for (std::uint64_t frame = 0; frame < 30; ++frame)
        packets.push_back(scene.packet(frame));
    return packets;
}

/// One way of drawing a scene, turn by turn.
Contest contest(const Scene& scene, const MeasureOptions& options, bool depth_test, std::uint32_t rounds) {
    const ig::Configuration configuration = configuration_of(scene, options);
    ig::Machine machine(scene.database, configuration);
    Peer peer(configuration.raster.width, configuration.raster.height, depth_test);
    const std::vector<FramePacket> packets = packets_of(scene);
    const FramePacket& first = packets.front();
    for (std::size_t channel = 0; channel < first.channels.size(); ++channel)
        peer.add(world_faces(scene.database, first, channel));
    Contest result;
    result.peer = peer.renderer();
    const std::vector<std::uint32_t>* read = nullptr;
    in_turns(
        rounds, [&](std::uint32_t frame) { machine.frame(packets[frame % packets.size()]); },
        [&](std::uint32_t frame) {
            const FramePacket& packet = packets[frame % packets.size()];
            for (std::size_t channel = 0; channel < packet.channels.size(); ++channel)
                read = &peer.draw(packet, channel);
        },
        [&](double ours_ms, double theirs_ms) {
            result.ours_ms.push_back(ours_ms);
            result.theirs_ms.push_back(theirs_ms);
        });
    // Both ended with the same frame.
    if (!options.smoothing) result.difference = difference(machine.picture(first.channels.size() - 1), *read);
    return result;
}

nlohmann::json row(const std::string& scene, const MeasureOptions& options, const std::string& peer,
                   const std::vector<double>& ours_ms, const std::vector<double>& theirs_ms) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < ours_ms.size(); ++k)
        ratios.push_back(theirs_ms[k] / ours_ms[k]);
    const auto [least, greatest] = std::ranges::minmax(ratios);
    return {{"scene", scene},
            {"size", options.size},
            {"threads", options.threads},
            {"smoothing", options.smoothing},
            {"peer", peer},
            {"ratio_median", median(ratios)},
            {"ratio_min", least},
            {"ratio_max", greatest},
            {"linkdig_ms", median(ours_ms)},
            {"peer_ms", median(theirs_ms)},
            {"linkdig_best_ms", *std::ranges::min_element(ours_ms)},
            {"peer_best_ms", *std::ranges::min_element(theirs_ms)}};
}

/// Our own time with smoothing or in haze against that without, turn by turn; the ratio is without / with.
nlohmann::json own_row(const Scene& scene, const MeasureOptions& plain, const MeasureOptions& dear,
                       const std::string& name, std::uint32_t rounds) {
    ig::Machine plain_machine(scene.database, configuration_of(scene, plain));
    ig::Machine dear_machine(scene.database, configuration_of(scene, dear));
    std::vector<double> plain_ms, dear_ms;
    const std::vector<FramePacket> packets = packets_of(scene);
    std::vector<FramePacket> hazy = packets;
    for (FramePacket& packet : hazy)
        packet.visibility_m = static_cast<float>(dear.visibility_m);
    in_turns(
        rounds, [&](std::uint32_t frame) { plain_machine.frame(packets[frame % packets.size()]); },
        [&](std::uint32_t frame) { dear_machine.frame(hazy[frame % hazy.size()]); },
        [&](double without_ms, double with_ms) {
            plain_ms.push_back(without_ms);
            dear_ms.push_back(with_ms);
        });
    return row(scene.name, dear, name, dear_ms, plain_ms);
}

void run(const std::string& name, MeasureOptions options, std::uint32_t rounds, nlohmann::json& rows) {
    const Scene scene = make_scene(name);
    for (const bool depth_test : {false, true}) {
        const Contest result = contest(scene, options, depth_test, rounds);
        nlohmann::json made = row(name, options, depth_test ? "llvmpipe, depth test" : "llvmpipe",
                                  result.ours_ms, result.theirs_ms);
        made["renderer"] = result.peer;
        made["mean_difference"] = result.difference;
        rows.push_back(made);
    }
    MeasureOptions smooth = options;
    smooth.smoothing = true;
    rows.push_back(own_row(scene, options, smooth, "itself, edges not smoothed", rounds));
    MeasureOptions haze = options;
    haze.visibility_m = 5000.0;
    rows.push_back(own_row(scene, options, haze, "itself, visibility unlimited", rounds));
}

} // namespace
} // namespace linkdig::bench

int main(int argc, char** argv) {
    if (argc < 5) {
        fmt::print(stderr, "usage: bench_peer THREADS SIZE ROUNDS SCENE...\n");
        return 2;
    }
    try {
        linkdig::bench::MeasureOptions options;
        options.threads = static_cast<std::uint32_t>(std::stoul(argv[1]));
        options.size = static_cast<std::uint32_t>(std::stoul(argv[2]));
        const auto rounds = static_cast<std::uint32_t>(std::stoul(argv[3]));
        nlohmann::json rows = nlohmann::json::array();
        for (int k = 4; k < argc; ++k)
            linkdig::bench::run(argv[k], options, rounds, rows);
        fmt::print("{}\n", rows.dump(2));
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_peer: error: {}\n", error.what());
        return 3;
    }
    return 0;
}
