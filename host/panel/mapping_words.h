#pragma once
/// What the messages about a mapping share.

#include "host/panel/layout.h"

#include <string>
#include <string_view>
#include <vector>

namespace linkdig::panel {

template <typename All>
std::vector<std::string> names_of(const All& all) {
    std::vector<std::string> names;
    for (const auto& each : all)
        names.emplace_back(each.name);
    return names;
}

std::vector<std::string> panel_names();
/// Indications and signals.
std::vector<std::string> shown_names();
/// `what "name" is unknown`, with the closest known name or all of them.
std::string unknown(std::string_view what, std::string_view name, const std::vector<std::string>& known);
/// "a switch or button"
const char* word_of(ControlKind kind);

} // namespace linkdig::panel
