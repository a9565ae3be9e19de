/// linkdig bench: what a frame costs here, and which stage takes it.

#include "tools/bench/live.h"
#include "tools/bench/measure.h"
#include "tools/bench/sea_methods.h"
#include "tools/bench/wake_costs.h"
#include "tools/flight/number_options.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace linkdig::tools {
namespace {

struct BenchArguments {
    std::string scene = "all";
    bench::MeasureOptions measure;
    std::uint32_t triangles = 20000;
    double live_hz = 0.0;
    bool sea_methods = false;
    bool wakes = false;
    bool json = false;
};

struct StageShare {
    const char* name;
    double ms;
};

std::vector<StageShare> shares_of(const ig::StageTimes& stages) {
    return {{"active", 1e3 * stages.active_s},
            {"priority", 1e3 * stages.priority_s},
            {"geometry", 1e3 * stages.geometry_s},
            {"edges", 1e3 * (stages.edges_s + stages.lights_s + stages.bands_s)},
            {"scanline", 1e3 * stages.scanline_s},
            {"video", 1e3 * stages.video_s}};
}

nlohmann::json as_json(const std::string& scene, const bench::MeasureOptions& options,
                       const bench::Measurement& result) {
    nlohmann::json stages;
    for (const StageShare& share : shares_of(result.stages))
        stages[share.name] = share.ms;
    return {{"scene", scene},
            {"size", options.size},
            {"threads", options.threads},
            {"smoothing", options.smoothing},
            {"visibility_m", options.visibility_m},
            {"frames", options.frames},
            {"ms_median", result.median_ms},
            {"ms_min", result.least_ms},
            {"ms_max", result.greatest_ms},
            {"stages_ms", stages},
            {"faces", result.faces},
            {"edges", result.edges},
            {"segments", result.segments}};
}

void print(const std::string& scene, const bench::Measurement& result) {
    fmt::print("{:<10} {:>8.3f} {:>8.3f} {:>8.3f}", scene, result.median_ms, result.least_ms,
               result.greatest_ms);
    for (const StageShare& share : shares_of(result.stages))
        fmt::print(" {:>8.3f}", share.ms);
    fmt::print(" {:>7} {:>7} {:>8}\n", result.faces, result.edges, result.segments);
}

nlohmann::json as_json(const std::string& scene, const bench::MeasureOptions& options,
                       const bench::LiveTimes& live) {
    return {{"scene", scene},
            {"size", options.size},
            {"threads", options.threads},
            {"smoothing", options.smoothing},
            {"visibility_m", options.visibility_m},
            {"rate_hz", live.rate_hz},
            {"frames", live.frames},
            {"ms_p50", live.p50_ms},
            {"ms_p99", live.p99_ms},
            {"ms_p999", live.p999_ms},
            {"ms_max", live.greatest_ms},
            {"overruns", live.overruns}};
}

bench::Scene scene_of(const BenchArguments& arguments, const std::string& name) {
    return name == "dense" ? bench::dense_scene(arguments.triangles) : bench::make_scene(name);
}

int run_live(const BenchArguments& arguments, const std::vector<std::string>& scenes) {
    nlohmann::json results = nlohmann::json::array();
    for (const std::string& name : scenes) {
        const bench::LiveTimes live =
            bench::measure_live(scene_of(arguments, name), arguments.measure, arguments.live_hz);
        if (arguments.json) {
            results.push_back(as_json(name, arguments.measure, live));
        } else {
            fmt::print(
                "{}: {} frames at {} Hz: p50 {:.3f} ms, p99 {:.3f} ms, p99.9 {:.3f} ms, longest {:.3f} ms, "
                "{} overruns\n",
                name, live.frames, live.rate_hz, live.p50_ms, live.p99_ms, live.p999_ms, live.greatest_ms,
                live.overruns);
        }
    }
    if (arguments.json) fmt::print("{}\n", results.dump(2));
    return ExitCode::done;
}

int run_sea_methods(const BenchArguments& arguments) {
    const bench::SeaMethodCosts costs =
        bench::compare_sea_methods(arguments.measure.size, arguments.measure.frames);
    if (arguments.json) {
        const auto method = [&](std::string_view name, std::uint64_t values, double host_ms,
                                double machine_ms) {
            return nlohmann::json{{"moved_by", name},
                                  {"values", values},
                                  {"host_ms", host_ms},
                                  {"machine_ms", machine_ms},
                                  {"greatest_difference", costs.greatest_difference}};
        };
        const nlohmann::json results = {
            method("sun", 1, costs.sun_host_ms, costs.sun_machine_ms),
            method("normals", costs.normals, costs.normals_host_ms, costs.normals_machine_ms)};
        fmt::print("{}\n", results.dump(2));
    } else {
        fmt::print("the sea moved by     host ms  machine ms\n"
                   "one sun vector   {:>11.4f} {:>11.3f}\n"
                   "{:>5} normals    {:>11.4f} {:>11.3f}\n"
                   "the pictures differ by at most {} level(s)\n",
                   costs.sun_host_ms, costs.sun_machine_ms, costs.normals, costs.normals_host_ms,
                   costs.normals_machine_ms, costs.greatest_difference);
    }
    return costs.greatest_difference <= 1 ? ExitCode::done : ExitCode::differs;
}

int run_wakes(const BenchArguments& arguments) {
    const std::vector<bench::WakeCost> costs =
        bench::compare_wakes(arguments.measure.size, arguments.measure.threads, arguments.measure.smoothing,
                             arguments.measure.frames);
    if (arguments.json) {
        nlohmann::json results = nlohmann::json::array();
        for (const bench::WakeCost& cost : costs)
            results.push_back({{"wakes", cost.made},
                               {"wake_faces", cost.faces},
                               {"particles", cost.particles},
                               {"edges", cost.edges},
                               {"making_ms", cost.making_ms},
                               {"frame_ms", cost.frame_ms}});
        fmt::print("{}\n", results.dump(2));
        return ExitCode::done;
    }
    fmt::print("{:<16} {:>10} {:>10} {:>8} {:>10} {:>9}\n", "wakes", "wake faces", "particles", "edges",
               "making ms", "frame ms");
    for (const bench::WakeCost& cost : costs)
        fmt::print("{:<16} {:>10} {:>10} {:>8} {:>10.3f} {:>9.3f}\n", cost.made, cost.faces, cost.particles,
                   cost.edges, cost.making_ms, cost.frame_ms);
    return ExitCode::done;
}

int run(const BenchArguments& arguments) {
    if (arguments.wakes) return run_wakes(arguments);
    if (arguments.sea_methods) return run_sea_methods(arguments);
    const std::vector<std::string> scenes =
        arguments.scene == "all" ? bench::scene_names() : std::vector<std::string>{arguments.scene};
    if (arguments.live_hz > 0.0) return run_live(arguments, scenes);
    nlohmann::json results = nlohmann::json::array();
    if (!arguments.json)
        fmt::print(
            "milliseconds of a frame of {0} x {0}, {1} thread(s), smoothing {2}\n{3:<10} {4:>8} {5:>8} {6:>8}"
            " {7:>8} {8:>8} {9:>8} {10:>8} {11:>8} {12:>8} {13:>7} {14:>7} {15:>8}\n",
            arguments.measure.size, arguments.measure.threads, arguments.measure.smoothing ? "on" : "off",
            "scene", "median", "min", "max", "active", "priority", "geometry", "edges", "scanline", "video",
            "faces", "edges", "segments");
    for (const std::string& name : scenes) {
        const bench::Measurement result = bench::measure(scene_of(arguments, name), arguments.measure);
        if (arguments.json) {
            results.push_back(as_json(name, arguments.measure, result));
        } else {
            print(name, result);
        }
    }
    if (arguments.json) {
        fmt::print("{}\n", results.dump(2));
    } else {
        fmt::print("filling such a frame with one value: {:.3f} ms\n",
                   bench::fill_ms(std::size_t{arguments.measure.size} * arguments.measure.size));
    }
    return ExitCode::done;
}

} // namespace

