/// Every mistake that an author can make is told, with the line.

#include "tests/database/compiler/authored.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace linkdig::database {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Expects the scene with these objects to be refused.
std::string said(const std::string& objects) {
    const CompileResult result = compile_text(scene(objects));
    EXPECT_FALSE(result.database) << objects;
    return messages(result);
}

/// Object of one face over named vertices.
std::string face_of(const std::string& vertices, const std::string& corners, const std::string& more = "") {
    return fmt::format("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\nvertices_m = {{{}}}\n"
                       "[[object.face]]\ncorners = [{}]\n{}",
                       vertices, corners, more);
}
const std::string square = "a = [0, 0, 0], b = [10, 0, 0], c = [10, 10, 0], d = [0, 10, 0]";
const std::string box = "[[object]]\nname = \"box\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.box]]\n"
                        "from_m = [0, 0, 0]\nto_m = [1, 1, 1]\n";

TEST(Messages, NoneForWhatIsRight) {
    const CompileResult result = compile_text(scene(face_of(square, "'a', 'b', 'c', 'd'")));
    EXPECT_EQ(messages(result), "");
    ASSERT_TRUE(result.database);
    EXPECT_EQ(result.database->faces.size(), 1U);
}

TEST(Messages, FilesThatCannotBeRead) {
    const ScratchFolder folder;
    EXPECT_THAT(messages(compile_file(folder.path() + "/absent.toml")),
                HasSubstr("absent.toml:0: no such file"));
    EXPECT_THAT(messages(compile_file(folder.path())), HasSubstr("is a directory"));
    EXPECT_THAT(messages(compile_file(folder.write("b.toml", std::string("\0\0\0", 3)))),
                HasSubstr("is not text"));
    EXPECT_THAT(messages(compile_file(folder.write("e.toml", ""))),
                HasSubstr("e.toml:0: lacks a [database] table"));
    EXPECT_THAT(messages(compile_file(folder.write("s.toml", "a = "))), HasSubstr("s.toml:1: "));
}

TEST(Messages, Includes) {
    const ScratchFolder folder;
    folder.write("sub/b.toml", "include = [\"../a.toml\"]\n");
    const std::string cycle = folder.write("a.toml", "[database]\nname = \"t\"\n");
    folder.write("a.toml", "include = [\"sub/b.toml\"]\n[database]\nname = \"t\"\n");
    EXPECT_THAT(messages(compile_file(cycle)), HasSubstr("b.toml:1: \"a.toml\" includes itself"));
    EXPECT_THAT(messages(compile_file(
                    folder.write("m.toml", "include = [\n\"no.toml\"]\n[database]\nname = \"t\"\n"))),
                HasSubstr("m.toml:2: cannot include \"" + folder.path() + "/no.toml\": no such file"));
    EXPECT_THAT(
        messages(compile_file(folder.write("d.toml", "include = [\"sub\"]\n[database]\nname = \"t\"\n"))),
        HasSubstr("d.toml:1: cannot include"));
    EXPECT_THAT(messages(compile_file(
                    folder.write("abs.toml", "include = [\"/etc/passwd\"]\n[database]\nname = \"t\"\n"))),
                HasSubstr("expected a path relative to this file"));
    EXPECT_THAT(messages(compile_file(folder.write("t.toml", "include = \"x\"\n[database]\nname = \"t\"\n"))),
                HasSubstr("expected an array of texts"));
    folder.write("own.toml", "[database]\nname = \"u\"\n");
    EXPECT_THAT(messages(compile_file(
                    folder.write("r.toml", "include = [\"own.toml\"]\n[database]\nname = \"t\"\n"))),
                HasSubstr("own.toml:1: [database] stands in an included file"));
}

