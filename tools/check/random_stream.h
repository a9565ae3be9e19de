#pragma once
/// Numbers from one seed, in the order of asking.

#include "database/model/random.h"
#include "database/model/vectors.h"

#include <cstdint>

namespace linkdig::tools {

class RandomStream {
public:
    explicit RandomStream(std::uint64_t seed) : seed_(seed) {}
    double between(double least, double greatest) {
        return least + (greatest - least) * random_unit(seed_, index_++);
    }
    /// 0 to count - 1.
    std::uint32_t below(std::uint32_t count) {
        return static_cast<std::uint32_t>(between(0.0, static_cast<double>(count)));
    }
    Vec3d point(const Vec3d& low, const Vec3d& high) { // in a fixed order
        const double x = between(low.x, high.x);
        const double y = between(low.y, high.y);
        return {x, y, between(low.z, high.z)};
    }

private:
    std::uint64_t seed_;
    std::uint64_t index_ = 0;
};

} // namespace linkdig::tools
