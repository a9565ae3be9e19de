#pragma once
/// Convex solids as half spaces: what a ray meets is computed from these alone, as a second opinion on compiled faces.

#include "tests/database/compiler/authored.h"

#include "database/model/random.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::database {

/// A convex solid as half spaces: what a ray meets is computed from these alone.
struct Solid {
    struct HalfSpace {
        Vec3d normal;
        double distance;
    };
    std::vector<HalfSpace> bounds;
    std::string text; ///< as authored
    Vec3d low{0}, high{0};
};

Solid box(const Vec3d& low, const Vec3d& high);
/// Upright prism over a regular polygon, turned about its axis.
Solid prism(const Vec3d& centre, double radius, double half_height, int sides, double turn);

class Random {
public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}
    double between(double low, double high) { return low + (high - low) * random_unit(seed_, index_++); }
    Vec3d point(const Vec3d& low, const Vec3d& high) {
        const double x = between(low.x, high.x), y = between(low.y, high.y);
        return {x, y, between(low.z, high.z)};
    }

private:
    std::uint64_t seed_;
    std::uint64_t index_ = 0;
};

struct Ray {
    Vec3d from;
    Vec3d along; ///< unit
};

/// The scene of these solids, and what the compiler makes of it.
CompileResult compiled(const std::vector<Solid>& solids);

/// Boxes and prisms that are apart from each other, at most as many as wanted.
std::vector<Solid> random_solids(Random& random, int wanted);
/// Three beams, each over the next: no order of whole beams is right from above.
std::vector<Solid> interlocked_beams();

/// The list's faces as the machine takes them: near side of each plane, what stands on it, far side.
void walk(const VisualDatabase& d, std::int32_t reference, const Vec3d& eye,
          std::vector<std::uint32_t>& faces);

/// Does the ray meet the face from its front (or either side)? `margin` shrinks to the nearest edge's distance, metres.
bool meets(const VisualDatabase& d, const Face& face, const Ray& ray, double& distance, double& margin);

/// What a ray meets among faces in an order: distances, metres, of the first in that order and of the nearest.
struct Met {
    double first = 1e300, nearest = 1e300;
    double margin = 1e300; ///< to the nearest edge of any of them
    /// It meets one, and no edge is so near that either answer would be right.
    bool clearly() const { return margin >= 5e-3 && nearest <= 1e299; }
};
Met met_in_order(const VisualDatabase& d, const std::vector<std::uint32_t>& order, const Ray& ray);

/// Rays looked at; wrong: the first face in the order is not the nearest solid.
struct Tally {
    int rays = 0, hits = 0, grazing = 0, wrong = 0;
};

/// Rays from random eyes at random points about the origin, 60 for each eye that is in no solid.
void check_rays(const VisualDatabase& d, const std::vector<Solid>& solids, Random& random, int eyes,
                Tally& tally);

} // namespace linkdig::database