TEST(Messages, AllAtOnceWithTheirLines) {
    const std::string text = said("[[object]]\nname = \"o\"\nlist = \"lits\"\ncolour = \"gray\"\nshadng = 1\n"
                                  "[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, nan]\n[[colour]]\nname "
                                  "= \"grey\"\nrgb = [0, 0, 300]\n");
    EXPECT_THAT(text, HasSubstr("root.toml:17: no object list is named \"lits\"; did you mean \"list\"?"));
    EXPECT_THAT(text, HasSubstr("root.toml:18: no colour is named \"gray\"; did you mean \"grey\"?"));
    EXPECT_THAT(
        text,
        HasSubstr("root.toml:19: unknown key \"shadng\" in [[object]] \"o\"; did you mean \"shading\"?"));
    EXPECT_THAT(text,
                HasSubstr("root.toml:22: \"to_m\" is an array; expected [x, y, z], three finite numbers"));
    EXPECT_THAT(text, HasSubstr("root.toml:23: the colour \"grey\" stands already in "));
    EXPECT_THAT(text, HasSubstr("root.toml:25: \"rgb\" holds 300; expected whole numbers 0 to 255"));
}

TEST(Messages, UnknownTables) {
    EXPECT_THAT(said("[[objects]]\nname = \"o\"\n"),
                HasSubstr("root.toml:15: unknown key \"objects\" in the file; did you mean \"object\"?"));
    EXPECT_THAT(said("[object]\nname = \"o\"\n"),
                HasSubstr("\"object\" is a table; expected an array of tables: [[object]]"));
}

TEST(Messages, MissingKeys) {
    const std::string text = said("[[object]]\n[[sun]]\n[[slot]]\nname = \"s\"\n");
    EXPECT_THAT(text, HasSubstr("root.toml:15: [[object]] lacks the key \"name\""));
    EXPECT_THAT(text, HasSubstr("root.toml:15: [[object]] lacks the key \"list\""));
    EXPECT_THAT(text, HasSubstr("root.toml:16: [[sun]] lacks the key \"name\""));
    EXPECT_THAT(text, HasSubstr("root.toml:17: [[slot]] \"s\" lacks the key \"alternatives\""));
}

TEST(Messages, DuplicateNames) {
    EXPECT_THAT(said(box + box), HasSubstr("the object \"box\" stands already in"));
    EXPECT_THAT(said("[[sun]]\nname = \"sun\"\n"),
                HasSubstr("root.toml:15: the sun \"sun\" stands already in"));
}

TEST(Messages, CornersOfFaces) {
    EXPECT_THAT(said(face_of(square, "'a', 'b'")),
                HasSubstr("root.toml:21: the face has 2 corners; expected 3 to 65535"));
    EXPECT_THAT(said(face_of(square, "")), HasSubstr("the face has 0 corners"));
    EXPECT_THAT(said(face_of(square, "'a', 'b', 'a'")), HasSubstr("the corner \"a\" stands twice"));
    EXPECT_THAT(said(face_of(square, "'a', 'b', 'e'")), HasSubstr("has no vertex \"e\""));
    EXPECT_THAT(said(face_of(square, "'a', 'b', 3")),
                HasSubstr("root.toml:21: \"corners\" is a whole number; expected a text"));
    EXPECT_THAT(said("[[object]]\nname = \"o\"\nlist = \"list\"\n"), HasSubstr("has no faces"));
}

TEST(Messages, ShapesOfFaces) {
    EXPECT_THAT(said(face_of("a = [0, 0, 0], b = [10, 0, 0], c = [10, 10, 0.1], d = [0, 10, 0]",
                             "'a', 'b', 'c', 'd'")),
                HasSubstr("root.toml:20: a face of object \"o\" is not planar"));
    EXPECT_THAT(
        said(face_of("a = [0, 0, 0], b = [10, 0, 0], c = [2, 2, 0], d = [0, 10, 0]", "'a', 'b', 'c', 'd'")),
        HasSubstr("is concave at corner \"c\""));
    EXPECT_THAT(said(face_of(square, "'a', 'c', 'b', 'd'")), HasSubstr("intersects itself"));
    EXPECT_THAT(said(face_of("a = [0, 0, 0], b = [10, 0, 0], c = [5, 0, 0]", "'a', 'b', 'c'")),
                HasSubstr("has no area"));
    EXPECT_THAT(said(face_of("a = [0, 0, 0], b = [0, 0, 0], c = [5, 0, 0]", "'a', 'b', 'c'")),
                HasSubstr("corner \"a\" and corner \"b\" of a face of object \"o\" are at the same place"));
    EXPECT_THAT(said(face_of("a = [0, 0, 0], b = [2e7, 0, 0], c = [0, 5, 0]", "'a', 'b', 'c'")),
                HasSubstr("root.toml:19: the vertex \"b\" of object \"o\" lies beyond 10000000 m"));
    EXPECT_THAT(said(face_of("a = [0, 0, 0], b = [inf, 0, 0], c = [0, 5, 0]", "'a', 'b', 'c'")),
                HasSubstr("three finite numbers"));
}

