#include "database/compiler/wake_spec.h"

#include "database/model/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace linkdig::database {

namespace {

std::vector<PathPiece> read_arc(TableReader& reader, bool spiral) {
    ArcPiece arc;
    arc.centre = reader.point2_m("centre");
    const Range radius{1e-6, 1e6};
    arc.from_radius = reader.length_m(spiral ? "from_radius" : "radius", {}, radius);
    arc.to_radius = spiral ? reader.length_m("to_radius", {}, radius) : arc.from_radius;
    arc.from_rad = reader.angle_rad("from", {}, {-36000.0, 36000.0});
    arc.to_rad = reader.angle_rad("to", {}, {-36000.0, 36000.0});
    return {arc};
}

std::vector<PathPiece> read_curve(TableReader& reader, const std::string& kind) {
    const std::vector<Vec2d> points = reader.points2_m("points");
    const std::size_t wanted = kind == "bezier" ? 4 : 2;
    if (points.size() < wanted || (kind != "spline" && points.size() != wanted)) {
        reader.error_at("points_m", fmt::format("a {} has {} points; expected {}{}", kind, points.size(),
                                                kind == "spline" ? "at least " : "", wanted));
        return {};
    }
    if (kind == "line") return {LinePiece{points[0], points[1]}};
    if (kind == "bezier") return {BezierPiece{{points[0], points[1], points[2], points[3]}}};
    const std::vector<BezierPiece> curves = natural_spline(points);
    return {curves.begin(), curves.end()};
}

std::vector<PathPiece> read_piece(const toml::table& table, TableReader& swimmer) {
    static const std::vector<std::string> kinds{"line", "arc", "spiral", "bezier", "spline"};
    TableReader reader(table, swimmer.file(), "[[swimmer.path]]", swimmer.diagnostics());
    if (!reader.has("kind")) {
        reader.error_at("kind", fmt::format("'kind' is missing; expected one of {}", fmt::join(kinds, ", ")));
        return {};
    }
    const std::size_t mistakes = reader.diagnostics().all().size();
    const std::string& kind = kinds[reader.choice("kind", 0, kinds)];
    if (reader.diagnostics().all().size() != mistakes) return {}; // which keys it should have is not known
    std::vector<PathPiece> pieces =
        kind == "arc" || kind == "spiral" ? read_arc(reader, kind == "spiral") : read_curve(reader, kind);
    reader.finish();
    return pieces;
}

KelvinSwimmer read_swimmer(const toml::table& table, const std::string& file, Diagnostics& diagnostics) {
    TableReader reader(table, file, "[[swimmer]]", diagnostics);
    KelvinSwimmer swimmer;
    swimmer.name = reader.text("name");
    swimmer.speed = reader.speed_mps("speed", {}, {1e-3, 1e3});
    swimmer.amplitude = reader.number("amplitude", 1.0, {-1e3, 1e3});
    swimmer.oscillation_rad_s =
        reader.number("oscillation_rad_s", gravity_mps2 / std::max(swimmer.speed, 1e-3), {0.0, 1e5});
    swimmer.damping_per_s = reader.number("damping_per_s", 0.0, {0.0, 1e3});
    const std::size_t mistakes = diagnostics.all().size();
    const auto path = reader.tables("path");
    for (const toml::table* piece : path)
        std::ranges::copy(read_piece(*piece, reader), std::back_inserter(swimmer.path));
    if (diagnostics.all().size() == mistakes) {
        const std::string mistake = path_mistake(swimmer.path);
        if (!mistake.empty())
            reader.error_at("path", fmt::format("the path of \"{}\" {}", swimmer.name, mistake));
    }
    reader.finish();
    return swimmer;
}

void read_field(const toml::table* table, const std::string& file, Diagnostics& diagnostics,
                KelvinWakes& wakes) {
    static const toml::table none;
    TableReader reader(table != nullptr ? *table : none, file, "[field]", diagnostics);
    wakes.size = static_cast<std::uint32_t>(reader.integer("cells", 512, 4, 8192));
    wakes.side = reader.length_m("side", 512.0, {1e-3, 1e6});
    wakes.origin = reader.point2_m("corner", wakes.origin);
    reader.finish();
}

void read_sampling(const toml::table* table, const std::string& file, Diagnostics& diagnostics,
                   WakeSpec& spec) {
    static const toml::table none;
    TableReader reader(table != nullptr ? *table : none, file, "[sampling]", diagnostics);
    KelvinWakes& wakes = spec.wakes;
    wakes.psi_per_unit = reader.number("psi_per_cell", 8.0, {0.01, 10000.0}) * wakes.size / wakes.side;
    wakes.u_steps = static_cast<std::uint32_t>(reader.integer("u_steps", 1000, 2, 1'000'000));
    wakes.sampling = static_cast<KelvinSampling>(reader.choice("kind", 0, {"even", "weighted", "column"}));
    wakes.layout = static_cast<KelvinLayout>(reader.choice("layout", 0, {"rays", "tangent"}));
    wakes.before = static_cast<KelvinBefore>(reader.choice("before", 0, {"straight", "rest"}));
    spec.smoothing_passes = static_cast<std::uint32_t>(reader.integer("smoothing_passes", 0, 0, 100));
    spec.smoothing_threshold = reader.number("smoothing_threshold", spec.smoothing_threshold, {0.0, 1e6});
    reader.finish();
}

/// What is told of swimmers is told by their names.
void add_swimmer(const toml::table& table, const std::string& file, Diagnostics& diagnostics,
                 std::vector<KelvinSwimmer>& swimmers) {
    KelvinSwimmer swimmer = read_swimmer(table, file, diagnostics);
    if (!swimmer.name.empty() && std::ranges::count(swimmers, swimmer.name, &KelvinSwimmer::name) > 0)
        diagnostics.error(
            location_of(*table.get("name"), file),
            fmt::format("a second [[swimmer]] is named \"{}\"; expected another name", swimmer.name));
    swimmers.push_back(std::move(swimmer));
}

} // namespace

