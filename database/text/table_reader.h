#pragma once
/// Reads a TOML table key by key: each value is checked for type, unit and range where it stands, and
/// whatever key was never asked for is reported as unknown. Used for databases and for scenarios alike.

#include "database/model/vectors.h"
#include "database/text/diagnostic.h"

#include <toml++/toml.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace linkdig::database {

struct Document {
    std::string path;
    toml::table root;
};

/// Reads and parses a file. A missing, unreadable, non-text or over-large file (64 MiB) and a syntax error
/// are reported in `diagnostics`, and nothing is returned.
std::optional<Document> parse_file(const std::string& path, Diagnostics& diagnostics);

struct Range {
    double least = -std::numeric_limits<double>::max();
    double greatest = std::numeric_limits<double>::max();
};

class TableReader {
public:
    /// `what` names the table in messages, e.g. "[[object]] \"deck\"".
    TableReader(const toml::table& table, std::string file, std::string what, Diagnostics& diagnostics);

    SourceLocation here() const;
    SourceLocation at(std::string_view key) const; ///< of the key's value, or here() if it is absent
    bool has(std::string_view key) const;
    void error_at(std::string_view key, std::string message) const;

    // Required values: absence is reported, and a default value returned.
    std::string text(std::string_view key);
    double number(std::string_view key, Range range = {});
    std::int64_t integer(std::string_view key, std::int64_t least, std::int64_t greatest);

    // Optional values: absence gives the default.
    std::string text(std::string_view key, std::string_view fallback);
    double number(std::string_view key, double fallback, Range range);
    std::int64_t integer(std::string_view key, std::int64_t fallback, std::int64_t least,
                         std::int64_t greatest);
    bool boolean(std::string_view key, bool fallback);
    /// One of `choices`, whose index is returned; anything else is an error that lists them.
    std::size_t choice(std::string_view key, std::size_t fallback, const std::vector<std::string>& choices);

    /// Lengths are written with their unit in the key: `stem_m` or `stem_ft`; returned in metres. Exactly one
    /// may stand.
    double length_m(std::string_view stem, std::optional<double> fallback = {}, Range range_m = {});
    Vec3d point_m(std::string_view stem, std::optional<Vec3d> fallback = {});
    Vec2d point2_m(std::string_view stem, std::optional<Vec2d> fallback = {});
    /// Required: [least, greatest], in this order and both within `range_m`.
    std::array<double, 2> range_m(std::string_view stem, Range range_m);
    std::vector<Vec3d> points_m(std::string_view stem);  ///< required: array of [x, y, z]
    std::vector<Vec2d> points2_m(std::string_view stem); ///< required: array of [x, y]
    /// `stem_deg`, returned in radians.
    double angle_rad(std::string_view stem, std::optional<double> fallback_deg = {}, Range range_deg = {});
    /// `stem_kt` or `stem_mps`, returned in metres a second.
    double speed_mps(std::string_view stem, std::optional<double> fallback = {}, Range range_mps = {});
    /// `stem_s`, seconds.
    double duration_s(std::string_view stem, std::optional<double> fallback = {}, Range range = {});
    Vec3d vector(std::string_view key, std::optional<Vec3d> fallback = {}); ///< three plain numbers

    std::vector<std::string> texts(std::string_view key);         ///< optional array of strings
    const toml::table* table(std::string_view key);               ///< optional sub-table
    std::vector<const toml::table*> tables(std::string_view key); ///< optional array of tables
    /// Any value, marked as known. What it may be is for describe() to say, before.
    const toml::node* node(std::string_view key);
    /// Says in words what a key holds and what its absence means, where that is not what the reading call would say.
    /// No value: the key of another unit, which is known but not listed.
    void describe(std::string_view key, std::string_view value, std::optional<std::string> fallback);

    /// Reports every key that was never asked for, with the closest known one. Call once, last.
    void finish();

    const std::string& file() const { return file_; }
    /// The path of another file that this one names, relative to its own folder.
    std::string beside(const std::string& name) const;
    const std::string& what() const { return what_; }
    Diagnostics& diagnostics() const { return *diagnostics_; }

private:
    using Units = std::vector<std::pair<const char*, double>>; ///< ending of the key, metres (...) per unit
    struct WithUnit {
        std::string key;
        const toml::node* node = nullptr;
        double unit = 1.0;
    };
    const toml::node* find(std::string_view key);
    bool noting() const { return diagnostics_->keys() != nullptr; }
    void note(std::string_view key, std::string value, std::optional<std::string> fallback) const;
    void missing(std::string_view key) const;
    void wrong_type(std::string_view key, const toml::node& found, std::string_view expected) const;
    std::string text_of(std::string_view key, const toml::node& found) const;
    double number_of(std::string_view key, const toml::node& found, Range range, double unit) const;
    std::int64_t integer_of(std::string_view key, const toml::node& found, std::int64_t least,
                            std::int64_t greatest) const;
    std::optional<WithUnit> with_unit(std::string_view stem, const Units& units, bool required);
    void note_with_units(std::string_view stem, const Units& units, std::string value,
                         std::optional<std::string> fallback);
    double quantity(std::string_view stem, const Units& units, std::optional<double> fallback, Range range);
    template <int count>
    glm::vec<count, double, glm::defaultp>
    point_with_unit(std::string_view stem, std::optional<glm::vec<count, double, glm::defaultp>> fallback);
    template <int count>
    std::vector<glm::vec<count, double, glm::defaultp>> points_of(std::string_view stem);

    const toml::table* table_;
    std::string file_;
    std::string what_;
    Diagnostics* diagnostics_;
    std::set<std::string, std::less<>> known_;
};

SourceLocation location_of(const toml::node& node, const std::string& file);

} // namespace linkdig::database
