#include "database/model/mathematics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

// std::floor, std::sqrt, std::isfinite and std::frexp-like bit work are exact by IEEE 754; nothing else of <cmath> is used.

namespace linkdig {

namespace {

// pi/2 in three parts whose leading ones have trailing zeros, so that quadrant x part is exact (Cody and Waite).
constexpr double half_pi_high = 1.57079632673412561417e+00;
constexpr double half_pi_middle = 6.07710050630396597660e-11;
constexpr double half_pi_low = 2.02226624879595063154e-21;

constexpr double ln2_high = 6.93147180369123816490e-01;
constexpr double ln2_low = 1.90821492927058770002e-10;

// Taylor polynomials on [-pi/4, pi/4]: the first omitted term is below 1e-16.
double sine_core(double r) {
    const double r2 = r * r;
    double p = -1.0 / 1307674368000.0;
    p = p * r2 + 1.0 / 6227020800.0;
    p = p * r2 - 1.0 / 39916800.0;
    p = p * r2 + 1.0 / 362880.0;
    p = p * r2 - 1.0 / 5040.0;
    p = p * r2 + 1.0 / 120.0;
    p = p * r2 - 1.0 / 6.0;
    return r + r * r2 * p;
}

double cosine_core(double r) {
    const double r2 = r * r;
    double p = 1.0 / 20922789888000.0;
    p = p * r2 - 1.0 / 87178291200.0;
    p = p * r2 + 1.0 / 479001600.0;
    p = p * r2 - 1.0 / 3628800.0;
    p = p * r2 + 1.0 / 40320.0;
    p = p * r2 - 1.0 / 720.0;
    p = p * r2 + 1.0 / 24.0;
    p = p * r2 - 0.5;
    return 1.0 + r2 * p;
}

// Arc tangent of x in [0, 1]: reduced by the addition theorem to |t| <= tan(pi/32), then its Taylor series.
double arc_tangent_unit(double x) {
    double scale = 1.0;
    for (int halving = 0; halving < 3; ++halving) { // atan x = 2 atan(x / (1 + sqrt(1 + x^2)))
        x = x / (1.0 + std::sqrt(1.0 + x * x));
        scale *= 2.0;
    }
    const double x2 = x * x;
    double p = 1.0 / 17.0;
    for (int k = 15; k >= 1; k -= 2)
        p = 1.0 / k - x2 * p;
    return scale * x * p;
}

} // namespace

SineCosine sine_cosine(double angle_rad) {
    if (!std::isfinite(angle_rad)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan};
    }
    const double quadrant = std::floor(angle_rad * (2.0 / pi) + 0.5);
    const double r =
        ((angle_rad - quadrant * half_pi_high) - quadrant * half_pi_middle) - quadrant * half_pi_low;
    const double s = sine_core(r);
    const double c = cosine_core(r);
    const double turn = quadrant - 4.0 * std::floor(quadrant * 0.25);
    if (turn == 0.0) return {s, c};
    if (turn == 1.0) return {c, -s};
    if (turn == 2.0) return {-s, -c};
    return {-c, s};
}

double sine(double angle_rad) { return sine_cosine(angle_rad).sine; }
double cosine(double angle_rad) { return sine_cosine(angle_rad).cosine; }

double tangent(double angle_rad) {
    const SineCosine sc = sine_cosine(angle_rad);
    return sc.sine / sc.cosine;
}

double arc_tangent(double y, double x) {
    const double ax = std::fabs(x);
    const double ay = std::fabs(y);
    if (ax == 0.0 && ay == 0.0) return 0.0;
    double angle = ay <= ax ? arc_tangent_unit(ay / ax) : pi / 2.0 - arc_tangent_unit(ax / ay);
    if (x < 0.0) angle = pi - angle;
    return y < 0.0 ? -angle : angle;
}

double arc_sine(double x) {
    if (x >= 1.0) return pi / 2.0;
    if (x <= -1.0) return -pi / 2.0;
    return arc_tangent(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double arc_cosine(double x) {
    if (x >= 1.0) return 0.0;
    if (x <= -1.0) return pi;
    return arc_tangent(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

double exponential(double x) {
    if (x != x) return x;
    if (x > 700.0) return std::numeric_limits<double>::infinity();
    if (x < -700.0) return 0.0;
    const double k = std::floor(x * 1.44269504088896340736 + 0.5);
    const double r = (x - k * ln2_high) - k * ln2_low;
    double p = 1.0;
    for (int n = 14; n >= 1; --n)
        p = 1.0 + p * r / n;
    const auto exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + 1023);
    // |k| <= 1010, so the exponent is that of a normal number.
    return p * std::bit_cast<double>(exponent << 52U);
}

double logarithm(double x) {
    if (x != x) return x;
    if (x <= 0.0) return -std::numeric_limits<double>::infinity();
    if (std::isinf(x)) return x;
    double k = 0.0;
    if (x < std::numeric_limits<double>::min()) { // subnormal
        x *= 18014398509481984.0;                 // 2^54
        k = -54.0;
    }
    const auto bits = std::bit_cast<std::uint64_t>(x);
    k += static_cast<double>(static_cast<std::int64_t>(bits >> 52U) - 1023);
    double m = std::bit_cast<double>((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL);
    if (m > 1.41421356237309504880) {
        m *= 0.5;
        k += 1.0;
    }
    const double s = (m - 1.0) / (m + 1.0); // log m = 2 atanh s, |s| <= 0.1716
    const double s2 = s * s;
    double p = 1.0 / 21.0;
    for (int n = 19; n >= 1; n -= 2)
        p = 1.0 / n + s2 * p;
    return k * ln2_high + (k * ln2_low + 2.0 * s * p);
}

double power(double x, double y) {
    if (x == 0.0) return y > 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
    return exponential(y * logarithm(x));
}

double smooth_step(double t) {
    const double inside = std::clamp(t, 0.0, 1.0);
    return inside * inside * (3.0 - 2.0 * inside);
}

double modulo(double x, double period) {
    const double r = x - period * std::floor(x / period);
    return r >= 0.0 && r < period ? r : 0.0;
}

} // namespace linkdig
