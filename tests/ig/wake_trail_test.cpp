// A ship's last minutes of track as wake faces: along the track, within their reserve, and never at once.

#include "ig/water/wake_trail.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"
#include "ig/machine/history_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::ig {
namespace {

constexpr double edge_deg = 35.26438968;

/// Steers a ship step by step, as a host would.
struct Steamer {
    WakeRequest wake{.most_faces = 1000, .age_s = 60.0F, .speed_mps = 7.0F};
    FramePacket packet;
    WakeTrail trail;
    double heading_rad = 0.0;

    Steamer() {
        packet.moving_objects.resize(1);
        follow_track(wake, packet, trail);
    }
    void step(double seconds, double turn_rad_s, double speed_mps) {
        heading_rad += turn_rad_s * seconds;
        MovingObject& ship = packet.moving_objects[0];
        ship.waterline_position_m += direction(heading_rad, 0.0) * (speed_mps * seconds);
        ship.waterline_heading_rad = heading_rad;
        wake.speed_mps = static_cast<float>(speed_mps);
        packet.time_s += seconds;
        follow_track(wake, packet, trail);
    }
    TrackSample now() const { return track_sample(wake, packet); }
    WakePoint wave(double row_s, double row_step_s, double u_rad) const {
        return wave_point(wake, trail, now(), wake_row(wake, trail, now(), row_s, row_step_s), u_rad);
    }
    ActiveDatabase faces() const {
        ActiveDatabase active;
        std::vector<WakeRow> rows;
        active.blocks.emplace_back();
        make_trail_faces(wake, trail, now(), rows, active, active.blocks.front());
        return active;
    }
};

TEST(WakeTrail, LiesInKelvinsConeBehindAStraightTrack) {
    const Steamer ship;
    const Vec2d bow = ship.now().position_m + Vec2d(0.5 * static_cast<double>(ship.wake.length_m), 0.0);
    for (const double row_s : {10.0, 25.0, 50.0}) {
        const WakePoint at = ship.wave(row_s, 0.5, radians(edge_deg));
        const Vec2d off = at.position_m - bow;
        EXPECT_NEAR(degrees(arc_tangent(-off.y, -off.x)), 19.4712, 1e-3) << row_s;
        const WakePoint astern = ship.wave(row_s, 0.5, 0.0);
        EXPECT_NEAR(astern.position_m.x - bow.x, -0.5 * 7.0 * row_s, 1e-6);
    }
}

TEST(WakeTrail, CrestsStandATransverseWavelengthApart) {
    Steamer ship;
    ship.wake.age_s = 600.0F; // hardly faded
    ship.trail = {};
    follow_track(ship.wake, ship.packet, ship.trail);
    const double period_s = 4.0 * pi * 7.0 / 9.80665; // 2 pi U^2 / g at half the speed
    const double crest = ship.wave(4.0 * period_s, 0.1, 0.0).height_m;
    const double trough = ship.wave(4.5 * period_s, 0.1, 0.0).height_m;
    EXPECT_GT(crest, 0.0);
    EXPECT_LT(trough, 0.0);
}

TEST(WakeTrail, NeedsNoMoreThanItsReserve) {
    Steamer ship;
    for (const std::uint32_t most : {0U, 20U, 256U, 2000U, 5000U}) {
        ship.wake.most_faces = most;
        const ActiveDatabase active = ship.faces();
        EXPECT_LE(active.made_faces.size(), most);
        if (most < 2000) continue;
        EXPECT_GT(active.made_faces.size(), most / 4);
    }
}

TEST(WakeTrail, ChurnedWaterLiesAlongTheTrackOfATurn) {
    Steamer ship;
    std::vector<Vec2d> sterns;
    for (int k = 0; k < 60 * 30; ++k) {
        ship.step(1.0 / 60.0, 0.03, 7.0);
        const TrackSample at = ship.now();
        sterns.push_back(at.position_m - at.forward * (0.46 * static_cast<double>(ship.wake.length_m)));
    }
    for (const double age_s : {1.0, 7.3, 15.0, 25.0}) {
        const Vec2d at = foam_point(ship.wake, ship.trail, ship.now(), age_s, 0.0).position_m;
        double nearest = 1e9;
        for (const Vec2d& stern : sterns)
            nearest = std::min(nearest, glm::length(stern - at));
        EXPECT_LT(nearest, 0.2) << age_s; // 7 m/s: places 0.12 m apart
    }
}

TEST(WakeTrail, NothingJumpsFromFrameToFrameThroughTurnsSpeedsAndAStop) {
    Steamer ship;
    ActiveDatabase before = ship.faces();
    Vec3d origin = before.blocks.front().origin_m;
    double speed_mps = 7.0;
    double most_light = 0.0, most_way = 0.0;
    for (int k = 0; k < 60 * 52; ++k) {
        if (k > 900 && k < 1800) speed_mps = 7.0 + 2.0 * (k - 900) / 900.0; // faster
        if (k > 2100) speed_mps = std::max(0.0, speed_mps - 9.0 / 900.0);   // to a stop in 15 s
        ship.step(1.0 / 60.0, k < 900 ? 0.03 : -0.02, speed_mps);
        ActiveDatabase after = ship.faces();
        const Vec3d moved = after.blocks.front().origin_m - origin;
        ASSERT_EQ(before.made_vertices.size(), after.made_vertices.size());
        for (std::size_t v = 0; v < after.made_vertices.size(); ++v) {
            const Vertex& a = before.made_vertices[v];
            const Vertex& b = after.made_vertices[v];
            most_light = std::max(most_light, static_cast<double>(glm::length(b.normal - a.normal)));
            most_way = std::max(most_way, glm::length(Vec3d(Vec3f(b.position - a.position)) + moved));
        }
        before = std::move(after);
        origin = before.blocks.front().origin_m;
    }
    RecordProperty("most_light", std::to_string(most_light));
    RecordProperty("most_way", std::to_string(most_way));
    // Of 1, in a sixtieth of a second: 5 of 255 levels. Metres: she goes 0.15 at most, and an edge swings as a turn begins.
    EXPECT_LT(most_light, 0.02);
    EXPECT_LT(most_way, 0.5);
    EXPECT_GT(most_light, 0.0);
}

/// Twice the signed area between two angles of two rows.
double area_between(const Steamer& ship, const WakeRow& row, const WakeRow& next,
                    const std::array<double, 2>& here, const std::array<double, 2>& there) {
    const auto at = [&](const WakeRow& r, double u) {
        return wave_point(ship.wake, ship.trail, ship.now(), r, u).position_m;
    };
    const Vec2d a = at(next, there[1]) - at(row, here[0]);
    const Vec2d b = at(next, there[0]) - at(row, here[1]);
    return a.x * b.y - a.y * b.x;
}

/// How much of the mesh between two shares of its columns lies the other way round than on a straight track.
double folded_part(const Steamer& ship, bool transverse) {
    double folded = 0.0, all = 0.0;
    const auto angle = [&](const WakeRow& row, double share) {
        return transverse ? row.low_rad + share * (row.high_rad - row.low_rad)
                          : row.high_rad + share * 0.5 * (0.5 * pi - row.high_rad);
    };
    for (double row_s = 6.0; row_s < 58.0; row_s += 2.0) {
        const WakeRow row = wake_row(ship.wake, ship.trail, ship.now(), row_s, 2.0);
        const WakeRow next = wake_row(ship.wake, ship.trail, ship.now(), row_s + 2.0, 2.0);
        for (double share = 0.0; share < 0.99; share += 0.05) {
            const double area = (transverse ? -1.0 : 1.0) *
                                area_between(ship, row, next, {angle(row, share), angle(row, share + 0.05)},
                                             {angle(next, share), angle(next, share + 0.05)});
            all += std::fabs(area);
            folded += std::max(0.0, -area);
        }
    }
    return folded / all;
}

TEST(WakeTrail, NeitherMeshFoldsOverInATurn) {
    for (const double turn_rad_s : {0.0, 0.016, -0.016}) { // radius 437 m at 7 m/s
        Steamer ship;
        for (int k = 0; k < 2 * 110; ++k)
            ship.step(0.5, turn_rad_s, 7.0);
        EXPECT_LT(folded_part(ship, true), 0.01) << turn_rad_s;
        EXPECT_LT(folded_part(ship, false), 0.01) << turn_rad_s;
    }
}

TEST(WakeTrail, LightEndsBeyondItsEdges) {
    Steamer ship;
    for (int k = 0; k < 60; ++k)
        ship.step(0.5, 0.016, 7.0);
    const WakeRow row = wake_row(ship.wake, ship.trail, ship.now(), 20.0, 0.5);
    for (const double side : {-1.0, 1.0}) {
        const WakePoint fringe = fringe_point(ship.wake, ship.trail, ship.now(), row, side);
        EXPECT_EQ(glm::length(fringe.slope), 0.0);
        EXPECT_EQ(fringe.light, 0.0);
        // Outside of the waves: further from the track than the edge is.
        const double u = side > 0.0 ? row.high_rad : row.low_rad;
        const Vec2d edge = wave_point(ship.wake, ship.trail, ship.now(), row, u).position_m;
        const TrackSample then = track_at(ship.trail, ship.now(), 20.0);
        const Vec2d across(then.forward.y * side, -then.forward.x * side);
        EXPECT_GT(glm::dot(fringe.position_m - edge, across), 1.0);
    }
}

TEST(WakeTrail, FadesToNothingAfterAStop) {
    Steamer ship;
    EXPECT_GT(ship.faces().made_faces.size(), 200U);
    std::size_t last = ship.faces().made_faces.size();
    for (int second = 0; second < 70; ++second) {
        for (int k = 0; k < 10; ++k)
            ship.step(0.1, 0.0, 0.0);
        if (second == 20) {
            EXPECT_LT(ship.faces().made_faces.size(), last);
            EXPECT_GT(ship.faces().made_faces.size(), 0U); // what she made before runs on
        }
    }
    EXPECT_EQ(ship.faces().made_faces.size(), 0U);
}

TEST(WakeTrail, HistoryGoesThroughBytes) {
    Steamer ship;
    ship.step(0.7, 0.02, 6.0);
    History history;
    history.trails.push_back(ship.trail);
    history.particle_wakes.push_back(
        {.list = 4, .begun = true, .time_s = 3.5, .particles = {{.amplitude = 0.1}}});
    std::vector<std::uint8_t> bytes = encode_history(history);
    const auto decoded = decode_history(bytes);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(*decoded, history);
    bytes.pop_back();
    EXPECT_FALSE(decode_history(bytes));
}

} // namespace
} // namespace linkdig::ig
