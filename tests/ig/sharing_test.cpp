/// Faces that share edges leave no gap and fill nothing twice.

#include "tests/ig/random_scene.h"
#include "tests/ig/random_scene_stages.h"
#include "tests/support/painter.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace linkdig::ig {
namespace {

/// A scene in which one face is left, the others gone.
Scene only(const Scene& scene, std::size_t face) {
    Scene single = scene;
    single.projected.faces = {scene.projected.faces[face]};
    return single;
}

/// How many faces the machine gives each pixel to, when each is drawn alone.
std::vector<std::uint32_t> drawn_coverage(const Scene& scene) {
    std::vector<std::uint32_t> count(std::size_t{scene.raster.width} * scene.raster.height, 0);
    for (std::size_t face = 0; face < scene.projected.faces.size(); ++face) {
        const Drawn drawn = draw(only(scene, face));
        for (std::size_t at = 0; at < count.size(); ++at)
            count[at] += drawn.picture.rank[at] == 0 ? 1 : 0;
    }
    return count;
}

/// 1 for each pixel whose centre the rectangle from `low` to below `high` holds, else 0.
std::vector<std::uint32_t> rectangle_coverage(const Raster& raster, RasterPoint low, RasterPoint high) {
    std::vector<std::uint32_t> count(std::size_t{raster.width} * raster.height, 0);
    for (std::uint32_t line = 0; line < raster.lines(); ++line)
        for (std::uint32_t element = 0; element < raster.elements(); ++element) {
            const std::int64_t l = support::centre_of(line);
            const std::int64_t e = support::centre_of(element);
            const bool inside = low.line <= l && l < high.line && low.element <= e && e < high.element;
            count[support::place(raster, line, element)] = inside ? 1 : 0;
        }
    return count;
}

std::vector<std::uint32_t> grid_coverage(const Raster& raster, const MeshGrid& grid) {
    return rectangle_coverage(
        raster, grid.origin,
        {grid.origin.line + grid.rows * grid.side, grid.origin.element + grid.columns * grid.side});
}

/// The owner of each pixel, whatever its rank: where the face's points begin, or `none`.
std::vector<std::int64_t> owners(const Scene& scene) {
    const Drawn drawn = draw(scene);
    std::vector<std::int64_t> owner;
    for (const std::int32_t rank : drawn.picture.rank)
        owner.push_back(
            rank == none ? std::int64_t{none}
                         : std::int64_t{scene.projected.faces[static_cast<std::size_t>(rank)].first_point});
    return owner;
}

const MeshGrid grids[] = {
    {{640, 640}, 2560, 5, 4},               // inside the raster, on half pixels
    {{-3333, -1234}, 2000, 12, 12},         // beyond it
    {{384, 128}, 256, 24, 20},              // squares of one pixel, corners near centres
    {{1000, 1000}, 37, 60, 50},             // squares of a seventh of a pixel
    {{129, 77}, 1, 300, 40},                // squares of one 1/256 pixel
    {{-8000000, -8000000}, 16000000, 1, 1}, // one square, nearly the guard band
};

TEST(Sharing, a_mesh_covers_each_pixel_once) {
    for (const Scan scan : {Scan::horizontal, Scan::vertical})
        for (const MeshGrid& grid : grids) {
            const Raster raster{70, 60, scan};
            // Tiny squares are drawn together only: there are too many of them to draw each alone.
            const bool alone = grid.rows * grid.columns <= 600;
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                SCOPED_TRACE("seed " + std::to_string(seed) + " side " + std::to_string(grid.side));
                const Scene scene = mesh_scene(seed, raster, grid);
                const std::vector<std::uint32_t> expected = grid_coverage(raster, grid);
                EXPECT_EQ(support::coverage(scene.projected, raster), expected);
                if (alone) {
                    EXPECT_EQ(drawn_coverage(scene), expected);
                }
                std::vector<std::uint32_t> owned;
                for (const std::int64_t owner : owners(scene))
                    owned.push_back(owner == none ? 0 : 1);
                EXPECT_EQ(owned, expected);
            }
        }
}

TEST(Sharing, the_order_of_a_mesh_does_not_matter) {
    for (const MeshGrid& grid : grids) {
        Scene scene = mesh_scene(7, {70, 60, Scan::horizontal}, grid);
        const std::vector<std::int64_t> once = owners(scene);
        std::reverse(scene.projected.faces.begin(), scene.projected.faces.end());
        EXPECT_EQ(once, owners(scene)) << "side " << grid.side;
    }
}

TEST(Sharing, rectangles_tile_the_raster) {
    for (const Scan scan : {Scan::horizontal, Scan::vertical})
        for (const std::int32_t side : {128, 256, 384, 1000, 4096}) {
            const Raster raster{48, 33, scan};
            const auto count = [side](std::uint32_t size) {
                return static_cast<std::int32_t>(size) * 256 / side + 2;
            };
            // From a half pixel before the raster: many borders run exactly through centres.
            const MeshGrid grid{{-128, -128}, side, count(raster.elements()), count(raster.lines())};
            const Scene scene = tiling_scene(3, raster, grid);
            const Drawn drawn = draw(scene);
            EXPECT_EQ(std::count(drawn.picture.rank.begin(), drawn.picture.rank.end(), none), 0)
                << "side " << side;
            if (grid.columns * grid.rows < 3000) {
                EXPECT_EQ(drawn_coverage(scene), std::vector<std::uint32_t>(48 * 33, 1)) << "side " << side;
            }
        }
}

TEST(Sharing, a_fan_about_a_pixel_centre_covers_each_pixel_once) {
    for (const Scan scan : {Scan::horizontal, Scan::vertical})
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const Raster raster{66, 66, scan};
            const RasterPoint hub{128 + 256 * 30, 128 + 256 * 33};
            const std::int32_t half_width = seed % 3 == 0 ? 20000 : seed % 3 == 1 ? 20 : 200;
            const Scene scene = fan_scene(seed, raster, hub, half_width);
            const std::int32_t reach = 256 * half_width;
            const std::vector<std::uint32_t> expected = rectangle_coverage(
                raster, {hub.line - reach, hub.element - reach}, {hub.line + reach, hub.element + reach});
            EXPECT_EQ(drawn_coverage(scene), expected) << "seed " << seed;
            EXPECT_EQ(support::coverage(scene.projected, raster), expected) << "seed " << seed;
        }
}

} // namespace
} // namespace linkdig::ig