TEST(Messages, AStarIntersectsItselfThoughItTurnsOneWay) {
    EXPECT_THAT(
        said(face_of(
            "a = [0, 10, 0], b = [-5.9, -8.1, 0], c = [9.5, 3.1, 0], d = [-9.5, 3.1, 0], e = [5.9, -8.1, 0]",
            "'a', 'b', 'c', 'd', 'e'")),
        HasSubstr("intersects itself"));
}

TEST(Messages, PlanarWithinTheToleranceIsTaken) {
    // 1e-4 of the extent, 14 m, is 1.4 mm: the corner may be 4 mm off, for the best plane halves and halves
    // it again.
    const auto compiled = [](const char* z) {
        return compile_text(scene(face_of(std::string("a = [0, 0, 0], b = [10, 0, 0], c = [10, 10, ") + z +
                                              "], d = [0, 10, 0]",
                                          "'a', 'b', 'c', 'd'")))
            .database.has_value();
    };
    EXPECT_TRUE(compiled("0.004"));
    EXPECT_FALSE(compiled("0.008"));
}

TEST(Messages, Diagonals) {
    EXPECT_THAT(said(face_of(square, "'a', 'b', 'c', 'd'", "diagonal = ['a', 'b']\n")),
                HasSubstr("names no diagonal of the face"));
    EXPECT_THAT(said(face_of(square, "'a', 'b', 'c', 'd'", "diagonal = 'x'\n")),
                HasSubstr("names no diagonal of the face"));
}

TEST(Messages, CoplanarFacesWithoutLayers) {
    const std::string deck =
        "[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.rectangle]]\n"
        "centre_m = [0, 0, 1]\nsize_m = [10, 10]\n[[object.rectangle]]\ncentre_m = [1, 1, 1]\nsize_m = [2, "
        "2]\n";
    EXPECT_THAT(
        said(deck),
        HasSubstr("root.toml:22: coplanar faces overlap with the same layer: this one of object \"o\""));
    EXPECT_TRUE(compile_text(scene(deck + "layer = 1\n")).database);
}

TEST(Messages, FacesThatPassThroughEachOtherAreCut) {
    const CompileResult result = compile_text(
        scene(box + "[[object]]\nname = \"second\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.box]]\n"
                    "from_m = [0.5, 0.5, 0.5]\nto_m = [2, 2, 2]\n"));
    ASSERT_TRUE(result.database) << messages(result);
    EXPECT_GT(result.statistics.total().splits, 0U);
}

TEST(Messages, Slots) {
    const std::string slot = "[[slot]]\nname = \"s\"\nalternatives = 3\n";
    const auto object = [](int number, int alternative) {
        return "[[object]]\nname = \"o" + std::to_string(number) +
               "\"\nlist = \"list\"\ncolour = \"grey\"\nslot = \"s\"\nalternative = " +
               std::to_string(alternative) +
               "\n[[object.rectangle]]\ncentre_m = [0, 0, 0]\nsize_m = [1, 1]\n";
    };
    EXPECT_THAT(said(slot + object(0, 0) + object(1, 2)),
                HasSubstr("root.toml:15: slot \"s\" has 3 alternatives, but its objects cover 2 of them; "
                          "expected also alternative 1"));
    EXPECT_THAT(said(slot + object(0, 0) + object(1, 1) + object(2, 2) + object(3, 3)),
                HasSubstr("object \"o3\" is alternative 3 of slot \"s\", which has 3"));
    EXPECT_THAT(said(slot + "[[object]]\nname = \"x\"\nlist = \"list\"\nslot = \"s\"\n"),
                HasSubstr("lacks the key \"alternative\""));
    EXPECT_THAT(said("[[object]]\nname = \"x\"\nlist = \"list\"\nalternative = 1\n"),
                HasSubstr("\"alternative\" stands without \"slot\""));
    EXPECT_TRUE(compile_text(scene(slot + object(0, 0) + object(1, 1) + object(2, 2))).database);
}

