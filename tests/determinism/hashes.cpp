#include "tests/determinism/hashes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <new>
#include <sstream>
#include <vector>

namespace linkdig::determinism {

namespace {

const char* const table_path = LINKDIG_SOURCE_DIR "/tests/determinism/hashes.txt";

std::vector<std::string> read_lines() {
    std::vector<std::string> lines;
    std::ifstream file(table_path);
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

std::string text_of(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

/// Name and hash of a line; both empty for comments and empty lines.
std::pair<std::string, std::string> parse(const std::string& line) {
    if (line.empty() || line.front() == '#') return {};
    std::istringstream words(line);
    std::string name;
    std::string hash;
    words >> name >> hash;
    return {name, hash};
}

void write(const std::string& name, const std::string& hash) {
    std::vector<std::string> lines = read_lines();
    const std::string entry = name + " " + hash;
    bool found = false;
    for (std::string& line : lines) {
        if (parse(line).first != name) continue;
        line = entry;
        found = true;
    }
    if (!found) lines.push_back(entry);
    std::ofstream file(table_path, std::ios::trunc);
    for (const std::string& line : lines)
        file << line << '\n';
    ASSERT_TRUE(file.good()) << "cannot write " << table_path;
}

} // namespace

Hasher::Hasher() : state_(XXH64_createState()) {
    if (state_ == nullptr) throw std::bad_alloc();
    XXH64_reset(state_, 0);
}

Hasher::~Hasher() { XXH64_freeState(state_); }

void Hasher::bytes(const void* data, std::size_t size) { XXH64_update(state_, data, size); }

std::uint64_t Hasher::hash() const { return XXH64_digest(state_); }

std::uint64_t picture_hash(const ig::VideoFrame& picture) {
    Hasher hasher;
    hasher.value(picture.width);
    hasher.value(picture.height);
    hasher.bytes(picture.pixels.data(), picture.pixels.size() * sizeof(std::uint32_t));
    return hasher.hash();
}

void expect_hash(const std::string& name, std::uint64_t hash) {
    const std::string actual = text_of(hash);
    std::string committed;
    for (const std::string& line : read_lines()) {
        const auto [entry, value] = parse(line);
        if (entry == name) committed = value;
    }
    if (actual == committed) return;
    if (std::getenv("LINKDIG_UPDATE_HASHES") != nullptr) {
        write(name, actual);
        return;
    }
    ADD_FAILURE() << name << " has hash " << actual << ", committed is "
                  << (committed.empty() ? "none" : committed) << " (" << table_path
                  << "; see hashes.h on how to update it)";
}

} // namespace linkdig::determinism
