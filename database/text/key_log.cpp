#include "database/text/key_log.h"

#include <algorithm>
#include <utility>

namespace linkdig::database {

void KeyLog::note(const std::string& table, KeyUse use) {
    auto found = std::ranges::find(tables_, table, &TableUse::table);
    if (found == tables_.end()) found = tables_.insert(tables_.end(), TableUse{table, {}});
    // "vertices_ft" stands with "vertices_m".
    if (use.key.ends_with("_ft") &&
        std::ranges::find(found->keys, use.key.substr(0, use.key.size() - 2) + "m", &KeyUse::key) !=
            found->keys.end())
        return;
    if (std::ranges::find(found->keys, use.key, &KeyUse::key) == found->keys.end())
        found->keys.push_back(std::move(use));
}

} // namespace linkdig::database
