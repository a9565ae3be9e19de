#include "database/model/rotation.h"

#include "database/model/random.h"

#include <gtest/gtest.h>

namespace linkdig {

namespace {

constexpr double quarter = pi / 2.0;
const Vec3d forward(1, 0, 0);
const Vec3d port(0, 1, 0);
const Vec3d up(0, 0, 1);

void expect_near(const Vec3d& actual, const Vec3d& expected, double tolerance = 1e-13) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(actual[axis], expected[axis], tolerance) << "axis " << axis;
}

TEST(WorldFromBody, IsTheIdentityAtRest) { EXPECT_EQ(world_from_body({}), Mat3d(1.0)); }

TEST(WorldFromBody, HeadingTurnsCounterClockwiseFromEast) {
    const Mat3d north = world_from_body({.heading_rad = quarter});
    expect_near(north * forward, {0, 1, 0});
    expect_near(north * port, {-1, 0, 0});
    expect_near(north * up, {0, 0, 1});
}

TEST(WorldFromBody, PositivePitchLiftsTheBow) {
    expect_near(world_from_body({.pitch_rad = quarter}) * forward, {0, 0, 1});
    EXPECT_GT((world_from_body({.heading_rad = 2.0, .pitch_rad = 0.1}) * forward).z, 0.0);
}

TEST(WorldFromBody, PositiveRollLowersStarboard) {
    const Mat3d rolled = world_from_body({.roll_rad = 0.1});
    EXPECT_LT((rolled * -port).z, 0.0); // starboard is -y
    EXPECT_GT((rolled * port).z, 0.0);
    expect_near(world_from_body({.roll_rad = quarter}) * port, {0, 0, 1});
}

/// A right-handed rotation about an axis, entry by entry.
Mat3d about(int axis, double angle) {
    const double s = sine(angle);
    const double c = cosine(angle);
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    Mat3d m(1.0);
    m[a][a] = c;
    m[a][b] = s; // [column][row]
    m[b][a] = -s;
    m[b][b] = c;
    return m;
}

TEST(WorldFromBody, IsTheProductOfItsThreeTurns) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const auto angle = [&](std::uint64_t k) { return 20.0 * random_unit(11, 3 * i + k) - 10.0; };
        const Attitude attitude{angle(0), angle(1), angle(2)};
        const Mat3d expected =
            about(2, attitude.heading_rad) * about(1, -attitude.pitch_rad) * about(0, attitude.roll_rad);
        const Mat3d made = world_from_body(attitude);
        const Mat3d unit = glm::transpose(made) * made;
        for (int column = 0; column < 3; ++column) {
            expect_near(made[column], expected[column]);
            expect_near(unit[column], Mat3d(1.0)[column]);
        }
        EXPECT_NEAR(glm::determinant(made), 1.0, 1e-13); // no reflection
    }
}

TEST(Direction, PointsToAzimuthAndElevation) {
    expect_near(direction(0.0, 0.0), {1, 0, 0});
    expect_near(direction(quarter, 0.0), {0, 1, 0});
    expect_near(direction(0.7, quarter), {0, 0, 1});
    expect_near(direction(pi, radians(30.0)), {-0.86602540378443865, 0, 0.5});
    for (std::uint64_t i = 0; i < 1000; ++i)
        EXPECT_NEAR(glm::length(direction(10.0 * random_unit(12, i), 3.0 * random_unit(13, i) - 1.5)), 1.0,
                    1e-13);
}

TEST(Direction, IsWhereABodyOfThatHeadingAndPitchLooks) {
    expect_near(direction(1.2, 0.3), world_from_body({1.2, 0.3, 0.9}) * forward);
}

TEST(AviationHeading, RunsClockwiseFromNorth) {
    EXPECT_EQ(heading_from_aviation(0.0), quarter); // north
    EXPECT_EQ(heading_from_aviation(quarter), 0.0); // east
    EXPECT_EQ(heading_from_aviation(pi), -quarter); // south
    for (const double heading : {-3.0, 0.0, 0.5, 6.0})
        EXPECT_NEAR(aviation_from_heading(heading_from_aviation(heading)), heading, 1e-15);
}

} // namespace

} // namespace linkdig
