#include "tools/flight/output_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace linkdig::tools {

void require_ending(const std::string& path, std::string_view kind,
                    std::initializer_list<std::string_view> endings) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (std::ranges::find(endings, std::string_view(ending)) == endings.end())
        throw std::invalid_argument(
            fmt::format("'{}' cannot be written: its name is not that of {}; expected a name in {}", path,
                        kind, fmt::join(endings, " or ")));
}

void require_recording_name(const std::string& path) {
    if (path.empty())
        throw std::invalid_argument("'' is no name of a file to write; expected one, as flight.rec");
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending == ".toml" || ending == ".igdb")
        throw std::invalid_argument(fmt::format("'{}' cannot be written: flights are made from files of that "
                                                "name; expected another one, as flight.rec",
                                                path));
}

bool same_file(const std::string& a, const std::string& b) {
    std::error_code none;
    return std::filesystem::equivalent(a, b, none);
}

void require_other_file(const std::string& output, const std::string& input) {
    if (same_file(output, input))
        throw std::invalid_argument(fmt::format(
            "'{}' cannot be written: it is read, too; expected the name of another file", output));
}

} // namespace linkdig::tools
