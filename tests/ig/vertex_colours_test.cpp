// Faces whose corners have colours: three interpolants that do what the one does.

#include "database/model/random.h"
#include "ig/machine/machine.h"
#include "ig/video/colour_run.h"
#include "tests/database/compiler/authored.h"
#include "tests/ig/small_database.h"
#include "tests/support/picture_comparison.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side = 64;

/// Objects of a list without ambient light, seen from the origin along x.
VisualDatabase compiled(const std::string& objects) {
    const database::CompileResult result = database::compile_text(
        "[database]\nname = \"t\"\n[[colour]]\nname = \"white\"\nrgb = [255, 255, 255]\n[[colour]]\nname = "
        "\"odd\"\n"
        "rgb = [201, 87, 33]\n[[sun]]\nname = \"sun\"\n[[cluster]]\nname = \"cluster\"\npriority = 1\n"
        "[[object_list]]\nname = \"list\"\ncluster = \"cluster\"\nsun = \"sun\"\nambient = 0.0\ndiffuse = "
        "1.0\n" +
        objects);
    EXPECT_TRUE(result.database) << database::messages(result);
    return result.database.value_or(VisualDatabase{});
}

/// A wall across the line of sight, seen from one end to the other; counter-clockwise from the eye.
std::string wall(const std::string& more) {
    return "[[object]]\nname = \"wall\"\nlist = \"list\"\ncolour = \"odd\"\n" + more +
           "vertices_m = { a = [10, 8, -8], b = [10, -8, -8], c = [10, -8, 8], d = [10, 8, 8] }\n"
           "[[object.face]]\ncorners = [\"a\", \"b\", \"c\", \"d\"]\n";
}

/// A floor under and behind the eye: cut at the near plane.
std::string ground(const std::string& more) {
    return "[[object]]\nname = \"floor\"\nlist = \"list\"\ncolour = \"odd\"\n" + more +
           "vertices_m = { a = [-30, -40, -2], b = [60, -40, -2], c = [60, 40, -2], d = [-30, 40, -2] }\n"
           "[[object.face]]\ncorners = [\"a\", \"b\", \"c\", \"d\"]\n";
}

struct Look {
    bool smoothing = false;
    float visibility_m = 0;
    Scan scan = Scan::horizontal;
    std::uint32_t threads = 1;
    std::int32_t colour = none; ///< of the list, sent by the host
};

VideoFrame picture_of(const VisualDatabase& database, const Look& look = {}) {
    Configuration configuration;
    configuration.raster = {side, side, look.scan};
    configuration.edge_smoothing = look.smoothing;
    configuration.threads = look.threads;
    Machine machine(database, configuration);
    machine.draw_planes(true, true);
    FramePacket packet;
    packet.channels = {channel_at({0, 0, 0})};
    packet.channels[0].left_tangent = packet.channels[0].bottom_tangent = -1;
    packet.channels[0].right_tangent = packet.channels[0].top_tangent = 1;
    packet.suns = {{0, 0, 1}};
    packet.visibility_m = look.visibility_m;
    if (look.colour != none)
        packet.lighting = {{.list = 0, .sun = 0, .ambient = 0, .diffuse = 1, .colour = look.colour}};
    EXPECT_TRUE(machine.frame(packet).errors.empty());
    return machine.picture(0);
}

std::uint32_t component(std::uint32_t pixel, unsigned k) { return pixel >> (8 * k) & 255U; }

/// The whole variety of ways that a run of pixels is drawn.
std::vector<Look> looks() {
    std::vector<Look> all;
    for (const bool smoothing : {false, true})
        for (const float visibility : {0.0F, 40.0F, 4000.0F}) // clear, by the pixel, flat over a face
            for (const Scan scan : {Scan::horizontal, Scan::vertical})
                all.push_back({.smoothing = smoothing, .visibility_m = visibility, .scan = scan});
    return all;
}

TEST(VertexColours, EachComponentIsLinearOnTheScreen) {
    // The wall stands across the line of sight: what is linear on it is linear on the screen.
    const VisualDatabase database = compiled(wall("shading = \"none\"\ncolours = { a = [0, 0, 0], b = [240, "
                                                  "0, 60], c = [240, 240, 60], d = [0, 240, 0] }\n"));
    const VideoFrame frame = picture_of(database);
    int compared = 0;
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const std::uint32_t pixel = frame.pixels[row * side + column];
            if (frame.rank[row * side + column] == none) continue;
            const double right = ((column + 0.5) / side * 2 - 1) * 10 / 16 + 0.5; // 0 to 1 across the wall
            const double up = (1 - (row + 0.5) / side * 2) * 10 / 16 + 0.5;
            EXPECT_NEAR(component(pixel, 0), 240 * right, 1);
            EXPECT_NEAR(component(pixel, 1), 240 * up, 1);
            EXPECT_NEAR(component(pixel, 2), 60 * right, 1);
            ++compared;
        }
    EXPECT_GT(compared, 1500);
}

