#include "database/compiler/wake_spec.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace linkdig::database {
namespace {

using testing::HasSubstr;

const std::string field = "[field]\ncells = 64\nside_m = 32.0\n";
const std::string boat = "[[swimmer]]\nname = \"boat\"\nspeed_mps = 2.0\n";
const std::string line = "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[1.0, 2.0], [30.0, 2.0]]\n";

std::string mistakes(const std::string& text) {
    const auto path =
        std::filesystem::temp_directory_path() /
        (std::string("linkdig_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml");
    std::ofstream(path) << text;
    Diagnostics diagnostics;
    const auto spec = read_wake_spec(path.string(), diagnostics);
    std::filesystem::remove(path);
    EXPECT_EQ(spec.has_value(), !diagnostics.any());
    return diagnostics.text();
}

TEST(WakeSpec, MistakesAreToldWithTheirLine) {
    EXPECT_EQ(mistakes(field + boat + line), "");
    EXPECT_THAT(mistakes(field), HasSubstr("no [[swimmer]]; expected at least one"));
    EXPECT_THAT(mistakes(field + boat),
                HasSubstr("the path of \"boat\" has no piece; expected at least one"));
    struct Case {
        std::string text;
        const char* told;
    };
    for (const Case& each : {
             Case{"[[swimmer]]\nname = \"b\"\nspeed_mps = 0.0\n" + line, ":6:13: error: "},
             Case{"[[swimmer]]\nname = \"b\"\nspeed_mps = nan\n" + line, ":6:13: error: "},
             Case{boat + line + boat + line,
                  ":11:8: error: a second [[swimmer]] is named \"boat\"; expected another name"},
             Case{boat + "damping_per_s = -1.0\n" + line, ":7:17: error: "},
             Case{boat + "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[1.0, 2.0], [1.0, 2.0]]\n",
                  "the path of \"boat\" piece 1 has no length"},
             Case{boat + "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[1.0, 2.0], [1.0, nan]]\n", ":9:"},
             Case{boat + "[[swimmer.path]]\nkind = \"loop\"\n",
                  "expected one of \"line\", \"arc\", \"spiral\", \"bezier\", \"spline\""},
             Case{boat + "[[swimmer.path]]\nkind = \"bezier\"\npoints_m = [[1.0, 2.0], [1.0, 3.0]]\n",
                  "a bezier has 2 points; expected 4"},
             Case{boat + "[[swimmer.path]]\nkind = \"arc\"\ncentre_m = [1.0]\nradius_m = 3.0\nfrom_deg = "
                         "0.0\nto_deg = 9.0\n",
                  "\"centre_m\" is an array; expected [x, y], two finite numbers"},
             Case{boat + line + "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[1.0, 2.0], [3.0, 2.0]]\n",
                  "piece 2 begins at (1, 2); expected (30, 2)"},
             Case{boat + line + "[sampling]\npsi_per_cell = 10000.0\nu_steps = 1000000\n",
                  "samples; expected at most 2e+10"},
             Case{boat + line + "[sampling]\nu_steps = 1000000000\n",
                  ":11:11: error: \"u_steps\" is 1000000000; expected 2 to 1000000"},
             Case{boat + "[[swimmer.path]]\nkind = \"line\"\npoints_m = [[0.0, 0.0], [1e9, 0.0]]\n",
                  "samples; expected at most 2e+10"},
             Case{boat + line + "[sampling]\nkind = \"odd\"\n", "\"kind\" is \"odd\"; expected one of"},
         }) {
        EXPECT_THAT(mistakes(field + each.text), HasSubstr(each.told)) << each.text;
    }
}

TEST(WakeSpec, EveryShippedOneMakesWaves) {
    std::size_t specs = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(LINKDIG_SOURCE_DIR "/database/scenes/wakes/kelvin")) {
        const std::string name = entry.path().stem().string();
        if (!name.starts_with("figure") || name.find("_") != std::string::npos) continue;
        SCOPED_TRACE(entry.path().filename().string());
        Diagnostics diagnostics;
        auto spec = read_wake_spec(entry.path().string(), diagnostics);
        ASSERT_TRUE(spec) << diagnostics.text();
        ++specs;
        spec->wakes.psi_per_unit *= 0.25; // a small form of each
        spec->wakes.size /= 4;
        const WakeFieldResult made = wake_field(*spec);
        EXPECT_GT(made.rms, 0.01);
    }
    EXPECT_GE(specs, 15U);
}

} // namespace
} // namespace linkdig::database
