#include "ig/priority/cluster_order.h"

#include "ig/priority/plane_tree.h"

#include <algorithm>
#include <cmath>

namespace linkdig::ig {

namespace {

struct OrientedBox {
    Vec3d centre_m{0};
    Mat3d axes{1.0}; ///< columns, world
    Vec3d half_m{0};
};

Vec3d reference_point_m(const ActiveDatabase& active, std::uint32_t cluster) {
    const ClusterPose& pose = active.poses[cluster];
    return pose.body_origin_m + pose.world_from_body * active.database->clusters[cluster].reference_point_m;
}

OrientedBox box_of(const ActiveDatabase& active, std::uint32_t cluster) {
    return {reference_point_m(active, cluster), active.poses[cluster].world_from_body,
            Vec3d(active.database->clusters[cluster].half_extent_m)};
}

/// Half the length of the box's shadow on an axis.
double reach(const OrientedBox& box, const Vec3d& axis) {
    return std::fabs(glm::dot(axis, box.axes[0])) * box.half_m.x +
           std::fabs(glm::dot(axis, box.axes[1])) * box.half_m.y +
           std::fabs(glm::dot(axis, box.axes[2])) * box.half_m.z;
}

double distance_squared(const Vec3d& a, const Vec3d& b) { return glm::dot(a - b, a - b); }

/// What planes say of two boxes. A plane between them with the eye on one's side proves that the other cannot
/// hide it; with planes for both, neither hides the other and their order is free.
struct Verdict {
    bool first_is_safe = false;  ///< the second cannot hide the first
    bool second_is_safe = false; ///< the first cannot hide the second
    bool undecided() const { return !first_is_safe && !second_is_safe; }
};

/// Tries the fifteen axes of which one separates any two disjoint boxes: the face normals of both and the
/// cross products of their edges.
Verdict compare_boxes(const OrientedBox& a, const OrientedBox& b, const Vec3d& eye_m) {
    Verdict verdict;
    for (int k = 0; k < 15; ++k) {
        Vec3d axis = k < 3   ? a.axes[k]
                     : k < 6 ? b.axes[k - 3]
                             : glm::cross(a.axes[(k - 6) / 3], b.axes[(k - 6) % 3]);
        const double length_squared = glm::dot(axis, axis);
        if (length_squared < 1e-12) continue; // parallel edges
        axis = axis * (1.0 / std::sqrt(length_squared));
        if (glm::dot(axis, b.centre_m - a.centre_m) < 0.0) axis = -axis;
        const double end_of_a = glm::dot(axis, a.centre_m) + reach(a, axis);
        const double start_of_b = glm::dot(axis, b.centre_m) - reach(b, axis);
        if (end_of_a >= start_of_b) continue;
        const double eye = glm::dot(axis, eye_m);
        verdict.first_is_safe = verdict.first_is_safe || eye < start_of_b;
        verdict.second_is_safe = verdict.second_is_safe || eye > end_of_a;
    }
    return verdict;
}

class GroupOrder {
public:
    GroupOrder(const ActiveDatabase& active, const Vec3d& eye_m, PriorityScratch& scratch)
        : active_(active), database_(*active.database), eye_m_(eye_m), scratch_(scratch) {}

    std::uint64_t run(std::uint32_t group) {
        auto& moving = moving_at(0);
        for (std::uint32_t c = 0; c < database_.clusters.size(); ++c) {
            const Cluster& cluster = database_.clusters[c];
            if (cluster.group != group || !active_.poses[c].visible) continue;
            if (cluster.moving_object != none) moving.push_back(c);
        }
        const std::int32_t root = database_.groups[group].root;
        if (root == none) {
            const std::int32_t only = only_static_cluster(group);
            put_leaf(only, 0);
        } else {
            put(root, 0);
        }
        return ambiguous_;
    }

private:
    std::vector<std::uint32_t>& moving_at(std::size_t depth) {
        if (scratch_.moving.size() <= depth) scratch_.moving.resize(depth + 1);
        scratch_.moving[depth].clear();
        return scratch_.moving[depth];
    }

