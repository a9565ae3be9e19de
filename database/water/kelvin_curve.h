#pragma once
/// The phase curve of a Kelvin wake (Glassner, "Duck!", where K is drawn, with the sign of Ky mended).
///
///   Kx(psi, u) = -psi/4 (5 cos u - cos 3u) = -psi (2 cos u - cos^3 u)
///   Ky(psi, u) = -psi/4 (sin u + sin 3u)   = -psi sin u cos^2 u,        -pi/2 <= u <= pi/2
///
/// with the swimmer at the origin, swimming towards +x. The column prints a minus in Ky, with which there is no cusp; its
/// own cusp at psi (-1.088, -0.385) comes out with the plus. psi is a length: the distance from the swimmer back to
/// where the curve crosses its path.

#include "database/model/vectors.h"

namespace linkdig::database {

/// |u| of the cusps, acos(sqrt(2/3)) = 35.26 degrees: dK/du = psi (3 cos^2 u - 2) (-sin u, -cos u) vanishes there.
double kelvin_cusp_u();

/// Half the angle of the cone that holds all waves: asin(1/3) = 19.47 degrees.
double kelvin_half_angle_rad();

/// Sine and cosine of u; u in [-pi/2, pi/2].
struct CurvePlace {
    double sine = 0.0;
    double cosine = 1.0;
};
CurvePlace curve_place(double u);

/// K(psi, u).
Vec2d kelvin_curve(double psi, const CurvePlace& place);

/// dK/du.
Vec2d kelvin_derivative(double psi, const CurvePlace& place);

/// Length of the curve from u = -pi/2 to u, for psi = 1; the integral of |3 cos^2 u - 2|, in closed form. It is 0 at -pi/2.
double kelvin_arc_length(double u);

/// Length of the whole curve for psi = 1: 4 (3/4 sin 2c - c/2) + pi/2 with c the cusp's u, 3.1688.
double kelvin_total_length();

/// The u to which the curve has run `fraction` of its length; fraction in [0, 1], u exact to 1e-12.
double kelvin_u_at(double fraction);

} // namespace linkdig::database
