#pragma once
/// The random sea: a table of normals at a fixed vertical angle (report, Appendix I, "a table of normals").

#include "database/model/vectors.h"

#include <cstdint>
#include <vector>

namespace linkdig::database {

/// Azimuths of the table of normals: N of Appendix I.
inline constexpr std::uint32_t normal_azimuths = 256;

/// One of two independent sequences of random azimuths for a seed.
enum class NormalStream : std::uint8_t { vertices, faces };

/// Normal I of the table: (cos phi cos a, sin phi cos a, sin a) with phi = 2 pi I / 256, a the vertical angle
/// in radians, 0 to pi/2.
Vec3f table_normal(std::uint32_t azimuth_index, double vertical_angle_rad);

/// `count` normals of random azimuth: a pure function of seed, stream and index.
std::vector<Vec3f> random_normals(std::uint64_t seed, NormalStream stream, std::size_t count,
                                  double vertical_angle_rad);

} // namespace linkdig::database