TEST(Messages, SlotsWhoseFirstAlternativeIsNothing) {
    const std::string slot = "[[slot]]\nname = \"s\"\nalternatives = 3\nfirst_empty = true\n";
    const auto object = [](int alternative) {
        return "[[object]]\nname = \"o" + std::to_string(alternative) +
               "\"\nlist = \"list\"\ncolour = \"grey\"\nslot = \"s\"\nalternative = " +
               std::to_string(alternative) +
               "\n[[object.rectangle]]\ncentre_m = [0, 0, 0]\nsize_m = [1, 1]\n";
    };
    EXPECT_TRUE(compile_text(scene(slot + object(1) + object(2))).database);
    EXPECT_THAT(
        said(slot + object(0) + object(1) + object(2)),
        HasSubstr("object \"o0\" is alternative 0 of slot \"s\", which has 3, the first empty; expected 1 "
                  "to 2"));
    EXPECT_THAT(said(slot + object(2)), HasSubstr("expected also alternative 1"));
    EXPECT_THAT(said("[[slot]]\nname = \"s\"\nalternatives = 1\nfirst_empty = true\n"),
                HasSubstr("\"alternatives\" is 1; expected 2 to 4096"));
}

TEST(Messages, Churn) {
    const auto churn = [](const std::string& more) {
        return "[[churn]]\nname = \"c\"\nlist = \"list\"\ncolour = \"grey\"\nvertical_angle_deg = 45\nseed = "
               "1\n" +
               more;
    };
    const std::string rims = "left_m = [[0, 1], [9, 1]]\nright_m = [[0, -1], [9, -1]]\n";
    EXPECT_TRUE(compile_text(scene(churn(rims + "square_m = 1\n"))).database);
    EXPECT_THAT(said(churn(rims)), HasSubstr("\"square_m\""));
    EXPECT_THAT(said(churn("left_m = [[0, 1]]\nright_m = [[0, -1], [9, -1]]\nsquare_m = 1\n")),
                HasSubstr("root.toml:21: the rim \"left_m\" has no length; expected two or more points"));
    EXPECT_THAT(
        said(churn("left_m = [[0, 1000], [9000, 1000]]\nright_m = [[0, 0], [9000, 0]]\nsquare_m = 0.1\n")),
        HasSubstr("makes more than 1000000 squares; expected larger ones"));
    EXPECT_THAT(said(churn(rims + "square_m = 1\nfade_sides = -1\n")), HasSubstr("fade_sides"));
    EXPECT_THAT(said(churn("left_m = [[0, -1], [9, -1]]\nright_m = [[0, 1], [9, 1]]\nsquare_m = 1\n")),
                HasSubstr("the strip runs the wrong way round; expected left_m to the left on the way"));
}

TEST(Messages, FacesOfASequence) {
    const auto solid = [](const std::string& faces) {
        return "[[slot]]\nname = \"s\"\nalternatives = 3\nfirst_empty = true\n[[sequence]]\nname = "
               "\"w\"\nlist = "
               "\"list\"\nslot = \"s\"\ncolour = \"grey\"\nfaces = " +
               faces +
               "\n[[sequence.key]]\nframe = 1\ncorners_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
               "[[sequence.key]]\nframe = 2\ncorners_m = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]]\n";
    };
    EXPECT_TRUE(compile_text(scene(solid("[[1, 3, 2], [1, 2, 4]]"))).database);
    for (const char* faces : {"[]", "[[1, 2]]", "[[1, 2, 5]]", "[[0, 1, 2]]", "[[1, 2, 1]]", "3", "[3]"})
        EXPECT_THAT(said(solid(faces)),
                    HasSubstr("\"faces\" of [[sequence]] \"w\" holds something else; expected "
                              "arrays of three or more distinct corner numbers, 1 to 4"))
            << faces;
}