std::optional<WakeSpec> read_wake_spec(const std::string& path, Diagnostics& diagnostics) {
    const std::optional<Document> document = parse_file(path, diagnostics);
    if (!document) return std::nullopt;
    WakeSpec spec;
    TableReader reader(document->root, path, "the wake specification", diagnostics);
    spec.title = reader.text("title", "");
    read_field(reader.table("field"), path, diagnostics, spec.wakes);
    read_sampling(reader.table("sampling"), path, diagnostics, spec);
    for (const toml::table* swimmer : reader.tables("swimmer"))
        add_swimmer(*swimmer, path, diagnostics, spec.wakes.swimmers);
    if (spec.wakes.swimmers.empty()) diagnostics.error({path, 0, 0}, "no [[swimmer]]; expected at least one");
    reader.finish();
    if (diagnostics.any()) return std::nullopt;
    const double samples = sample_count(spec.wakes);
    if (samples > most_wake_samples) {
        diagnostics.error(
            {path, 0, 0},
            fmt::format("the wakes take {:.3g} samples; expected at most {:g}: fewer psi_per_cell "
                        "or u_steps, or shorter paths",
                        samples, most_wake_samples));
        return std::nullopt;
    }
    return spec;
}

WakeFieldResult wake_field(const WakeSpec& spec) {
    WakeFieldResult made{.kelvin = kelvin_field(spec.wakes)};
    WaveField& field = made.kelvin.field;
    made.rms = rms_of(field);
    made.rogues = made.rogues_left = rogue_cells(field);
    const double threshold = spec.smoothing_threshold * made.rms;
    for (std::uint32_t pass = 0; pass < spec.smoothing_passes; ++pass)
        smooth_field(field, threshold);
    if (spec.smoothing_passes > 0) made.rogues_left = rogue_cells(field);
    return made;
}

} // namespace linkdig::database
