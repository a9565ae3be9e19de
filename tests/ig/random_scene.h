#pragma once
/// Seeded scenes of projected faces, made to be hard: slivers, points, faces without area, beyond the
/// picture, as large as the guard band, corners exactly on pixel centres, meshes that share edges.

#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"
#include "tests/support/picture.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace linkdig::ig {

/// The largest coordinate that the format allows (ig/geometry/projected_face.h), 1/256 pixel.
inline constexpr std::int32_t greatest_coordinate = (guard_pixels - 1) * subpixels;

struct Scene {
    ProjectedFaces projected;
    Raster raster;
    std::vector<Colour> colours;
    Colour background{40, 60, 90};
    std::uint32_t packed_background() const {
        return support::packed(background.red, background.green, background.blue);
    }
};

/// Numbers from one seed, in the order of asking.
class RandomStream {
public:
    explicit RandomStream(std::uint64_t seed) : seed_(seed) {}
    double unit();                                                   ///< [0, 1)
    double between(double least, double greatest);                   ///< [least, greatest)
    std::int32_t integer(std::int32_t least, std::int32_t greatest); ///< both included
    bool one_in(std::int32_t n) { return integer(1, n) == 1; }

private:
    std::uint64_t seed_;
    std::uint64_t index_ = 0;
};

/// Twice the signed area in (element, line) coordinates, exact.
std::int64_t doubled_area(std::span<const RasterPoint> points);

/// An empty scene with 16 random colours.
Scene empty_scene(RandomStream& random, const Raster& raster);

/// Appends a face, turned so that its signed area is not negative. An empty `intensities` makes it flat, of
/// random intensity; three make it smooth, of the triangle that its points are.
void add_face(Scene& scene, RandomStream& random, std::vector<RasterPoint> points,
              std::span<const std::int32_t> intensities = {});

/// Three intensities, now and then the extremes.
std::array<std::int32_t, 3> random_intensities(RandomStream& random);

/// Puts the faces in random rank order.
void shuffle_ranks(Scene& scene, RandomStream& random);

/// Faces of all kinds in random rank order. `faces` is their number.
Scene random_scene(std::uint64_t seed, const Raster& raster, std::uint32_t faces);

/// Long edges that miss a pixel centre by the least that the format allows, down to 2^-32 pixel, or hit it:
/// `faces` triangles on a raster of at least 64 elements.
Scene near_miss_scene(std::uint64_t seed, const Raster& raster, std::uint32_t faces);

/// Where a mesh's squares lie: columns x rows of them from `origin`, each `side` wide and high (1/256 pixel).
struct MeshGrid {
    RasterPoint origin;
    std::int32_t side = 2560;
    std::int32_t columns = 8; ///< along the elements
    std::int32_t rows = 8;    ///< along the lines
};

/// A triangulation of the grid: inner corners moved by less than a quarter of the side, some of them onto
/// pixel centres, every square cut along a random diagonal, ranks shuffled, smooth shading. It covers the
/// grid's rectangle exactly.
Scene mesh_scene(std::uint64_t seed, const Raster& raster, const MeshGrid& grid);

/// The grid's squares themselves, flat: rectangular tiling.
Scene tiling_scene(std::uint64_t seed, const Raster& raster, const MeshGrid& grid);

/// Thin triangles around a hub that lies exactly on a pixel centre, out to a rectangle of the given half
/// width in pixels.
Scene fan_scene(std::uint64_t seed, const Raster& raster, RasterPoint hub, std::int32_t half_width);

} // namespace linkdig::ig