TEST(Messages, ListsAndFrames) {
    EXPECT_THAT(said("[[object_list]]\nname = \"m\"\ncluster = \"cluster\"\npriority = 5\nsun = "
                     "\"sun\"\nframe = \"body\"\n"),
                HasSubstr("\"frame\" needs a moving object, but the cluster \"cluster\" is static"));
    EXPECT_THAT(said("[[object_list]]\nname = \"m\"\ncluster = \"cluster\"\npriority = 5\nsun = "
                     "\"sun\"\nambient = 1.5\n"),
                HasSubstr("\"ambient\" is 1.5; expected 0 to 1"));
}

TEST(Messages, Tiles) {
    const std::string tile =
        "[[tile]]\nlist = \"list\"\nperiod = 12\ncell_m = 50\nrings = 8\nfine_levels = 2\nhalf_width = 10\n"
        "vertical_angle_deg = 70\ncolour = \"grey\"\nseed = 1\npattern = \"random\"\n";
    const std::string text = said(tile + box);
    EXPECT_THAT(text, HasSubstr("root.toml:17: \"period\" is 12; expected a power of two"));
    EXPECT_THAT(text, HasSubstr("root.toml:21: \"half_width\" is 10; expected a multiple of 4"));
    EXPECT_THAT(
        text,
        HasSubstr(
            "root.toml:16: the list \"list\" of a tile holds the object \"box\"; expected nothing else"));
}

TEST(Messages, TilesThatReachTooFarOrMakeTooMuch) {
    const auto tile = [](const char* numbers) {
        return said(
            fmt::format("[[tile]]\nlist = \"list\"\nperiod = 2\nvertical_angle_deg = 70\ncolour = \"grey\"\n"
                        "seed = 1\n{}\n",
                        numbers));
    };
    EXPECT_THAT(tile("cell_m = 90000\nrings = 16\nhalf_width = 8\nfine_levels = 0"),
                HasSubstr("the rings reach further than 1000000000 m"));
    EXPECT_THAT(tile("cell_m = 1\nrings = 16\nhalf_width = 256\nfine_levels = 6"),
                HasSubstr("the tiles make 6029312 squares a frame; expected at most 4000000"));
}

TEST(Messages, PatternsOfTiles) {
    const std::string tile =
        "[[tile]]\nlist = \"list\"\nperiod = 16\ncell_m = 8\nrings = 3\nfine_levels = 1\nhalf_width = 8\n"
        "colour = \"grey\"\nvertical_angle_deg = 60\n";
    EXPECT_THAT(said(tile + "pattern = \"sine\"\n"), HasSubstr("lacks the key \"wavelength_m\""));
    EXPECT_THAT(said(tile + "pattern = \"sine\"\nwavelength_m = 24\n"),
                HasSubstr("root.toml:25: \"wavelength_m\" is 24 m, 3 squares; expected at least 4 squares"));
    EXPECT_THAT(
        said(tile + "pattern = \"sine\"\nwavelength_m = 50\n"),
        HasSubstr(
            "root.toml:25: a wave of 50 m at 0 degrees does not repeat over the pattern's 128 m; the nearest "
            "that does has 42.6667 m at 0 degrees"));
    EXPECT_THAT(
        said(
            tile +
            "pattern = \"two_waves\"\nfirst_wavelength_m = 32\nsecond_wavelength_m = 64\nbetween_deg = 20\n"),
        HasSubstr("root.toml:26: a wave of 64 m at 20 degrees does not repeat over the pattern's 128 m; the "
                  "nearest "
                  "that does has 57.2433 m at 26.57 degrees"));
    EXPECT_THAT(said(tile + "pattern = \"sine\"\nwavelength_m = 64\nseed = 3\n"),
                HasSubstr("unknown key \"seed\""));
    const std::string levels = tile.substr(0, tile.find("vertical_angle"));
    for (const char* wrong :
         {"[]", "[[1, 2], [0, 0]]", "[[1, 0, 1], [0, 1, 0], [1, 0, 1]]", "[[1, 0], [1]]", "3"})
        EXPECT_THAT(said(levels + "pattern = \"levels\"\nlevels = " + wrong + "\n"),
                    HasSubstr("\"levels\" is no pattern of levels; expected n rows of n numbers, 0 to 1"))
            << wrong;
    EXPECT_THAT(said(tile + "pattern = \"levels\"\nlevels = [[1]]\n"),
                HasSubstr("unknown key \"vertical_angle_deg\""));
}

