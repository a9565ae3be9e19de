#include "database/text/table_reader.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace linkdig::database {

namespace {

constexpr std::uintmax_t largest_file_bytes = 64ULL << 20U;

/// The file's bytes, or the reason why there are none.
std::optional<std::string> read_bytes(const std::string& path, std::string& reason) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (!std::filesystem::exists(status)) {
        reason = "no such file; expected an authoring file (.toml)";
        return std::nullopt;
    }
    if (!std::filesystem::is_regular_file(status)) {
        reason = std::filesystem::is_directory(status)
                     ? "is a directory; expected an authoring file (.toml)"
                     : "is not a regular file; expected an authoring file (.toml)";
        return std::nullopt;
    }
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (ignored || size > largest_file_bytes) {
        reason = fmt::format("is larger than {} MiB; divide it with `include`", largest_file_bytes >> 20U);
        return std::nullopt;
    }
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(size))) {
        reason = "cannot be read; check its permissions";
        return std::nullopt;
    }
    return bytes;
}

} // namespace

std::optional<Document> parse_file(const std::string& path, Diagnostics& diagnostics) {
    std::string reason;
    const std::optional<std::string> bytes = read_bytes(path, reason);
    if (!bytes) {
        diagnostics.error({path, 0, 0}, std::move(reason));
        return std::nullopt;
    }
    if (const std::size_t zero = bytes->find('\0'); zero != std::string::npos) {
        diagnostics.error({path, 0, 0},
                          fmt::format("is not text: byte {} is zero; expected TOML in UTF-8", zero));
        return std::nullopt;
    }
    try {
        return Document{path, toml::parse(*bytes, path)};
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        diagnostics.error({path, at.line, at.column}, fmt::format("{}; expected TOML", error.description()));
        return std::nullopt;
    }
}

SourceLocation location_of(const toml::node& node, const std::string& file) {
    const toml::source_position at = node.source().begin;
    return {file, at.line, at.column};
}

} // namespace linkdig::database
