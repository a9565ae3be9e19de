// The functions that stand in for the C library's: their bits, not their accuracy (that is
// tests/database/model).

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "database/model/rotation.h"
#include "tests/determinism/hashes.h"

#include <gtest/gtest.h>

namespace linkdig::determinism {

namespace {

constexpr std::uint64_t samples = 20000;
constexpr std::uint64_t seed = 1979;

/// Argument number `index`, uniform between the two.
double argument(std::uint64_t index, double least, double greatest) {
    return least + (greatest - least) * random_unit(seed, index);
}

template <typename Function>
std::uint64_t hash_of(double least, double greatest, Function function) {
    Hasher hasher;
    for (std::uint64_t index = 0; index < samples; ++index)
        hasher.value(function(argument(index, least, greatest)));
    return hasher.hash();
}

} // namespace

TEST(Mathematics, RandomNumbersKeepTheirBits) {
    Hasher hasher;
    for (std::uint64_t index = 0; index < samples; ++index) {
        hasher.value(random_bits(seed, index));
        hasher.value(random_unit(seed, index));
    }
    expect_hash("mathematics/random", hasher.hash());
}

TEST(Mathematics, CircularFunctionsKeepTheirBits) {
    expect_hash("mathematics/sine", hash_of(-1e4, 1e4, sine));
    expect_hash("mathematics/cosine", hash_of(-1e4, 1e4, cosine));
    expect_hash("mathematics/tangent", hash_of(-1.5, 1.5, tangent));
    expect_hash("mathematics/arc_sine", hash_of(-1.0, 1.0, arc_sine));
    expect_hash("mathematics/arc_cosine", hash_of(-1.0, 1.0, arc_cosine));
    expect_hash("mathematics/arc_tangent",
                hash_of(-50.0, 50.0, [](double y) { return arc_tangent(y, 3.0 - y); }));
}

TEST(Mathematics, ExponentialsKeepTheirBits) {
    expect_hash("mathematics/exponential", hash_of(-60.0, 60.0, exponential));
    expect_hash("mathematics/logarithm", hash_of(1e-9, 1e6, logarithm));
    expect_hash("mathematics/power", hash_of(1e-3, 1e3, [](double x) { return power(x, 0.2 * x - 1.5); }));
}

TEST(Mathematics, AttitudesKeepTheirBits) {
    Hasher hasher;
    for (std::uint64_t index = 0; index < samples; index += 3) {
        const Attitude attitude{.heading_rad = argument(index, -7.0, 7.0),
                                .pitch_rad = argument(index + 1, -1.5, 1.5),
                                .roll_rad = argument(index + 2, -3.0, 3.0)};
        const Mat3d matrix = world_from_body(attitude);
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row)
                hasher.value(matrix[column][row]);
        }
    }
    expect_hash("mathematics/world_from_body", hasher.hash());
}

} // namespace linkdig::determinism
