#include "tools/flight/shipped_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace linkdig::tools {

std::string shipped_scenes() {
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (const char* named = std::getenv("LINKDIG_SCENES"); named != nullptr && *named != '\0') {
        if (!fs::is_directory(named, ignored))
            throw std::runtime_error(fmt::format("LINKDIG_SCENES names {}, which is no folder", named));
        return named;
    }
    std::vector<std::string> places{LINKDIG_SOURCE_SCENES};
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty())
        places.push_back((program.parent_path().parent_path() / "share/linkdig/scenes").string());
    for (const std::string& place : places)
        if (fs::is_directory(place, ignored)) return place;
    throw std::runtime_error(
        fmt::format("the shipped scenes were not found; looked in {} (LINKDIG_SCENES names another folder)",
                    fmt::join(places, " and ")));
}

} // namespace linkdig::tools
