#include "ig/water/wake_trail.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"
#include "database/model/rotation.h"
#include "ig/water/made_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkdig::ig {

namespace {

constexpr double gravity_mps2 = 9.80665;

/// Angles of the waves: the transverse ones between the two edges of the cone, closer together towards them, and the diverging ones
/// on each side. 35.2644 degrees is acos(sqrt(2/3)), the edge itself, in both.
constexpr double edge_deg = 35.26438968;
constexpr std::array transverse_deg{-edge_deg, -32.5, -29.0, -24.0, -18.0, -10.0,   0.0,
                                    10.0,      18.0,  24.0,  29.0,  32.5,  edge_deg};
constexpr std::array diverging_deg{edge_deg, 38.0, 42.0, 48.0, 56.0, 66.0};
constexpr std::array foam_across{-1.0, -0.5, 0.0, 0.5, 1.0};
constexpr std::uint32_t faces_of_a_row =
    transverse_deg.size() - 1 + 2 * (diverging_deg.size() - 1) + foam_across.size() - 1;

// Everything from here to the functions is estimated, by eye.
constexpr double steepness = 0.11;       ///< of the waves along the cone's edge, near the ship
constexpr double transverse_part = 0.45; ///< of those between
constexpr double edge_width_rad = 0.22;  ///< over which the one becomes the other
constexpr double crest_light = 0.55;     ///< of a breaking crest of greatest steepness
constexpr double spread_s = 12.0;        ///< waves fall to 1 / sqrt 2 in this time
constexpr double full_speed_mps = 5.0;   ///< below it, a wake is less than it could be
constexpr double foam_light = 0.62;
constexpr double foam_lasts_s = 70.0;

/// 1 for a young row, 0 for the last.
double fade(const WakeRequest& wake, double row_s) {
    const double part = row_s / static_cast<double>(wake.age_s);
    return 1.0 - smooth_step(std::clamp((part - 0.35) / 0.6, 0.0, 1.0));
}

double at_speed(double speed_mps) {
    const double part = std::clamp(std::fabs(speed_mps) / full_speed_mps, 0.0, 1.0);
    return part * part;
}

/// Smooth between whole numbers, 0 to 1.
double patchiness(double at, std::uint64_t salt) {
    const double below = std::floor(at);
    const auto number = static_cast<std::uint64_t>(static_cast<std::int64_t>(below));
    const double a = random_unit(salt, number);
    return a + (random_unit(salt, number + 1) - a) * smooth_step(at - below);
}

Vec2d to_port(const Vec2d& forward) { return {-forward.y, forward.x}; }

TrackSample before(const TrackSample& sample, double seconds) {
    TrackSample earlier = sample;
    earlier.time_s -= seconds;
    earlier.position_m -= sample.forward * (sample.speed_mps * seconds);
    return earlier;
}

/// Cubic through both places with both velocities.
TrackSample between(const TrackSample& a, const TrackSample& b, double time_s) {
    const double span = b.time_s - a.time_s;
    if (!(span > 0.0)) return b;
    const double t = (time_s - a.time_s) / span;
    const double u = 1.0 - t;
    TrackSample at;
    at.time_s = time_s;
    at.position_m = a.position_m * (u * u * (1.0 + 2.0 * t)) + b.position_m * (t * t * (3.0 - 2.0 * t)) +
                    (a.forward * (a.speed_mps * u) - b.forward * (b.speed_mps * t)) * (span * t * u);
    at.speed_mps = a.speed_mps + (b.speed_mps - a.speed_mps) * t;
    const Vec2d forward = a.forward * u + b.forward * t;
    const double length = std::sqrt(forward.x * forward.x + forward.y * forward.y);
    at.forward = length > 0.0 ? forward / length : b.forward;
    return at;
}

std::size_t most_samples(const WakeRequest& wake) {
    return static_cast<std::size_t>(static_cast<double>(wake.age_s) / track_interval_s) + 3;
}

void begin_track(const WakeRequest& wake, const TrackSample& now, WakeTrail& trail) {
    const std::size_t count = most_samples(wake);
    trail.samples.clear();
    trail.samples.reserve(count + 1);
    for (std::size_t k = count - 1; k > 0; --k)
        trail.samples.push_back(before(now, static_cast<double>(k) * track_interval_s));
    trail.samples.push_back(now);
}

/// How much of a wave of this phase step between rows the mesh can hold: none that is shorter than three rows, all of five.
double resolved(double phase_step) { return std::clamp((2.1 - phase_step) / (2.1 - 1.25), 0.0, 1.0); }

/// Waves along the cone's edge are the highest; far to the outside there are none.
double weight(double u_rad) {
    const double u = std::fabs(u_rad);
    const double off = (u - radians(edge_deg)) / edge_width_rad;
    const double near_edge = exponential(-off * off);
    const double inside = u < radians(edge_deg) ? transverse_part : 0.0;
    return inside + (1.0 - inside) * near_edge;
}

} // namespace

