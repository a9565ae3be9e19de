/// linkdig why: which face won a pixel, by which planes, and how it got its colour.

#include "database/model/mathematics.h"
#include "ig/geometry/projected_face.h"
#include "tools/flight/arguments.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/flight.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace linkdig::tools {
namespace {

using Json = nlohmann::ordered_json;

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

constexpr const char* tree_names[] = {"group", "cluster", "list"};
constexpr const char* side_names[] = {"front", "on", "back"};
constexpr const char* shading_names[] = {"unshaded", "face", "vertex"};

double unit(std::int32_t intensity) { return intensity / static_cast<double>(ig::intensity_one); }

double cosine_of(const ig::Layer& layer) {
    return static_cast<double>(layer.normal.x) * layer.sun.x +
           static_cast<double>(layer.normal.y) * layer.sun.y +
           static_cast<double>(layer.normal.z) * layer.sun.z;
}

Json numbers(const Vec3f& v) { return Json::array({v.x, v.y, v.z}); }

Json plane_json(const ig::PlaneTaken& plane) {
    return {{"tree", tree_names[static_cast<int>(plane.tree)]},
            {"normal", numbers(plane.normal)},
            {"distance_m", plane.distance_m},
            {"eye_distance_m", plane.eye_distance_m},
            {"eye", plane.eye_in_front ? "front" : "back"},
            {"face", side_names[static_cast<int>(plane.side)]}};
}

Json layer_json(const VisualDatabase& database, const ig::Layer& layer) {
    Json json{{"rank", layer.rank},
              {"list", database.lists[layer.list].name},
              {"object", database.objects[layer.object].name},
              {"cluster", database.clusters[layer.cluster].name},
              {"group_number", layer.group_number},
              {"list_number", layer.list_number},
              {"file", database.source_files[layer.file]},
              {"line", layer.line},
              {"colour", database.colour_names[layer.colour]},
              {"shading", shading_names[static_cast<int>(layer.shading)]},
              {"intensity", unit(layer.intensity)},
              {"ambient", layer.ambient},
              {"diffuse", layer.diffuse},
              {"sun", numbers(layer.sun)},
              {"normal", numbers(layer.normal)}};
    if (layer.smooth) {
        json["corner_intensities"] =
            Json::array({unit(layer.corner_intensity[0]), unit(layer.corner_intensity[1]),
                         unit(layer.corner_intensity[2])});
    }
    if (layer.coloured)
        json["tint"] = Json::array({unit(layer.tint[0]), unit(layer.tint[1]), unit(layer.tint[2])});
    if (layer.level != none) {
        const DetailLevel& level = database.detail_levels[static_cast<std::size_t>(layer.level)];
        const Detail& detail = database.details[level.detail];
        json["detail"] = detail.name;
        json["level"] = static_cast<std::uint32_t>(layer.level) - detail.first_level;
        json["level_opacity"] = layer.level_opacity / 256.0;
    }
    json["planes"] = Json::array();
    for (const ig::PlaneTaken& plane : layer.planes)
        json["planes"].push_back(plane_json(plane));
    return json;
}

std::string place(const VisualDatabase& database, const ig::Layer& layer) {
    return fmt::format("{}, object \"{}\" ({}:{})", database.lists[layer.list].name,
                       database.objects[layer.object].name, database.source_files[layer.file], layer.line);
}

void print_priority(const VisualDatabase& database, const ig::Layer& layer) {
    fmt::print("priority  group {}, cluster {}, number {} in it, rank {}\n", layer.group_number,
               database.clusters[layer.cluster].name, layer.list_number, layer.rank);
    for (const ig::PlaneTaken& plane : layer.planes) {
        if (plane.normal == Vec3f(0)) {
            fmt::print("          {} tree: fixed order, the face stands {}\n",
                       tree_names[static_cast<int>(plane.tree)],
                       plane.side == ig::PlaneTaken::Side::front ? "first" : "later");
            continue;
        }
        fmt::print("          {} tree: plane ({:.3f} {:.3f} {:.3f}) at {:.3f} m; the eye is {:.2f} m {} it, "
                   "the face {}\n",
                   tree_names[static_cast<int>(plane.tree)], plane.normal.x, plane.normal.y, plane.normal.z,
                   plane.distance_m, std::fabs(plane.eye_distance_m),
                   plane.eye_in_front ? "in front of" : "behind", side_names[static_cast<int>(plane.side)]);
    }
}

void print_intensity(const VisualDatabase& database, const ig::Layer& layer) {
    const Colour code = database.colours[layer.colour];
    if (layer.coloured) {
        fmt::print("colour    ({:.1f} {:.1f} {:.1f}), between those of its corners, each x intensity\n",
                   255 * unit(layer.tint[0]), 255 * unit(layer.tint[1]), 255 * unit(layer.tint[2]));
        return;
    }
    if (layer.smooth) {
        fmt::print("intensity {:.4f}, between corners of {:.4f}, {:.4f} and {:.4f}\n", unit(layer.intensity),
                   unit(layer.corner_intensity[0]), unit(layer.corner_intensity[1]),
                   unit(layer.corner_intensity[2]));
        fmt::print("          each corner: {:.3f} + {:.3f} max(0, n.s), s = ({:.3f} {:.3f} {:.3f})\n",
                   layer.ambient, layer.diffuse, layer.sun.x, layer.sun.y, layer.sun.z);
    } else if (layer.shading == Shading::face) {
        fmt::print("intensity {:.4f} = {:.3f} + {:.3f} max(0, {:.4f}), n = ({:.3f} {:.3f} {:.3f}), s = "
                   "({:.3f} {:.3f} "
                   "{:.3f})\n",
                   unit(layer.intensity), layer.ambient, layer.diffuse, cosine_of(layer), layer.normal.x,
                   layer.normal.y, layer.normal.z, layer.sun.x, layer.sun.y, layer.sun.z);
    } else {
        fmt::print("intensity {:.4f}, the same at every corner\n", unit(layer.intensity));
    }
    fmt::print("colour    {} ({} {} {}) x intensity\n", database.colour_names[layer.colour], code.red,
               code.green, code.blue);
}

void print_level(const VisualDatabase& database, const ig::Layer& layer) {
    if (layer.level == none) return;
    const DetailLevel& level = database.detail_levels[static_cast<std::size_t>(layer.level)];
    const Detail& detail = database.details[level.detail];
    fmt::print("detail    level {} of {}, to {:.6g} m, seen by {:.0f} %\n",
               static_cast<std::uint32_t>(layer.level) - detail.first_level, detail.name, level.to_m,
               layer.level_opacity / 2.56);
}

void print_text(const VisualDatabase& database, std::uint32_t pixel, const std::vector<ig::Layer>& layers) {
    fmt::print("pixel     ({} {} {})\n", pixel & 0xffU, pixel >> 8U & 0xffU, pixel >> 16U & 0xffU);
    if (layers.empty()) {
        fmt::print("seen      the background: no face covers the pixel's centre\n");
        return;
    }
    fmt::print("seen      {}\n", place(database, layers.front()));
    print_priority(database, layers.front());
    print_level(database, layers.front());
    print_intensity(database, layers.front());
    for (std::size_t k = 1; k < layers.size(); ++k) {
        fmt::print("{} {}\n", k == 1 ? "behind it" : "         ", place(database, layers[k]));
    }
}

/// COLUMN,ROW from the upper left corner.
void parse_pixel(const std::string& text, const ig::VideoFrame& picture, std::uint32_t& column,
                 std::uint32_t& row) {
    int used = 0;
    const bool read = std::sscanf(text.c_str(), "%u,%u%n", &column, &row, &used) == 2 &&
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
    flight.draw(options.frame, {});
    const ig::VideoFrame& picture = flight.machine().picture(options.channel);
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    parse_pixel(options.at, picture, column, row);
    const std::uint32_t pixel = picture.pixels[std::size_t{row} * picture.width + column];
    const std::vector<ig::Layer> layers = flight.machine().explain(options.channel, column, row);
    if (!options.json) {
        print_text(flight.database(), pixel, layers);
        return ExitCode::done;
    }
    Json json{{"frame", options.frame},
              {"channel", options.channel},
              {"at", Json::array({column, row})},
              {"pixel", Json::array({pixel & 0xffU, pixel >> 8U & 0xffU, pixel >> 16U & 0xffU})},
              {"layers", Json::array()}};
    for (const ig::Layer& layer : layers)
        json["layers"].push_back(layer_json(flight.database(), layer));
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
}

} // namespace

void add_why(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<WhyOptions>();
    CLI::App* why = app.add_subcommand("why", "Tell why a pixel looks as it does");
    why->add_option("scenario", options->scenario, "Scenario file (.toml)")->required();
    why->add_option("--frame", options->frame, "Frame of the scenario")->capture_default_str();
    why->add_option("--at", options->at, "COLUMN,ROW of the pixel, from the upper left corner")->required();
    why->add_option("--channel", options->channel, "Channel of the scenario, from 0")->capture_default_str();
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
        "the arithmetic of its intensity, and what lies behind it in order.\n"
        "Example:\n  linkdig why database/scenes/first_flight/approach.toml --frame 300 --at 512,600");
    why->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace linkdig::tools
