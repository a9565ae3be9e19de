#pragma once
/// Output of the active data base: the faces that exist this frame, in blocks that share frame, light and
/// priority.

#include "database/model/visual_database.h"
#include "host/packet/frame_packet.h"

#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// Faces of one object list as they are this frame. Spans point into the visual database, or into
/// ActiveDatabase's own pools for faces that were made this frame; both outlive the frame.
struct FaceBlock {
    std::uint32_t list = 0;     ///< into VisualDatabase::lists
    std::uint32_t cluster = 0;  ///< into VisualDatabase::clusters
    std::int32_t number = 0;    ///< priority inside the cluster
    Mat3d world_from_list{1.0}; ///< rotation
    Vec3d origin_m{0};          ///< of the list's vertices, world (ignored if at_eye)
    bool at_eye = false;        ///< the origin is the channel's own viewpoint
    Vec3f sun{0, 0, 1};         ///< towards the list's sun, in the list's frame
    float ambient = 0;
    float diffuse = 1;
    bool smooth = true;         ///< false: vertex-shaded faces are face-shaded this frame
    std::int32_t colour = none; ///< overrides every face's colour code
    std::span<const Vertex> vertices{};
    std::span<const std::uint32_t> corners{}; ///< indices into vertices
    std::span<const Colour> corner_colours{}; ///< parallel to corners, or empty: no face is coloured
    std::span<const Face> faces{};            ///< first_corner indexes `corners`
    std::span<const FaceRun> runs{};          ///< first_face indexes `faces`
    std::span<const RunLeaf> leaves{};        ///< first_run indexes `runs`
    std::span<const LightPoint> lights{};     ///< first_light indexes them
    std::int32_t root =
        none; ///< of the list's plane tree: nodes in VisualDatabase::planes, leaves in `leaves`
};

/// A moving cluster's frames, this frame.
struct ClusterPose {
    bool visible = true;
    Mat3d world_from_body{1.0};
    Vec3d body_origin_m{0};
    Mat3d world_from_waterline{1.0};
    Vec3d waterline_origin_m{0};
};

/// What an object costs, and how large it is: its bounding sphere in its list's frame (radius negative: never small).
struct ObjectWorth {
    Vec3f centre{0};
    float radius = -1;
    std::uint32_t edges = 0; ///< not fewer than its faces have on one channel
};

/// What exists this frame. Shared by all channels.
struct ActiveDatabase {
    const VisualDatabase* database = nullptr;
    std::vector<FaceBlock> blocks;
    std::vector<ClusterPose> poses;     ///< parallel to VisualDatabase::clusters
    std::vector<ClusterPriority> moved; ///< clusters that leave their group this frame, by number, then index
    std::vector<std::uint32_t>
        slot_index;               ///< parallel to VisualDatabase::slots: the alternative that is present
    double time_s = 0.0;          ///< of the packet: what flashes by
    double visibility_m = 0.0;    ///< 0: unlimited
    float light_points = 1.0F;    ///< factor on the intensity of light points
    std::uint32_t light_step = 0; ///< 0 where the machine has no limits: see light_steps.h

    std::vector<std::uint16_t>
        level_opacity; ///< parallel to VisualDatabase::detail_levels: of 256; 0 is absent

    /// Only where the machine has limits, else empty: see shedding.h.
    std::vector<ObjectWorth> object_worth; ///< parallel to VisualDatabase::objects, as the next two
    std::vector<double>
        object_px; ///< how large each looks, on the channel where it looks largest; 0 out of sight
    std::vector<std::uint8_t> object_shed; ///< 1: left out
    std::vector<double>
        detail_range_m; ///< parallel to VisualDatabase::details: of the nearest eye, without bias
    std::vector<std::int32_t> block_of_list; ///< parallel to VisualDatabase::lists

    /// Storage of the faces made this frame. Capacities persist from frame to frame.
    std::vector<Vertex> made_vertices;
    std::vector<std::uint32_t> made_corners;
    std::vector<Face> made_faces;
    std::vector<FaceRun> made_runs;
    std::vector<RunLeaf> made_leaves;
    std::vector<Vec3f> updated_normals;       ///< of the tile at hand, where the packet changes them
    std::vector<std::uint32_t> made_faces_of; ///< blocks whose faces were made this frame
};

/// How much of a level of detail is seen, of 256; what belongs to none (`none`) is wholly there.
inline std::uint16_t level_opacity(const ActiveDatabase& active, std::int32_t level) {
    return level == none ? std::uint16_t{256} : active.level_opacity[static_cast<std::size_t>(level)];
}

/// Is this run in the active data base, given the slots' pointers and the levels of detail?
inline bool present(const FaceRun& run, const ActiveDatabase& active) {
    return (run.slot == none || active.slot_index[static_cast<std::size_t>(run.slot)] == run.alternative) &&
           level_opacity(active, run.level) != 0;
}

} // namespace linkdig::ig
