#include "database/model/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace linkdig {

namespace {

// Published outputs of SplitMix64 for the seed 1234567 (Rosetta Code, "Pseudo-random numbers/Splitmix64").
TEST(RandomBits, AreThoseOfSplitMix64) {
    const std::array<std::uint64_t, 5> published = {6457827717110365317ULL, 3203168211198807973ULL,
                                                    9817491932198370423ULL, 4593380528125082431ULL,
                                                    16408922859458223821ULL};
    for (std::uint64_t i = 0; i < published.size(); ++i)
        EXPECT_EQ(random_bits(1234567, i), published[i]);
}

// The same source: floor(5 u) of the seed 987654321, 100,000 times.
TEST(RandomUnit, HasThePublishedHistogram) {
    std::array<int, 5> counts{};
    for (std::uint64_t i = 0; i < 100'000; ++i)
        ++counts[static_cast<std::size_t>(random_unit(987654321, i) * 5.0)];
    EXPECT_EQ(counts, (std::array<int, 5>{20027, 19892, 20073, 19978, 20030}));
}

TEST(RandomUnit, IsBelowOne) {
    static_assert(static_cast<double>(~std::uint64_t{0} >> 11U) * (1.0 / 9007199254740992.0) < 1.0);
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        EXPECT_GE(random_unit(i, ~i), 0.0);
        EXPECT_LT(random_unit(i, ~i), 1.0);
    }
}

TEST(RandomUnit, DiffersBySeedAndIndex) {
    EXPECT_NE(random_unit(1, 0), random_unit(2, 0));
    EXPECT_NE(random_unit(1, 0), random_unit(1, 1));
    EXPECT_EQ(random_unit(1, 5), random_unit(1, 5));
}

} // namespace

} // namespace linkdig
