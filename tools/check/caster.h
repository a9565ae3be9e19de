#pragma once
/// Which faces a ray meets, and where: Embree finds them, their planes tell the range.

#include "tools/check/cast_scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace linkdig::tools {

struct CastHit {
    std::uint32_t face = 0; ///< into CastScene::faces
    double range_m = 0;     ///< from the eye; endless_m at infinity
};

/// Ranges that differ by less are the same to the check, metres: a centimetre, or 1/10,000 of the range.
double tolerance_m(double range_m);

/// Casts from the scene's eye. Many threads may ask at a time.
class Caster {
public:
    /// The scene must outlive the caster. Throws std::runtime_error if Embree cannot start.
    explicit Caster(const CastScene& scene);
    ~Caster();
    Caster(const Caster&) = delete;
    Caster& operator=(const Caster&) = delete;

    /// The faces that show their visible side to the ray, from `from_m` on, nearest first: all of them, or those
    /// within the tolerance of the nearest. `direction` is a unit vector.
    void all(const Vec3d& direction, double from_m, std::vector<CastHit>& hits) const;
    void nearest(const Vec3d& direction, double from_m, std::vector<CastHit>& hits) const;

    /// Is the eye inside something solid, or below a ground? Inside, most of what it sees first is a back.
    bool eye_is_inside() const;

private:
    struct Tree;
    void finish(const Vec3d& direction, double from_m, std::vector<CastHit>& hits) const;
    const CastFace* first_of_any_side(const Vec3d& direction) const;
    const CastScene& scene_;
    std::unique_ptr<Tree> tree_;
};

} // namespace linkdig::tools
