#pragma once
/// A scenario: what happens in front of a visual database. The file's contents as a value, in SI units and
/// radians, with mathematical headings; things of the database are still named.
///
/// In the file headings and azimuths are degrees clockwise from north, speeds knots, lengths metres or feet:
/// [scenario], [suns.NAME], [[ship]] with [ship.track], [ship.motion], [ship.cam], [ship.water], [[sequence]], [[approach]], [own_ship],
/// [[channel]], [sea], [[quay]], [sky].

#include "database/model/mathematics.h"
#include "database/text/diagnostic.h"
#include "host/packet/frame_packet.h"
#include "host/scenario/methods.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::host {

/// A name that stands in the scenario's file, and where.
struct Name {
    std::string text;
    database::SourceLocation at;
};

/// A sun. It turns if a rate is not 0; its elevation is then reflected between the two limits.
struct SunSection {
    Name sun;
    double azimuth_rad = 0.0; ///< counter-clockwise from east, as all azimuths and headings here
    double elevation_rad = 0.0;
    double azimuth_rate_rad_s = 0.0; ///< counter-clockwise; the file's is clockwise
    double elevation_rate_rad_s = 0.0;
    double least_elevation_rad = 0.0;
    double greatest_elevation_rad = 0.0;
    bool has_sea_state = false; ///< a preset chose it: it may be turned and raised even if it stands
    bool turning() const { return has_sea_state || azimuth_rate_rad_s != 0.0 || elevation_rate_rad_s != 0.0; }
};

/// Estimated response of one of a ship's axes.
struct AxisSection {
    double gain = 1.0;
    double limit = 0.0; ///< metres or radians
};

/// A row of a time history. Angles in radians, mathematical.
struct HistoryRow {
    double time_s = 0.0;
    std::array<double, 6>
        values{}; ///< a ship's surge, sway, heave, roll, pitch, yaw; or position, heading, pitch, roll
};

/// [ship.track]: without it a ship steers her heading.
struct TrackSection {
    enum class Kind : std::uint8_t { straight, turn, figure_of_eight, station };
    Kind kind = Kind::straight;
    double begin_s = 0.0;   ///< when she puts her helm over
    double radius_m = 0.0;  ///< of a turn
    bool to_port = false;   ///< the (first) turn
    double angle_rad = 0.0; ///< through which she turns; 0: for ever
    Name leader;            ///< station: the moving object whose place she keeps
    Vec3d offset_m{0};      ///< station: in the leader's mean frame
};

/// [ship.motion]: without it a ship does not move about her track.
struct MotionSection {
    double significant_height_m = 0.0;
    double period_s = 10.0;          ///< modal
    double travel_heading_rad = 0.0; ///< where the waves run to; the file says where they come from
    std::uint64_t seed = 0;
    std::uint32_t components = 12;
    double length_m = 180.0;
    double heave_period_s = 8.0;
    double roll_period_s = 14.0;
    double pitch_period_s = 7.5;
    std::array<AxisSection, 6> axes; ///< surge, sway, heave, roll, pitch, yaw
    std::vector<HistoryRow> history; ///< not empty: this moves her, and nothing above does
};

/// When a ship's lights burn: while it is not full day (host/motion/daylight.h), always, never.
enum class ShipLights : std::uint8_t { from_dusk, on, off };
inline constexpr std::array<const char*, 3> ship_lights_names{"from_dusk", "on", "off"};

/// [ship.water]: what a ship's wakes that are made at frame time are made with.
struct WaterSection {
    std::uint32_t kelvin_faces = 4000; ///< reserved
    double kelvin_age_s = 180.0;       ///< what is older is gone
    std::uint32_t particle_faces = 4096;
    double strength = 1.0; ///< factor on the wakes' light and height
    bool heights = false;  ///< their faces rise and fall
    double length_m = 160.0;
    double beam_m = 20.0;
};

/// A ship's methods. Absent: the slots stay as the database has them (waterline, no wake).
struct MethodsSection {
    std::optional<Occulting> occulting{};
    std::optional<Wakes> wakes{};
    database::SourceLocation occulting_at{};
    database::SourceLocation wake_at{};
    ShipLights lights = ShipLights::from_dusk; ///< of a database that has a slot for them
    database::SourceLocation lights_at{};
    double wake_dwell_s = 0.1; ///< of each of the 28 faces
    Vec3d cam_position_m{63.5, 8.1,
                         0.0}; ///< middle of the port cam's axis in the waterline frame; estimated, LPH-2's
    double cam_axis_rad = radians(24.0); ///< which runs aft and outward, so far off the ship's; estimated
    double cam_period_s = 2.0;           ///< of one roll; estimated
    WaterSection water{};
};

