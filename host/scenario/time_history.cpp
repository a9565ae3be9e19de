#include "host/scenario/time_history.h"

#include "database/model/mathematics.h"
#include "database/model/units.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace linkdig::host {

namespace {

using database::Diagnostics;
using database::SourceLocation;

constexpr std::size_t most_mistakes = 20; ///< of one file: the rest are of the same kind

struct Cell {
    std::string_view text;
    std::uint32_t column = 1;
};

std::vector<Cell> cells_of(std::string_view line) {
    std::vector<Cell> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        std::size_t first = begin;
        std::size_t last = end;
        while (first < last && (line[first] == ' ' || line[first] == '\t'))
            ++first;
        while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t' || line[last - 1] == '\r'))
            --last;
        cells.push_back({line.substr(first, last - first), static_cast<std::uint32_t>(first + 1)});
        begin = end + 1;
    }
    return cells;
}

/// Which cell of a row a value comes from, and what makes it SI.
struct Source {
    std::size_t cell = 0;
    double factor = 1.0;
};

class HistoryReader {
public:
    HistoryReader(std::string path, Diagnostics& diagnostics)
        : path_(std::move(path)), diagnostics_(diagnostics) {}

    std::vector<HistoryRow> read(std::istream& text, std::span<const HistoryColumn> columns) {
        std::string line;
        while (std::getline(text, line) && mistakes_ < most_mistakes) {
            ++line_;
            if (line.empty() || line == "\r" || line[0] == '#') continue;
            const std::vector<Cell> cells = cells_of(line);
            if (width_ == 0)
                take_header(cells, columns);
            else if (sources_.size() == columns.size() + 1)
                take_row(cells);
        }
        if (width_ == 0)
            fail({1, 1}, "the file is empty; expected a header that names time_s and its columns");
        if (mistakes_ == 0 && rows_.empty())
            fail({line_, 1}, "there is no row below the header; expected at least one");
        return mistakes_ == 0 ? rows_ : std::vector<HistoryRow>{};
    }

private:
    struct Place {
        std::uint32_t line, column;
    };
    void fail(Place at, std::string message) {
        ++mistakes_;
        diagnostics_.error({path_, at.line, at.column}, std::move(message));
    }

    void take_header(const std::vector<Cell>& cells, std::span<const HistoryColumn> columns) {
        width_ = cells.size();
        find(cells, {"time", {{"_s", 1.0}}});
        for (const HistoryColumn& column : columns)
            find(cells, column);
    }

    void find(const std::vector<Cell>& cells, const HistoryColumn& column) {
        std::string expected;
        for (const HistoryColumn::Unit& unit : column.units) {
            const std::string name = std::string(column.stem) + unit.ending;
            expected += (expected.empty() ? "" : " or ") + name;
            for (std::size_t i = 0; i < cells.size(); ++i)
                if (cells[i].text == name) {
                    sources_.push_back({i, unit.factor});
                    return;
                }
        }
        fail({line_, 1},
             fmt::format("the header has no column {}; expected the unit in the column's name", expected));
    }

    void take_row(const std::vector<Cell>& cells) {
        if (cells.size() != width_) {
            fail({line_, 1},
                 fmt::format("the row has {} values; the header has {} columns", cells.size(), width_));
            return;
        }
        HistoryRow row;
        row.time_s = number(cells, sources_[0]);
        for (std::size_t i = 0; i < row.values.size(); ++i)
            row.values[i] = number(cells, sources_[i + 1]);
        if (!rows_.empty() && !(row.time_s > rows_.back().time_s) && mistakes_ == 0)
            fail({line_, cells[sources_[0].cell].column},
                 fmt::format("time {} does not follow {}; expected ascending times", row.time_s,
                             rows_.back().time_s));
        rows_.push_back(row);
    }

    double number(const std::vector<Cell>& cells, const Source& source) {
        const Cell& cell = cells[source.cell];
        double value = 0.0;
        const char* const end = cell.text.data() + cell.text.size();
        const auto parsed = std::from_chars(cell.text.data(), end, value);
        if (parsed.ec == std::errc{} && parsed.ptr == end && std::isfinite(value))
            return value * source.factor;
        fail({line_, cell.column}, fmt::format("\"{}\" is no finite number", cell.text));
        return 0.0;
    }

    std::string path_;
    Diagnostics& diagnostics_;
    std::vector<Source> sources_; ///< time, then the columns
    std::vector<HistoryRow> rows_;
    std::size_t width_ = 0;
    std::size_t mistakes_ = 0;
    std::uint32_t line_ = 0;
};

constexpr double degree = radians(1.0);

} // namespace

std::span<const HistoryColumn> ship_history_columns() {
    static const std::vector<HistoryColumn> columns{
        {"surge", {{"_m", 1.0}, {"_ft", metres_per_foot}}}, {"sway", {{"_m", 1.0}, {"_ft", metres_per_foot}}},
        {"heave", {{"_m", 1.0}, {"_ft", metres_per_foot}}}, {"roll", {{"_deg", degree}, {"_rad", 1.0}}},
        {"pitch", {{"_deg", degree}, {"_rad", 1.0}}},       {"yaw", {{"_deg", -degree}, {"_rad", -1.0}}}};
    return columns;
}

std::span<const HistoryColumn> path_history_columns() {
    static const std::vector<HistoryColumn> columns{
        {"east", {{"_m", 1.0}, {"_ft", metres_per_foot}}}, {"north", {{"_m", 1.0}, {"_ft", metres_per_foot}}},
        {"up", {{"_m", 1.0}, {"_ft", metres_per_foot}}},   {"heading", {{"_deg", -degree}, {"_rad", -1.0}}},
        {"pitch", {{"_deg", degree}, {"_rad", 1.0}}},      {"roll", {{"_deg", degree}, {"_rad", 1.0}}}};
    return columns;
}

std::vector<HistoryRow> read_history(const std::string& path, std::span<const HistoryColumn> columns,
                                     const SourceLocation& from, Diagnostics& diagnostics) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code)) {
        diagnostics.error(from, fmt::format("there is no file \"{}\"; expected a CSV time history", path));
        return {};
    }
    std::ifstream text(path);
    if (!text) {
        diagnostics.error(from, fmt::format("\"{}\" cannot be read", path));
        return {};
    }
    return HistoryReader(path, diagnostics).read(text, columns);
}

} // namespace linkdig::host
