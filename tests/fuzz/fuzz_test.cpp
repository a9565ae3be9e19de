// The fuzzers' functions without a fuzzer: on their seeds, on seeded damage of those, and on what fuzzing has found.

#include "database/model/random.h"
#include "tests/fuzz/seeds.h"
#include "tests/fuzz/targets.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace linkdig::fuzz {
namespace {

using Target = void (*)(std::span<const std::uint8_t>);

/// Sets some bytes to anything.
Bytes damaged(Bytes bytes, std::uint64_t seed) {
    const std::uint64_t wounds = 1 + random_bits(seed, 0) % 3;
    for (std::uint64_t i = 0; i < wounds && !bytes.empty(); ++i)
        bytes[random_bits(seed, 2 * i + 1) % bytes.size()] =
            static_cast<std::uint8_t>(random_bits(seed, 2 * i + 2));
    return bytes;
}

/// Each call that returns is a pass: a target aborts where it finds a contradiction.
int run_all(Target target, const std::vector<Bytes>& seeds, const char* name) {
    int runs = 0;
    for (const Bytes& seed : seeds) {
        target(seed);
        ++runs;
        for (std::uint64_t i = 0; i < 300; ++i, ++runs)
            target(damaged(seed, i));
    }
    const std::filesystem::path found = std::filesystem::path(LINKDIG_SOURCE_DIR "/tests/fuzz/found") / name;
    if (!std::filesystem::exists(found)) return runs;
    for (const auto& file : std::filesystem::directory_iterator(found)) {
        std::ifstream stream(file.path(), std::ios::binary);
        target(Bytes(std::istreambuf_iterator<char>(stream), {}));
        ++runs;
    }
    return runs;
}

TEST(Fuzz, PacketBytes) { EXPECT_GT(run_all(packet_bytes, packet_bytes_seeds(), "packet_bytes"), 600); }
TEST(Fuzz, PacketJson) { EXPECT_GT(run_all(packet_json, packet_json_seeds(), "packet_json"), 900); }
TEST(Fuzz, Database) { EXPECT_GT(run_all(database_file, database_seeds(), "database_file"), 600); }

} // namespace
} // namespace linkdig::fuzz
