#include "database/water/kelvin_curve.h"

#include "database/model/mathematics.h"

#include <cmath>

namespace linkdig::database {

namespace {

/// Integral of 3 cos^2 u - 2 from 0: its sign changes at the cusps.
double signed_length(double u) { return 0.75 * sine(2.0 * u) - 0.5 * u; }

/// Length from u = 0 to |u|.
double length_from_middle(double u) {
    const double cusp = kelvin_cusp_u();
    const double to_cusp = signed_length(cusp);
    return u <= cusp ? signed_length(u) : 2.0 * to_cusp - signed_length(u);
}

} // namespace

double kelvin_cusp_u() { return arc_cosine(std::sqrt(2.0 / 3.0)); }

double kelvin_half_angle_rad() { return arc_sine(1.0 / 3.0); }

CurvePlace curve_place(double u) {
    const SineCosine at = sine_cosine(u);
    return {at.sine, at.cosine};
}

Vec2d kelvin_curve(double psi, const CurvePlace& place) {
    const double square = place.cosine * place.cosine;
    return {-psi * place.cosine * (2.0 - square), -psi * place.sine * square};
}

Vec2d kelvin_derivative(double psi, const CurvePlace& place) {
    const double rate = psi * (3.0 * place.cosine * place.cosine - 2.0);
    return {-rate * place.sine, -rate * place.cosine};
}

double kelvin_arc_length(double u) {
    const double half = length_from_middle(0.5 * pi);
    return u < 0.0 ? half - length_from_middle(-u) : half + length_from_middle(u);
}

double kelvin_total_length() { return 2.0 * length_from_middle(0.5 * pi); }

double kelvin_u_at(double fraction) {
    const double wanted = fraction * kelvin_total_length();
    double least = -0.5 * pi;
    double greatest = 0.5 * pi;
    for (int i = 0; i < 44; ++i) { // pi / 2^44 < 2e-13
        const double middle = 0.5 * (least + greatest);
        (kelvin_arc_length(middle) < wanted ? least : greatest) = middle;
    }
    return 0.5 * (least + greatest);
}

} // namespace linkdig::database
