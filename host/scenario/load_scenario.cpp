#include "host/scenario/scenario.h"
#include "host/scenario/sections.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>

namespace linkdig::host {

namespace {

using Path = std::filesystem::path;

void read_head(TableReader& root, Scenario& scenario) {
    const toml::table* table = root.table("scenario");
    if (table == nullptr) {
        if (!root.has("scenario")) root.error_at("scenario", "the table [scenario] is missing");
        return;
    }
    TableReader reader(*table, root.file(), "[scenario]", root.diagnostics());
    scenario.name = reader.text("name");
    const Path database = reader.text("database");
    if (!database.empty() && database.extension() != ".toml" && database.extension() != ".igdb")
        reader.error_at("database", fmt::format("\"database\" is \"{}\"; expected a .toml or .igdb file",
                                                database.string()));
    scenario.database_path = root.beside(database.string());
    scenario.duration_s = reader.duration_s("duration", {}, {0.1, 86400.0});
    scenario.seed =
        static_cast<std::uint64_t>(reader.integer("seed", 0, 0, std::numeric_limits<std::int64_t>::max()));
    reader.finish();
}

} // namespace

Name read_name(TableReader& reader, std::string_view key) { return {reader.text(key), reader.at(key)}; }

double read_heading_rad(TableReader& reader, std::string_view stem) {
    return heading_from_aviation(reader.angle_rad(stem, {}, {-360.0, 360.0}));
}

ScenarioResult load_scenario(const std::string& path) {
    ScenarioResult result;
    const auto document = database::parse_file(path, result.diagnostics);
    if (!document) return result;
    Scenario scenario;
    scenario.path = path;
    TableReader root(document->root, document->path, "the scenario", result.diagnostics);
    read_head(root, scenario);
    read_suns(root, scenario);
    read_ships(root, scenario);
    check_stations(scenario, result.diagnostics);
    read_own_ship(root, scenario);
    read_sequences(root, scenario);
    read_approaches(root, scenario);
    read_channels(root, scenario);
    read_sea(root, scenario);
    read_quays(root, scenario);
    read_sky(root, scenario);
    root.finish();
    if (!result.diagnostics.any()) result.scenario = std::move(scenario);
    return result;
}

const ApproachSection& approach_for(const Scenario& scenario) {
    const ApproachSection* chosen = &scenario.approaches.front();
    for (const ApproachSection& each : scenario.approaches)
        if (each.duration_s <= scenario.duration_s) chosen = &each;
    return *chosen;
}

} // namespace linkdig::host
