#pragma once
/// Walks a tree of separating planes from the eye: near side, what stands on the plane, far side
/// (Schumacker's separating planes between clusters).

#include "database/model/visual_database.h"

#include <cstdint>
#include <span>

namespace linkdig::ig {

/// Calls leaf(index) for every leaf, nearest first. in_front(node) tells whether the eye is on a plane's
/// front side.
template <typename InFront, typename Leaf>
void walk_plane_tree(std::span<const PlaneNode> planes, std::int32_t reference, const InFront& in_front,
                     const Leaf& leaf) {
    if (reference == none) return;
    if (is_leaf(reference)) {
        leaf(leaf_index(reference));
        return;
    }
    const PlaneNode& node = planes[static_cast<std::size_t>(reference)];
    const bool front = in_front(node);
    walk_plane_tree(planes, front ? node.front : node.back, in_front, leaf);
    walk_plane_tree(planes, node.on, in_front, leaf);
    walk_plane_tree(planes, front ? node.back : node.front, in_front, leaf);
}

/// Is the point strictly in front of the plane? (A node with a null normal and distance -1 is in front of
/// everything: the compiler's way of writing a fixed order.)
inline bool in_front_of(const PlaneNode& node, const Vec3d& point) {
    return static_cast<double>(node.normal.x) * point.x + static_cast<double>(node.normal.y) * point.y +
               static_cast<double>(node.normal.z) * point.z >
           static_cast<double>(node.distance);
}

} // namespace linkdig::ig
