#include "tools/figures/findings.h"

#include "ig/sink/image_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace linkdig::tools {

Findings::Findings(std::string folder, bool quick) : folder_(std::move(folder)), quick_(quick) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw std::runtime_error(fmt::format("{}: cannot be made: {}", folder_, error.message()));
}

void Findings::at_most(const std::string& figure, const std::string& what, double value, double bound) {
    checks_.push_back({figure, what, value, fmt::format("at most {:.4g}", bound), value <= bound});
}

void Findings::at_least(const std::string& figure, const std::string& what, double value, double bound) {
    checks_.push_back({figure, what, value, fmt::format("at least {:.4g}", bound), value >= bound});
}

void Findings::between(const std::string& figure, const std::string& what, double value, double least,
                       double greatest) {
    checks_.push_back({figure, what, value, fmt::format("{:.4g} to {:.4g}", least, greatest),
                       value >= least && value <= greatest});
}

void Findings::picture(const std::string& name, const ig::VideoFrame& picture) const {
    ig::write_png(fmt::format("{}/{}.png", folder_, name), picture);
}

bool Findings::passed() const { return std::ranges::all_of(checks_, &Check::passed); }

std::string Findings::text() const {
    std::string text;
    for (const Check& check : checks_)
        text += fmt::format("{:<6} figure {:<9} {}: {:.4g}; {}\n", check.passed ? "ok" : "FAILED",
                            check.figure, check.what, check.value, check.expected);
    for (const Table& table : tables_) {
        text += fmt::format("\n{}\n| {} |\n|", table.title, fmt::join(table.heads, " | "));
        for (std::size_t i = 0; i < table.heads.size(); ++i)
            text += " --- |";
        text += "\n";
        for (const auto& row : table.rows)
            text += fmt::format("| {} |\n", fmt::join(row, " | "));
    }
    return text;
}

std::string Findings::json() const {
    nlohmann::ordered_json checks = nlohmann::ordered_json::array();
    for (const Check& check : checks_)
        checks.push_back({{"figure", check.figure},
                          {"what", check.what},
                          {"value", check.value},
                          {"expected", check.expected},
                          {"passed", check.passed}});
    nlohmann::ordered_json tables = nlohmann::ordered_json::array();
    for (const Table& table : tables_)
        tables.push_back({{"title", table.title}, {"heads", table.heads}, {"rows", table.rows}});
    return nlohmann::ordered_json{{"checks", checks}, {"tables", tables}}.dump(2);
}

} // namespace linkdig::tools
