#pragma once
/// Planes that explain a picture: where the machine keeps numbers instead of colours, pixel by pixel.

#include "ig/machine/machine.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace linkdig::tools {

/// No face is seen there: only the background.
inline constexpr std::uint32_t no_face = 0xFFFFFFFFU;
/// The face plane's value where a face is seen that the machine made this frame (copies of a repeated tile):
/// it has no place in VisualDatabase::faces.
inline constexpr std::uint32_t made_face = 0xFFFFFFFEU;

/// The planes of a comma-separated list of colour, intensity, rank, list, object, face, edges, flat.
/// Throws std::invalid_argument, naming the unknown word and the known ones.
std::vector<ig::Plane> parse_planes(const std::string& names);
const char* plane_name(ig::Plane plane);

/// Intensities as numbers 0 to 1 (exact: 23 bits); 0 where only the background is seen.
std::vector<float> intensities(std::span<const std::int32_t> plane);

/// The plane's number for every pixel: rank itself; list, object and face as indices into the database's
/// vectors.
std::vector<std::uint32_t> numbers(ig::Plane plane, const VisualDatabase& database,
                                   const ig::Machine& machine, std::size_t channel);

/// The picture with the borders between the faces that are seen, white where it is dark and black where it is bright.
/// Needs the rank plane, as the next does.
std::vector<std::uint32_t> edges_over(const ig::VideoFrame& picture);

/// Every face in one colour: its colour code x the intensity of its own normal, whatever its shading; without air and
/// without smoothed edges. What is centred on the eye, a sky, keeps its picture: its normals mean nothing.
std::vector<std::uint32_t> flat_colours(const VisualDatabase& database, const ig::Machine& machine,
                                        std::size_t channel);

/// Writes a plane of a channel of the machine's last frame: FOLDER/colour_000010.png, FOLDER/rank_000010.exr
/// ... Throws std::runtime_error, naming the file, if it cannot.
void write_plane(ig::Plane plane, const VisualDatabase& database, const ig::Machine& machine,
                 std::size_t channel, const std::string& folder, std::uint64_t frame);

} // namespace linkdig::tools
