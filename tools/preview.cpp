/// linkdig preview: a contact sheet of what stands in a database, and a film that goes round it.

#include "tools/preview/preview.h"
#include "ig/machine/machine.h"
#include "tools/film/film.h"
#include "tools/flight/arguments.h"
#include "tools/flight/open_database.h"
#include "tools/flight/output_name.h"
#include "tools/flight/progress.h"
#include "tools/sheet/contact_sheet.h"
#include "tools/sheet/text.h"
#include "tools/subcommands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

namespace linkdig::tools {

namespace {

struct PreviewOptions {
    std::string database;
    std::string output;
    std::string turntable;
    std::string size = "480x320";
    std::uint32_t threads = 0;
};

constexpr std::uint32_t turn_frames = 180; ///< one round of a subject, six seconds
constexpr std::uint32_t turn_rate_hz = 30;

class Previewer {
public:
    Previewer(const VisualDatabase& database, const ig::Configuration& configuration)
        : database_(database),
          aspect_(static_cast<double>(configuration.raster.width) / configuration.raster.height),
          machine_(database, configuration) {}

    const ig::VideoFrame& picture(const PreviewSubject& subject, const PreviewView& view) {
        const FrameReport& report = machine_.frame(preview_packet(database_, subject, view, aspect_));
        if (!report.errors.empty())
            throw std::logic_error(
                fmt::format("the preview was refused: {}", fmt::join(report.errors, "; ")));
        edges_ = report.channels.front().edges;
        return machine_.picture(0);
    }
    std::uint64_t edges() const { return edges_; } ///< of the last picture

private:
    const VisualDatabase& database_;
    double aspect_;
    ig::Machine machine_;
    std::uint64_t edges_ = 0;
};

void write_sheet(const PreviewOptions& options, const OpenedDatabase& opened,
                 const std::vector<PreviewSubject>& subjects, const ig::Raster& raster,
                 Previewer& previewer) {
    ContactSheet sheet(fmt::format("{}: {} faces in {} lists", opened.database.name,
                                   opened.database.faces.size(), opened.database.lists.size()),
                       raster.width, raster.height, static_cast<std::uint32_t>(subjects.size()));
    for (std::uint32_t row = 0; row < subjects.size(); ++row)
        for (std::uint32_t column = 0; column < preview_views; ++column) {
            const PreviewView view = preview_view(column);
            const ig::VideoFrame& picture = previewer.picture(subjects[row], view);
            sheet.place(row * sheet_columns + column, picture,
                        fmt::format("{}: {}, {} edges", subjects[row].name, view.name, previewer.edges()));
        }
    sheet.write(options.output);
}

void write_turntable(const PreviewOptions& options, const std::vector<PreviewSubject>& subjects,
                     const ig::Raster& raster, Previewer& previewer) {
    Film film(options.turntable, raster.width, raster.height, turn_rate_hz);
    Progress progress(stderr_is_terminal(), turn_frames * subjects.size());
    std::uint64_t done_frames = 0;
    for (const PreviewSubject& subject : subjects)
        for (std::uint32_t frame = 0; frame < turn_frames; ++frame) {
            film.add(previewer.picture(subject, {"", 40.0 + 360.0 * frame / turn_frames, 14.0}));
            progress.at(++done_frames);
        }
    progress.finish();
    film.finish();
}

int preview(const PreviewOptions& options) {
    require_ending(options.output, "a PNG picture", {".png"});
    if (!options.turntable.empty()) require_ending(options.turntable, "an MP4 film", {".mp4"});
    const ig::Configuration configuration =
        configuration_of("modern", options.size, std::nullopt, options.threads, false);
    require_fonts();
    const OpenedDatabase opened = open_database(options.database);
    const std::vector<PreviewSubject> subjects = preview_subjects(opened.database);
    if (subjects.empty()) {
        fmt::print(stderr, "linkdig: error: {}: nothing in it has faces; expected something to look at\n",
                   options.database);
        return ExitCode::bad_input;
    }
    Previewer previewer(opened.database, configuration);
    write_sheet(options, opened, subjects, configuration.raster, previewer);
    if (!options.turntable.empty()) write_turntable(options, subjects, configuration.raster, previewer);
    fmt::print("{}: {} views of {} subjects\n", options.output, preview_views * subjects.size(),
               subjects.size());
    return ExitCode::done;
}

} // namespace

void add_preview(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<PreviewOptions>();
    CLI::App* command =
        app.add_subcommand("preview", "Draw a contact sheet of what stands in a visual database");
    command->add_option("database", options->database, "Visual database (.igdb, or .toml to compile)")
        ->required();
    command->add_option("-o,--output", options->output, "Contact sheet to write (.png)")->required();
    command->add_option("--turntable", options->turntable,
                        "Film to write (.mp4) that goes round each subject");
    command->add_option("--size", options->size, "Each picture, WIDTHxHEIGHT pixels")->capture_default_str();
    command->add_option("--threads", options->threads, "Threads; 0: as many as the machine has")
        ->check(CLI::Range(0, 256));
    command->footer("A row of views for each moving object and each static cluster (seas only where nothing\n"
                    "else is static); slots show their first alternatives.\n"
                    "Example:\n  linkdig preview first_flight.igdb -o sheet.png --turntable round.mp4");
    command->callback([options, &exit_code] { exit_code = preview(*options); });
}

} // namespace linkdig::tools
