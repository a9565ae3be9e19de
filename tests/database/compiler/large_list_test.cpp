/// Lists too large for "can hide" to look at all pairs: cells of an even tree, each with an order of its own.

#include "tests/database/compiler/solids.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::database {
namespace {

/// Hills over a square of side x side cells of 10 m, two faces to a cell: a loft with its front upward.
std::string hills(std::uint32_t side) {
    std::string text =
        "[[object]]\nname = \"hills\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.loft]]\nflip = true\n"
        "sections_m = [\n";
    for (std::uint32_t i = 0; i <= side; ++i) {
        text += "[";
        for (std::uint32_t j = 0; j <= side;
             ++j) { // parabolas and a hash: ridges, hollows, no two cells alike
            const std::uint32_t hash = (i * 73856093U ^ j * 19349663U) * 2654435761U;
            const double u = static_cast<double>(i % 24) - 12, v = static_cast<double>(j % 30) - 15;
            text += fmt::format("[{}, {}, {:.2f}],", i * 10, j * 10,
                                60.0 - 0.3 * u * u + 0.2 * v * v + 6.0 * (hash >> 16U) / 65536.0);
        }
        text += "],\n";
    }
    return text + "]\n";
}

struct TreeShape {
    std::uint32_t depth = 0;
    std::uint32_t largest_leaf = 0; ///< faces
};

void measure(const VisualDatabase& d, std::int32_t reference, std::uint32_t depth, TreeShape& shape) {
    shape.depth = std::max(shape.depth, depth);
    if (reference == none) return;
    if (is_leaf(reference)) {
        const RunLeaf& leaf = d.run_leaves[leaf_index(reference)];
        std::uint32_t faces = 0;
        for (std::uint32_t r = 0; r < leaf.run_count; ++r)
            faces += d.runs[leaf.first_run + r].face_count;
        shape.largest_leaf = std::max(shape.largest_leaf, faces);
        return;
    }
    const PlaneNode& node = d.planes[static_cast<std::size_t>(reference)];
    for (const std::int32_t child : {node.front, node.on, node.back})
        measure(d, child, depth + 1, shape);
}

/// The first face in the order that a ray meets, against the nearest of all faces.
void expect_order_of_rays(const VisualDatabase& d, Random& random, int eyes, const Vec3d& low,
                          const Vec3d& high) {
    int wrong = 0, hits = 0;
    for (int e = 0; e < eyes; ++e) {
        const Vec3d eye = random.point({low.x, low.y, high.z}, {high.x, high.y, high.z + 200});
        std::vector<std::uint32_t> order;
        walk(d, d.lists[0].root, eye, order);
        ASSERT_EQ(order.size(), d.faces.size());
        for (int r = 0; r < 10; ++r) {
            const Ray ray{eye, glm::normalize(random.point(low, high) - eye)};
            const Met met = met_in_order(d, order, ray);
            if (!met.clearly()) continue;
            ++hits;
            wrong += met.first - met.nearest > 1e-2 ? 1 : 0;
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << hits;
    EXPECT_GT(hits, eyes * 2); // solids fill about a quarter of the view
}

TEST(LargeList, AHeightFieldIsDividedEvenlyAndNotCut) {
    const CompileResult result = compile_text(scene(hills(90)));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_GT(d.faces.size(), 16000U);
    EXPECT_LT(result.statistics.total().splits, d.faces.size() / 200); // only where a cell has a cycle in it
    TreeShape shape;
    measure(d, d.lists[0].root, 0, shape);
    EXPECT_LE(shape.largest_leaf, 48U);
    EXPECT_LT(shape.depth, 40U);
}

TEST(LargeList, TheOrderIsThatOfRays) {
    const CompileResult result = compile_text(scene(hills(60)));
    ASSERT_TRUE(result.database) << messages(result);
    Random random(3);
    expect_order_of_rays(*result.database, random, 60, {0, 0, 0}, {600, 600, 110});
}

/// No grid: solids in all directions, so that planes must cut faces.
TEST(LargeList, SolidsInAllDirectionsAreOrderedToo) {
    Random random(8);
    std::string text;
    for (int i = 0; i < 700; ++i) {
        const Vec3d at = random.point({-300, -300, -300}, {300, 300, 300});
        text +=
            fmt::format("[[object]]\nname = \"p{}\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.prism]]\n"
                        "base_m = [[{:.2f}, {:.2f}], [{:.2f}, {:.2f}], [{:.2f}, {:.2f}], [{:.2f}, {:.2f}]]\n"
                        "bottom_m = {:.2f}\ntop_m = {:.2f}\n",
                        i, at.x - 7, at.y - 1, at.x + 1, at.y - 9, at.x + 6, at.y + 2, at.x - 2, at.y + 8,
                        at.z, at.z + 9);
    }
    const CompileResult result = compile_text(scene(text));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_GT(result.database->faces.size(), 4000U);
    expect_order_of_rays(*result.database, random, 60, {-300, -300, -300}, {300, 300, 300});
}

} // namespace
} // namespace linkdig::database