TrackSample track_sample(const WakeRequest& wake, const FramePacket& packet) {
    const MovingObject& ship = packet.moving_objects[wake.moving_object];
    return {.time_s = packet.time_s,
            .position_m = Vec2d(ship.waterline_position_m),
            .forward = Vec2d(direction(ship.waterline_heading_rad, 0.0)),
            .speed_mps = static_cast<double>(wake.speed_mps)};
}

void follow_track(const WakeRequest& wake, const FramePacket& packet, WakeTrail& trail) {
    const TrackSample now = track_sample(wake, packet);
    std::vector<TrackSample>& samples = trail.samples;
    const double gap = samples.empty() ? 0.0 : now.time_s - samples.back().time_s;
    if (samples.empty() || packet.discontinuity || gap < 0.0 || gap > static_cast<double>(wake.age_s)) {
        begin_track(wake, now, trail);
        return;
    }
    if (gap < track_interval_s) return;
    const std::size_t most = most_samples(wake);
    if (samples.size() >= most)
        samples.erase(samples.begin(),
                      samples.begin() + static_cast<std::int64_t>(samples.size() - most + 1));
    samples.push_back(now);
}

TrackSample track_at(const WakeTrail& trail, const TrackSample& now, double age_s) {
    const double time_s = now.time_s - age_s;
    const std::vector<TrackSample>& samples = trail.samples;
    const auto after = std::ranges::upper_bound(samples, time_s, {}, &TrackSample::time_s);
    if (after == samples.begin())
        return samples.empty() ? before(now, age_s)
                               : before(samples.front(), samples.front().time_s - time_s);
    return between(*(after - 1), after == samples.end() ? now : *after, time_s);
}

WakePoint wave_point(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now, double row_s,
                     double row_step_s, double u_rad) {
    const SineCosine u = sine_cosine(u_rad);
    const double age_s = row_s * u.cosine;
    const TrackSample then = track_at(trail, now, age_s);
    const Vec2d bow = then.position_m + then.forward * (0.5 * static_cast<double>(wake.length_m));
    const Vec2d way = then.forward * u.cosine - to_port(then.forward) * u.sine;
    WakePoint point{.position_m = bow + way * (0.5 * then.speed_mps * age_s * u.cosine)};
    const double speed = std::max(std::fabs(then.speed_mps), 0.1);
    const double phase_of_second = 0.5 * gravity_mps2 / speed;
    const double start = smooth_step(std::clamp(row_s / 4.0, 0.0, 1.0));
    const double spread = 1.0 / std::sqrt(1.0 + row_s / spread_s);
    const double steep = static_cast<double>(wake.strength) * steepness * weight(u_rad) * at_speed(speed) *
                         start * spread * fade(wake, row_s) * resolved(phase_of_second * row_step_s);
    if (steep <= 0.0) return point;
    const SineCosine phase = sine_cosine(phase_of_second * row_s);
    const double wave_number = gravity_mps2 / (speed * speed * u.cosine * u.cosine);
    point.height_m = steep / wave_number * phase.cosine;
    point.slope = way * (steep * phase.sine); // the phase grows away from the ship
    point.light = crest_light / steepness * steep * std::max(0.0, phase.cosine);
    return point;
}

