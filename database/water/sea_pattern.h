#pragma once
/// Patterns of normals that make a flat sea look like water (report, 3.1.3, 3.1.4 and Appendix I).
///
/// A pattern is a square table of period x period normals, row by row (y outer), that repeats. Vertex (i, j) stands
/// at x = i cell, y = j cell; square (i, j) at (i + 1/2, j + 1/2). Moving patterns have normals of one elevation a, the
/// *vertical angle*, and differ in azimuth phi: under a sun of elevation e and azimuth w the intensity follows
/// sin a sin e + cos a cos e cos(phi - w), so a turning sun lets every normal rise and fall in a phase of its own.

#include "database/model/vectors.h"

#include <cstdint>
#include <vector>

namespace linkdig::database {

/// Azimuths of the random sea's table of normals: N of Appendix I.
inline constexpr std::uint32_t normal_azimuths = 256;

/// Whose normals: they differ in place by half a square, and in the random pattern are independent sequences.
enum class NormalStream : std::uint8_t { vertices, faces };

/// Normal I of a table of N: (cos phi cos a, sin phi cos a, sin a) with phi = 2 pi I / N, a the vertical angle
/// in radians, 0 to pi/2 (report, Appendix I; `rb`, `rj` and `0` of its print are this one phi).
Vec3f table_normal(std::uint32_t azimuth_index, double vertical_angle_rad,
                   std::uint32_t azimuths = normal_azimuths);

/// `count` normals of random azimuth: a pure function of seed, stream and index. A confused sea.
std::vector<Vec3f> random_normals(std::uint64_t seed, NormalStream stream, std::size_t count,
                                  double vertical_angle_rad);

/// A sine wave that travels along x (report, 3.1.4, patterns 2 and 3): phi = 2 pi x / L, so that the azimuth itself
/// advances; a sine height put through the table would move both ways on its two flanks. `waves` = period / L, whole.
/// Mirrored: phi on odd rows, -phi on even ones. Squares are taken at their middle and count to the row of their
/// southern side.
std::vector<Vec3f> sine_normals(std::uint32_t period, std::uint32_t waves, bool mirrored, NormalStream stream,
                                double vertical_angle_rad);

/// A wave by how often it repeats over the pattern along x and along y: then the tile has no seam.
struct WholeWaves {
    std::int32_t along_x = 0;
    std::int32_t along_y = 0;
};

/// The whole waves nearest to a wave of `waves` = pattern's side / wavelength that runs at `angle_rad` to the x axis.
WholeWaves nearest_whole_waves(double waves, double angle_rad);

/// Appendix I's two waves: Z = Z1 + Z2, sines of unit height, index I = floor((Z + 2) / 4 N), at most N - 1, into a
/// table of N normals (N >= 1).
std::vector<Vec3f> two_wave_normals(std::uint32_t period, WholeWaves first, WholeWaves second,
                                    std::uint32_t table_size, NormalStream stream, double vertical_angle_rad);

/// A static pattern of many intensity levels (report, 3.1.3). `levels`: side x side numbers, 0 to 1, that repeat over
/// the pattern (side divides period). A square's normal stands upright and has the level as its length, so that it
/// shows level x sin e wherever the sun is in azimuth; a vertex has the mean of the four squares around it.
std::vector<Vec3f> level_normals(std::uint32_t period, const std::vector<float>& levels, NormalStream stream);

/// The pattern, followed by its coarser tables of half, a quarter ... the side, down to one normal, the mean. Vertices:
/// each coarser normal is the mean of the nine around it with weights 1 2 1, which lets a wave fade before there
/// are too few vertices to carry it; squares: the mean of the four that it is made of. Period: a power of two.
std::vector<Vec3f> with_coarser_tables(std::vector<Vec3f> pattern, std::uint32_t period, NormalStream stream);

} // namespace linkdig::database
