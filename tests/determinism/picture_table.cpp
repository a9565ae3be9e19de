#include "tests/determinism/picture_table.h"

#include "ig/machine/machine.h"
#include "ig/simd/simd_level.h"
#include "ig/video/pixel_run.h"
#include "tests/determinism/hashes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdio>

namespace linkdig::determinism {

namespace {

#if defined(__clang__)
constexpr const char* compiler = "clang++ " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif
#if defined(NDEBUG)
constexpr const char* build_type = "Release";
#else
constexpr const char* build_type = "Debug";
#endif

/// How a picture is drawn.
struct Way {
    std::uint32_t threads = 1;
    std::string simd;
};

std::vector<Way> ways() {
    const std::vector<std::string> levels = ig::simd_levels();
    std::vector<Way> all;
    for (const std::string& level : levels)
        for (const std::uint32_t threads : {1U, 2U, 4U})
            all.push_back({threads, level});
    return all;
}

/// One hash per packet, all drawn by the same machine, one after the other.
std::vector<std::uint64_t> hashes_of(const VisualDatabase& database, std::span<const NamedPacket> packets,
                                     const ig::Raster& raster, bool edge_smoothing, const Way& way) {
    EXPECT_TRUE(ig::use_simd_level(way.simd)) << way.simd;
    ig::Machine machine(
        database,
        {.name = "determinism", .raster = raster, .edge_smoothing = edge_smoothing, .threads = way.threads});
    std::vector<std::uint64_t> hashes;
    for (const NamedPacket& named : packets) {
        const FrameReport& report = machine.frame(named.packet);
        for (const std::string& error : report.errors)
            ADD_FAILURE() << named.name << " was refused: " << error;
        hashes.push_back(picture_hash(machine.picture(0)));
    }
    EXPECT_TRUE(ig::use_simd_level("best"));
    return hashes;
}

void print_row(const std::string& name, const Way& way, std::uint64_t hash) {
    std::fputs(fmt::format("{:<28} {:<8} {} thread{} {:<8} {:016x}  {}\n", compiler, build_type, way.threads,
                           way.threads == 1 ? " " : "s", way.simd, hash, name)
                   .c_str(),
               stdout);
}

/// Once: what this processor cannot tell about.
void print_missing_levels() {
    static bool told = false;
    if (told) return;
    told = true;
    for (const std::string& level : ig::missing_simd_levels())
        std::fputs(fmt::format("{:<28} {:<8} {} is in this build, but the processor lacks it: not checked\n",
                               compiler, build_type, level)
                       .c_str(),
                   stdout);
}

} // namespace

void expect_pictures(const VisualDatabase& database, std::span<const NamedPacket> packets,
                     const ig::Raster& raster, bool edge_smoothing) {
    // Four threads must be four, whatever the number of processors.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 4);
    print_missing_levels();
    std::vector<std::uint64_t> first;
    for (const Way& way : ways()) {
        const std::vector<std::uint64_t> hashes = hashes_of(database, packets, raster, edge_smoothing, way);
        if (first.empty()) first = hashes;
        for (std::size_t i = 0; i < packets.size(); ++i) {
            print_row(packets[i].name, way, hashes[i]);
            EXPECT_EQ(hashes[i], first[i])
                << packets[i].name << " differs with " << way.threads << " threads at " << way.simd;
        }
    }
    for (std::size_t i = 0; i < packets.size(); ++i) {
        expect_hash(packets[i].name, first[i]);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NE(first[i], first[j]) << packets[i].name << " looks like " << packets[j].name;
    }
}

} // namespace linkdig::determinism
