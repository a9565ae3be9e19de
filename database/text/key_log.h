#pragma once
/// What readers ask of tables: key by key the kind of value, its unit and range, and its default. The reference of the
/// authoring language is this log, taken while the compiler reads one table of each kind (database/compiler/schema.h).

#include <optional>
#include <string>
#include <vector>

namespace linkdig::database {

struct KeyUse {
    std::string key;                     ///< a quantity's with its first unit: "radius_m"
    std::string value;                   ///< in words: "whole number, 3 to 1000"
    std::optional<std::string> fallback; ///< in words; nothing: the key is required
};

struct TableUse {
    std::string table;        ///< "[[object.box]]"
    std::vector<KeyUse> keys; ///< in the order in which they are first asked for
};

class KeyLog {
public:
    /// The first note of a key of a table stays.
    void note(const std::string& table, KeyUse use);
    const std::vector<TableUse>& tables() const { return tables_; }

private:
    std::vector<TableUse> tables_;
};

} // namespace linkdig::database