/// Equal colours at all corners are the colour code itself, wherever and however the face is drawn.
TEST(VertexColours, OneColourAtEveryCornerIsThePlainFace) {
    const std::string same = "colours = { a = \"odd\", b = \"odd\", c = [201, 87, 33], d = \"odd\" }\n";
    for (const std::string shading : {"none", "face", "vertex"}) {
        const std::string shaded =
            "shading = \"" + shading + "\"\n" +
            "normals = { a = [0, 0, 1], b = [0, 1, 1], c = [0, -3, 1], d = [0, 1, 2] }\n";
        for (const Look& look : looks()) {
            for (const bool floor : {false, true}) {
                const auto make = [&](const std::string& more) {
                    return compiled(floor ? ground(shaded + more) : wall(shaded + more));
                };
                const VideoFrame plain = picture_of(make(""), look);
                const VideoFrame coloured = picture_of(make(same), look);
                const support::PictureDifference difference = support::compare(plain, coloured);
                EXPECT_LE(difference.worst_level, 1U) << shading << (floor ? " floor " : " wall ")
                                                      << look.smoothing << look.visibility_m << "\n"
                                                      << difference.explanation;
            }
        }
    }
}

/// White corners of different intensity and grey corners of intensity 1 are one picture.
TEST(VertexColours, GreyCornersAreIntensities) {
    // Normals whose cosine to the sun above is a whole number of 255ths: 51/255 = 0.2, 204/255 = 0.8 and so on.
    const auto normal = [](double cosine) {
        return fmt::format("[{:.12f}, 0, {:.12f}]", std::sqrt(1 - cosine * cosine), cosine);
    };
    const std::string normals = fmt::format("normals = {{ a = {}, b = {}, c = {}, d = {} }}\n", normal(0.2),
                                            normal(0.8), normal(1), normal(0.6));
    const std::string greys = "colours = { a = [51, 51, 51], b = [204, 204, 204], c = [255, 255, 255], "
                              "d = [153, 153, 153] }\n";
    for (const Look& look : looks()) {
        for (const bool floor : {false, true}) {
            const auto make = [&](const std::string& more) {
                return compiled(floor ? ground(more) : wall(more));
            };
            const VideoFrame lit = picture_of(make("shading = \"vertex\"\n" + normals + "two_sided = true\n" +
                                                   "colours = { a = \"white\", b = \"white\", c = \"white\", "
                                                   "d = \"white\" }\n"),
                                              look);
            const VideoFrame grey =
                picture_of(make("shading = \"none\"\n" + greys + "two_sided = true\n"), look);
            EXPECT_LE(support::compare(lit, grey).worst_level, 1U);
        }
    }
}

TEST(VertexColours, TheHostsColourOverridesThem) {
    const std::string corners = "shading = \"none\"\ncolours = { a = [9, 9, 9], b = [99, 9, 9] }\n";
    const VideoFrame frame = picture_of(compiled(wall(corners)), {.colour = 0});
    EXPECT_EQ(frame.pixels[side * side / 2 + side / 2], 0xffffffffU);
}

TEST(VertexColours, ThreadsAndScansAgree) {
    const VisualDatabase database = compiled(ground("shading = \"none\"\ncolours = { a = [250, 0, 0], b = "
                                                    "[0, 250, 0], c = [0, 0, 250], d = [250, 250, 0] }\n"));
    for (Look look : looks()) {
        const VideoFrame one = picture_of(database, look);
        look.threads = 3;
        EXPECT_EQ(picture_of(database, look).pixels, one.pixels);
    }
}

TEST(VertexColours, AnEqualTintIsAGreyShade) {
    for (std::int32_t intensity = 0; intensity <= intensity_one; intensity += 4099) {
        EXPECT_EQ(shade(Tint{intensity, intensity, intensity}), shade({255, 255, 255, 0}, intensity));
        EXPECT_EQ(lit(Tint{intensity, 0, 0}).red, lit({255, 0, 0, 0}, intensity).red);
    }
}

} // namespace
} // namespace linkdig::ig
