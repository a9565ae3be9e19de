// Our functions against the C library's in long double (64 bits of mantissa, errors below 1e-18), to the
// bounds that mathematics.h states.

#include "database/model/mathematics.h"
#include "database/model/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace linkdig {

namespace {

static_assert(std::numeric_limits<long double>::digits >= 64,
              "the reference needs more digits than double has");

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double least_subnormal = std::numeric_limits<double>::denorm_min();
constexpr double least_normal = std::numeric_limits<double>::min();
constexpr double greatest = std::numeric_limits<double>::max();

double uniform(std::uint64_t seed, std::uint64_t index, double from, double to) {
    return from + (to - from) * random_unit(seed, index);
}

/// Many values from -limit to limit: even ones, and ones of every magnitude.
std::vector<double> arguments(double limit, std::uint64_t seed) {
    std::vector<double> values{0.0, -0.0, least_subnormal, -least_subnormal, least_normal, limit, -limit};
    for (std::uint64_t i = 0; i < 100'000; ++i)
        values.push_back(uniform(seed, i, -limit, limit));
    for (double magnitude = limit; magnitude > 1e-300; magnitude *= 0.37)
        for (const double sign : {1.0, -1.0})
            values.push_back(sign * magnitude);
    return values;
}

/// Worst of |ours - reference|, and where.
struct Worst {
    double error = 0.0;
    double at = 0.0;
    void note(long double difference, double where) {
        const auto size = static_cast<double>(std::fabs(difference));
        if (!(size <= error)) { // a NaN counts as worst
            error = size;
            at = where;
        }
    }
};

#define EXPECT_WORST_BELOW(worst, bound) EXPECT_LT((worst).error, bound) << "at " << (worst).at

TEST(Sine, IsWithinItsBound) {
    std::vector<double> angles = arguments(1e6, 1);
    for (int quarter = -2000; quarter <= 2000;
         ++quarter) // where the quadrant changes, and on both sides of it
        for (const double nearby : {-1e-9, -1e-16, 0.0, 1e-16, 1e-9})
            for (const double part : {pi / 2.0, pi / 4.0})
                angles.push_back(quarter * part * (1.0 + nearby));
    Worst sines;
    Worst cosines;
    Worst units;
    for (const double angle : angles) {
        const SineCosine both = sine_cosine(angle);
        sines.note(both.sine - std::sin(static_cast<long double>(angle)), angle);
        cosines.note(both.cosine - std::cos(static_cast<long double>(angle)), angle);
        units.note(static_cast<long double>(both.sine) * both.sine +
                       static_cast<long double>(both.cosine) * both.cosine - 1.0L,
                   angle);
        EXPECT_EQ(sine(angle), both.sine);
        EXPECT_EQ(cosine(angle), both.cosine);
    }
    EXPECT_WORST_BELOW(sines, 1e-13);
    EXPECT_WORST_BELOW(cosines, 1e-13);
    EXPECT_WORST_BELOW(units, 1e-13);
}

TEST(Sine, HasItsExactValues) {
    EXPECT_EQ(sine(0.0), 0.0);
    EXPECT_EQ(cosine(0.0), 1.0);
    EXPECT_EQ(sine(least_subnormal), least_subnormal);
    EXPECT_EQ(sine(pi / 2.0), 1.0);
    EXPECT_EQ(cosine(pi), -1.0);
    for (const double angle : {0.1, 1.0, 3.0, 1000.0}) { // odd and even, to the bit
        EXPECT_EQ(sine(-angle), -sine(angle));
        EXPECT_EQ(cosine(-angle), cosine(angle));
    }
}

TEST(Sine, OfNoAngleIsNoNumber) {
    for (const double angle : {infinity, -infinity, nan}) {
        EXPECT_TRUE(std::isnan(sine(angle)));
        EXPECT_TRUE(std::isnan(cosine(angle)));
        EXPECT_TRUE(std::isnan(tangent(angle)));
    }
}

TEST(Tangent, FollowsSineAndCosine) {
    Worst worst;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        const double angle = uniform(2, i, -1.5, 1.5); // |tan| < 15
        worst.note(tangent(angle) - std::tan(static_cast<long double>(angle)), angle);
    }
    EXPECT_WORST_BELOW(worst, 1e-12);
    EXPECT_EQ(tangent(0.0), 0.0);
}

TEST(ArcTangent, IsWithinItsBound) {
    Worst worst;
    const auto compare = [&](double y, double x) {
        const double angle = arc_tangent(y, x);
        worst.note(angle - std::atan2(static_cast<long double>(y), static_cast<long double>(x)), y);
        EXPECT_LE(std::fabs(angle), pi);
    };
    for (std::uint64_t i = 0; i < 100'000; ++i)
        compare(uniform(3, 2 * i, -2.0, 2.0), uniform(3, 2 * i + 1, -2.0, 2.0));
    for (const double y : {1e-300, 1e-9, 1.0, 1e9, 1e300, greatest, least_subnormal})
        for (const double x : {1e-300, 1e-9, 1.0, 1e9, 1e300, greatest, least_subnormal})
            for (const double sign : {1.0, -1.0}) {
                compare(y, sign * x);
                compare(-y, sign * x);
            }
    EXPECT_WORST_BELOW(worst, 1e-12);
}

TEST(ArcTangent, HasItsExactValues) {
    EXPECT_EQ(arc_tangent(0.0, 0.0), 0.0);
    EXPECT_EQ(arc_tangent(-0.0, -0.0), 0.0);
    EXPECT_EQ(arc_tangent(0.0, 1.0), 0.0);
    EXPECT_EQ(arc_tangent(0.0, -1.0), pi); // (-pi, pi]: the seam belongs to pi
    EXPECT_EQ(arc_tangent(-0.0, -1.0), pi);
    EXPECT_EQ(arc_tangent(1.0, 0.0), pi / 2.0);
    EXPECT_EQ(arc_tangent(-1.0, 0.0), -pi / 2.0);
    EXPECT_NEAR(arc_tangent(1.0, -1.0), 0.75 * pi, 1e-15);
    EXPECT_TRUE(std::isnan(arc_tangent(nan, 1.0)));
    EXPECT_TRUE(std::isnan(arc_tangent(1.0, nan)));
}

TEST(ArcSine, IsWithinItsBound) {
    Worst sines;
    Worst cosines;
    for (const double x : arguments(1.0, 4)) {
        sines.note(arc_sine(x) - std::asin(static_cast<long double>(x)), x);
        cosines.note(arc_cosine(x) - std::acos(static_cast<long double>(x)), x);
    }
    for (double gap = 0.1; gap > 1e-17; gap *= 0.7) // the steep ends
        for (const double sign : {1.0, -1.0}) {
            const double x = sign * (1.0 - gap);
            sines.note(arc_sine(x) - std::asin(static_cast<long double>(x)), x);
            cosines.note(arc_cosine(x) - std::acos(static_cast<long double>(x)), x);
        }
    EXPECT_WORST_BELOW(sines, 1e-10);
    EXPECT_WORST_BELOW(cosines, 1e-10);
}

TEST(ArcSine, ClampsItsArgument) {
    for (const double x : {1.0, 1.0 + 1e-15, 5.0, infinity}) {
        EXPECT_EQ(arc_sine(x), pi / 2.0);
        EXPECT_EQ(arc_sine(-x), -pi / 2.0);
        EXPECT_EQ(arc_cosine(x), 0.0);
        EXPECT_EQ(arc_cosine(-x), pi);
    }
    EXPECT_TRUE(std::isnan(arc_sine(nan)));
    EXPECT_TRUE(std::isnan(arc_cosine(nan)));
}

TEST(Exponential, IsWithinItsBound) {
    Worst worst;
    for (const double x : arguments(700.0, 5)) {
        const long double reference = std::exp(static_cast<long double>(x));
        worst.note((exponential(x) - reference) / reference, x);
    }
    EXPECT_WORST_BELOW(worst, 1e-13);
}

TEST(Exponential, HasItsEdges) {
    EXPECT_EQ(exponential(0.0), 1.0);
    EXPECT_EQ(exponential(std::nextafter(700.0, infinity)), infinity);
    EXPECT_EQ(exponential(infinity), infinity);
    EXPECT_EQ(exponential(std::nextafter(-700.0, -infinity)), 0.0);
    EXPECT_EQ(exponential(-infinity), 0.0);
    EXPECT_TRUE(std::isnan(exponential(nan)));
}

TEST(Logarithm, IsWithinItsBound) {
    Worst worst;
    const auto compare = [&](double x) {
        const long double reference = std::log(static_cast<long double>(x));
        if (reference != 0.0L) worst.note((logarithm(x) - reference) / reference, x);
    };
    for (std::uint64_t i = 0; i < 100'000; ++i)
        compare(uniform(6, i, 0.0, 4.0));
    for (double x = least_subnormal; x < 1e300; x *= 3.7)
        compare(x);
    for (double gap = 0.5; gap > 1e-15; gap *= 0.6) { // near 1 the logarithm itself is small
        compare(1.0 + gap);
        compare(1.0 - gap);
    }
    for (const double x :
         {least_normal, std::nextafter(least_normal, 0.0), greatest, std::sqrt(2.0), std::sqrt(0.5)})
        compare(x);
    EXPECT_WORST_BELOW(worst, 1e-12);
}

TEST(Logarithm, HasItsEdges) {
    EXPECT_EQ(logarithm(1.0), 0.0);
    EXPECT_EQ(logarithm(0.0), -infinity);
    EXPECT_EQ(logarithm(-0.0), -infinity);
    EXPECT_EQ(logarithm(-1.0), -infinity);
    EXPECT_EQ(logarithm(infinity), infinity);
    EXPECT_TRUE(std::isnan(logarithm(nan)));
}

TEST(Power, IsWithinItsBound) {
    Worst worst;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        const double x = exponential(uniform(7, 2 * i, -20.0, 20.0));
        const double y = uniform(7, 2 * i + 1, -5.0, 5.0);
        const long double reference = std::pow(static_cast<long double>(x), static_cast<long double>(y));
        worst.note((power(x, y) - reference) / reference, x);
    }
    EXPECT_WORST_BELOW(worst, 1e-10);
}

TEST(Power, HasItsEdges) {
    EXPECT_EQ(power(0.0, 2.0), 0.0);
    EXPECT_EQ(power(0.0, 0.5), 0.0);
    EXPECT_EQ(power(1.0, 3.0), 1.0);
    EXPECT_EQ(power(5.0, 0.0), 1.0);
    EXPECT_NEAR(power(2.0, 10.0), 1024.0, 1e-9);
}

TEST(Modulo, LiesInItsPeriod) {
    for (const double period : {1.0, two_pi, 28.0, 360.0, 1e-3})
        for (const double x : arguments(1e6, 8)) {
            const double rest = modulo(x, period);
            EXPECT_GE(rest, 0.0) << x;
            EXPECT_LT(rest, period) << x;
        }
}

TEST(Modulo, IsTheRest) {
    EXPECT_EQ(modulo(7.5, 2.0), 1.5);
    EXPECT_EQ(modulo(-0.5, 2.0), 1.5);
    EXPECT_EQ(modulo(-2.0, 2.0), 0.0);
    EXPECT_EQ(modulo(4.0, 2.0), 0.0);
    EXPECT_EQ(modulo(-1e-20, 2.0), 0.0); // 2 - 1e-20 is no double: the border, not the period itself
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        const double x = uniform(9, i, -1e6, 1e6);
        const long double turns = (static_cast<long double>(x) - modulo(x, 28.0)) / 28.0L;
        EXPECT_NEAR(static_cast<double>(turns - std::round(turns)), 0.0, 1e-9) << x;
    }
}

TEST(Angles, AreConvertedBothWays) {
    EXPECT_EQ(radians(180.0), pi);
    EXPECT_EQ(degrees(pi), 180.0);
    for (const double angle : {-720.0, -1.0, 0.0, 19.4712, 360.0})
        EXPECT_NEAR(degrees(radians(angle)), angle, 1e-12);
}

} // namespace

} // namespace linkdig
