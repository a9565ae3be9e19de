#pragma once
/// The visual database: what the compiler returns, the file format stores and the image generator reads.
///
/// A value: copyable, comparable, without pointers. Everything refers to everything by index into the vectors
/// below.
///
///   cluster -> object list -> face run -> face -> corner -> vertex
///
/// Priority (lower number wins) is resolved at four levels, each with the means that the level needs:
///   1. priority groups: clusters with different group numbers: the lower number wins;
///   2. inside a group, a tree of planes orders the static clusters; moving ones are inserted by the machine;
///   3. inside a cluster, lists with different numbers: the lower wins; equal ones by the cluster's tree of
///   planes;
///   4. inside a list, a tree of planes orders face runs from the eye; inside a run the face order is fixed.

#include "database/model/vectors.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig {

/// No such thing: index of nothing.
inline constexpr std::int32_t none = -1;

/// Colour code: display-referred 8-bit components; a pixel is colour code x intensity, without gamma.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t reserved = 0;
    bool operator==(const Colour&) const = default;
};

/// A vertex of an object list, in the list's frame. w = 1: position in metres relative to the list's origin;
/// w = 0: a direction, the vertex lies at infinity. The normal (unit, or the mean of unit normals) lights
/// vertex-shaded faces.
struct Vertex {
    Vec4f position{0, 0, 0, 1};
    Vec3f normal{0, 0, 1};
    bool operator==(const Vertex&) const = default;
};

/// How a face gets its intensity (report, 3.1.3 and Appendix I).
enum class Shading : std::uint8_t {
    unshaded, ///< intensity 1: the colour code as it stands
    face,     ///< one intensity from the face normal
    vertex,   ///< smooth shading: an intensity per vertex, interpolated along edges, then along the line
};

/// One convex planar polygon. Corners run counter-clockwise seen from the front. Corner 0 is where the
/// machine's triangulation of smooth-shaded faces fans out from: the compiler rotates the corners so that the
/// stored diagonal (Figure 11 of the report) starts there.
struct Face {
    std::uint32_t first_corner = 0; ///< into VisualDatabase::corners
    std::uint16_t corner_count = 0; ///< >= 3
    std::uint16_t colour = 0;       ///< into VisualDatabase::colours
    std::uint32_t object = 0;       ///< into VisualDatabase::objects
    Vec3f normal{0, 0, 1};          ///< unit, in the list's frame; lights face-shaded faces
    Shading shading = Shading::face;
    std::uint8_t two_sided = 0;  ///< 1: seen from both sides (lit by its front normal)
    std::uint16_t file = 0;      ///< into VisualDatabase::source_files
    std::uint32_t line = 0;      ///< line of the authoring file; 0 if generated
    std::uint16_t opacity = 256; ///< of 256: what it takes of the light behind it; 1 to 256
    std::uint16_t coloured = 0;  ///< 1: its corners have colours of their own, which are interpolated
    bool operator==(const Face&) const = default;
};

/// A named thing of an object list. Its faces may stand in several runs of the list.
struct Object {
    std::string name;
    std::uint32_t list = 0;
    std::int32_t slot = none;      ///< substitution slot it belongs to, or none: always present
    std::uint16_t alternative = 0; ///< its index in that slot: present when the slot's pointer stands on it
    std::uint16_t reserved = 0;
    std::int32_t level = none; ///< level of detail that it belongs to: into detail_levels; none: at any range
    bool operator==(const Object&) const = default;
};

/// Which way a light point shines.
enum class LightBeam : std::uint8_t { all_round, one_way, two_way };

/// How a light point weakens with range r beyond full_to_m: not at all, as full_to_m / r, or as its square.
enum class FallOff : std::uint8_t { flat, linear, square };