    std::int32_t only_static_cluster(std::uint32_t group) const {
        for (std::uint32_t c = 0; c < database_.clusters.size(); ++c) {
            if (database_.clusters[c].group == group && database_.clusters[c].moving_object == none) {
                return static_cast<std::int32_t>(c);
            }
        }
        return none;
    }

    /// Near side, on the plane, far side; each moving cluster goes with the side of its reference point.
    void put(std::int32_t reference, std::size_t depth) {
        if (reference == none || is_leaf(reference)) {
            put_leaf(reference == none ? none : static_cast<std::int32_t>(leaf_index(reference)), depth);
            return;
        }
        const PlaneNode& node = database_.planes[static_cast<std::size_t>(reference)];
        const bool eye_in_front = in_front_of(node, eye_m_);
        put_side(eye_in_front ? node.front : node.back, node, eye_in_front, depth);
        if (node.on != none) {
            moving_at(depth + 1);
            put(node.on, depth + 1);
        }
        put_side(eye_in_front ? node.back : node.front, node, !eye_in_front, depth);
    }

    void put_side(std::int32_t child, const PlaneNode& node, bool front, std::size_t depth) {
        auto& side = moving_at(depth + 1);
        for (const std::uint32_t c : scratch_.moving[depth]) {
            if (in_front_of(node, reference_point_m(active_, c)) == front) side.push_back(c);
        }
        put(child, depth + 1);
    }

    /// One static cluster (or none) and the moving ones that share its cell.
    void put_leaf(std::int32_t static_cluster, std::size_t depth) {
        auto& left = scratch_.moving[depth];
        if (static_cluster != none) left.push_back(static_cast<std::uint32_t>(static_cluster));
        count_undecided(left);
        while (!left.empty()) {
            const std::size_t next = first_in_front(left);
            scratch_.clusters.push_back(left[next]);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(next));
        }
    }

    void count_undecided(const std::vector<std::uint32_t>& clusters) {
        for (std::size_t i = 0; i < clusters.size(); ++i) {
            for (std::size_t j = i + 1; j < clusters.size(); ++j) {
                if (compare(clusters[i], clusters[j]).undecided()) ++ambiguous_;
            }
        }
    }

    /// Index of a cluster that none of the others is in front of; in a cycle, which counts as undecided, the
    /// nearest.
    std::size_t first_in_front(const std::vector<std::uint32_t>& left) {
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            bool free = true;
            for (std::size_t j = 0; j < left.size() && free; ++j) {
                if (i != j && in_front(left[j], left[i])) free = false;
            }
            if (free) return i;
            if (distance(left[i]) < distance(left[nearest])) nearest = i;
        }
        ++ambiguous_;
        return nearest;
    }

    double distance(std::uint32_t cluster) const {
        return distance_squared(reference_point_m(active_, cluster), eye_m_);
    }

    Verdict compare(std::uint32_t a, std::uint32_t b) const {
        return compare_boxes(box_of(active_, a), box_of(active_, b), eye_m_);
    }

    /// Must a come before b?
    bool in_front(std::uint32_t a, std::uint32_t b) const {
        const Verdict verdict = compare(a, b);
        if (!verdict.undecided()) return !verdict.second_is_safe;
        const double da = distance(a);
        const double db = distance(b);
        return da < db || (da == db && a < b);
    }

    const ActiveDatabase& active_;
    const VisualDatabase& database_;
    Vec3d eye_m_;
    PriorityScratch& scratch_;
    std::uint64_t ambiguous_ = 0;
};

} // namespace

std::uint64_t order_clusters(const ActiveDatabase& active, std::uint32_t group, const Vec3d& eye_m,
                             PriorityScratch& scratch) {
    return GroupOrder(active, eye_m, scratch).run(group);
}

} // namespace linkdig::ig
