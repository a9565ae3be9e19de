#include "tools/flight/shipped_folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace linkdig::tools {

std::string shipped_folder(const ShippedFolder& folder) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (const char* named = std::getenv(folder.variable); named != nullptr && *named != '\0') {
        if (!fs::is_directory(named, ignored))
            throw std::runtime_error(fmt::format("{} names {}, which is no folder", folder.variable, named));
        return named;
    }
    std::vector<std::string> places{folder.source};
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) places.push_back((program.parent_path().parent_path() / folder.installed).string());
    for (const std::string& place : places)
        if (fs::is_directory(place, ignored)) return place;
    throw std::runtime_error(fmt::format("{} were not found; looked in {} ({} names another folder)",
                                         folder.what, fmt::join(places, " and "), folder.variable));
}

} // namespace linkdig::tools