/// A light point: it hides nothing, and its light is added to what is seen at its place. In a beam it is as bright as
/// max(0, 1 - q/2), q = (a / tan A)^2 + (b / tan B)^2, a and b the tangents of the angles to the side and upwards off
/// the beam's middle, A and B the half-angles at which half is left.
struct LightPoint {
    Vec3f position{0};             ///< metres, in the list's frame
    std::uint32_t place = 0;       ///< faces of its run that it is behind; it is in front of the others
    Vec3f direction{1, 0, 0};      ///< unit: the middle of the beam (two_way: of the first one)
    float across = 0;              ///< 1 / tan^2 A
    Vec3f side{0, 1, 0};           ///< unit, at right angles to `direction`: where a counts
    float upward = 0;              ///< 1 / tan^2 B
    float intensity = 1;           ///< the whole splat's light, in pixels at the full colour code
    float size_m = 0;              ///< diameter; 0: never more than a point
    float full_to_m = 0;           ///< range from which on it falls off
    float flash_hz = 0;            ///< 0: steady
    float duty = 1;                ///< part of a flash's period for which it is lit, from the beginning
    float phase = 0;               ///< where in its period it stands at time 0, 0 to 1
    std::uint32_t object = 0;      ///< into VisualDatabase::objects
    std::uint32_t line = 0;        ///< of the authoring file
    std::uint16_t file = 0;        ///< into VisualDatabase::source_files
    std::uint16_t colour = 0;      ///< into VisualDatabase::colours
    std::uint16_t back_colour = 0; ///< of the second beam (two_way)
    LightBeam beam = LightBeam::all_round;
    FallOff fall_off = FallOff::flat;
    bool operator==(const LightPoint&) const = default;
};

/// Faces in their fixed order, front to back, that are present or absent together (same slot and alternative,
/// same level of detail), and the light points among them, ascending by `place`.
struct FaceRun {
    std::uint32_t first_face = 0;
    std::uint32_t face_count = 0;
    std::int32_t slot = none;
    std::uint32_t alternative = 0;
    std::int32_t level = none; ///< into VisualDatabase::detail_levels
    Vec3f centre{0};  ///< bounding sphere in the list's frame, of the vertices with w = 1 and the lights
    float radius = 0; ///< metres; negative: reaches infinity, never culled
    std::uint32_t first_light = 0;
    std::uint32_t light_count = 0;
    bool operator==(const FaceRun&) const = default;
};

/// A node of a tree of separating planes. The children are *references*: r >= 0 is plane node r, r == none
/// nothing, r <= -2 is leaf number (-2 - r) -- of what kind depends on the owner (clusters, lists or leaves
/// of face runs). Seen from the eye, the near side comes first, then what stands on the plane, then the far
/// side.
struct PlaneNode {
    Vec3f normal{0, 0, 1}; ///< unit
    float distance = 0;    ///< metres: front is dot(normal, p) > distance
    std::int32_t front = none;
    std::int32_t on = none;
    std::int32_t back = none;
    std::uint8_t waterline =
        0; ///< plane hangs in the waterline frame instead of the body frame (clusters only)
    std::uint8_t reserved[3] = {0, 0, 0};
    bool operator==(const PlaneNode&) const = default;
};
constexpr std::int32_t leaf_reference(std::uint32_t leaf) { return -2 - static_cast<std::int32_t>(leaf); }
constexpr bool is_leaf(std::int32_t reference) { return reference <= -2; }
constexpr std::uint32_t leaf_index(std::int32_t reference) {
    return static_cast<std::uint32_t>(-2 - reference);
}

/// Leaf of a list's tree: consecutive face runs, in their fixed order.
struct RunLeaf {
    std::uint32_t first_run = 0;
    std::uint32_t run_count = 0;
    bool operator==(const RunLeaf&) const = default;
};

/// Which frame of its cluster a list hangs in.
enum class Attachment : std::uint8_t {
    world,     ///< static
    body,      ///< moves with all six degrees of freedom
    waterline, ///< position and heading only: without pitch, roll, heave
    eye,       ///< centred on the viewpoint, world-oriented: sky domes
};

/// Faces that share a frame, a sun vector and the light's parameters (report, 3.1.4: a second sun vector for
/// a group of objects of its own).
struct ObjectList {
    std::string name;
    std::uint32_t cluster = 0;
    std::int32_t number = 0; ///< priority inside its cluster; lower wins
    Attachment attachment = Attachment::world;
    std::uint32_t sun = 0; ///< index into the packet's table of sun vectors
    float ambient = 0;     ///< intensity = ambient + diffuse * max(0, n.s), 0 to 1
    float diffuse = 1;
    Vec3d origin_m{0};        ///< of the vertices, in the frame named by attachment
    std::int32_t root = none; ///< tree of the list: leaf references point into run_leaves
    std::int32_t tile = none; ///< repeated tile whose copies the active data base puts in, or none
    /// Additive list (report, 3.2.3): its faces hide nothing; their light is added to that of the next face behind them
    /// if that belongs to this list, and over anything else they are not seen. None: an ordinary list.
    std::int32_t added_to = none;
    bool operator==(const ObjectList&) const = default;
};

