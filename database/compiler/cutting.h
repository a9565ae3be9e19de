#pragma once
/// Cutting faces by planes so that neighbours stay joined: both sides of an edge get the same cut points.

#include "database/compiler/ordering.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace linkdig::database {

/// The places of a list's corners, and the points made on edges. Every point is computed from the ends of the
/// edge that it was first made on, in canonical order, and remembered there: whoever else has that edge gets
/// it too.
class EdgePoints {
public:
    /// The number of a place.
    std::uint32_t point(const Vec4d& position);
    /// Where the plane crosses the edge between two corners on its different sides.
    OrderCorner cross(const OrderCorner& a, const OrderCorner& b, const Plane& plane);
    /// Puts points that were made on the face's edges by other faces into its corners.
    void join(OrderFace& face) const;

private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< lower point first
    using Place = std::array<double, 4>;
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };
    struct Cut {
        double part = 0; ///< of the way from the edge's lower to its higher point
        std::uint32_t point = 0;
    };
    void join_edges(OrderFace& face) const;
    Edge root_edge(std::uint32_t a, std::uint32_t b) const;
    double part_of(const Edge& edge, std::uint32_t point) const;
    std::uint32_t cut(const Edge& edge, const Plane& plane);

    std::vector<Vec4d> positions_;
    std::vector<std::optional<Edge>> made_on_; ///< by point
    std::unordered_map<Place, std::uint32_t, PlaceHash>
        index_;                             ///< looked up, never walked: it decides no order
    std::map<Edge, std::vector<Cut>> cuts_; ///< ascending by part
};

struct Halves {
    std::vector<OrderFace> faces;               ///< one or two
    std::optional<std::size_t> front, on, back; ///< into faces
};

/// The parts of a face in front of a plane, on it, behind it.
Halves cut_face(OrderFace face, const Plane& plane, double tolerance, EdgePoints& points);

} // namespace linkdig::database
