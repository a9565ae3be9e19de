// Kelvin wakes against what can be said of them without drawing any: angles, lengths, symmetries, sums.

#include "database/model/mathematics.h"
#include "database/model/units.h"
#include "database/water/kelvin_curve.h"
#include "database/water/kelvin_wake.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

namespace linkdig::database {
namespace {

constexpr double side = 512.0; // of cells of 1 m

KelvinSwimmer swimmer(std::vector<PathPiece> path, double damping_per_s = 0.02) {
    constexpr double speed = 5.0;
    return {.name = "boat",
            .path = std::move(path),
            .speed = speed,
            .oscillation_rad_s = gravity_mps2 / speed,
            .damping_per_s = damping_per_s};
}

const LinePiece straight{{40.5, 256.0}, {480.5, 256.0}};

KelvinWakes wakes_of(std::vector<KelvinSwimmer> swimmers) {
    KelvinWakes wakes;
    wakes.size = 512;
    wakes.side = side;
    wakes.psi_per_unit = 10.0;
    wakes.swimmers = std::move(swimmers);
    return wakes;
}

WaveField straight_field() {
    static const WaveField field = kelvin_field(wakes_of({swimmer({straight})})).field;
    return field;
}

Vec2d middle_of(const WaveField& field, std::size_t k) {
    return field.origin + field.cell * Vec2d(static_cast<double>(k % field.size) + 0.5,
                                             static_cast<double>(k / field.size) + 0.5);
}

double square(float h) { return static_cast<double>(h) * static_cast<double>(h); }

double largest_difference(const WaveField& a, const WaveField& b) {
    double largest = 0.0;
    for (std::size_t k = 0; k < a.heights.size(); ++k)
        largest = std::max(largest,
                           std::fabs(static_cast<double>(a.heights[k]) - static_cast<double>(b.heights[k])));
    return largest;
}

TEST(KelvinCurve, HasItsCuspsWhereItsDerivativeVanishes) {
    const double u = kelvin_cusp_u();
    EXPECT_NEAR(degrees(u), 35.2644, 1e-4);
    EXPECT_NEAR(u, std::acos(std::sqrt(2.0 / 3.0)), 1e-9);
    EXPECT_LT(glm::length(kelvin_derivative(1.0, curve_place(u))), 1e-9);
    const Vec2d cusp = kelvin_curve(1.0, curve_place(u));
    EXPECT_NEAR(cusp.x, -1.0887, 1e-4);
    EXPECT_NEAR(cusp.y, -0.3849, 1e-4);
    EXPECT_NEAR(degrees(kelvin_half_angle_rad()), 19.4712, 1e-4);
    EXPECT_NEAR(std::atan2(cusp.y, cusp.x), -pi + kelvin_half_angle_rad(), 1e-9);
}

TEST(KelvinCurve, IsTheColumnsFormulaWithItsSignMended) {
    for (double u = -1.57; u <= 1.57; u += 0.01) {
        const Vec2d k = kelvin_curve(3.0, curve_place(u));
        EXPECT_NEAR(k.x, -0.75 * (5.0 * std::cos(u) - std::cos(3.0 * u)), 1e-12);
        EXPECT_NEAR(k.y, -0.75 * (std::sin(u) + std::sin(3.0 * u)), 1e-12);
        const Vec2d d = kelvin_derivative(3.0, curve_place(u));
        EXPECT_NEAR(d.x, -0.75 * (-5.0 * std::sin(u) + 3.0 * std::sin(3.0 * u)), 1e-12);
        EXPECT_NEAR(d.y, -0.75 * (std::cos(u) + 3.0 * std::cos(3.0 * u)), 1e-12);
        EXPECT_LE(std::atan2(std::fabs(k.y), -k.x), kelvin_half_angle_rad() + 1e-9);
    }
}

TEST(KelvinCurve, EvenSharesAreEvenAlongIt) {
    constexpr int parts = 200;
    constexpr int steps = 200;
    double longest = 0.0;
    double shortest = 1e9;
    for (int i = 0; i < parts; ++i) { // each part measured by small chords
        const double from = kelvin_u_at(static_cast<double>(i) / parts);
        const double to = kelvin_u_at((i + 1.0) / parts);
        double length = 0.0;
        for (int k = 0; k < steps; ++k)
            length += glm::distance(kelvin_curve(1.0, curve_place(from + (to - from) * k / steps)),
                                    kelvin_curve(1.0, curve_place(from + (to - from) * (k + 1.0) / steps)));
        longest = std::max(longest, length);
        shortest = std::min(shortest, length);
    }
    EXPECT_NEAR(longest * parts, kelvin_total_length(), 1e-3);
    EXPECT_NEAR(shortest * parts, kelvin_total_length(), 1e-3);
    EXPECT_NEAR(kelvin_arc_length(0.5 * pi), kelvin_total_length(), 1e-12);
}

TEST(SwimmingPath, KnowsItsLengthAndWhereItWent) {
    const SampledPath line = sample_path({straight}, 0.5, 0.0);
    EXPECT_NEAR(line.length, 440.0, 1e-9);
    EXPECT_NEAR(line.points[200].x, 380.5, 1e-9);
    const SampledPath arc = sample_path({ArcPiece{{0, 0}, 10.0, 10.0, 0.0, pi}}, 0.01, 20.0);
    EXPECT_NEAR(arc.length, 10.0 * pi, 1e-9);
    EXPECT_NEAR(arc.points[0].x, -10.0, 1e-9);
    for (std::size_t k = 0; k < 3141; k += 97)
        EXPECT_NEAR(glm::length(arc.points[k]), 10.0, 1e-9);
    EXPECT_NEAR(arc.tangents[0].y, -1.0, 1e-9); // counter-clockwise: at (-10, 0) it swims towards -y
    const SampledPath spiral = sample_path({ArcPiece{{0, 0}, 1.0, 2.0, 0.0, two_pi}}, 0.01, 0.0);
    // Archimedes: r = a + b phi, ds = sqrt(r^2 + b^2) dphi
    const double b = 1.0 / two_pi;
    const auto whole = [&](double r) {
        return (0.5 * r * std::hypot(r, b) + 0.5 * b * b * std::asinh(r / b)) / b;
    };
    EXPECT_NEAR(spiral.length, whole(2.0) - whole(1.0), 1e-6);
}

TEST(SwimmingPath, GoesOnStraightBeforeItsBeginning) {
    const SampledPath path = sample_path({ArcPiece{{0, 0}, 10.0, 10.0, 0.0, pi}}, 0.5, 100.0);
    EXPECT_GE(static_cast<double>(path.points.size() - 1) * path.step, 100.0);
    EXPECT_NEAR(path.points[100].x, 10.0, 1e-9); // it came along x = 10, from below
    EXPECT_NEAR(path.points[100].y, -(50.0 - 10.0 * pi), 1e-9);
}

TEST(SwimmingPath, NaturalSplineGoesThroughItsPointsWithoutAKink) {
    const std::vector<Vec2d> points{{0, 0}, {2, 3}, {5, 1}, {6, 6}};
    const std::vector<BezierPiece> curves = natural_spline(points);
    ASSERT_EQ(curves.size(), 3U);
    const auto second = [](const BezierPiece& c, int end) {
        return end == 0 ? c.points[0] - 2.0 * c.points[1] + c.points[2]
                        : c.points[1] - 2.0 * c.points[2] + c.points[3];
    };
    for (std::size_t i = 0; i + 1 < curves.size(); ++i) {
        EXPECT_LT(glm::distance(curves[i].points[3], points[i + 1]), 1e-12);
        EXPECT_LT(glm::distance(place_on(curves[i], 1.0).derivative, place_on(curves[i + 1], 0.0).derivative),
                  1e-12);
        EXPECT_LT(glm::distance(second(curves[i], 1), second(curves[i + 1], 0)), 1e-12);
    }
    EXPECT_LT(glm::length(second(curves.front(), 0)), 1e-12);
    EXPECT_LT(glm::length(second(curves.back(), 1)), 1e-12);
    EXPECT_EQ(natural_spline({{0, 0}, {3, 0}})[0].points[1], Vec2d(1, 0));
}

TEST(SwimmingPath, MistakesAreTold) {
    EXPECT_EQ(path_mistake({}), "has no piece; expected at least one");
    EXPECT_EQ(path_mistake({straight, LinePiece{{480.5, 256.0}, {480.5, 256.0}}}), "piece 2 has no length");
    EXPECT_EQ(path_mistake({straight, LinePiece{{0, 0}, {1, 0}}}),
              "piece 2 begins at (0, 0); expected (480.5, 256), where the piece before it ends");
    EXPECT_EQ(path_mistake({LinePiece{{0, 0}, {std::nan(""), 0}}}), "has numbers that are not finite");
    EXPECT_EQ(path_mistake({straight}), "");
}

TEST(KelvinWake, StaysInItsCone) {
    const WaveField field = straight_field();
    const double tangent_of_cone = std::tan(kelvin_half_angle_rad());
    const double half_diagonal = field.cell * std::sqrt(0.5);
    double inside = 0.0;
    double outside = 0.0;
    for (std::size_t k = 0; k < field.heights.size(); ++k) {
        const Vec2d from_apex = middle_of(field, k) - straight.to;
        if (glm::length(from_apex) < 2.0 * field.cell) continue;
        // Distance beyond the cone's side.
        const double beyond =
            (std::fabs(from_apex.y) + from_apex.x * tangent_of_cone) * std::cos(kelvin_half_angle_rad());
        (beyond > half_diagonal ? outside : inside) += square(field.heights[k]);
    }
    EXPECT_GT(inside, 0.0);
    EXPECT_LT(outside, 0.01 * (inside + outside));
}

TEST(KelvinWake, ConeMeasuredFromTheFieldHasTheKelvinAngle) {
    // Undamped, the edge is as sharp far out as near. Per column of cells behind the boat: the outermost cell that is not still.
    const WaveField field = kelvin_field(wakes_of({swimmer({straight}, 0.0)})).field;
    double n = 0.0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    double sum_xx = 0.0;
    double sum_xy = 0.0;
    for (std::uint32_t column = 80; column < 400; ++column) {
        float largest = 0.0F;
        for (std::uint32_t row = 0; row < field.size; ++row)
            largest = std::max(largest, std::fabs(field.heights[std::size_t{row} * field.size + column]));
        std::uint32_t row = field.size - 1;
        while (std::fabs(field.heights[std::size_t{row} * field.size + column]) < 0.1F * largest)
            --row;
        const double x = straight.to.x - (column + 0.5);
        const double y = row + 0.5 - straight.to.y;
        n += 1.0;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    const double slope = (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
    EXPECT_NEAR(degrees(std::atan(slope)), 19.47, 0.2);
}

TEST(KelvinWake, InAHalfTurnStaysInTheCirclesOfItsPackets) {
    // Figure 8e for each place of the path: what left it s ago lies in a circle of radius s/4, s/4 ahead.
    const ArcPiece turn{{256.0, 256.0}, 110.0, 110.0, 0.0, pi};
    KelvinWakes wakes = wakes_of({swimmer({turn}, 0.005)});
    wakes.before = KelvinBefore::rest;
    const double slack = std::sqrt(0.5); // half a cell's diagonal: a splat reaches so far
    const auto share_outside = [&](KelvinLayout layout) {
        wakes.layout = layout;
        const WaveField field = kelvin_field(wakes).field;
        const SampledPath path = sample_path({turn}, 0.5, 0.0);
        double outside = 0.0;
        double all = 0.0;
        for (std::size_t k = 0; k < field.heights.size(); ++k) {
            const double energy = square(field.heights[k]);
            all += energy;
            if (energy == 0.0) continue;
            bool within = false;
            for (std::size_t i = 0; i < path.points.size() && !within; ++i) {
                const double s = static_cast<double>(i) * path.step;
                if (s > path.length) break;
                within = glm::distance(middle_of(field, k), path.points[i] + 0.25 * s * path.tangents[i]) <=
                         0.25 * s + slack;
            }
            if (!within) outside += energy;
        }
        return outside / all;
    };
    EXPECT_LT(share_outside(KelvinLayout::rays), 0.02);
    EXPECT_GT(share_outside(KelvinLayout::tangent),
              0.05); // the column's literal way is another one
}

TEST(KelvinWake, IsSymmetrical) {
    const WaveField field = straight_field();
    double largest = 0.0;
    for (std::size_t row = 0; row < 256; ++row)
        for (std::size_t column = 0; column < 512; ++column)
            largest =
                std::max(largest, std::fabs(static_cast<double>(field.heights[row * 512 + column]) -
                                            static_cast<double>(field.heights[(511 - row) * 512 + column])));
    EXPECT_LT(largest, 1e-6);
    EXPECT_GT(rms_of(field), 0.1);
}

TEST(KelvinWake, TransverseWavesAreAsLongAsPhysicsSays) {
    const WaveField field = kelvin_field(wakes_of({swimmer({straight}, 0.0)})).field;
    // Zero crossings on the path, upwards and downwards, from 60 m to 360 m behind.
    double first = 0.0;
    double last = 0.0;
    int crossings = 0;
    const float* const row = &field.heights[256U * 512];
    for (int column = 120; column < 420; ++column) {
        if ((row[column] < 0.0F) == (row[column + 1] < 0.0F)) continue;
        const double at = column + static_cast<double>(row[column] / (row[column] - row[column + 1]));
        if (crossings++ == 0) first = at;
        last = at;
    }
    ASSERT_GT(crossings, 20);
    EXPECT_NEAR(2.0 * (last - first) / (crossings - 1), two_pi * 25.0 / gravity_mps2, 0.1);
}

TEST(KelvinWake, WakesAddUp) {
    const KelvinSwimmer one = swimmer({straight});
    const KelvinSwimmer other = swimmer({ArcPiece{{256.0, 200.0}, 150.0, 100.0, 0.0, 4.0}});
    const WaveField a = kelvin_field(wakes_of({one})).field;
    const WaveField b = kelvin_field(wakes_of({other})).field;
    WaveField both = kelvin_field(wakes_of({one, other})).field;
    for (std::size_t k = 0; k < both.heights.size(); ++k)
        both.heights[k] -= b.heights[k];
    EXPECT_LT(largest_difference(both, a), 1e-5);
}

TEST(KelvinWake, APathInSevenPiecesIsTheSamePath) {
    const std::vector<PathPiece> wholes{
        straight, ArcPiece{{256.0, 256.0}, 120.0, 120.0, 0.3, 3.0},
        ArcPiece{{256.0, 256.0}, 60.0, 160.0, 3.0, -1.0},
        BezierPiece{{Vec2d(60, 60), Vec2d(300, 60), Vec2d(200, 460), Vec2d(450, 450)}}};
    for (const PathPiece& whole : wholes) {
        SCOPED_TRACE(whole.index());
        std::vector<PathPiece> pieces;
        for (int i = 0; i < 7; ++i)
            pieces.push_back(part_of(whole, i / 7.0, (i + 1) / 7.0));
        ASSERT_EQ(path_mistake(pieces), "");
        const WaveField one = kelvin_field(wakes_of({swimmer({whole})})).field;
        const WaveField seven = kelvin_field(wakes_of({swimmer(pieces)})).field;
        EXPECT_GT(rms_of(one), 0.01);
        EXPECT_LT(largest_difference(one, seven), 1e-4);
    }
}

TEST(KelvinWake, DoesNotDependOnHowManySamplesThereAre) {
    const WaveField field = straight_field();
    KelvinWakes more = wakes_of({swimmer({straight})});
    more.psi_per_unit = 25.0;
    more.u_steps = 2000;
    EXPECT_LT(largest_difference(field, kelvin_field(more).field), 0.2 * rms_of(field));
    more.sampling = KelvinSampling::weighted;
    EXPECT_LT(largest_difference(field, kelvin_field(more).field), 0.2 * rms_of(field));
}

TEST(KelvinWake, EvenSamplesLeaveNoRogues) {
    KelvinWakes wakes = wakes_of({swimmer({straight})});
    wakes.psi_per_unit = 75.0; // the column's figures
    wakes.u_steps = 750;
    EXPECT_EQ(rogue_cells(kelvin_field(wakes).field), 0U);
    wakes.sampling = KelvinSampling::column;
    WaveField column = kelvin_field(wakes).field;
    const std::uint64_t rogues = rogue_cells(column);
    EXPECT_GT(rogues, 100U);
    for (int pass = 0; pass < 3; ++pass)
        EXPECT_GT(smooth_field(column, 3.0 * rms_of(column)), 0U);
    EXPECT_LT(rogue_cells(column), rogues);
}

TEST(KelvinWake, SameBytesForAnyNumberOfThreads) {
    const WaveField field = straight_field();
    for (const std::size_t threads : {1U, 2U, 5U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        EXPECT_EQ(kelvin_field(wakes_of({swimmer({straight})})).field.heights, field.heights);
    }
}

TEST(KelvinWake, OfARestedSwimmerStaysBehindWhatItSwam) {
    // Nothing older than the path: energy runs half as fast as the boat, so half of the way back lies still.
    KelvinWakes wakes = wakes_of({swimmer({straight}, 0.0)});
    wakes.before = KelvinBefore::rest;
    const WaveField field = kelvin_field(wakes).field;
    for (std::size_t row = 250; row < 262; ++row)
        for (std::size_t column = 0; column < 250; ++column)
            EXPECT_EQ(field.heights[row * 512 + column], 0.0F);
    EXPECT_NE(field.heights[256 * 512 + 300], 0.0F);
}

TEST(WaveField, GreyImageRunsFromBlackToWhiteWithTheTopRowFirst) {
    WaveField field{2, 1.0, {}, {-1.0F, 0.0F, 0.5F, 3.0F}};
    EXPECT_EQ(grey_image(field), (std::vector<std::uint8_t>{96, 255, 0, 64}));
    field.heights = {2.0F, 2.0F, 2.0F, 2.0F};
    EXPECT_EQ(grey_image(field), (std::vector<std::uint8_t>{128, 128, 128, 128}));
}

} // namespace
} // namespace linkdig::database
