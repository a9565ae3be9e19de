#pragma once
/// Pass 5: the faces of a list in an order that holds from every eye: fixed where it can be, by planes where
/// it must.
///
/// Face a *can hide* face b if b has a part strictly behind a's plane and a has a part strictly in front of
/// b's: then, and only then, a ray from an eye in front of both meets a before b. Faces among which "can
/// hide" has no cycle have one order for all eyes; a cycle is broken by a plane between its faces, which may
/// cut some of them in two (Schumacker, Brand, Gilliland, Sharp: Study for applying computer-generated images
/// to visual simulation, AFHRL-TR-69-14, 1969).

#include "database/compiler/polygon.h"
#include "database/model/visual_database.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace linkdig::database {

struct OrderCorner {
    Vec4d position{0, 0, 0, 1};
    Vec3d normal{0, 0, 1};
    Vec3d colour{0};         ///< 0 to 255, of a coloured face
    std::uint32_t point = 0; ///< corners at the same place share it
};

/// Which levels of one detail are present at a time.
enum class Levels : std::uint8_t {
    one_by_one, ///< replaced at once
    blended,    ///< neighbours, while they blend: then the finer is in front, wherever it lies
    added,      ///< all
};

struct OrderFace {
    std::vector<OrderCorner> corners;
    Plane plane;
    double tolerance = plane_tolerance_m; ///< of sides of its plane: its own corners are on it
    bool at_infinity = false;
    bool two_sided = false;
    bool interpolates = false; ///< its corners' normals matter
    bool coloured = false;     ///< its corners' colours matter
    /// A light point: one corner; it hides nothing, and what stands in its own plane is behind it. Directed: seen
    /// only from the front of `plane`.
    bool is_light = false;
    bool directed = false;
    bool of_mesh = false; ///< where such faces overlap in one plane and layer, the later one is in front
    std::int32_t layer = 0;
    std::int32_t slot = none;
    std::uint32_t alternative = 0;
    std::int32_t detail = none;
    std::uint32_t level = 0;
    Levels levels = Levels::one_by_one; ///< of its detail
    std::uint32_t source = 0;           ///< the face that it is, or is a part of
    Vec3d centre{0};                    ///< bounding sphere of its corners
    double radius = 0;                  ///< infinite if a corner is
};

/// Sets centre and radius from the corners.
void bound(OrderFace& face);

/// Where the face has parts: in front of a plane, behind it.
struct Sides {
    bool front = false;
    bool back = false;
};
Sides sides_of(const OrderFace& face, const Plane& plane, double tolerance);

enum class Relation { none, first_hides, second_hides, both_hide, tie };
Relation relation(const OrderFace& a, const OrderFace& b);

/// Sets of faces that hide each other in a cycle, in an order in which none hides an earlier one. Of those
/// that are free to come next, the one with the lowest index does. `tied` is told of coplanar faces that
/// overlap in one layer.
std::vector<std::vector<std::uint32_t>>
hiding_order(std::span<const OrderFace> faces,
             const std::function<void(const OrderFace&, const OrderFace&)>& tied);

/// Appends plane nodes that put the references in this order from every eye; the root, or none of none.
std::int32_t fixed_order(std::span<const std::int32_t> references, std::vector<PlaneNode>& nodes);

struct FaceOrder {
    std::vector<PlaneNode> nodes;               ///< leaf references point into leaves
    std::vector<std::vector<OrderFace>> leaves; ///< front to back
    std::int32_t root = none;
    std::uint32_t splits = 0;                                  ///< times that a plane cut a face in two
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ties; ///< sources, each pair once
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        inseparable; ///< sources that hide each other, no plane between
};

/// "Can hide" looks at all pairs. Lists of more faces than this are *large*: axis planes divide them first,
/// into cells of at most `most_faces_of_cell`, and on as long as a plane cuts nothing, to `least_faces_of_cell`.
inline constexpr std::size_t most_faces_compared = 4000;
inline constexpr std::size_t most_faces_of_cell = 512;
inline constexpr std::size_t least_faces_of_cell = 48;

FaceOrder order_faces(std::vector<OrderFace> faces);

} // namespace linkdig::database
