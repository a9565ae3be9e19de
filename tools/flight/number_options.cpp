#include "tools/flight/number_options.h"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <system_error>

namespace linkdig::tools {
namespace {

std::string refusal(const std::string& text, const std::string& expected) {
    return fmt::format("'{}' cannot be taken; expected {}", text, expected);
}

} // namespace

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
    const std::string range = fmt::format("{} to {}", least, most);
    const bool bounded = most != std::numeric_limits<std::uint64_t>::max();
    return {[=](std::string& text) {
                std::uint64_t value = 0;
                const char* const last = text.data() + text.size();
                const auto [end, error] = std::from_chars(text.data(), last, value);
                if (error != std::errc{} || end != last || value < least || value > most)
                    return refusal(text, "a whole number, " + range);
                text = fmt::format("{}", value); // CLI11 would read a leading zero as that of an octal number
                return std::string();
            },
            bounded ? range : std::string()};
}

CLI::Validator finite_number(double least, double most) {
    const std::string range = fmt::format("{} to {}", least, most);
    return {[=](std::string& text) {
                double value = 0.0;
                const bool read = CLI::detail::lexical_cast(text, value);
                const bool inside = value >= least && value <= most; // never true of nan
                return read && inside ? std::string() : refusal(text, "a number, " + range);
            },
            range};
}

} // namespace linkdig::tools
