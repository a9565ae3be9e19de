#include "tests/ig/random_scene.h"

#include <algorithm>
#include <array>

namespace linkdig::ig {

namespace {

/// The grid's corners, row by row; inner ones moved.
std::vector<RasterPoint> mesh_corners(RandomStream& random, const MeshGrid& grid) {
    std::vector<RasterPoint> corners;
    // Under a quarter of the side every triangle keeps a positive area; moving onto a pixel centre adds half
    // a pixel.
    const bool onto_centres = grid.side > 2048;
    const std::int32_t reach = (grid.side - 1) / 4 - (onto_centres ? 128 : 0);
    for (std::int32_t row = 0; row <= grid.rows; ++row) {
        for (std::int32_t column = 0; column <= grid.columns; ++column) {
            RasterPoint corner{grid.origin.line + row * grid.side, grid.origin.element + column * grid.side};
            const bool inner = row > 0 && row < grid.rows && column > 0 && column < grid.columns;
            if (inner)
                corner = {corner.line + random.integer(-reach, reach),
                          corner.element + random.integer(-reach, reach)};
            if (inner && onto_centres && random.one_in(4))
                corner = {(corner.line & ~255) | 128, (corner.element & ~255) | 128};
            corners.push_back(corner);
        }
    }
    return corners;
}

} // namespace

Scene mesh_scene(std::uint64_t seed, const Raster& raster, const MeshGrid& grid) {
    RandomStream random(seed);
    Scene scene = empty_scene(random, raster);
    const std::vector<RasterPoint> corners = mesh_corners(random, grid);
    for (std::int32_t row = 0; row < grid.rows; ++row) {
        for (std::int32_t column = 0; column < grid.columns; ++column) {
            const auto corner = [&](std::int32_t down, std::int32_t along) {
                return corners[static_cast<std::size_t>((row + down) * (grid.columns + 1) + column + along)];
            };
            const std::array<RasterPoint, 4> square{corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)};
            const std::size_t start = random.one_in(2) ? 0 : 1; // which diagonal
            for (const std::size_t half : {std::size_t{1}, std::size_t{2}})
                add_face(scene, random,
                         {square[start], square[(start + half) % 4], square[(start + half + 1) % 4]},
                         random_intensities(random));
        }
    }
    shuffle_ranks(scene, random);
    return scene;
}

Scene tiling_scene(std::uint64_t seed, const Raster& raster, const MeshGrid& grid) {
    RandomStream random(seed);
    Scene scene = empty_scene(random, raster);
    for (std::int32_t row = 0; row < grid.rows; ++row) {
        for (std::int32_t column = 0; column < grid.columns; ++column) {
            const std::int32_t l = grid.origin.line + row * grid.side;
            const std::int32_t e = grid.origin.element + column * grid.side;
            add_face(scene, random,
                     {{l, e}, {l, e + grid.side}, {l + grid.side, e + grid.side}, {l + grid.side, e}});
        }
    }
    shuffle_ranks(scene, random);
    return scene;
}

Scene fan_scene(std::uint64_t seed, const Raster& raster, RasterPoint hub, std::int32_t half_width) {
    RandomStream random(seed);
    Scene scene = empty_scene(random, raster);
    const std::int32_t reach = 256 * half_width;
    std::vector<RasterPoint> rim;
    const std::array<RasterPoint, 4> corners{
        {{-reach, -reach}, {-reach, reach}, {reach, reach}, {reach, -reach}}};
    for (std::size_t side = 0; side < 4; ++side) {
        const RasterPoint from = corners[side];
        const RasterPoint to = corners[(side + 1) % 4];
        std::vector<std::int32_t> along{0};
        for (int i = 0; i < 12; ++i)
            along.push_back(random.integer(0, 2 * reach - 1));
        std::sort(along.begin(), along.end());
        for (const std::int32_t a : along) // from and to differ by 2 reach along one axis
            rim.push_back({from.line + (to.line > from.line   ? a
                                        : to.line < from.line ? -a
                                                              : 0),
                           from.element + (to.element > from.element   ? a
                                           : to.element < from.element ? -a
                                                                       : 0)});
    }
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const RasterPoint& a = rim[i];
        const RasterPoint& b = rim[(i + 1) % rim.size()];
        add_face(
            scene, random,
            {hub, {hub.line + a.line, hub.element + a.element}, {hub.line + b.line, hub.element + b.element}},
            random_intensities(random));
    }
    shuffle_ranks(scene, random);
    return scene;
}

} // namespace linkdig::ig
