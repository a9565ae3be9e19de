#pragma once
/// Vectors and matrices of the house: GLM without intrinsics (GLM_FORCE_PURE), so that every build gives the
/// same bits.

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glm/geometric.hpp>

namespace linkdig {

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Mat3f = glm::mat3;
using Mat3d = glm::dmat3;

} // namespace linkdig
