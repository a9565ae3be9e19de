#include "tests/tools/command.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <string>
#include <tuple>

namespace linkdig::tools {
namespace {

using testing::HasSubstr;

const std::string scenario = "'" LINKDIG_SOURCE_DIR "/database/scenes/first_flight/approach.toml'";

TEST(CommandLine, HelpAndVersionAreNoMistakes) {
    const Outcome help = run("--help");
    EXPECT_EQ(help.exit_code, 0);
    for (const char* name : {"demo", "compile", "inspect", "render", "figures", "fly", "panel", "record",
                             "replay", "convert", "wake", "why"}) {
        EXPECT_THAT(help.output, HasSubstr(name));
        const Outcome own = run(std::string(name) + " --help");
        EXPECT_EQ(own.exit_code, 0);
        EXPECT_THAT(own.output, testing::ContainsRegex(std::string("Example:[ \n]+linkdig ") + name));
    }
    const Outcome version = run("--version");
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_THAT(version.output, testing::MatchesRegex("linkdig [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

struct Mistake {
    const char* arguments;
    const char* told;
};

TEST(CommandLine, WhyTellsTheFaceAndItsAuthoringLine) {
    const Outcome why = run("why " + scenario + " --frame 560 --at 320,300 --size 640x480");
    EXPECT_EQ(why.exit_code, 0);
    EXPECT_THAT(why.output, HasSubstr("seen      lph2.topsides, object \"hull sides\" (../lph2/hull.toml:"));
    EXPECT_THAT(why.output, HasSubstr("behind it sea, object \"sea\" (../seas/confused_sea.toml:"));
    const Outcome json = run("why " + scenario + " --frame 560 --at 320,300 --size 640x480 --json");
    EXPECT_EQ(json.exit_code, 0);
    EXPECT_THAT(json.output, HasSubstr("\"object\": \"hull sides\""));
    for (const char* at : {"640,0", "0,480", "1", "1,2,3", "-1,2", "a,b", "4294967296,0"}) {
        const Outcome outside = run("why " + scenario + " --size 640x480 --at=" + at);
        EXPECT_EQ(outside.exit_code, 2) << at;
        EXPECT_THAT(outside.errors, HasSubstr("expected COLUMN,ROW inside the 640 x 480 picture")) << at;
    }
}

TEST(CommandLine, MistakesAreToldOnStderrWithCode2) {
    for (const Mistake& each : {
             Mistake{"", "subcommand is required"},
             Mistake{"dmo", "unknown subcommand 'dmo'; expected one of: demo, "},
             Mistake{"demo --frmes 3", "--frmes"},
             Mistake{"compare a b --foo", "Try 'linkdig compare --help'"},
             Mistake{"--foo", "Try 'linkdig --help'"},
             Mistake{"demo --frames 0", "--frames"},
             Mistake{"demo --headless --size 10", "'10' is no picture size"},
             Mistake{"demo --profile 1979", "--profile"},
             Mistake{"demo --fps 0", "--fps"},
             Mistake{"demo --threads 257", "--threads"},
             Mistake{"render", "scenario is required"},
             Mistake{"render /nowhere.toml", "/nowhere.toml"},
         }) {
        const Outcome outcome = run(each.arguments);
        EXPECT_EQ(outcome.exit_code, 2) << each.arguments;
        EXPECT_EQ(outcome.output, "") << each.arguments;
        EXPECT_THAT(outcome.errors, HasSubstr(each.told)) << each.arguments;
    }
}

/// Each would otherwise be another number than the one that stands there, or none at all.
TEST(CommandLine, NumbersThatAnOptionCannotTakeAreToldWithIt) {
    const std::string whole = "' cannot be taken; expected a whole number, 0 to 18446744073709551615";
    for (const auto& [arguments, option, value, expected] : {
             std::tuple{"render " + scenario, "--edges", "-5", whole},
             std::tuple{"render " + scenario, "--edges", "18446744073709551616", whole},
             std::tuple{"render " + scenario, "--crossings", "-1", whole},
             std::tuple{std::string("demo"), "--lights", "1e3", whole},
             std::tuple{"render " + scenario, "--channel", "-1", whole},
             std::tuple{std::string("demo"), "--seed", "-1", whole},
             std::tuple{"why " + scenario + " --at 1,1", "--frame", "-1", whole},
             std::tuple{"why " + scenario + " --at 1,1", "--channel", "-1", whole},
             std::tuple{std::string("replay x"), "--from", "-3", whole},
             std::tuple{std::string("check x"), "--seed", "-4", whole},
             std::tuple{std::string("check x"), "--view", "-1",
                        std::string("' cannot be taken; expected a whole number, 0 to 999999")},
             std::tuple{std::string("check x"), "--views", "0",
                        std::string("' cannot be taken; expected a whole number, 1 to 1000000")},
             std::tuple{std::string("check x"), "--allow", "nan",
                        std::string("' cannot be taken; expected a number, 0 to 100")},
             std::tuple{std::string("bench"), "--visibility", "nan",
                        std::string("' cannot be taken; expected a number, 0 to 1000000")},
             std::tuple{std::string("bench"), "--live", "inf",
                        std::string("' cannot be taken; expected a number, 1 to 1000")},
             std::tuple{std::string("demo --headless"), "--seconds", "nan",
                        std::string("' cannot be taken; expected a number, 0.1 to 86400")},
             std::tuple{std::string("demo --headless"), "--fps", "nan", std::string()},
             std::tuple{std::string("panel monitor"), "--seconds", "nan",
                        std::string("' cannot be taken; expected a number, 0.1 to 86400")},
             std::tuple{std::string("panel test"), "--step", "nan",
                        std::string("' cannot be taken; expected a number, 0.05 to 60")},
         }) {
        const Outcome outcome = run(arguments + " " + option + " " + value);
        EXPECT_EQ(outcome.exit_code, 2) << arguments << option;
        EXPECT_EQ(outcome.output, "") << arguments << option;
        const std::string told = expected.empty() ? "" : std::string("'") + value + expected;
        EXPECT_THAT(outcome.errors, HasSubstr(std::string("linkdig: error: ") + option + ": " + told))
            << arguments;
    }
}

TEST(CommandLine, OutputThatIsLostIsTheEnvironments) {
    for (const std::string arguments : {"--help", "compile --schema", "compile --schema --json"}) {
        const Outcome full = run(arguments + " >/dev/full");
        EXPECT_EQ(full.exit_code, 3) << arguments;
        EXPECT_THAT(full.errors, HasSubstr("No space left on device")) << arguments;
        const Outcome closed = run(arguments + " >&-");
        EXPECT_EQ(closed.exit_code, 3) << arguments;
        EXPECT_THAT(closed.errors, HasSubstr("Bad file descriptor")) << arguments;
    }
    EXPECT_EQ(run("--help | true").errors, "");
}

TEST(CommandLine, FramesAfterTheScenariosEndAreTold) {
    const TemporaryFolder folder;
    const std::string render = "render " + scenario + " --size 16x16 --out " + folder.text() + " --frames ";
    EXPECT_EQ(run(render + "599").errors, "");
    const Outcome after = run(render + "599:600");
    EXPECT_EQ(after.exit_code, 0);
    EXPECT_EQ(after.errors,
              "linkdig: warning: --frames 599:600: the scenario ends with frame 599, after 20 s\n");
    for (const std::string& command :
         {render + "100000000", "why " + scenario + " --at 1,1 --frame 100000000"}) {
        const Outcome refused = run(command);
        EXPECT_EQ(refused.exit_code, 2) << command;
        EXPECT_THAT(refused.errors,
                    HasSubstr("linkdig: error: frame 100000000 cannot be drawn: channels[0].eye_m has the "
                              "coordinate "))
            << command;
        EXPECT_THAT(refused.errors, HasSubstr("the scenario has the frames 0 to 599 (--frames, --frame)"))
            << command;
    }
}

TEST(CommandLine, ValuesOfRenderAreChecked) {
    EXPECT_THAT(run("render " + scenario + " --planes depth").errors, HasSubstr("no plane named 'depth'"));
    EXPECT_THAT(run("render " + scenario + " --frames 3:2").errors, HasSubstr("'3:2' is no range of frames"));
    const Outcome outcome = run("render " + scenario + " --channel 7");
    EXPECT_THAT(outcome.errors, HasSubstr("there is no channel 7"));
    EXPECT_EQ(outcome.exit_code, 2);
}

/// A slip of the pen would cost an author the work: the source, and what it includes, are no output.
TEST(CommandLine, NoSourceIsOverwritten) {
    const TemporaryFolder folder;
    // Both are named as a compiled file is: other names are refused before.
    const std::string source = folder.file("a.igdb");
    const std::string included = folder.file("b.igdb");
    const std::string words = "include = [\"b.igdb\"]\n[database]\nname = \"a\"\n";
    std::ofstream(source) << words;
    std::ofstream(included) << "[[sun]]\nname = \"sun\"\n";
    for (const std::string& output : {source, included, folder.file("./a.igdb")}) {
        const Outcome outcome = run("compile " + source + " -o " + output);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.errors, HasSubstr(output + " is a file that the database is made of"));
    }
    std::ostringstream left;
    left << std::ifstream(source).rdbuf();
    EXPECT_EQ(left.str(), words);
}

/// What is written is what the name says, or nothing is; what stood there is as it was.
TEST(CommandLine, NamesOfFilesToWriteAreThoseOfTheirKind) {
    const TemporaryFolder folder;
    const std::string database = LINKDIG_SOURCE_DIR "/database/scenes/runway_lights/runway_lights.toml";
    const std::string star = LINKDIG_SOURCE_DIR "/database/scenes/wakes/kelvin/figure22.toml";
    struct Case {
        std::string command;
        std::string name;
        const char* told;
    };
    for (const Case& each : {
             Case{"preview " + database + " -o ", "a.jpg", "that of a PNG picture; expected a name in .png"},
             Case{"preview " + database + " -o ", "a", "that of a PNG picture; expected a name in .png"},
             Case{"preview " + database + " -o " + folder.file("sheet.png") + " --turntable ", "a.gif",
                  "that of an MP4 film; expected a name in .mp4"},
             Case{"check " + database + " --view 1 --picture ", "a.jpg", "that of a PNG picture"},
             Case{"compile " + database + " -o ", "a.db",
                  "that of a compiled database; expected a name in .igdb"},
             Case{"export " + database + " -o ", "a.obj", "a glTF file; expected a name in .gltf or .glb"},
             Case{"wake " + star + " -o ", "a.png", "that of an OpenEXR file; expected a name in .exr"},
             Case{"compare x y --report ", "a.txt", "that of a page; expected a name in .html"},
             Case{"compare x y --junit ", "a.json", "that of a JUnit file; expected a name in .xml"},
             Case{"record " + scenario + " -o ", "a.toml", "flights are made from files of that name"},
             Case{"fly " + scenario + " --record ", "a.toml", "flights are made from files of that name"},
             Case{"fly " + scenario + " --state ", "a.igdb", "flights are made from files of that name"},
             Case{"convert x -o ", "a.igdb", "flights are made from files of that name"},
             Case{"replay x --save-state ", "a.toml", "flights are made from files of that name"},
         }) {
        const std::string path = folder.file(each.name);
        std::ofstream(path) << "as it was";
        const Outcome outcome = run(each.command + path);
        EXPECT_EQ(outcome.exit_code, 2) << each.command;
        EXPECT_EQ(outcome.output, "") << each.command;
        EXPECT_THAT(outcome.errors, HasSubstr("'" + path + "' cannot be written")) << each.command;
        EXPECT_THAT(outcome.errors, HasSubstr(each.told)) << each.command;
        EXPECT_EQ(bytes_of(path), "as it was") << each.command;
    }
    EXPECT_FALSE(std::filesystem::exists(folder.file("sheet.png")));
}

/// What an option asks for is done, or it is said that it cannot be.
TEST(CommandLine, OptionsThatWouldDoNothingAreRefused) {
    struct Case {
        std::string arguments;
        const char* told;
    };
    for (const Case& each : {
             Case{"compile --schema x.toml", "--schema excludes SRC"},
             Case{"compile --schema -o x.igdb", "--schema excludes --output"},
             Case{"compile --schema --watch", "--schema excludes --watch"},
             Case{"bench --wakes --scene sea", "--wakes excludes --scene"},
             Case{"bench --wakes --visibility 100", "--wakes excludes --visibility"},
             Case{"bench --sea-methods --scene sea", "--sea-methods excludes --scene"},
             Case{"bench --sea-methods --live 30", "--sea-methods excludes --live"},
             Case{"bench --sea-methods --threads 2", "--sea-methods excludes --threads"},
             Case{"replay x.rec --hashes --out y", "--hashes excludes --out"},
             Case{"replay x.rec --save-state y --out z", "--save-state excludes --out"},
             Case{"replay x.rec --save-state y --frames 3", "--save-state excludes --frames"},
             Case{"replay x.rec --save-state ''", "'' is no name of a file to write"},
             Case{"render " + scenario + " --planes intensity --display retro",
                  "--display retro photographs the colour plane; expected colour among --planes"},
             Case{"fly " + scenario + " --headless --record ''", "'' is no name of a file to write"},
         }) {
        const Outcome outcome = run(each.arguments);
        EXPECT_EQ(outcome.exit_code, 2) << each.arguments;
        EXPECT_EQ(outcome.output, "") << each.arguments;
        // CLI11 names two that exclude one another in either order.
        std::string swapped = each.told;
        if (const std::size_t at = swapped.find(" excludes "); at != std::string::npos)
            swapped = swapped.substr(at + 10) + " excludes " + swapped.substr(0, at);
        EXPECT_THAT(outcome.errors, testing::AnyOf(HasSubstr(each.told), HasSubstr(swapped)))
            << each.arguments;
    }
}

TEST(CommandLine, AFileThatIsReadIsNotWritten) {
    const TemporaryFolder folder;
    const std::string flight = folder.file("flight.rec");
    ASSERT_EQ(run("record " + scenario + " --frames 2 -o " + flight).exit_code, 0);
    const std::string before = bytes_of(flight);
    std::filesystem::create_symlink(flight, folder.file("link"));
    for (const std::string& command :
         {"convert " + flight + " -o " + flight, "convert " + flight + " -o " + folder.file("link"),
          "replay " + flight + " --save-state " + flight,
          "record " + scenario + " --state " + flight + " -o " + flight}) {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.exit_code, 2) << command;
        EXPECT_THAT(outcome.errors, HasSubstr("it is read, too; expected the name of another file"))
            << command;
        EXPECT_EQ(bytes_of(flight), before) << command;
    }
    EXPECT_EQ(run("replay " + flight + " --hashes --save-state " + folder.file("s")).exit_code, 2);
}

TEST(CommandLine, AFolderThatCannotBeMadeIsTheEnvironments) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("file")) << "in the way";
    const std::string out = folder.file("file/below");
    const Outcome demo = run("demo --headless --frames 1 --size 16x16 --out " + out);
    EXPECT_EQ(demo.exit_code, 3);
    EXPECT_THAT(demo.errors, HasSubstr(out + ": cannot be made"));
    const Outcome render = run("render " + scenario + " --size 16x16 --out " + out);
    EXPECT_EQ(render.exit_code, 3);
    EXPECT_THAT(render.errors, HasSubstr(out + ": cannot be made"));
}

TEST(CommandLine, ScenesThatAreNotThereAreNamed) {
    const TemporaryFolder folder;
    setenv("LINKDIG_SCENES", folder.file("none").c_str(), 1);
    const Outcome outcome = run("demo --headless --frames 1");
    unsetenv("LINKDIG_SCENES");
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.errors,
                HasSubstr("LINKDIG_SCENES names " + folder.file("none") + ", which is no folder"));
}