TEST(Messages, Paths) {
    const std::string path =
        "[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.path]]\nwidth_m = 2\n";
    EXPECT_THAT(said(path + "points_m = [[0, 0, 0], [9, 0, 0], [0, 1, 0]]\n"),
                HasSubstr("root.toml:21: the path turns by more than 120 degrees at point 2"));
    for (const char* points : {"[[0, 0, 0]]", "[[0, 0, 0], [0, 0, 0]]", "[[0, 0, 0], [9, 0, 1]]"})
        EXPECT_THAT(said(path + "points_m = " + points + "\n"),
                    HasSubstr("root.toml:21: the path has no length, or its points differ in height"))
            << points;
}

TEST(Messages, Patchworks) {
    const std::string work =
        "[[patchwork]]\nname = \"p\"\nlist = \"list\"\nfrom_m = [0, 0, 0]\ncolumns = 2\nrows = 2\nseed = 1\n";
    EXPECT_THAT(said(work + "to_m = [9, 9, 1]\ncolours = [\"grey\"]\n"),
                HasSubstr("root.toml:22: the patchwork has no area"));
    EXPECT_THAT(said(work + "to_m = [9, 9, 0]\n"),
                HasSubstr("\"p\" has no colours; expected at least one name"));
    EXPECT_THAT(said(work + "to_m = [9, 9, 0]\ncolours = [\"gray\"]\n"),
                HasSubstr("root.toml:23: no colour is named \"gray\"; did you mean \"grey\"?"));
    EXPECT_THAT(said(work + "to_m = [9, 9, 0]\ncolours = [\"grey\"]\ndisorder = 0.5\n"),
                HasSubstr("\"disorder\" is 0.5; expected 0 to 0.2"));
}

TEST(Messages, Mounds) {
    const auto field = [](const std::string& lines) {
        return said("[[mounds]]\nname = \"m\"\nlist = \"list\"\ncolour = \"grey\"\nfrom_m = [0, 0, 0]\n" +
                    lines + "seed = 1\n");
    };
    EXPECT_THAT(
        field("to_m = [90, 90, 0]\nspacing_m = 10\nradius_m = [4, 6]\nheight_m = [1, 2]\n"),
        HasSubstr("root.toml:22: the greatest radius is 6 m and the spacing 10 m; expected at most half"));
    EXPECT_THAT(field("to_m = [9, 90, 0]\nspacing_m = 10\nradius_m = [4, 5]\nheight_m = [1, 2]\n"),
                HasSubstr("root.toml:20: the field holds no mound"));
    EXPECT_THAT(
        field("to_m = [9000, 9000, 0]\nspacing_m = 10\nradius_m = [4, 5]\nheight_m = [2, 1]\n"),
        HasSubstr("root.toml:23: \"height_m\" is no range; expected [least, greatest], 0.001 to 1e+06"));
    EXPECT_THAT(field("to_m = [9000, 9000, 0]\nspacing_m = 10\nradius_m = [4, 5]\nheight_m = [1, 2]\n"),
                HasSubstr("root.toml:21: the field makes up to 5670000 faces; expected at most 100000"));
    EXPECT_THAT(
        field("to_m = [90, 90, 0]\nspacing_m = 10\nradius_m = [4, 5]\nheight_m = [1, 2]\nleast_sides = 9\n"),
        HasSubstr("\"least_sides\" is above \"greatest_sides\""));
}

