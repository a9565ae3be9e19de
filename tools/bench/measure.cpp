#include "tools/bench/measure.h"

#include "database/model/mathematics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <stdexcept>

namespace linkdig::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t warm_up_frames = 5;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

constexpr double ig::StageTimes::*stages[] = {&ig::StageTimes::active_s,   &ig::StageTimes::priority_s,
                                              &ig::StageTimes::geometry_s, &ig::StageTimes::edges_s,
                                              &ig::StageTimes::lights_s,   &ig::StageTimes::bands_s,
                                              &ig::StageTimes::scanline_s, &ig::StageTimes::video_s};

void add(const ig::StageTimes& frame, double part, ig::StageTimes& sum) {
    for (double ig::StageTimes::*stage : stages)
        sum.*stage += frame.*stage * part;
}

void count(const FrameReport& report, Measurement& result) {
    for (const ChannelReport& channel : report.channels) {
        result.faces += channel.faces_projected;
        result.edges += channel.edges;
        result.segments += channel.segments;
    }
}

} // namespace

ig::Configuration configuration_of(const Scene& scene, const MeasureOptions& options) {
    ig::Configuration configuration = scene.vertical_scan ? ig::ames_profile() : ig::modern_profile();
    configuration.raster.width = options.size;
    configuration.raster.height = scene.vertical_scan ? options.size * 3 / 4 : options.size;
    configuration.threads = options.threads;
    configuration.edge_smoothing = options.smoothing;
    return configuration;
}

FramePacket packet_of(const Scene& scene, const MeasureOptions& options, std::uint64_t frame) {
    FramePacket packet = scene.packet(frame);
    packet.visibility_m = static_cast<float>(options.visibility_m);
    if (options.channels == 0) return packet;
    packet.channels.resize(options.channels, packet.channels.front());
    for (std::size_t k = 1; k < packet.channels.size(); ++k)
        packet.channels[k].attitude.heading_rad = packet.channels[k - 1].attitude.heading_rad + 0.25 * pi;
    return packet;
}

const FrameReport& drawn(ig::Machine& machine, const FramePacket& packet) {
    const FrameReport& report = machine.frame(packet);
    if (!report.errors.empty())
        throw std::runtime_error(
            fmt::format("bench: frame {} was refused: {}", packet.frame, fmt::join(report.errors, "; ")));
    return report;
}

Measurement measure(const Scene& scene, const MeasureOptions& options) {
    ig::Machine machine(scene.database, configuration_of(scene, options));
    machine.measure_stages(true);
    Measurement result;
    std::vector<double> times_ms;
    for (std::uint32_t frame = 0; frame < warm_up_frames + options.frames; ++frame) {
        const FramePacket packet = packet_of(scene, options, frame);
        const Clock::time_point begin = Clock::now();
        const FrameReport& report = drawn(machine, packet);
        const double taken_ms = ms_since(begin);
        if (frame < warm_up_frames) continue;
        times_ms.push_back(taken_ms);
        add(machine.stage_times(), 1.0 / options.frames, result.stages);
        if (times_ms.size() == options.frames) count(report, result);
    }
    result.median_ms = median(times_ms);
    const auto [least, greatest] = std::ranges::minmax(times_ms);
    result.least_ms = least;
    result.greatest_ms = greatest;
    return result;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

double fill_ms(std::size_t pixels) {
    std::vector<std::uint32_t> frame(pixels);
    std::vector<double> times_ms;
    for (int round = 0; round < 21; ++round) {
        const Clock::time_point begin = Clock::now();
        std::memset(frame.data(), round, pixels * sizeof(std::uint32_t));
        times_ms.push_back(ms_since(begin));
        if (frame[static_cast<std::size_t>(round) % pixels] == 1)
            times_ms.back() = 0.0; // keeps the fill alive
    }
    return median(times_ms);
}

} // namespace linkdig::bench
