#include "database/compiler/cutting.h"
#include "database/compiler/ordering.h"
#include "database/compiler/splitting_plane.h"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace linkdig::database {

std::int32_t fixed_order(std::span<const std::int32_t> references, std::vector<PlaneNode>& nodes) {
    if (references.empty()) return none;
    if (references.size() == 1) return references.front();
    const std::size_t third = (references.size() + 2) / 3;
    const auto part = [&](std::size_t index) {
        const std::size_t first = std::min(references.size(), index * third);
        return fixed_order(references.subspan(first, std::min(third, references.size() - first)), nodes);
    };
    PlaneNode node;
    node.normal = Vec3f(0.0F);
    node.distance = -1.0F; // every eye is in front: front, on, back
    node.front = part(0);
    node.on = part(1);
    node.back = part(2);
    nodes.push_back(node);
    return static_cast<std::int32_t>(nodes.size()) - 1;
}

namespace {

class Orderer {
public:
    FaceOrder run(std::vector<OrderFace> faces) {
        for (OrderFace& face : faces) {
            for (OrderCorner& corner : face.corners)
                corner.point = points_.point(corner.position);
            bound(face);
        }
        tolerance_ = split_tolerance(faces);
        large_ = faces.size() > most_faces_compared;
        order_.root = order(std::move(faces));
        for (std::vector<OrderFace>& leaf : order_.leaves)
            for (OrderFace& face : leaf)
                points_.join(face);
        return std::move(order_);
    }

private:
    std::int32_t order(std::vector<OrderFace> faces) {
        if (faces.empty()) return none;
        if (const auto plane = cell_plane(faces)) return split(std::move(faces), *plane);
        const auto tied = [&](const OrderFace& a, const OrderFace& b) {
            tell(order_.ties, told_ties_, a, b);
        };
        std::vector<std::int32_t> references;
        std::vector<OrderFace> leaf;
        for (const std::vector<std::uint32_t>& part : hiding_order(faces, tied)) {
            if (part.size() == 1) {
                leaf.push_back(std::move(faces[part.front()]));
                continue;
            }
            if (!leaf.empty()) references.push_back(add_leaf(std::exchange(leaf, {})));
            std::vector<OrderFace> cycle;
            for (const std::uint32_t i : part)
                cycle.push_back(std::move(faces[i]));
            references.push_back(break_cycle(std::move(cycle)));
        }
        if (!leaf.empty()) references.push_back(add_leaf(std::move(leaf)));
        return fixed_order(references, order_.nodes);
    }

    /// The plane that divides a large list's cell further, if it is to be divided.
    std::optional<Plane> cell_plane(std::span<const OrderFace> faces) const {
        if (!large_ || faces.size() <= least_faces_of_cell) return std::nullopt;
        const std::optional<EvenPlane> found = even_plane(faces, tolerance_);
        if (!found || (found->cuts && faces.size() <= most_faces_of_cell)) return std::nullopt;
        return found->plane;
    }

    std::int32_t break_cycle(std::vector<OrderFace> cycle) {
        if (const auto plane = splitting_plane(cycle, tolerance_)) return split(std::move(cycle), *plane);
        tell(order_.inseparable, told_inseparable_, cycle[0], cycle[1]);
        return add_leaf(std::move(cycle));
    }

    std::int32_t split(std::vector<OrderFace> faces, const Plane& plane) {
        std::vector<OrderFace> front, on, back;
        for (OrderFace& face : faces) {
            Halves halves = cut_face(std::move(face), plane, tolerance_, points_);
            order_.splits += halves.faces.size() > 1 ? 1 : 0;
            if (halves.front) front.push_back(std::move(halves.faces[*halves.front]));
            if (halves.on) on.push_back(std::move(halves.faces[*halves.on]));
            if (halves.back) back.push_back(std::move(halves.faces[*halves.back]));
        }
        faces = {}; // a large list does not fit in memory once per level of its tree
        PlaneNode node;
        node.normal = Vec3f(plane.normal);
        node.distance = static_cast<float>(plane.distance);
        node.front = order(std::move(front));
        node.on = order(std::move(on));
        node.back = order(std::move(back));
        order_.nodes.push_back(node);
        return static_cast<std::int32_t>(order_.nodes.size()) - 1;
    }

    std::int32_t add_leaf(std::vector<OrderFace> faces) {
        order_.leaves.push_back(std::move(faces));
        return leaf_reference(static_cast<std::uint32_t>(order_.leaves.size()) - 1);
    }

    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    static void tell(std::vector<Pair>& list, std::set<Pair>& told, const OrderFace& a, const OrderFace& b) {
        const Pair pair = std::minmax(a.source, b.source);
        if (told.insert(pair).second) list.push_back(pair);
    }

    EdgePoints points_;
    FaceOrder order_;
    double tolerance_ = plane_tolerance_m;
    bool large_ = false;
    std::set<Pair> told_ties_, told_inseparable_;
};

} // namespace

FaceOrder order_faces(std::vector<OrderFace> faces) { return Orderer().run(std::move(faces)); }

} // namespace linkdig::database
