/// The film that the report delivered: every method in turn, titled.

#include "tools/film/film.h"
#include "tools/figures/figures.h"
#include "tools/figures/stage.h"
#include "tools/sheet/contact_sheet.h"
#include "tools/sheet/text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace linkdig::tools {
namespace {

using host::Signal;
using host::SignalValues;

struct Setting {
    Signal signal = Signal::freeze;
    double value = 0.0;
};

struct Scene {
    const char* scenario;
    const char* title;
    std::array<Setting, 4> settings{};
};

constexpr Setting no_faces{Signal::face_substitution, 1.0}; // change-overs of what methods.toml shows
constexpr Setting no_churn{Signal::churned, 1.0};
constexpr Setting even_keel{Signal::ship_motion, 0.0};

constexpr std::array scenes{
    Scene{"report/mounds_smooth.toml", "3.1.1  Static 3D waves, smooth-shaded: washed out"},
    Scene{"report/mounds_switched.toml", "3.1.2  3D waves switched in and out"},
    Scene{"report/regular_smooth.toml", "3.1.3  A static 2D pattern, smooth-shaded"},
    Scene{"report/confused.toml",
          "3.1.4  Dynamic 2D sea, smooth shading off",
          {{{Signal::smooth_shading, 0.0}, {Signal::sea_state, 3.0}}}},
    Scene{"report/confused.toml",
          "3.1.4  Dynamic 2D sea, random normals: sea state 1-2",
          {{{Signal::sea_state, 2.0}}}},
    Scene{"report/confused.toml",
          "3.1.4  The same: sea state 3",
          {{{Signal::sea_state, 3.0}, {Signal::sea_sun_rate, 1.6}}}},
    Scene{"report/swell.toml", "3.1.4  A sine wave on all rows: swell"},
    Scene{"report/methods.toml",
          "3.2.1  Wake: a white V",
          {{no_faces, no_churn, {Signal::white_v, 1.0}, even_keel}}},
    Scene{"report/methods.toml",
          "3.2.2  Bow wake: rolling cams",
          {{no_faces, no_churn, {Signal::cam, 1.0}, even_keel}}},
    Scene{"report/methods.toml", "3.2.2  Bow wake: 28 faces, one at a time", {{no_churn, even_keel}}},
    Scene{"report/methods.toml", "3.2.3  Bow and stern wake: churned water, added to the sea", {{even_keel}}},
    Scene{"report/methods.toml",
          "3.3.1  Hull below the waterline: she floats on her keel",
          {{{Signal::occulting, 3.0}}}},
    Scene{"report/methods.toml", "3.3.1.1  Moving box", {{{Signal::occulting, 5.0}}}},
    Scene{"report/methods.toml", "3.3.1.2  Wedges driven by pitch", {{{Signal::occulting, 6.0}}}},
    Scene{"report/methods.toml",
          "3.3.2  Modelled to the waterline: what the report recommends",
          {{{Signal::occulting, 2.0}}}},
};

/// "3.2.1" of "3.2.1  Wake: a white V": the picture bears the whole title.
std::string section_of(std::string_view title) { return std::string(title.substr(0, title.find("  "))); }

} // namespace

void film(const Findings& findings, double seconds) {
    if (!video_files()) return;
    constexpr std::uint32_t rate = 30;
    constexpr StageOptions options{.width = 640, .height = 480, .edge_smoothing = true};
    const GlyphSheet glyphs = glyph_sheet(16);
    Film film(findings.folder() + "/report.mp4", options.width, options.height, rate);
    const auto frames = static_cast<std::uint64_t>(std::lround(seconds * rate / scenes.size()));
    ContactSheet sheet("The film: each scene after two seconds", options.width, options.height, 4);
    std::uint32_t place = 0;
    for (const Scene& scene : scenes) {
        Stage stage(scene.scenario, options);
        SignalValues signals;
        for (const Setting& each : scene.settings)
            signals.set(each.signal, each.value);
        for (std::uint64_t frame = 0; frame < frames; ++frame) {
            ig::VideoFrame picture = stage.draw(stage.packet(frame, signals));
            write_over(picture, scene.title, glyphs);
            film.add(picture);
            if (frame == frames / 2) sheet.place(place++, picture, section_of(scene.title));
        }
    }
    film.finish();
    sheet.write(findings.folder() + "/film.png");
}

} // namespace linkdig::tools
