/// linkdig wake: the field of a wake specification.

#include "database/compiler/wake_spec.h"
#include "ig/sink/image_file.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/output_name.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace linkdig::tools {
namespace {

using database::KelvinCount;
using database::WakeFieldResult;
using database::WakeSpec;
using database::WaveField;

struct WakeOptions {
    std::string spec;
    std::string output;
    bool png = false;
    bool json = false;
    std::optional<std::uint32_t> size;
};

/// The first row of a picture is that of greatest y.
std::vector<float> from_top(const WaveField& field) {
    std::vector<float> values;
    values.reserve(field.heights.size());
    for (std::size_t row = field.size; row-- > 0;)
        values.insert(values.end(), field.heights.begin() + static_cast<std::ptrdiff_t>(row * field.size),
                      field.heights.begin() + static_cast<std::ptrdiff_t>((row + 1) * field.size));
    return values;
}

void write_grey(const WaveField& field, const std::string& path) {
    ig::VideoFrame picture;
    picture.width = picture.height = field.size;
    for (const std::uint32_t grey : database::grey_image(field))
        picture.pixels.push_back(grey | grey << 8U | grey << 16U);
    ig::write_png(path, picture);
}

void tell(const WakeOptions& options, const WakeSpec& spec, const WakeFieldResult& made, double seconds) {
    std::uint64_t samples = 0;
    for (const KelvinCount& count : made.kelvin.swimmers)
        samples += count.drawn;
    if (options.json) {
        nlohmann::ordered_json swimmers = nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < spec.wakes.swimmers.size(); ++i)
            swimmers.push_back({{"name", spec.wakes.swimmers[i].name},
                                {"samples", made.kelvin.swimmers[i].samples},
                                {"drawn", made.kelvin.swimmers[i].drawn},
                                {"outside", made.kelvin.swimmers[i].outside}});
        fmt::print("{}\n", nlohmann::ordered_json{{"field", options.output},
                                                  {"cells", made.kelvin.field.size},
                                                  {"side_m", spec.wakes.side},
                                                  {"rms", made.rms},
                                                  {"rogues", made.rogues},
                                                  {"rogues_left", made.rogues_left},
                                                  {"samples", samples},
                                                  {"seconds", seconds},
                                                  {"swimmers", swimmers}}
                               .dump(2));
        return;
    }
    fmt::print("{}: {} x {} cells, {:g} m a side, {} swimmers\n", options.output, made.kelvin.field.size,
               made.kelvin.field.size, spec.wakes.side, spec.wakes.swimmers.size());
    fmt::print("{:.1f} million samples in {:.2f} s: {:.0f} million a second\n",
               1e-6 * static_cast<double>(samples), seconds, 1e-6 * static_cast<double>(samples) / seconds);
    fmt::print("rms {:.4g}; rogue cells: {}", made.rms, made.rogues);
    if (spec.smoothing_passes > 0)
        fmt::print(", after {} smoothing passes {}", spec.smoothing_passes, made.rogues_left);
    fmt::print("\n");
}

/// A path may leave the grid, and waves may be too short for it: that is no mistake, but whoever wrote the file should know.
void warn_of_what_is_missing(const WakeSpec& spec, const WakeFieldResult& made) {
    for (std::size_t i = 0; i < spec.wakes.swimmers.size(); ++i) {
        const KelvinCount& count = made.kelvin.swimmers[i];
        constexpr double whole_from = 4.0; // database/water/kelvin_wake.h
        if (spec.wakes.sampling != database::KelvinSampling::column && count.longest_cells < whole_from)
            fmt::print(stderr,
                       "linkdig: warning: the longest waves of \"{}\" are {:.2g} cells long; waves under two "
                       "cells are left "
                       "out, and up to four they fade in\n",
                       spec.wakes.swimmers[i].name, count.longest_cells);
        if (count.drawn == 0) continue;
        const double share = 100.0 * static_cast<double>(count.outside) / static_cast<double>(count.drawn);
        if (share > 0.005)
            fmt::print(
                stderr,
                "linkdig: warning: {:.2f} % of the wake of \"{}\" lies beyond the field and is left out\n",
                share, spec.wakes.swimmers[i].name);
    }
}

int wake(const WakeOptions& options) {
    require_ending(options.output, "an OpenEXR file", {".exr"});
    database::Diagnostics diagnostics;
    std::optional<WakeSpec> spec = database::read_wake_spec(options.spec, diagnostics);
    if (!spec) throw BadInput(diagnostics.text());
    if (options.size) {
        // As many psi a metre as before for each cell.
        spec->wakes.psi_per_unit *= static_cast<double>(*options.size) / spec->wakes.size;
        spec->wakes.size = *options.size;
    }
    const auto begin = std::chrono::steady_clock::now();
    const WakeFieldResult made = database::wake_field(*spec);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const WaveField& field = made.kelvin.field;
    ig::write_exr(options.output, field.size, field.size, from_top(field));
    if (options.png)
        write_grey(field, std::filesystem::path(options.output).replace_extension(".png").string());
    warn_of_what_is_missing(*spec, made);
    tell(options, *spec, made, seconds);
    return ExitCode::done;
}

} // namespace

void add_wake(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<WakeOptions>();
    CLI::App* command =
        app.add_subcommand("wake", "Sum the Kelvin wakes of swimmers into a field of heights");
    command->add_option("spec", options->spec, "Wake specification (.toml)")->required();
    command->add_option("-o,--output", options->output, "Field to write (.exr, 32-bit floats)")->required();
    command->add_flag("--png", options->png,
                      "Write a grey image beside it, least height black, greatest white");
    command->add_option("--size", options->size, "Cells a side; default: the specification's")
        ->check(CLI::Range(4, 8192));
    command->add_flag("--json", options->json, "Print the figures as JSON");
    command->footer("Example:\n  linkdig wake database/scenes/wakes/kelvin/figure22.toml -o star.exr --png");
    command->callback([options, &exit_code] { exit_code = wake(*options); });
}

} // namespace linkdig::tools