WakePoint foam_point(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now, double row_s,
                     double across) {
    const TrackSample then = track_at(trail, now, row_s);
    const double beam = static_cast<double>(wake.beam_m);
    const double half = beam * (0.42 + 0.5 * row_s / (row_s + 60.0));
    const Vec2d stern = then.position_m - then.forward * (0.46 * static_cast<double>(wake.length_m));
    WakePoint point{.position_m = stern + to_port(then.forward) * (across * half)};
    const auto strip = static_cast<std::uint64_t>(across * 2.0 + 2.0);
    const double patches = 0.45 + 0.55 * patchiness(then.time_s * 0.7, 977U * strip + wake.list);
    const double profile = 1.0 - across * across;
    point.light = static_cast<double>(wake.strength) * foam_light * profile * patches *
                  at_speed(then.speed_mps) * exponential(-row_s / foam_lasts_s) * fade(wake, row_s);
    return point;
}

std::uint32_t trail_rows(const WakeRequest& wake) { return wake.most_faces / faces_of_a_row; }

namespace {

class TrailMaker {
public:
    TrailMaker(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
               ActiveDatabase& active)
        : wake_(wake), trail_(trail), now_(now), active_(active), rows_(trail_rows(wake)),
          step_s_(static_cast<double>(wake.age_s) / std::max(1.0, static_cast<double>(rows_))) {}

    void make() {
        if (rows_ == 0) return;
        waves(transverse_deg, 1.0);
        waves(diverging_deg, 1.0);
        waves(diverging_deg, -1.0);
        mesh(foam_across.size(), [&](double row_s, std::size_t column) {
            return foam_point(wake_, trail_, now_, row_s, foam_across[column]);
        });
    }

private:
    template <std::size_t count>
    void waves(const std::array<double, count>& angles_deg, double side) {
        mesh(count, [&](double row_s, std::size_t column) {
            return wave_point(wake_, trail_, now_, row_s, step_s_, side * radians(angles_deg[column]));
        });
    }

    template <typename PointAt>
    void mesh(std::size_t columns, PointAt point_at) {
        const MeshRows rows{.first_vertex = static_cast<std::uint32_t>(active_.made_vertices.size()),
                            .columns = static_cast<std::uint32_t>(columns),
                            .rows = rows_ + 1};
        for (std::uint32_t row = 0; row <= rows_; ++row)
            for (std::size_t column = 0; column < columns; ++column) {
                const WakePoint point = point_at(step_s_ * static_cast<double>(row), column);
                active_.made_vertices.push_back(lit_vertex(point.position_m - now_.position_m,
                                                           wake_.heights ? point.height_m : 0.0, point.slope,
                                                           point.light));
            }
        make_mesh_faces(rows, static_cast<std::uint16_t>(wake_.colour), 0, active_);
    }

    const WakeRequest& wake_;
    const WakeTrail& trail_;
    const TrackSample& now_;
    ActiveDatabase& active_;
    std::uint32_t rows_;
    double step_s_;
};

} // namespace

void make_trail_faces(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
                      ActiveDatabase& active, FaceBlock& block) {
    const auto first_run = static_cast<std::uint32_t>(active.made_runs.size());
    TrailMaker(wake, trail, now, active).make();
    block.origin_m = Vec3d(now.position_m, 0.0);
    finish_made_block(first_run, static_cast<std::uint32_t>(&block - active.blocks.data()), active);
}

} // namespace linkdig::ig
