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

/// acos(sqrt(2/3)): the angle of the waves along the cone's edges of a straight track.
constexpr double edge_rad = 0.61547970867038737;

/// Where the columns of the mesh lie. Transverse waves: from one edge (-1) to the other (1), closer together towards them; diverging
/// ones: from an edge (0) to where they are too short to be seen (1). Beyond an edge follows a column without light.
constexpr std::array transverse_columns{-1.0, -0.92, -0.82, -0.68, -0.51, -0.28, 0.0,
                                        0.28, 0.51,  0.68,  0.82,  0.92,  1.0};
constexpr std::array diverging_columns{0.0, 0.09, 0.22, 0.41, 0.67, 1.0};
constexpr std::array foam_across{-1.0, -0.5, 0.0, 0.5, 1.0};
constexpr std::uint32_t faces_of_a_row =
    transverse_columns.size() + 1 + 2 * diverging_columns.size() + foam_across.size() - 1;

// Everything from here to the functions is estimated, by eye.
constexpr double steepness = 0.11;       ///< of the waves along the cone's edge, near the ship
constexpr double transverse_part = 0.45; ///< of those between
constexpr double edge_width_rad = 0.22;  ///< over which the one becomes the other
constexpr double fringe_waves = 0.2;     ///< lengths of a wave that light takes to end beyond an edge
constexpr double diverging_part = 0.56;  ///< of the angles between an edge and abeam that are drawn
constexpr double turn_over_s = 6.0;      ///< before and after, over which a turn is measured
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

/// Waves along the cone's edges are the highest; far to the outside there are none.
double weight(const WakeRow& row, double u_rad) {
    const double to_starboard = u_rad - row.high_rad;
    const double to_port = row.low_rad - u_rad;
    const double beyond = std::max(to_starboard, to_port);
    const double off = beyond / edge_width_rad;
    const double near_edge = exponential(-off * off);
    const double inside = beyond < 0.0 ? transverse_part : 0.0;
    const double part = to_starboard > to_port ? row.high_part : row.low_part;
    return (inside + (1.0 - inside) * near_edge) * (1.0 - near_edge * (1.0 - part));
}

/// Short waves along the edge on the inside of a turn would lie there as fine lines. 2/3 is the square of the cosine on a straight track.
double long_enough(double cosine) {
    return smooth_step(std::clamp((cosine * cosine * 1.5 - 0.3) / 0.5, 0.0, 1.0));
}

/// Where a wave is.
struct Place {
    Vec2d position_m{0.0};
    Vec2d way{0.0};         ///< unit: where it goes
    double cosine = 1.0;    ///< of its angle
    double speed_mps = 0.0; ///< hers, when it left
};

Place place_of(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now, double row_s,
               double u_rad) {
    const SineCosine u = sine_cosine(u_rad);
    const double age_s = row_s * u.cosine;
    const TrackSample then = track_at(trail, now, age_s);
    const Vec2d bow = then.position_m + then.forward * (0.5 * static_cast<double>(wake.length_m));
    const Vec2d way = then.forward * u.cosine - to_port(then.forward) * u.sine;
    return {bow + way * (0.5 * then.speed_mps * age_s * u.cosine), way, u.cosine, then.speed_mps};
}

/// How fast she turned to port at an age, radians a second: over a while, so that a turn begins gently.
double turn_rate_at(const WakeTrail& trail, const TrackSample& now, double age_s) {
    const double later = std::max(age_s - turn_over_s, 0.0);
    const Vec2d a = track_at(trail, now, age_s + turn_over_s).forward;
    const Vec2d b = track_at(trail, now, later).forward;
    return arc_tangent(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y) / (age_s + turn_over_s - later);
}

