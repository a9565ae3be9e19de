#include "tests/database/compiler/authored.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace linkdig::database {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string head =
    "[database]\nname = \"t\"\n[[sun]]\nname = \"sun\"\n[[moving_object]]\nname = \"ship\"\n"
    "[[cluster]]\nname = \"c\"\npriority = 1\nmoving_object = \"ship\"\n";

std::string list(const std::string& name, int priority) {
    return fmt::format("[[object_list]]\nname = \"{}\"\ncluster = \"c\"\nsun = \"sun\"\npriority = {}\n",
                       name, priority);
}

std::string plane(const std::string& name, const std::string& sides,
                  const std::string& normal = "[0, 2, 0]") {
    return fmt::format("[[cluster_plane]]\ncluster = \"c\"\nname = \"{}\"\nnormal = {}\ndistance_m = 1\n{}\n",
                       name, normal, sides);
}

/// Leaves from the eye: near side, on the plane, far side.
void walk(const VisualDatabase& d, std::int32_t reference, const Vec3d& eye,
          std::vector<std::uint32_t>& leaves) {
    if (reference == none) return;
    if (is_leaf(reference)) return leaves.push_back(leaf_index(reference));
    const PlaneNode& node = d.planes[static_cast<std::size_t>(reference)];
    const bool front = glm::dot(Vec3d(node.normal), eye) > static_cast<double>(node.distance);
    walk(d, front ? node.front : node.back, eye, leaves);
    walk(d, node.on, eye, leaves);
    walk(d, front ? node.back : node.front, eye, leaves);
}

std::vector<std::uint32_t> order(const VisualDatabase& d, std::int32_t root, const Vec3d& eye) {
    std::vector<std::uint32_t> leaves;
    walk(d, root, eye, leaves);
    return leaves;
}

TEST(PriorityPlanes, OrderListsFromTheEye) {
    const CompileResult result =
        compile_text(head + list("port", 0) + list("hull", 0) + list("starboard", 0) + list("a", 0) +
                     list("b", 0) + plane("centre", "front = \"port\"\non = \"hull\"\nback = \"deck\"") +
                     plane("deck", "front = [\"a\", \"starboard\", \"b\"]", "[0, 0, 1]"));
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    EXPECT_THAT(order(d, d.clusters[0].root, {0, 5, 0}), ElementsAre(0, 1, 3, 2, 4));
    EXPECT_THAT(order(d, d.clusters[0].root, {0, -5, 0}), ElementsAre(3, 2, 4, 1, 0));
    EXPECT_THAT(order(d, d.clusters[0].root, {0, -5, -1e6}), ElementsAre(3, 2, 4, 1, 0))
        << "an array is a fixed order";
    EXPECT_FLOAT_EQ(d.planes[static_cast<std::size_t>(d.clusters[0].root)].normal.y, 1.0F);
}

TEST(PriorityPlanes, ArraysOfAnyLengthKeepTheirOrder) {
    std::string lists, names;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < 11; ++i) {
        lists += list(fmt::format("l{}", i), 0);
        names += fmt::format("\"l{}\", ", i);
        expected.push_back(i);
    }
    const CompileResult result = compile_text(head + lists + plane("p", fmt::format("front = [{}]", names)));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_EQ(order(*result.database, result.database->clusters[0].root, {0, 0, -3}), expected);
}

TEST(PriorityPlanes, TiesOfLists) {
    EXPECT_THAT(messages(compile_text(head + list("a", 3) + list("b", 3))),
                HasSubstr("tie: object lists \"a\" and \"b\" of cluster \"c\" have the same priority 3"));
    EXPECT_THAT(messages(compile_text(head + list("a", 3) + list("b", 3) + plane("p", "front = \"a\""))),
                HasSubstr("root.toml:16: tie: object lists \"b\" and \"a\""));
    EXPECT_TRUE(compile_text(head + list("a", 3) + list("b", 4)).database);
}

TEST(PriorityPlanes, MistakesInTrees) {
    const std::string two = head + list("a", 0) + list("b", 0);
    const auto said = [&](const std::string& planes) { return messages(compile_text(two + planes)); };
    EXPECT_THAT(
        said(plane("p", "front = \"a\"\nback = \"bb\"")),
        HasSubstr("names \"bb\", which is no plane or object list of cluster \"c\"; did you mean \"b\"?"));
    EXPECT_THAT(said(plane("p", "front = \"a\"\nback = [\"b\", \"a\"]")),
                HasSubstr("names the object list \"a\" a second time"));
    EXPECT_THAT(said(plane("p", "front = \"a\"\nback = \"p\"")),
                HasSubstr("leads to the plane \"p\" a second time"));
    EXPECT_THAT(said(plane("p", "front = \"a\"\nback = \"b\"") + plane("q", "")),
                HasSubstr("no plane of cluster \"c\" leads to the plane \"q\""));
    EXPECT_THAT(said(plane("p", "front = \"a\"\nback = \"b\"", "[0, 0, 0]")),
                HasSubstr("normal has no length"));
    EXPECT_THAT(said(plane("p", "front = \"a\"\nback = \"b\"\nframe = \"world\"")),
                HasSubstr("expected \"body\" or \"waterline\""));
    EXPECT_THAT(said(plane("p", "front = 3")), HasSubstr("\"front\" is a whole number; expected a text"));
}

const std::string piers = "[database]\nname = \"t\"\n[[cluster]]\nname = \"east\"\npriority = "
                          "7\n[[cluster]]\nname = \"sea\"\npriority = 9\n"
                          "[[cluster]]\nname = \"west\"\npriority = 7\n";

TEST(PriorityPlanes, GroupsAscendAndOrderStaticClusters) {
    const CompileResult result = compile_text(
        piers + "[[group_plane]]\npriority = 7\nname = \"p\"\nnormal = [1, 0, 0]\ndistance_m = 0\n"
                "front = \"east\"\nback = \"west\"\n");
    ASSERT_TRUE(result.database) << messages(result);
    const VisualDatabase& d = *result.database;
    ASSERT_EQ(d.groups.size(), 2U);
    EXPECT_EQ(d.groups[0].number, 7);
    EXPECT_EQ(d.groups[1].number, 9);
    EXPECT_THAT(order(d, d.groups[0].root, {1, 0, 0}), ElementsAre(0, 2));
    EXPECT_THAT(order(d, d.groups[0].root, {-1, 0, 0}), ElementsAre(2, 0));
    EXPECT_THAT(order(d, d.groups[1].root, {0, 0, 0}), ElementsAre(1)) << "a cluster alone needs no plane";
}

TEST(PriorityPlanes, TiesOfStaticClusters) {
    EXPECT_THAT(
        messages(compile_text(piers)),
        HasSubstr("root.toml:3: tie: no plane orders the static cluster \"east\" among the 2 of priority 7"));
    EXPECT_THAT(
        messages(compile_text(
            piers + "[[group_plane]]\npriority = 8\nname = \"p\"\nnormal = [1, 0, 0]\ndistance_m = 0\n")),
        HasSubstr("no cluster has the priority 8"));
}

} // namespace
} // namespace linkdig::database