void add_bench(CLI::App& app, int& exit_code) {
    auto arguments = std::make_shared<BenchArguments>();
    CLI::App* command = app.add_subcommand("bench", "Measure what a frame costs, stage by stage");
    std::vector<std::string> scenes = bench::scene_names();
    scenes.emplace_back("all");
    command->add_option("--scene", arguments->scene, "What to draw")
        ->check(CLI::IsMember(scenes))
        ->capture_default_str();
    command->add_option("--size", arguments->measure.size, "Width of the picture, pixels")
        ->check(CLI::Range(16, 4096))
        ->capture_default_str();
    command
        ->add_option("--threads", arguments->measure.threads,
                     "Threads that draw; 0: as many as the machine has")
        ->check(CLI::Range(0, 256))
        ->capture_default_str();
    command->add_option("--frames", arguments->measure.frames, "Frames to measure")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command
        ->add_option("--triangles", arguments->triangles,
                     "Triangles of the scene dense, at constant coverage")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command
        ->add_option("--channels", arguments->measure.channels,
                     "Views of the scene, side by side; 0: as many as the scene has")
        ->check(CLI::Range(0, 8))
        ->capture_default_str();
    command->add_flag("--smoothing", arguments->measure.smoothing, "Smooth the edges");
    command->add_option("--visibility", arguments->measure.visibility_m, "Visibility, metres; 0: unlimited")
        ->check(finite_number(0.0, 1e6))
        ->capture_default_str();
    command
        ->add_option("--live", arguments->live_hz,
                     "Frames at this rate, Hz, as a host sends them: quantiles of their times, and overruns")
        ->check(finite_number(1.0, 1000.0));
    // Both fly a scenario of their own, and how the sea is moved is measured on one thread.
    command
        ->add_flag("--sea-methods", arguments->sea_methods,
                   "The sea moved by one sun vector against all vertex normals (report, 3.1.4)")
        ->excludes("--live", "--scene", "--triangles", "--channels", "--visibility", "--threads",
                   "--smoothing");
    command
        ->add_flag("--wakes", arguments->wakes,
                   "Two ships' figure of eight with and without the wakes that the machine makes")
        ->excludes("--sea-methods", "--live", "--scene", "--triangles", "--channels", "--visibility");
    command->add_flag("--json", arguments->json, "Print a list of objects");
    command->footer(
        "Frames are measured whole: packet in, pixels in memory. The share of scanline and video is summed\n"
        "over threads. tools/bench.sh sets the same frames against another renderer.\n"
        "Example:\n  linkdig bench --scene sea --size 2048 --threads 2 --smoothing");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

} // namespace linkdig::tools