/// The angle of the waves at an edge, `side` 1 to starboard and -1 to port, where the track bends by `bend`: in wave_point()'s terms
/// neighbouring waves touch where 3/2 cos^2 u - 1 = bend sin u cos u, that is 3 cos 2u - 2 bend sin 2u = 1.
double edge_angle(double bend, double side) {
    const double part = 1.0 / std::sqrt(9.0 + 4.0 * bend * bend);
    return 0.5 * (side * arc_cosine(part) - arc_tangent(2.0 * bend, 3.0));
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

WakeRow wake_row(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now, double row_s,
                 double step_s) {
    // Of when the waves of a straight track's edges left: what is the same for both edges makes no row jump.
    const double then_s = row_s * sine_cosine(edge_rad).cosine;
    const double speed = std::max(std::fabs(track_at(trail, now, then_s).speed_mps), 1.0);
    const double turn = turn_rate_at(trail, now, then_s);
    const auto edge = [&](double at_s, double side) {
        double u_rad = side * edge_rad;
        for (int k = 0; k < 4; ++k) { // the bend depends on the age, and that on the angle
            const double age_s = at_s * sine_cosine(u_rad).cosine;
            u_rad = edge_angle(turn * (0.5 * age_s + static_cast<double>(wake.length_m) / speed), side);
        }
        return u_rad;
    };
    const auto part = [&](double u_rad, double side) {
        constexpr double later_s = 1.0; // long enough for a turn that begins to change nothing at once
        constexpr double straight = 0.57735026918962576; // of her way, on a straight track: sqrt(1/3)
        const double after_s = row_s + later_s;
        const Vec2d way = place_of(wake, trail, now, after_s, edge(after_s, side)).position_m -
                          place_of(wake, trail, now, row_s, u_rad).position_m;
        return smooth_step(
            std::clamp((glm::length(way) / (straight * speed * later_s) - 0.2) / 0.6, 0.0, 1.0));
    };
    WakeRow row{.row_s = row_s, .step_s = step_s, .low_rad = edge(row_s, -1.0), .high_rad = edge(row_s, 1.0)};
    row.low_part = part(row.low_rad, -1.0);
    row.high_part = part(row.high_rad, 1.0);
    return row;
}

WakePoint wave_point(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
                     const WakeRow& row, double u_rad) {
    const Place place = place_of(wake, trail, now, row.row_s, u_rad);
    WakePoint point{.position_m = place.position_m};
    const double speed = std::max(std::fabs(place.speed_mps), 0.1);
    const double phase_of_second = 0.5 * gravity_mps2 / speed;
    const double start = smooth_step(std::clamp(row.row_s / 4.0, 0.0, 1.0));
    const double spread = 1.0 / std::sqrt(1.0 + row.row_s / spread_s);
    const double steep = static_cast<double>(wake.strength) * steepness * weight(row, u_rad) *
                         long_enough(place.cosine) * at_speed(speed) * start * spread *
                         fade(wake, row.row_s) * resolved(phase_of_second * row.step_s);
    if (steep <= 0.0) return point;
    const SineCosine phase = sine_cosine(phase_of_second * row.row_s);
    const double wave_number = gravity_mps2 / (speed * speed * place.cosine * place.cosine);
    point.height_m = steep / wave_number * phase.cosine;
    point.slope = place.way * (steep * phase.sine); // the phase grows away from the ship
    point.light = crest_light / steepness * steep * std::max(0.0, phase.cosine);
    return point;
}

WakePoint fringe_point(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
                       const WakeRow& row, double side) {
    const double u_rad = side > 0.0 ? row.high_rad : row.low_rad;
    const SineCosine u = sine_cosine(u_rad);
    const TrackSample then = track_at(trail, now, row.row_s * u.cosine);
    const double speed = std::fabs(then.speed_mps);
    const double length_m = two_pi * speed * speed * u.cosine * u.cosine / gravity_mps2;
    // The waves of one age lie on a circle that the edge touches: away from its middle is away from all waves.
    const SineCosine twice = sine_cosine(2.0 * u_rad);
    const Vec2d away = then.forward * twice.cosine - to_port(then.forward) * twice.sine;
    return {.position_m =
                wave_point(wake, trail, now, row, u_rad).position_m + away * (fringe_waves * length_m)};
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
               std::vector<WakeRow>& rows, ActiveDatabase& active)
        : wake_(wake), trail_(trail), now_(now), rows_(rows), active_(active) {
        const std::uint32_t count = trail_rows(wake);
        const double step_s = static_cast<double>(wake.age_s) / std::max(1.0, static_cast<double>(count));
        rows_.clear();
        for (std::uint32_t k = 0; k <= count; ++k)
            rows_.push_back(wake_row(wake, trail, now, step_s * static_cast<double>(k), step_s));
    }

    void make() {
        if (rows_.size() < 2) return;
        transverse();
        diverging(1.0);
        diverging(-1.0);
        mesh(foam_across.size(), [&](const WakeRow& row, std::size_t column) {
            return foam_point(wake_, trail_, now_, row.row_s, foam_across[column]);
        });
    }

private:
    WakePoint wave(const WakeRow& row, double u_rad) const {
        return wave_point(wake_, trail_, now_, row, u_rad);
    }

    void transverse() {
        constexpr std::size_t last = transverse_columns.size() + 1;
        mesh(last + 1, [&](const WakeRow& row, std::size_t column) {
            if (column == 0 || column == last)
                return fringe_point(wake_, trail_, now_, row, column == 0 ? -1.0 : 1.0);
            const double half = 0.5 * (row.high_rad - row.low_rad);
            return wave(row, row.low_rad + half * (1.0 + transverse_columns[column - 1]));
        });
    }

    void diverging(double side) {
        mesh(diverging_columns.size() + 1, [&](const WakeRow& row, std::size_t column) {
            if (column == 0) return fringe_point(wake_, trail_, now_, row, side);
            const double edge = side > 0.0 ? row.high_rad : row.low_rad;
            return wave(row,
                        edge + diverging_columns[column - 1] * diverging_part * (side * 0.5 * pi - edge));
        });
    }

    template <typename PointAt>
    void mesh(std::size_t columns, PointAt point_at) {
        const MeshRows rows{.first_vertex = static_cast<std::uint32_t>(active_.made_vertices.size()),
                            .columns = static_cast<std::uint32_t>(columns),
                            .rows = static_cast<std::uint32_t>(rows_.size())};
        for (const WakeRow& row : rows_)
            for (std::size_t column = 0; column < columns; ++column) {
                const WakePoint point = point_at(row, column);
                active_.made_vertices.push_back(lit_vertex(point.position_m - now_.position_m,
                                                           wake_.heights ? point.height_m : 0.0, point.slope,
                                                           point.light));
            }
        make_mesh_faces(rows, static_cast<std::uint16_t>(wake_.colour), active_);
    }

    const WakeRequest& wake_;
    const WakeTrail& trail_;
    const TrackSample& now_;
    std::vector<WakeRow>& rows_;
    ActiveDatabase& active_;
};

} // namespace

void make_trail_faces(const WakeRequest& wake, const WakeTrail& trail, const TrackSample& now,
                      std::vector<WakeRow>& rows, ActiveDatabase& active, FaceBlock& block) {
    const auto first_run = static_cast<std::uint32_t>(active.made_runs.size());
    TrailMaker(wake, trail, now, rows, active).make();
    block.origin_m = Vec3d(now.position_m, 0.0);
    finish_made_block(first_run, static_cast<std::uint32_t>(&block - active.blocks.data()), active);
}

} // namespace linkdig::ig