struct ShipSection {
    Name moving_object;
    Vec3d position_m{0};
    double heading_rad = 0.0;
    double speed_mps = 0.0;
    std::optional<MotionSection> motion;
    TrackSection track{};
    MethodsSection methods{};
};

/// Alternatives of a slot, one after the other (report, 3.2.2).
struct SequenceSection {
    Name slot;
    double dwell_s = 0.1; ///< time that each face stays
    double phase = 0.0;   ///< where it begins, as a fraction of the whole sequence
};

/// The own ship's approach, in the mean frame of a ship (x forward, y to port, z up from the water), or in the world.
struct ApproachSection {
    Name ship;               ///< a moving object that has a [[ship]], or empty: the path hangs in the world
    double duration_s = 0.0; ///< for scenarios of at least this length
    std::array<Vec3d, 4> path_m; ///< control points of a cubic Bezier curve: start, two handles, hover
    Vec3d first_aim_m{0};
    Vec3d last_aim_m{0};
};

/// [own_ship]: without it the own ship flies the approach.
struct OwnShipSection {
    enum class Kind : std::uint8_t { approach, fixed, path, flown };
    Kind kind = Kind::approach;
    std::optional<Name> beside; ///< fixed: a ship in whose mean frame position and aim are meant
    Vec3d position_m{0};        ///< fixed, and where a flown one begins
    Vec3d aim_m{0};             ///< fixed
    double heading_rad = 0.0;   ///< a flown one's at the beginning
    double speed_mps = 0.0;
    std::vector<HistoryRow> path; ///< position in the world, heading, pitch, roll
};

struct ChannelSection {
    std::string name;
    double horizontal_field_rad = 0.0;
    std::optional<double> vertical_field_rad{}; ///< absent: from the picture's shape, pixels square
    double azimuth_rad =
        0.0; ///< of its line of sight off the own ship's nose, to port; the file's is to starboard
    double elevation_rad = 0.0;
};

struct Scenario {
    std::string path;
    std::string name;
    std::string database_path; ///< a .toml or .igdb file, the scenario's folder already before it
    double duration_s = 0.0;
    std::uint64_t seed = 0;
    std::vector<SunSection> suns;
    std::vector<ShipSection> ships;
    std::vector<SequenceSection> sequences;
    std::vector<ApproachSection> approaches; ///< ascending by duration
    std::vector<ChannelSection> channels;
    OwnShipSection own_ship{};
    std::vector<Quay> quays; ///< walls from which waves come back
    double sea_state = 0.0;  ///< the report's: 0, 1.5 ("1-2"), 3
    SeaMethod sea_method = SeaMethod::sun;
    std::uint32_t normals_every = 1; ///< frames between two updates of the normals
    database::SourceLocation sea_method_at{};
    double current_east_mps = 0.0;
    double current_north_mps = 0.0;
    Vec3f sky{0.60F, 0.72F, 0.86F};
    /// Object lists that stay smooth when smooth shading is off: a dome whose authored normals are its
    /// picture.
    std::vector<Name> sky_lists;
    double visibility_m = 0.0;     ///< 0: unlimited
    double time_of_day_h = 12.0;   ///< at time 0
    double hours_per_minute = 0.0; ///< how fast the day goes by
    std::vector<Name> sky_bands;   ///< colour codes of the sky that follow the hour, from the horizon up
    double lamps_by_day = 0.3;     ///< factor on light points in full daylight; 1 in the dark
};

struct ScenarioResult {
    std::optional<Scenario> scenario; ///< nothing if there is any diagnostic
    database::Diagnostics diagnostics;
};

/// Reads a scenario file. All its mistakes are told at once; names are not looked up yet, see bind().
ScenarioResult load_scenario(const std::string& path);

/// The approach to fly in a scenario of this length: the longest that fits, or else the shortest.
const ApproachSection& approach_for(const Scenario& scenario);

} // namespace linkdig::host
