#include "host/scenario/sections.h"
#include "host/scenario/time_history.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::host {

namespace {

using Kind = OwnShipSection::Kind;

void read_fixed(TableReader& reader, OwnShipSection& own) {
    const std::size_t mistakes = reader.diagnostics().all().size();
    own.position_m = reader.point_m("position");
    own.aim_m = reader.point_m("aim");
    const bool read = reader.diagnostics().all().size() == mistakes;
    if (read && own.aim_m == own.position_m)
        reader.error_at("aim_m", "the aim is the eye itself; expected another point");
    if (reader.has("beside")) {
        own.beside = read_name(reader, "beside");
    } else {
        reader.node("beside"); // known, though absent
    }
}

void read_path(TableReader& reader, OwnShipSection& own) {
    const std::string file = reader.text("file");
    if (file.empty()) return;
    own.path =
        read_history(reader.beside(file), path_history_columns(), reader.at("file"), reader.diagnostics());
    for (HistoryRow& row : own.path)
        row.values[3] += heading_from_aviation(0.0); // the factor has turned its sense already
}

} // namespace

void read_own_ship(TableReader& root, Scenario& scenario) {
    const toml::table* table = root.table("own_ship");
    if (table == nullptr) return;
    TableReader reader(*table, root.file(), "[own_ship]", root.diagnostics());
    OwnShipSection& own = scenario.own_ship;
    own.kind = static_cast<Kind>(reader.choice("kind", 0, {"approach", "fixed", "path", "flown"}));
    if (own.kind == Kind::fixed) read_fixed(reader, own);
    if (own.kind == Kind::path) read_path(reader, own);
    if (own.kind == Kind::flown) {
        own.position_m = reader.point_m("position");
        own.heading_rad = read_heading_rad(reader, "heading");
        own.speed_mps = reader.speed_mps("speed", 0.0, {0.0, 100.0});
    }
    reader.finish();
}

} // namespace linkdig::host
