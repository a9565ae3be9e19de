#include "ig/water/particle_wake.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"
#include "ig/water/made_mesh.h"

#include <algorithm>
#include <cmath>

namespace linkdig::ig {

namespace {

constexpr double longest_gap_s = 5.0;
constexpr double grid_lengths = 2.4; ///< side of the grid, in lengths of the ship
constexpr double grid_behind = 0.45; ///< its middle lies so many lengths abaft hers
constexpr double radius_cells = 2.0; ///< of a bump: its slopes then reach over four cells
constexpr double particle_speed =
    4.0; ///< m/s; estimated: about half of a ship's, so that her waves form a narrow wedge
constexpr double slope_part = 0.45; ///< of a sum's slope that is lit (estimated)
constexpr double crest_light =
    0.5; ///< straight up, of a crest that is crest_m high; a trough has none (estimated)
constexpr double crest_m = 0.8;

double cell_of(const WakeRequest& wake) {
    return grid_lengths * static_cast<double>(wake.length_m) / static_cast<double>(grid_side(wake));
}

WaveParticleKind kind_of(const WakeRequest& wake) {
    const double radius = radius_cells * cell_of(wake);
    return {.speed_mps = particle_speed,
            .radius = radius,
            .least_amplitude = 0.004,
            .lifetime_s = 16.0,
            .rise_m = 0.5 * radius,
            .most = most_particles};
}

Vec3d angles(const Attitude& attitude) {
    return {attitude.heading_rad, attitude.pitch_rad, attitude.roll_rad};
}

/// Angular velocity in the world's axes, of rates of heading, pitch (bow up) and roll (starboard down).
Vec3d turn_rate(const Attitude& attitude, const Vec3d& rates) {
    const SineCosine h = sine_cosine(attitude.heading_rad);
    const Vec3d level_port(-h.sine, h.cosine, 0.0);
    const Vec3d forward = world_from_body(attitude) * Vec3d(1.0, 0.0, 0.0);
    return Vec3d(0.0, 0.0, rates.x) - level_port * rates.y + forward * rates.z;
}

/// Difference of two angles the short way round.
double turned_by(double from, double to) {
    const double turn = modulo(to - from, two_pi);
    return turn > pi ? turn - two_pi : turn;
}

/// Neither a slot's alternative nor a coarser level of what is there already.
bool is_always_there(const VisualDatabase& database, const Object& object) {
    if (object.slot != none) return false;
    if (object.level == none) return true;
    const auto level = static_cast<std::uint32_t>(object.level);
    return database.details[database.detail_levels[level].detail].first_level == level;
}

/// What closes her sides at the waterline lies inside the whole hull.
bool lies_on_waterline(const VisualDatabase& database, const Face& face) {
    for (std::uint32_t k = 0; k < face.corner_count; ++k)
        if (std::fabs(database.vertices[database.corners[face.first_corner + k]].position.z) > 0.01F)
            return false;
    return true;
}

/// 1 well inside the grid, 0 at its edge: measured from where its middle is, not from where its cells are, so that it moves evenly.
double window(const Vec2d& off_middle, double half_side) {
    const double reach = std::max(std::fabs(off_middle.x), std::fabs(off_middle.y)) / half_side;
    return 1.0 - smooth_step(std::clamp((reach - 0.72) / 0.2, 0.0, 1.0));
}

} // namespace

std::vector<HullTriangle> hull_of(const VisualDatabase& database, const WakeRequest& wake) {
    std::vector<HullTriangle> hull;
    for (const Face& face : database.faces) {
        const Object& object = database.objects[face.object];
        const auto list = static_cast<std::int32_t>(object.list);
        if (list != wake.hull && !(list == wake.hull_above && is_always_there(database, object))) continue;
        if (list != wake.hull && lies_on_waterline(database, face)) continue;
        const auto corner = [&](std::uint32_t k) {
            const Vec4f& position = database.vertices[database.corners[face.first_corner + k]].position;
            return Vec3d(position) + database.lists[object.list].origin_m;
        };
        for (std::uint32_t k = 2; k < face.corner_count; ++k)
            hull.push_back({corner(0), corner(k - 1), corner(k)});
    }
    return hull;
}

std::uint32_t grid_side(const WakeRequest& wake) {
    std::uint32_t side = 2;
    while (side < 256 && side * side <= wake.most_faces) // (side + 1 - 1)^2 faces
        ++side;
    return side;
}

ParticleWakeMaker::ParticleWakeMaker(const VisualDatabase& database, const WakeRequest& wake)
    : list_(wake.list), hull_lists_{wake.hull, wake.hull_above}, length_m_(wake.length_m),
      faces_(wake.most_faces), hull_(hull_of(database, wake)), particles_(kind_of(wake)) {}

bool ParticleWakeMaker::serves(const WakeRequest& wake) const {
    return hull_lists_ == std::array{wake.hull, wake.hull_above} && length_m_ == wake.length_m &&
           faces_ == wake.most_faces;
}

void ParticleWakeMaker::give_birth(const MovingObject& ship, double duration_s, const ParticleWake& history) {
    const Vec3d now = angles(ship.attitude);
    const Vec3d rates =
        Vec3d(turned_by(history.attitude_rad.x, now.x), turned_by(history.attitude_rad.y, now.y),
              turned_by(history.attitude_rad.z, now.z)) /
        duration_s;
    const HullMotion motion{.world_from_body = world_from_body(ship.attitude),
                            .position = ship.position_m,
                            .velocity_mps = (ship.position_m - history.position_m) / duration_s,
                            .turn_rate_rad_s = turn_rate(ship.attitude, rates)};
    draw_silhouette(hull_, motion, silhouette_pixels, silhouette_scratch_, silhouette_);
    boundary_waves(silhouette_, SilhouetteBoundary::inner, levels_, waves_);
    particles_.add(silhouette_, waves_, duration_s, count_);
}

void ParticleWakeMaker::follow(const WakeRequest& wake, const FramePacket& packet, ParticleWake& history) {
    const MovingObject& ship = packet.moving_objects[wake.moving_object];
    const double gap = packet.time_s - history.time_s;
    if (packet.discontinuity || gap < 0.0 || gap > longest_gap_s || !history.begun) {
        history.begun = true;
        history.particles.clear();
        history.particles.reserve(most_particles);
        history.time_s = history.born_s = packet.time_s;
        history.position_m = ship.position_m;
        history.attitude_rad = angles(ship.attitude);
        return;
    }
    particles_.exchange(history.particles);
    if (gap > 0.0) particles_.advance(gap, packet.quays, count_);
    history.time_s = packet.time_s;
    const double since = packet.time_s - history.born_s;
    if (since >= birth_interval_s) {
        give_birth(ship, since, history);
        history.born_s = packet.time_s;
        history.position_m = ship.position_m;
        history.attitude_rad = angles(ship.attitude);
    }
    particles_.exchange(history.particles);
}

void ParticleWakeMaker::make_faces(const WakeRequest& wake, const FramePacket& packet, ParticleWake& history,
                                   ActiveDatabase& active, FaceBlock& block) {
    const MovingObject& ship = packet.moving_objects[wake.moving_object];
    const Vec2d forward(direction(ship.waterline_heading_rad, 0.0));
    const Vec2d middle =
        Vec2d(ship.waterline_position_m) - forward * (grid_behind * static_cast<double>(wake.length_m));
    const std::uint32_t side = grid_side(wake);
    particles_.exchange(history.particles);
    const database::WaveField& field =
        particles_.surface({.size = side, .cell = cell_of(wake), .centre = middle});
    particles_.exchange(history.particles);

    const auto first_run = static_cast<std::uint32_t>(active.made_runs.size());
    const MeshRows rows{.first_vertex = static_cast<std::uint32_t>(active.made_vertices.size()),
                        .columns = side,
                        .rows = side};
    const double half_side = 0.5 * field.cell * static_cast<double>(side);
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const Vec2d at = field.origin + field.cell * (Vec2d(column, row) + 0.5);
            const double part = static_cast<double>(wake.strength) * window(at - middle, half_side);
            const double height = static_cast<double>(field.heights[std::size_t{row} * side + column]);
            const double crest = std::clamp(height / crest_m, 0.0, 1.0);
            active.made_vertices.push_back(lit_vertex(at - middle, wake.heights ? part * height : 0.0,
                                                      slope_part * part * slope_at(field, column, row),
                                                      crest_light * part * crest));
        }
    make_mesh_faces(rows, static_cast<std::uint16_t>(wake.colour), active);
    block.origin_m = Vec3d(middle, 0.0);
    finish_made_block(first_run, static_cast<std::uint32_t>(&block - active.blocks.data()), active);
}

} // namespace linkdig::ig
