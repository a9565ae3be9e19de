#pragma once
/// Time histories: CSV files whose header names each column and its unit.

#include "host/scenario/scenario.h"

#include <span>

namespace linkdig::host {

/// A column that must stand in the file, with the units that it may have: "roll" is found as roll_deg or roll_rad.
struct HistoryColumn {
    struct Unit {
        const char* ending; ///< with its underscore
        double factor;      ///< to SI and radians, with the sign of the house's conventions
    };
    const char* stem;
    std::vector<Unit> units;
};

/// Surge, sway (to port), heave; roll (starboard down), pitch (bow up), yaw (the file's clockwise).
std::span<const HistoryColumn> ship_history_columns();
/// east, north, up; heading (the file's clockwise from north), pitch, roll.
std::span<const HistoryColumn> path_history_columns();

/// Reads "time_s" and six columns; columns of other names are passed over. Times must ascend. A missing file, a missing
/// column, a row of another length and whatever is no finite number are reported where they stand, `from` being the place of
/// the scenario that names the file; nothing is returned then.
std::vector<HistoryRow> read_history(const std::string& path, std::span<const HistoryColumn> columns,
                                     const database::SourceLocation& from,
                                     database::Diagnostics& diagnostics);

} // namespace linkdig::host
