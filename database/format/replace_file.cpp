#include "database/format/replace_file.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace linkdig::database {

namespace {

[[noreturn]] void refuse(const std::string& path, int error) {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", path, std::generic_category().message(error)));
}

/// A file that did not exist before, so that two writers never share one; its name is put into `temporary`.
std::FILE* open_beside(const std::string& path, std::string& temporary) {
    constexpr int attempts = 100; // left-overs of writers that were killed and had the same process number
    for (int attempt = 0; attempt < attempts; ++attempt) {
        temporary = fmt::format("{}.part-{}-{}", path, ::getpid(), attempt);
        if (std::FILE* file = std::fopen(temporary.c_str(), "wbx")) return file;
        if (errno != EEXIST) return nullptr;
    }
    return nullptr;
}

/// 0 or the error's number.
int write_and_close(std::FILE* file, std::span<const std::uint8_t> bytes) {
    int error = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) error = errno;
    if (std::fclose(file) != 0 && error == 0) error = errno;
    return error;
}

} // namespace

void replace_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) refuse(path, EISDIR);
    std::string temporary;
    std::FILE* file = open_beside(path, temporary);
    if (file == nullptr) refuse(path, errno);
    int error = write_and_close(file, bytes);
    if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
    if (error != 0) {
        std::remove(temporary.c_str());
        refuse(path, error);
    }
}

} // namespace linkdig::database
