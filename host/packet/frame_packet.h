#pragma once
/// The frame packet: everything the host tells the image generator about one frame. Absolute state, no commands: the
/// same packet gives the same picture whatever came before it (histories travel in a recording's first record).

#include "database/model/rotation.h"
#include "database/model/vectors.h"
#include "database/model/visual_database.h"

#include <cstdint>
#include <vector>

namespace linkdig {

/// One display channel: where it looks from and how.
struct ChannelView {
    bool on = true;
    Vec3d eye_m{0};               ///< viewpoint, world
    Attitude attitude;            ///< of the view: body x is the line of sight, body z is up on the screen
    double left_tangent = -0.577; ///< frustum: tangents of the half-angles, right > left, top > bottom
    double right_tangent = 0.577;
    double bottom_tangent = -0.577;
    double top_tangent = 0.577;
};

/// How the shading of the faces of a list is overridden for this frame.
enum class ShadingMethod : std::uint8_t {
    as_modelled,
    no_smooth, ///< vertex-shaded faces are face-shaded instead (report, Figures 2, 8 and 9)
};

/// Per-list light, parallel to VisualDatabase::lists. An empty table means: as the database has it.
struct ListLighting {
    std::uint32_t list = 0; ///< index into VisualDatabase::lists
    std::uint32_t sun = 0;  ///< row of FramePacket::suns
    float ambient = 0;
    float diffuse = 1;
    std::int32_t colour = none; ///< colour code for every face of the list, or none: as modelled
    ShadingMethod method = ShadingMethod::as_modelled;
};

/// Where a moving object is: index parallel to VisualDatabase::moving_objects.
struct MovingObject {
    bool visible = true;
    Vec3d position_m{0};           ///< of the body frame's origin, world
    Attitude attitude;             ///< of the body frame
    Vec3d waterline_position_m{0}; ///< of the waterline frame: position without heave
    double waterline_heading_rad = 0.0;
};

/// Which alternative of a substitution slot is in the active data base (report, 3.2.2).
struct Substitution {
    std::uint32_t slot = 0; ///< index into VisualDatabase::slots
    std::uint32_t index = 0;
};

/// New vertex normals for a list (the report's first method, 3.1.4), from `first` on, in the list's frame.
struct VertexNormalUpdate {
    std::uint32_t list = 0;
    std::uint32_t first = 0; ///< relative to the list's tile normals, or to its first vertex
    std::vector<Vec3f> normals;
};

/// Another priority number for a cluster in this frame: the report's real-time program sets the priorities of lists at its
/// initialization (3.3.1.1). The cluster leaves its group; of equal numbers it comes after the whole group.
struct ClusterPriority {
    std::uint32_t cluster = 0; ///< index into VisualDatabase::clusters
    std::int64_t number = 0;   ///< the lower wins
};

/// Something that the host itself stood at when it made the packet (a signal, its own ship's state; host/loop/host_values.h).
/// The image generator does not look at it; a recording keeps it.
struct HostValue {
    std::uint32_t index = 0;
    double value = 0.0;
};

/// Parameters of the sea that generators at frame time may use; nothing from ig/geometry down reads them.
struct SeaParameters {
    float state = 0; ///< report's sea state: 0, 1.5 ("1-2"), 3
    float current_east_mps = 0;
    float current_north_mps = 0;
};

/// How the machine makes a wake of a moving object's way, frame by frame.
enum class WakeMethod : std::uint8_t {
    kelvin,         ///< of her last minutes' track: crests, and churned water along it
    wave_particles, ///< of what her hull does to the water, as it floats
};

/// A wake that is made at frame time, as the faces of an object list that has none of its own.
struct WakeRequest {
    std::uint32_t list = 0;          ///< index into VisualDatabase::lists; in one row at most
    std::uint32_t moving_object = 0; ///< whose wake
    WakeMethod method = WakeMethod::kelvin;
    bool heights = false;            ///< its vertices rise and fall, besides being lit
    std::uint32_t colour = 0;        ///< colour code of its faces
    std::uint32_t most_faces = 4000; ///< reserved: it never takes more
    float age_s = 180.0F;            ///< kelvin: what is older is gone
    float strength = 1.0F;           ///< factor on its light and its height
    float speed_mps = 0.0F;          ///< through the water, along the heading
    float length_m = 160.0F;         ///< of the waterline, its middle at the moving object's position
    float beam_m = 20.0F;
    std::int32_t hull = none; ///< wave_particles: the list whose faces are the hull below her waterline
    /// wave_particles: the list with her sides above it, which are in the water when she rolls, pitches and heaves; none: she has none
    std::int32_t hull_above = none;
};

/// A straight wall in the water, from which the waves of wave particles come back. World, metres.
struct Quay {
    Vec2d from_m{0.0};
    Vec2d to_m{0.0};
};

struct FramePacket {
    std::uint64_t frame = 0;
    double time_s = 0.0;
    std::uint64_t database_id = 0; ///< content hash of the compiled database; 0: do not check
    std::vector<ChannelView> channels;
    std::vector<Vec3f> suns; ///< unit vectors towards the sun, world, parallel to VisualDatabase::suns
    std::vector<ListLighting> lighting;
    std::vector<MovingObject> moving_objects;
    std::vector<Substitution> substitutions;
    std::vector<VertexNormalUpdate> normal_updates;
    float lod_bias = 0.0F;          ///< levels of detail reach 2^bias times as far as authored; -16 to 16
    float visibility_m = 0.0F;      ///< meteorological optical range; 0: unlimited
    Vec3f sky{0.60F, 0.72F, 0.86F}; ///< colour where no face is, display-referred 0 to 1
    float time_of_day_h =
        12.0F; ///< what the numbers around it were made for: the machine reads them, never it
    /// Colour table of faces and tiles for this frame, parallel to VisualDatabase::colours; empty: as the database has
    /// it. Light points keep the database's colours.
    std::vector<Colour> colours;
    float light_points = 1.0F; ///< factor on the intensity of every light point, 0 to 100
    SeaParameters sea;
    std::uint64_t seed = 0;
    bool discontinuity = false; ///< the viewpoint or the scene jumped: histories start anew
    std::vector<ClusterPriority> priorities;
    std::vector<HostValue> host_values;
    std::vector<WakeRequest> wakes; ///< those that are there in this frame
    std::vector<Quay> quays;
};

} // namespace linkdig