/// Lists ordered as a unit: a ship with its box, wedges and wakes; a pier; the sea.
struct Cluster {
    std::string name;
    std::uint32_t group = 0;           ///< into VisualDatabase::groups
    std::int32_t moving_object = none; ///< into VisualDatabase::moving_objects, or none: static
    Vec3d reference_point_m{0};        ///< in the cluster's frame
    Vec3f half_extent_m{0};   ///< of its box about the reference point, for planes between moving clusters
    std::int32_t root = none; ///< tree of the cluster: leaf references are object lists
    bool operator==(const Cluster&) const = default;
};

/// Clusters that compete under one priority number.
struct PriorityGroup {
    std::int32_t number = 0;  ///< lower wins
    std::int32_t root = none; ///< tree over static clusters (planes in world): leaf references are clusters
    bool operator==(const PriorityGroup&) const = default;
};

/// A substitution slot (report, 3.2.2): one of `alternatives` objects is in the active data base at a time.
struct SubstitutionSlot {
    std::string name;
    std::uint32_t alternatives = 0;
    bool operator==(const SubstitutionSlot&) const = default;
};

/// Levels of detail of one thing, replaced by the range of the nearest eye from a point of its cluster. Level 0 is the
/// finest; level k is present from the end of level k - 1 out to its own to_m, beyond the last there is nothing.
/// Either hysteresis or a blend keeps the change from being seen twice, or at all; not both.
struct Detail {
    std::string name;
    std::uint32_t cluster = 0;
    Vec3d reference_m{0}; ///< in the cluster's body frame (world if it is static)
    float hysteresis_m =
        0;             ///< between the change outward and the change back; half of it to each side of to_m
    float blend_m = 0; ///< over this range, half to each side of to_m, both levels are present
    std::uint8_t added =
        0; ///< 1: levels add up instead (report, 3.2.3): each is present from range 0 to its to_m
    std::uint32_t first_level = 0; ///< into detail_levels
    std::uint32_t levels = 0;      ///< 1 to 16
    bool operator==(const Detail&) const = default;
};

/// The levels of all details, each detail's together, finest first.
struct DetailLevel {
    std::uint32_t detail = 0; ///< into details
    float to_m = 0;           ///< ascending inside a detail
    bool operator==(const DetailLevel&) const = default;
};

/// A periodic tile of squares, repeated over the horizontal plane of its list out to the horizon. Squares of
/// ring k have the side cell_m * 2^k and use every 2^k-th vertex of the pattern; `fine_levels` more levels
/// below 0 divide the pattern's squares close to the eye.
struct RepeatedTile {
    std::uint32_t list = 0;
    std::uint32_t period = 0;      ///< cells along each side of the tile: a power of two, 2 to 1024
    double cell_m = 0;             ///< side of a square
    std::uint32_t rings = 0;       ///< coarser rings around the innermost square field, 1 to 16
    std::uint32_t fine_levels = 0; ///< 0 to 6
    std::uint32_t half_width = 0;  ///< squares from the eye to a ring's outer border: a multiple of 4, >= 8
    float vertical_angle_rad = 0;  ///< a: the normals' fixed elevation; the mean normal is (0, 0, sin a)
    std::uint16_t colour = 0;
    std::uint16_t file = 0;
    std::uint32_t line = 0;
    std::uint32_t first_normal = 0; ///< into tile_normals: period^2 vertex normals, row by row (y outer)
    std::uint32_t first_face_normal =
        0; ///< into tile_normals: period^2 normals of the squares, for face shading
    bool operator==(const RepeatedTile&) const = default;
};

struct VisualDatabase {
    std::string name;
    std::vector<std::string> source_files;
    std::vector<Colour> colours;
    std::vector<std::string> colour_names;
    std::vector<std::string> suns;           ///< names of the rows of the packet's table of sun vectors
    std::vector<std::string> moving_objects; ///< names of the rows of the packet's table of moving objects
    std::vector<SubstitutionSlot> slots;
    std::vector<Detail> details;
    std::vector<DetailLevel> detail_levels;
    std::vector<PriorityGroup> groups; ///< ascending by number
    std::vector<Cluster> clusters;
    std::vector<ObjectList> lists;
    std::vector<Object> objects;
    std::vector<PlaneNode> planes;
    std::vector<RunLeaf> run_leaves;
    std::vector<FaceRun> runs;
    std::vector<Face> faces;
    std::vector<std::uint32_t> corners; ///< indices into vertices
    std::vector<Colour> corner_colours; ///< parallel to corners; empty if no face is coloured
    std::vector<Vertex> vertices;
    std::vector<LightPoint> lights;
    std::vector<RepeatedTile> tiles;
    std::vector<Vec3f> tile_normals;
    bool operator==(const VisualDatabase&) const = default;
};

} // namespace linkdig
