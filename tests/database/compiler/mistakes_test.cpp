/// Forty and more mistakes, each by its message: file, line, column, what is wrong and what was expected. Nothing is written.

#include "tests/database/compiler/authored.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <ostream>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

struct Mistake {
    const char* name;
    std::string objects; ///< after scene()'s lines
    std::string told;    ///< in the text of the diagnostics, without the folder
};
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

const std::string object = "[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n";
const std::string disc = "[[object.disc]]\ncentre_m = [0, 0, 0]\nradius_m = 1\n";

std::string in_order(int count, const std::string& before, const std::string& after) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += before + std::to_string(i) + after;
    return text;
}

std::vector<Mistake> mistakes() {
    return {
        {"UnknownKey", object + "colr = 1\n" + disc,
         "root.toml:19:1: error: unknown key \"colr\" in [[object]] \"o\"; expected one of: "},
        {"UnknownTable",
         "[[objekt]]\n"
         "name = \"o\"\n",
         "root.toml:15:3: error: unknown key \"objekt\" in the file; did you mean \"object\"?"},
        {"UnitThatIsNone",
         object + "[[object.disc]]\n"
                  "centre_m = [0, 0, 0]\n"
                  "radius_km = 1\n",
         "root.toml:21:1: error: unknown key \"radius_km\" in [[object.disc]] of [[object]] \"o\"; did you "
         "mean \"radius_m\"?"},
        {"TwoUnitsForOneLength",
         object + "[[object.disc]]\n"
                  "centre_m = [0, 0, 0]\n"
                  "radius_m = 1\n"
                  "radius_ft = 3\n",
         "root.toml:22:13: error: both \"radius_m\" and \"radius_ft\" stand in [[object.disc]] of [[object]] "
         "\"o\"; expected one of them"},
        {"AnglesInRadians",
         "[[tile]]\n"
         "list = \"list\"\n"
         "period = 16\n"
         "cell_m = 8\n"
         "rings = 4\n"
         "fine_levels = 1\n"
         "half_width = 8\n"
         "colour = \"grey\"\n"
         "vertical_angle_rad = 1\n"
         "seed = 1\n",
         "root.toml:23:1: error: unknown key \"vertical_angle_rad\" in [[tile]]; did you mean "
         "\"vertical_angle_deg\"?"},
        {"LengthInQuotes",
         object + "[[object.disc]]\n"
                  "centre_m = [0, 0, 0]\n"
                  "radius_m = \"1\"\n",
         "root.toml:21:12: error: \"radius_m\" is a text; expected a finite number"},
        {"DuplicateColour",
         "[[colour]]\n"
         "name = \"grey\"\n"
         "rgb = [1, 2, 3]\n",
         "root.toml:15:1: error: the colour \"grey\" stands already in root.toml:3; expected another name"},
        {"DuplicateList",
         "[[object_list]]\n"
         "name = \"list\"\n"
         "cluster = \"cluster\"\n"
         "sun = \"sun\"\n"
         "priority = 2\n",
         "root.toml:15:1: error: the object list \"list\" stands already in root.toml:11; expected another "
         "name"},
        {"UnknownColour",
         std::string("[[object]]\n"
                     "name = \"o\"\n"
                     "list = \"list\"\n"
                     "colour = \"gray\"\n") +
             disc,
         "root.toml:18:10: error: no colour is named \"gray\"; did you mean \"grey\"?"},
        {"UnknownList",
         std::string("[[object]]\n"
                     "name = \"o\"\n"
                     "list = \"lists\"\n"
                     "colour = \"grey\"\n") +
             disc,
         "root.toml:17:8: error: no object list is named \"lists\"; did you mean \"list\"?"},
        {"UnknownSun",
         "[[object_list]]\n"
         "name = \"other\"\n"
         "cluster = \"cluster\"\n"
         "sun = \"moon\"\n"
         "priority = 2\n",
         "root.toml:18:7: error: no sun is named \"moon\"; expected a [[sun]] of that name"},
        {"ColourOutOfRange",
         "[[colour]]\n"
         "name = \"red\"\n"
         "rgb = [256, 0, 0]\n",
         "root.toml:17:7: error: \"rgb\" holds 256; expected whole numbers 0 to 255"},
        {"NonPlanar",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [4, 4, 1], d = [0, 4, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\", \"c\", \"d\"]\n",
         "root.toml:20:1: error: a face of object \"o\" is not planar: corner \"a\" lies 0.2462 m off its "
         "plane; expected at most 0.001 m"},
        {"SelfIntersecting",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [4, 4, 0], d = [0, 4, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"c\", \"b\", \"d\"]\n",
         "root.toml:20:1: error: a face of object \"o\" intersects itself; expected corners in their order "
         "around the face"},
        {"Concave",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [1, 1, 0], d = [0, 4, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\", \"c\", \"d\"]\n",
         "root.toml:20:1: error: a face of object \"o\" is concave at corner \"c\"; expected convex faces, "
         "counter-clockwise seen from the front"},
        {"Degenerate",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [8, 0, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\", \"c\"]\n",
         "root.toml:20:1: error: a face of object \"o\" has no area; expected three corners that span one"},
        {"ReversedNormal",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [4, 4, 0], d = [0, 4, 0]}\n"
                  "normals = { a = [0, 0, 1], b = [0, 0, 1], c = [0, 0, 1], d = [0, 0, 1] }\n"
                  "shading = \"vertex\"\n"
                  "[[object.face]]\n"
                  "corners = [\"d\", \"c\", \"b\", \"a\"]\n",
         "root.toml:22:1: error: a face of object \"o\" is reversed: the normals of its corners point behind "
         "it; expected corners counter-clockwise seen from the front"},
        {"InsideOutSolid",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [0, 4, 0], d = [0, 0, 4]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\", \"c\"]\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"d\", \"b\"]\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"c\", \"d\"]\n"
                  "[[object.face]]\n"
                  "corners = [\"b\", \"d\", \"c\"]\n",
         "root.toml:15:1: error: the solid of 4 faces in object \"o\" is inside out; expected corners "
         "counter-clockwise seen from outside"},
        {"TooFewCorners",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [4, 4, 0], d = [0, 4, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\"]\n",
         "root.toml:21:11: error: the face has 2 corners; expected 3 to 65535"},
        {"CornerTwice",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [4, 4, 0], d = [0, 4, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\", \"b\"]\n",
         "root.toml:21:11: error: the corner \"b\" stands twice; expected distinct corners"},
        {"UnknownVertex",
         object + "vertices_m = {a = [0, 0, 0], b = [4, 0, 0], c = [4, 4, 0], d = [0, 4, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\", \"x\"]\n",
         "root.toml:21:11: error: [[object]] \"o\" has no vertex \"x\"; did you mean \"a\"?"},
        {"NotANumber",
         object + "vertices_m = {a = [0, 0, nan], b = [4, 0, 0], c = [4, 4, 0]}\n"
                  "[[object.face]]\n"
                  "corners = [\"a\", \"b\", \"c\"]\n",
         "root.toml:19:19: error: \"a\" is an array; expected [x, y, z], three finite numbers"},
        {"Infinite",
         object + "[[object.disc]]\n"
                  "centre_m = [0, 0, 0]\n"
                  "radius_m = inf\n",
         "root.toml:21:12: error: \"radius_m\" is infinite; expected a finite number"},
        {"NoLayer",
         object + "[[object.disc]]\n"
                  "centre_m = [0, 0, 0]\n"
                  "radius_m = 4\n"
                  "[[object.ring]]\n"
                  "centre_m = [0, 0, 0]\n"
                  "radius_m = 2\n"
                  "width_m = 0.5\n",
         "root.toml:22:1: error: coplanar faces overlap with the same layer: this one of object \"o\" and "
         "that of object \"o\" in root.toml:19; expected different layers"},
        {"PriorityTieOfLists",
         "[[object_list]]\n"
         "name = \"other\"\n"
         "cluster = \"cluster\"\n"
         "sun = \"sun\"\n"
         "[[object]]\n"
         "name = \"o\"\n"
         "list = \"list\"\n"
         "colour = \"grey\"\n"
         "[[object.disc]]\n"
         "centre_m = [0, 0, 0]\n"
         "radius_m = 4\n",
         "root.toml:11:1: error: tie: object lists \"list\" and \"other\" of cluster \"cluster\" have the "
         "same priority 0; expected different ones or a [[cluster_plane]] that names both"},
        {"PriorityTieOfClusters",
         "[[cluster]]\n"
         "name = \"second\"\n"
         "priority = 1\n",
         "root.toml:8:1: error: tie: no plane orders the static cluster \"cluster\" among the 2 of priority "
         "1; expected another priority or a [[group_plane]] that names it"},
        {"WakeWithTwentyNineKeys",
         "[[slot]]\n"
         "name = \"wake\"\n"
         "alternatives = 28\n"
         "[[sequence]]\n"
         "name = \"w\"\n"
         "list = \"list\"\n"
         "colour = \"grey\"\n"
         "slot = \"wake\"\n"
         "[[sequence.key]]\n"
         "frame = 1\n"
         "corners_m = [[0, 0, 0], [1, 0, 0], [1, 0, 1]]\n"
         "[[sequence.key]]\n"
         "frame = 29\n"
         "corners_m = [[0, 0, 0], [2, 0, 0], [2, 0, 1]]\n",
         "root.toml:27:9: error: \"frame\" is 29; expected 1 to 28"},
        {"WakeWithTwentyNineFaces",
         "[[slot]]\nname = \"wake\"\nalternatives = 28\n" +
             in_order(29, object + "slot = \"wake\"\nalternative = ", "\n" + disc),
         "error: object \"o\" is alternative 28 of slot \"wake\", which has 28; expected 0 to 27"},
        {"SlotNotCovered",
         std::string("[[slot]]\n"
                     "name = \"wake\"\n"
                     "alternatives = 28\n"
                     "[[object]]\n"
                     "name = \"o\"\n"
                     "list = \"list\"\n"
                     "colour = \"grey\"\n"
                     "slot = \"wake\"\n"
                     "alternative = 0\n") +
             disc,
         "root.toml:15:1: error: slot \"wake\" has 28 alternatives, but its objects cover 1 of them; "
         "expected also alternative 1"},
        {"AlternativeOutOfRange",
         std::string("[[slot]]\n"
                     "name = \"s\"\n"
                     "alternatives = 1\n"
                     "[[object]]\n"
                     "name = \"o\"\n"
                     "list = \"list\"\n"
                     "colour = \"grey\"\n"
                     "slot = \"s\"\n"
                     "alternative = 1\n") +
             disc,
         "root.toml:18:1: error: object \"o\" is alternative 1 of slot \"s\", which has 1; expected 0 to 0"},
        {"UnreachableLevel",
         "[[detail]]\n"
         "name = \"d\"\n"
         "cluster = \"cluster\"\n"
         "reference_m = [0, 0, 0]\n"
         "to_m = [400, 300]\n",
         "root.toml:19:8: error: level 1 reaches to 300 m and the one before to 400 m: it is never seen; "
         "expected ascending ranges"},
        {"LevelWithoutObjects",
         std::string("[[detail]]\n"
                     "name = \"d\"\n"
                     "cluster = \"cluster\"\n"
                     "reference_m = [0, 0, 0]\n"
                     "to_m = [400, 900]\n"
                     "[[object]]\n"
                     "name = \"o\"\n"
                     "list = \"list\"\n"
                     "colour = \"grey\"\n"
                     "detail = \"d\"\n"
                     "level = 0\n") +
             disc,
         "root.toml:15:1: error: no object is level 1 of detail \"d\"; expected at least one"},
        {"LevelOutOfRange",
         std::string("[[detail]]\n"
                     "name = \"d\"\n"
                     "cluster = \"cluster\"\n"
                     "reference_m = [0, 0, 0]\n"
                     "to_m = [400]\n"
                     "[[object]]\n"
                     "name = \"o\"\n"
                     "list = \"list\"\n"
                     "colour = \"grey\"\n"
                     "detail = \"d\"\n"
                     "level = 3\n") +
             disc,
         "root.toml:20:1: error: object \"o\" is level 3 of detail \"d\", which has 1; expected 0 to 0"},
        {"LevelWithoutDetail", object + "level = 0\n" + disc,
         "root.toml:19:9: error: \"level\" stands without \"detail\"; expected both or neither"},
        {"EmptyObject", object,
         "root.toml:15:1: error: [[object]] \"o\" has no faces; expected at least one"},
        {"PlaneWithoutNormal",
         "[[cluster_plane]]\n"
         "cluster = \"cluster\"\n"
         "name = \"p\"\n"
         "normal = [0, 0, 0]\n"
         "distance_m = 1\n"
         "front = \"list\"\n",
         "root.toml:18:10: error: the plane's normal has no length; expected a vector"},
        {"PlaneToNowhere",
         "[[cluster_plane]]\n"
         "cluster = \"cluster\"\n"
         "name = \"p\"\n"
         "normal = [0, 0, 1]\n"
         "distance_m = 1\n"
         "front = \"list\"\n"
         "back = \"lost\"\n",
         "root.toml:15:1: error: the back of plane \"p\" names \"lost\", which is no plane or object list of "
         "cluster \"cluster\"; did you mean \"list\"?"},
        {"PlaneInACircle",
         "[[cluster_plane]]\n"
         "cluster = \"cluster\"\n"
         "name = \"p\"\n"
         "normal = [0, 0, 1]\n"
         "distance_m = 1\n"
         "front = \"list\"\n"
         "back = \"p\"\n",
         "root.toml:15:1: error: the back of plane \"p\" leads to the plane \"p\" a second time; expected a "
         "tree"},
        {"OverTheBudget",
         "[[object_list]]\n"
         "name = \"small\"\n"
         "cluster = \"cluster\"\n"
         "sun = \"sun\"\n"
         "priority = 2\n"
         "edge_budget = 4\n"
         "[[object]]\n"
         "name = \"o\"\n"
         "list = \"small\"\n"
         "colour = \"grey\"\n"
         "[[object.box]]\n"
         "from_m = [0, 0, 0]\n"
         "to_m = [1, 1, 1]\n",
         "root.toml:15:1: error: object list \"small\" has up to 12 edges at once; expected at most its "
         "edge_budget, 4"},
        {"TooFar",
         "[[object_list]]\n"
         "name = \"far\"\n"
         "cluster = \"cluster\"\n"
         "sun = \"sun\"\n"
         "priority = 2\n"
         "origin_m = [2e7, 0, 0]\n",
         "root.toml:20:12: error: \"origin_m\" lies beyond 10000000 m; expected less"},
        {"PeriodNoPowerOfTwo",
         "[[tile]]\n"
         "list = \"list\"\n"
         "period = 12\n"
         "cell_m = 8\n"
         "rings = 4\n"
         "fine_levels = 1\n"
         "half_width = 8\n"
         "colour = \"grey\"\n"
         "vertical_angle_deg = 60\n"
         "seed = 1\n"
         "pattern = \"random\"\n",
         "root.toml:17:10: error: \"period\" is 12; expected a power of two, 2 to 1024"},
        {"WordForAChoice", object + "shading = \"phong\"\n" + disc,
         "root.toml:19:11: error: \"shading\" is \"phong\"; expected one of \"none\", \"face\", \"vertex\""},
        {"BoxWithoutExtent",
         object + "[[object.box]]\n"
                  "from_m = [0, 0, 0]\n"
                  "to_m = [1, 0, 1]\n",
         "root.toml:21:8: error: [[object.box]] of [[object]] \"o\" has no extent in y; expected at least "
         "0.001 m"},
        {"PrismClockwise",
         object + "[[object.prism]]\n"
                  "base_m = [[0, 0], [0, 1], [1, 0]]\n"
                  "bottom_m = 0\n"
                  "top_m = 1\n",
         "root.toml:20:10: error: the base runs clockwise; expected counter-clockwise seen from above"},
        {"OffsetWithoutMover",
         "[[object_list]]\n"
         "name = \"b\"\n"
         "cluster = \"cluster\"\n"
         "sun = \"sun\"\n"
         "priority = 2\n"
         "frame = \"body\"\n",
         "root.toml:20:9: error: \"frame\" needs a moving object, but the cluster \"cluster\" is static; "
         "expected \"world\" or \"eye\""},
        {"AddedToItself",
         "[[object_list]]\n"
         "name = \"b\"\n"
         "cluster = \"cluster\"\n"
         "sun = \"sun\"\n"
         "priority = 2\n"
         "added_to = \"b\"\n",
         "root.toml:20:12: error: a list is added to itself; expected another list"},
        {"BeamWithoutDirection",
         object + "[[object.light]]\n"
                  "position_m = [0, 0, 0]\n"
                  "beam = \"one_way\"\n",
         "root.toml:19:1: error: [[object.light]] of [[object]] \"o\" lacks the key \"direction\""},
        {"FaceTurnedInASolid",
         object + "vertices_m = { a = [0, 0, 0], b = [4, 0, 0], c = [0, 4, 0], d = [0, 0, 4] }\n"
                  "[[object.face]]\ncorners = [\"a\", \"c\", \"b\"]\n[[object.face]]\ncorners = [\"a\", "
                  "\"b\", \"d\"]\n"
                  "[[object.face]]\ncorners = [\"a\", \"d\", \"c\"]\n[[object.face]]\ncorners = [\"b\", "
                  "\"d\", \"c\"]\n",
         "root.toml:26:1: error: a face of object \"o\" is turned against the other faces of its solid; "
         "expected corners "
         "counter-clockwise seen from outside"},
        {"LoftTurnedBetweenItsEnds",
         object +
             "vertices_m = { a = [4, 1, 0], b = [4, 0, 1], c = [4, -1, 0], d = [0, 1, 0], e = [0, 0, 1], "
             "f = [0, -1, 0] }\n"
             "[[object.face]]\ncorners = [\"a\", \"b\", \"c\"]\n[[object.face]]\ncorners = [\"f\", "
             "\"e\", \"d\"]\n[[object.loft]]\nsections_m = [[[4, 1, 0], [4, 0, 1], [4, -1, 0], [4, 1, 0]], "
             "[[0, 1, 0], [0, 0, 1], [0, -1, 0], [0, 1, 0]]]\n",
         "root.toml:24:1: error: 3 faces of object \"o\" are turned against the other faces of their solid; "
         "expected corners counter-clockwise seen from outside"},
    };
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, IsToldWhereItStands) {
    const ScratchFolder folder;
    const CompileResult result = compile_file(folder.write("root.toml", scene(GetParam().objects)));
    EXPECT_FALSE(result.database);
    std::string text = result.diagnostics.text();
    for (std::size_t at = 0; (at = text.find(folder.path() + "/")) != std::string::npos;)
        text.erase(at, folder.path().size() + 1);
    EXPECT_THAT(text, HasSubstr(GetParam().told));
}

INSTANTIATE_TEST_SUITE_P(All, Mistakes, testing::ValuesIn(mistakes()),
                         [](const testing::TestParamInfo<Mistake>& each) { return each.param.name; });

TEST(MistakesTogether, AreToldAtOnce) {
    EXPECT_GE(mistakes().size(), 40U);
    const CompileResult result = compile_text(
        scene(object + "colr = 1\n" + disc + "[[colour]]\nname = \"grey\"\nrgb = [256, 0, 0]\n" +
              "[[object]]\nname = \"p\"\nlist = \"lost\"\n" + disc + "[[object_list]]\nname = \"n\"\n"));
    EXPECT_FALSE(result.database);
    const std::string told = messages(result);
    for (const char* each :
         {"root.toml:19: unknown key \"colr\" in [[object]] \"o\"",
          "root.toml:23: the colour \"grey\" stands already", "root.toml:25: \"rgb\" holds 256",
          "root.toml:28: no object list is named \"lost\"",
          "root.toml:29: [[object.disc]] of [[object]] \"p\" has no colour",
          "root.toml:32: [[object_list]] \"n\" lacks the key \"cluster\"",
          "root.toml:32: [[object_list]] \"n\" lacks the key \"sun\""})
        EXPECT_THAT(told, HasSubstr(each));
    EXPECT_EQ(result.diagnostics.all().size(), 7U) << told;
}

/// Files that no text is: each is told and read no further.
TEST(MistakesOfFiles, AreToldByWhatTheFileIs) {
    const ScratchFolder folder;
    const auto said = [&](const std::string& name) {
        const CompileResult result = compile_file(folder.path() + "/" + name);
        EXPECT_FALSE(result.database) << name;
        return result.diagnostics.text();
    };
    EXPECT_THAT(said("lost.toml"), HasSubstr("lost.toml:0:0: error: "));
    std::filesystem::create_directories(folder.path() + "/folder.toml");
    EXPECT_THAT(said("folder.toml"), HasSubstr("folder.toml:0:0: error: is a directory"));
    folder.write("huge.toml", "");
    std::filesystem::resize_file(folder.path() + "/huge.toml", std::uintmax_t{1} << 30U); // sparse
    EXPECT_THAT(said("huge.toml"), HasSubstr("huge.toml:0:0: error: is larger than 64 MiB"));
    folder.write("binary.toml", std::string("LINKDIG\0\x01\xff\xfe", 11));
    EXPECT_THAT(said("binary.toml"), HasSubstr("binary.toml:0:0: error: is not text: byte 7 is zero"));
    folder.write("syntax.toml", "[database]\nname = \n[[colour]]\nrgb = 3\n");
    EXPECT_THAT(said("syntax.toml"), HasSubstr("syntax.toml:2:8: error: "));
    folder.write("a.toml", "include = [\"b.toml\"]\n");
    folder.write("b.toml", "include = [\"a.toml\"]\n");
    EXPECT_THAT(said("a.toml"), HasSubstr("b.toml:1:12: error: "));
    EXPECT_THAT(said("a.toml"), HasSubstr("a.toml"));
    folder.write("c.toml", "include = [\"lost.toml\"]\n");
    EXPECT_THAT(said("c.toml"), HasSubstr("c.toml:1:12: error: "));
    folder.write("secret.toml", "");
    std::filesystem::permissions(folder.path() + "/secret.toml", std::filesystem::perms::none);
    std::filesystem::permissions(folder.path(), std::filesystem::perms::others_all,
                                 std::filesystem::perm_options::add);
    const uid_t self = geteuid();
    constexpr uid_t nobody = 65534;
    ASSERT_EQ(self == 0 ? seteuid(nobody) : 0, 0); // root reads everything
    const std::string secret = said("secret.toml");
    ASSERT_EQ(self == 0 ? seteuid(self) : 0, 0);
    EXPECT_THAT(secret, HasSubstr("secret.toml:0:0: error: cannot be read; check its permissions"));
}

} // namespace
} // namespace linkdig::database
