#pragma once
/// Transcendental functions from + - x / and sqrt alone.
///
/// The C library's sin, cos, exp, atan2 and pow give other bits on another CPU, so none of them may influence
/// a face, a packet, a compiled database or a field. These give the same bits everywhere (built without
/// contraction), and agree with the true value to the bounds stated, which is far below one intensity level.

namespace linkdig {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double two_pi = 2.0 * pi;

struct SineCosine {
    double sine;
    double cosine;
};

/// Sine and cosine of an angle in radians, |angle| <= 1e6 (beyond it the argument reduction loses digits).
/// Absolute error below 1e-13. A NaN or infinite angle gives NaN.
SineCosine sine_cosine(double angle_rad);
double sine(double angle_rad);
double cosine(double angle_rad);
double tangent(double angle_rad);

/// Angle of the vector (x, y), in (-pi, pi]; 0 for the null vector. Absolute error below 1e-12.
double arc_tangent(double y, double x);
/// Arc sine and arc cosine, argument clamped to [-1, 1]. Absolute error below 1e-10.
double arc_sine(double x);
double arc_cosine(double x);

/// e^x; relative error below 1e-13 for |x| <= 700, 0 below, infinity above.
double exponential(double x);
/// Natural logarithm of x > 0; relative error below 1e-12. x <= 0 gives -infinity.
double logarithm(double x);
/// x^y for x > 0; relative error below 1e-10 while |y log x| <= 100. x == 0 gives 0 (y > 0).
double power(double x, double y);

constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
constexpr double degrees(double radians_value) { return radians_value * (180.0 / pi); }

/// Rises from 0 at t <= 0 to 1 at t >= 1, level at both ends.
double smooth_step(double t);

/// x reduced to [0, period), period > 0.
double modulo(double x, double period);

} // namespace linkdig