TEST(Messages, Primitives) {
    const auto primitive = [](const std::string& kind, const std::string& text) {
        return said("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n[[object." + kind +
                    "]]\n" + text + "\n");
    };
    EXPECT_THAT(primitive("box", "from_m = [0, 0, 0]\nto_m = [1, 0, 1]"), HasSubstr("has no extent in y"));
    EXPECT_THAT(primitive("box", "from_m = [0, 0, 0]\nto_m = [1, 1, 1]\nomit = [\"left\"]"),
                HasSubstr("a box has no side \"left\"; expected one of \"bow\""));
    EXPECT_THAT(primitive("prism", "base_m = [[0, 0], [0, 1], [1, 0]]\nbottom_m = 0\ntop_m = 1"),
                HasSubstr("runs clockwise"));
    EXPECT_THAT(primitive("prism", "base_m = [[0, 0], [1, 0], [0, 1]]\nbottom_m = 1\ntop_m = 1"),
                HasSubstr("is not above the bottom"));
    EXPECT_THAT(primitive("prism", "base_m = [[0, 0], [4, 0], [1, 1], [0, 4]]\nbottom_m = 0\ntop_m = 1"),
                HasSubstr("is concave"));
    EXPECT_THAT(primitive("loft", "sections_m = [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0]]]"),
                HasSubstr("the section has 1 points"));
    EXPECT_THAT(primitive("loft", "sections_m = [[[0, 0, 0], [1, 0, 0]]]"), HasSubstr("at least two"));
    EXPECT_THAT(primitive("ring", "centre_m = [0, 0, 0]\nradius_m = 2\nwidth_m = 2"),
                HasSubstr("the ring is 2 m wide and its radius 2 m"));
    EXPECT_THAT(primitive("stripe", "from_m = [0, 0, 0]\nto_m = [1, 0, 1]\nwidth_m = 1"),
                HasSubstr("the same z"));
    EXPECT_THAT(primitive("stripe", "from_m = [0, 0, 0]\nto_m = [9, 0, 0]\nwidth_m = 1\ndash_m = 1"),
                HasSubstr("make a dashed stripe together"));
    EXPECT_THAT(primitive("numeral", "text = \"2A\"\ncentre_m = [0, 0, 0]\nheight_m = 5\nstroke_m = 0.5"),
                HasSubstr("expected one to eight digits"));
    EXPECT_THAT(primitive("disc", "centre_m = [0, 0, 0]\nradius_m = 0"), HasSubstr("\"radius_m\" is 0"));
    EXPECT_THAT(primitive("rectangle", "centre_m = [0, 0, 0]\nsize_m = [1]"),
                HasSubstr("expected [length, width]"));
    EXPECT_THAT(
        primitive("box", "from_m = [0, 0, 0]\nto_m = [1, 1, 1]\nrepeat = { count = 3, step_m = [0, 0, 0] }"),
        HasSubstr("the copies stand in one place"));
    EXPECT_THAT(said("[[object]]\nname = \"o\"\nlist = \"list\"\n[[object.disc]]\ncentre_m = [0, 0, "
                     "0]\nradius_m = 1\n"),
                HasSubstr("has no colour"));
}

TEST(Messages, AMistakeIsToldOnce) {
    const std::string text = said("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = "
                                  "\"gray\"\n[[object.box]]\nfrom_m = [0, 0, 0]\nto_m = [1, 1, 1]\n");
    EXPECT_EQ(text, "root.toml:18: no colour is named \"gray\"; did you mean \"grey\"?\n");
    EXPECT_THAT(said("[[object]]\nname = \"o\"\nlist = \"list\"\ncolour = \"grey\"\n[[object.box]]\nfrom = "
                     "[0, 0, 0]\nto_m = [1, 1, 1]\n"),
                Not(HasSubstr("no faces")));
}

} // namespace
} // namespace linkdig::database