/// What has no place in a file is said by the program.
TEST(CommandLine, MistakesWithoutAPlaceBeginWithTheProgramsName) {
    const TemporaryFolder folder;
    const std::string flight = folder.file("flight.rec");
    ASSERT_EQ(run("record " + scenario + " --frames 1 -o " + flight).exit_code, 0);
    std::ofstream(folder.file("cut.igdb")) << "cut";
    const std::string database = "'" LINKDIG_SOURCE_DIR "/database/scenes/runway_lights/runway_lights.toml'";
    for (const auto& [command, exit_code] :
         {std::pair("inspect " + folder.file("cut.igdb"), 2),
          std::pair("preview " + folder.file("cut.igdb") + " -o " + folder.file("a.png"), 2),
          std::pair("compile " + database + " -o " + folder.file("none/a.igdb"), 3),
          std::pair("replay " + flight + " --database " + folder.file("none.igdb"), 2),
          std::pair("replay " + flight + " --from 1", 2), std::pair("replay " + folder.file("none.rec"), 2),
          std::pair("record " + scenario + " -o " + folder.file("b.rec") + " --state " + folder.file("none"),
                    2),
          std::pair("convert " + folder.file("none") + " -o " + folder.file("b.rec"), 2),
          std::pair("compare " + folder.file("none") + " " + flight, 2)}) {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.exit_code, exit_code) << command;
        EXPECT_EQ(outcome.output, "") << command;
        EXPECT_THAT(outcome.errors, testing::MatchesRegex("linkdig: error: [^\n]*\n")) << command;
    }
}

TEST(CommandLine, AMistakeInAScenarioHasItsPlace) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("wrong.toml")) << "[scenario]\nname = 3\n";
    const Outcome outcome = run("render " + folder.file("wrong.toml") + " --out " + folder.file("out"));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr(folder.file("wrong.toml") + ":2:8: error: "));
    EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

} // namespace
} // namespace linkdig::tools
