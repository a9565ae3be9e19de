#pragma once
/// The unit normal that a field's slopes stand for.

#include "database/water/wave_field.h"

namespace linkdig::support {

inline Vec3f normal_at(const database::WaveField& field, std::uint32_t column, std::uint32_t row) {
    const Vec2d slope = database::slope_at(field, column, row);
    return Vec3f(glm::normalize(Vec3d(-slope.x, -slope.y, 1.0)));
}

} // namespace linkdig::support
