#pragma once
/// The words in which readers note what a key may hold.

#include "database/text/table_reader.h"

#include <cstdint>
#include <set>
#include <string>

namespace linkdig::database {

/// Of a key that was only looked at, by node() or has(), and that nobody has described.
inline constexpr const char* undescribed = "?";

/// ", 0 to 1"; empty: any number.
std::string words_of(Range range);
/// "whole number, 3 to 1000"
std::string words_of(std::int64_t least, std::int64_t greatest);
/// Is this the key of a second unit, like "size_ft" where "size_m" is known too?
bool is_other_unit(const std::string& key, const std::set<std::string, std::less<>>& known);

} // namespace linkdig::database
