// Light points: a splat's total is constant, faces in front hide it, beams and flashes follow their definitions.

#include "tests/ig/small_database.h"

#include "database/model/mathematics.h"
#include "ig/geometry/project_lights.h"
#include "ig/lights/splat.h"
#include "ig/machine/machine.h"
#include "ig/simd/simd_level.h"
#include "ig/video/pixel_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace linkdig::ig {
namespace {

/// Light points in a static list of their own, group 0 (before everything that add_box puts into later groups), and an
/// empty world.
VisualDatabase lights_database(const std::vector<LightPoint>& lights) {
    VisualDatabase d;
    d.name = "lights";
    d.source_files = {"made in code"};
    d.colours = {{255, 255, 255, 0}, {200, 100, 40, 0}, {0, 0, 255, 0}, {60, 60, 60, 0}};
    d.colour_names = {"white", "amber", "blue", "grey"};
    d.suns = {"sun"};
    d.groups = {{.number = 1, .root = none}, {.number = 2, .root = none}, {.number = 3, .root = none}};
    d.clusters.push_back({.name = "lights", .group = 1, .root = leaf_reference(0)});
    d.lists.push_back({.name = "lights", .root = leaf_reference(0)});
    d.objects.push_back({.name = "lights"});
    d.run_leaves.push_back({0, 1});
    d.runs.push_back({.radius = -1, .light_count = static_cast<std::uint32_t>(lights.size())});
    d.lights = lights;
    return d;
}

FramePacket packet_of(const VisualDatabase& database, const ChannelView& view) {
    FramePacket packet;
    packet.channels = {view};
    packet.suns = {Vec3f(0, 0, 1)};
    packet.sky = {0, 0, 0};
    packet.moving_objects.resize(database.moving_objects.size());
    return packet;
}

/// A view whose pixels are a milliradian: a light at (1000, -x, z) m stands x pixels right of the middle.
ChannelView fine_view(double width, double height) {
    ChannelView view;
    view.left_tangent = -width / 2000.0;
    view.right_tangent = width / 2000.0;
    view.bottom_tangent = -height / 2000.0;
    view.top_tangent = height / 2000.0;
    return view;
}

std::uint64_t sum_of_red(const VideoFrame& picture) {
    std::uint64_t sum = 0;
    for (const std::uint32_t pixel : picture.pixels)
        sum += pixel & 0xffU;
    return sum;
}

Configuration small_machine(Scan scan = Scan::horizontal, std::uint32_t side = 64) {
    Configuration configuration;
    configuration.raster = {side, side, scan};
    configuration.threads = 1;
    return configuration;
}

TEST(Splat, WeightsSumToTheWholeAtEverySixteenthOfAPixel) {
    Splats splats;
    const Raster raster{64, 64, Scan::horizontal};
    for (const std::int32_t radius : {least_splat_radius, 3 * 256 + 77, greatest_splat_radius}) {
        std::uint32_t brightest = 0;
        std::uint32_t dimmest = whole_splat;
        for (std::int32_t down = 0; down <= 256; down += 16) {
            for (std::int32_t right = 0; right <= 256; right += 16) {
                const ProjectedLight light{.at = {32 * 256 + down, 31 * 256 + right}, .radius = radius};
                make_splats({&light, 1}, raster, 32, splats);
                std::uint64_t sum = 0;
                std::uint32_t peak = 0;
                for (const SplatPixel& pixel : splats.pixels) {
                    sum += pixel.weight;
                    peak = std::max(peak, pixel.weight);
                }
                ASSERT_EQ(sum, whole_splat) << radius << " " << down << " " << right;
                brightest = std::max(brightest, peak);
                dimmest = std::min(dimmest, peak);
            }
        }
        EXPECT_LT(brightest, 2 * dimmest)
            << "a light that moves keeps its brightest pixel within a factor of two";
    }
}

TEST(Splat, IsRoundAndFallsFromItsMiddle) {
    Splats splats;
    const ProjectedLight light{.at = {32 * 256 + 128, 32 * 256 + 128}, .radius = 10 * 256};
    make_splats({&light, 1}, {64, 64, Scan::horizontal}, 64, splats);
    for (const SplatPixel& pixel : splats.pixels) {
        const double r2 = std::pow(pixel.line - 32.0, 2) + std::pow(pixel.element - 32.0, 2);
        ASSERT_LT(r2, 100.0);
        // The bump (R^2 - r^2)^2 over its integral pi R^6 / 3.
        const double expected = 65536.0 * std::pow(100.0 - r2, 2) * 3.0 / (pi * 1e6);
        EXPECT_NEAR(pixel.weight, expected, 2.0 + 0.002 * expected);
    }
}

TEST(Splat, ABandOwnsItsLines) {
    Splats splats;
    std::vector<ProjectedLight> lights(5, {.at = {32 * 256, 10 * 256}, .radius = least_splat_radius});
    lights[4].at = {-100, -100}; // a corner of it is in the picture
    make_splats(lights, {64, 64, Scan::horizontal}, 32, splats);
    EXPECT_EQ(splats.of(0).size(), 5U);
    EXPECT_EQ(splats.of(1).size(), 4U);
    for (const std::size_t band : {0U, 1U})
        for (const BandLight& light : splats.of(band))
            for (std::uint32_t k = 0; k < light.pixel_count; ++k)
                EXPECT_EQ(splats.pixels[light.first_pixel + k].line / 32, band);
}

TEST(LightPoints, KeepTheirTotalWhereverBetweenPixelsTheyStand) {
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        for (int sixteenth = 0; sixteenth <= 32; ++sixteenth) {
            const double x = sixteenth / 16.0;
            const VisualDatabase d =
                lights_database({{.position = {1000.0F, static_cast<float>(-x), static_cast<float>(0.5 * x)},
                                  .intensity = 1.0F}});
            Machine machine(d, small_machine(scan));
            const FrameReport& report = machine.frame(packet_of(d, fine_view(64, 64)));
            ASSERT_TRUE(report.errors.empty()) << report.errors[0];
            EXPECT_EQ(report.channels[0].lights_active, 1U);
            EXPECT_EQ(report.channels[0].lights, 1U);
            // One pixel's worth of 255, each of at most 16 pixels rounded by half a level.
            EXPECT_NEAR(static_cast<double>(sum_of_red(machine.picture(0))), 255.0, 8.0) << x;
        }
    }
}

TEST(LightPoints, AddToWhatIsSeenAndClampOnce) {
    // Twelve dim lights at one place: each alone would round to nothing, together they show; many saturate.
    LightPoint dim{.position = {1000, 0.5F, 0.5F}, .intensity = 0.00392F};
    for (const std::size_t count : {12U, 200000U}) {
        VisualDatabase d = lights_database(std::vector<LightPoint>(count, dim));
        Machine machine(d, small_machine());
        FramePacket packet = packet_of(d, fine_view(64, 64));
        packet.sky = {0.5F, 0.5F, 0.5F};
        machine.frame(packet);
        const std::uint32_t middle = machine.picture(0).pixels[31 * 64 + 31] & 0xffU;
        if (count == 12) {
            EXPECT_NEAR(middle, 128 + 12 * 0.00392 * 255 * 0.44, 1.0);
        } else {
            EXPECT_EQ(middle, 255U);
        }
        EXPECT_EQ(machine.picture(0).pixels[0] & 0xffU, 128U);
    }
}

TEST(LightPoints, FacesInFrontHideThemAndFacesBehindDoNot) {
    const LightPoint light{.position = {100, 0, 0}, .intensity = 3.0F};
    for (const bool smoothing : {false, true}) {
        for (const auto& [group, from, shown] : {std::tuple{0U, -5.0F, 0.0}, std::tuple{2U, -5.0F, 1.0},
                                                 std::tuple{0U, 0.2F, 1.0}, std::tuple{0U, 0.0F, 0.5}}) {
            VisualDatabase d = lights_database({light});
            // A black wall before the light, from y = `from` to the left; in the sky's colour, so that only lights show.
            d.colours[3] = {0, 0, 0, 0};
            add_box(d, {.from = {90, from, -5}, .to = {91, 6, 5}, .colour = 3, .group = group});
            Configuration configuration = small_machine();
            configuration.edge_smoothing = smoothing;
            Machine machine(d, configuration);
            ChannelView view = fine_view(64, 64);
            const FrameReport& report = machine.frame(packet_of(d, view));
            ASSERT_TRUE(report.errors.empty()) << report.errors[0];
            EXPECT_NEAR(static_cast<double>(sum_of_red(machine.picture(0))), shown * 3.0 * 255.0, 8.0)
                << smoothing << " " << group << " " << from;
            EXPECT_EQ(report.channels[0].light_pixels == 0, shown == 0.0);
        }
    }
}

TEST(LightPoints, BehindASmoothedEdgeShineByTheShareThatIsLeft) {
    // The wall's edge crosses the light's brightest pixels: its light grows as the edge moves away, by area.
    const LightPoint light{.position = {100, 0, 0}, .intensity = 1.0F};
    double before = -1.0;
    for (int step = -32; step <= 32; step += 4) {
        VisualDatabase d = lights_database({light});
        d.colours[3] = {0, 0, 0, 0};
        const float edge = static_cast<float>(step) / 160.0F; // sixteenths of a pixel at 100 m
        add_box(d, {.from = {100, edge, -5}, .to = {101, 6, 5}, .colour = 3, .group = 0});
        Configuration configuration = small_machine();
        configuration.edge_smoothing = true;
        Machine machine(d, configuration);
        machine.frame(packet_of(d, fine_view(64, 64)));
        const auto sum = static_cast<double>(sum_of_red(machine.picture(0)));
        EXPECT_GE(sum, before - 4.0) << step;
        before = sum;
        if (step == 0) {
            EXPECT_NEAR(sum, 127.5, 6.0);
        }
    }
    EXPECT_NEAR(before, 255.0, 8.0);
}

TEST(LightPoints, ShineThroughSemiOpaqueFacesByWhatTheseLeave) {
    VisualDatabase d = lights_database({{.position = {100, 0, 0}, .intensity = 4.0F}});
    d.colours[3] = {0, 0, 0, 0};
    add_box(d, {.from = {90, -5, -5}, .to = {91, 5, 5}, .colour = 3, .group = 0});
    for (Face& face : d.faces)
        face.opacity = 64;
    Machine machine(d, small_machine());
    machine.frame(packet_of(d, fine_view(64, 64)));
    EXPECT_NEAR(static_cast<double>(sum_of_red(machine.picture(0))), 0.75 * 4 * 255, 10.0);
}

TEST(LightPoints, ATableOfColoursDimsFacesAndNotLights) {
    VisualDatabase d = lights_database({{.position = {100, 0, 0}, .intensity = 1.0F}});
    add_box(d, {.from = {110, -50, -50}, .to = {111, 50, 50}, .colour = 0, .group = 2});
    Machine machine(d, small_machine());
    FramePacket packet = packet_of(d, fine_view(64, 64));
    packet.colours.assign(d.colours.size(), Colour{10, 10, 10, 0});
    ASSERT_TRUE(machine.frame(packet).errors.empty());
    EXPECT_NEAR(static_cast<double>(sum_of_red(machine.picture(0))), 10.0 * 64 * 64 + 255.0, 8.0);
    packet.light_points = 0.5F;
    machine.frame(packet);
    EXPECT_NEAR(static_cast<double>(sum_of_red(machine.picture(0))), 10.0 * 64 * 64 + 127.5, 8.0);
    packet.colours.pop_back();
    EXPECT_EQ(machine.frame(packet).errors.size(), 1U);
}

// ---- beams ------------------------------------------------------------------------------------------------------------

LightPoint beam(LightBeam kind, double across_deg, double upward_deg) {
    const auto steepness = [](double deg) {
        const double t = tangent(radians(deg));
        return static_cast<float>(1.0 / (t * t));
    };
    return {.direction = {1, 0, 0},
            .across = steepness(across_deg),
            .side = {0, 1, 0},
            .upward = steepness(upward_deg),
            .beam = kind};
}

TEST(Beam, FallsToHalfAtItsHalfAngles) {
    const LightPoint light = beam(LightBeam::one_way, 20.0, 5.0);
    bool back = false;
    EXPECT_NEAR(beam_part(light, {7, 0, 0}, back), 1.0, 1e-6);
    EXPECT_NEAR(beam_part(light, direction(radians(20.0), 0.0), back), 0.5, 1e-6);
    EXPECT_NEAR(beam_part(light, direction(radians(-20.0), 0.0), back), 0.5, 1e-6);
    EXPECT_NEAR(beam_part(light, direction(0.0, radians(5.0)), back), 0.5, 1e-6);
    EXPECT_NEAR(beam_part(light, direction(0.0, radians(-5.0)), back), 0.5, 1e-6);
    for (double deg = 0.0; deg < 180.0; deg += 3.0) {
        const double t = std::tan(radians(deg)) / std::tan(radians(20.0));
        const double expected = deg < 90.0 ? std::max(0.0, 1.0 - 0.5 * t * t) : 0.0;
        EXPECT_NEAR(beam_part(light, direction(radians(deg), 0.0), back), expected, 1e-6) << deg;
        EXPECT_FALSE(back);
    }
}

TEST(Beam, ASecondBeamShinesTheOtherWay) {
    const LightPoint light = beam(LightBeam::two_way, 20.0, 20.0);
    bool back = false;
    EXPECT_NEAR(beam_part(light, direction(pi - radians(20.0), 0.0), back), 0.5, 1e-6);
    EXPECT_TRUE(back);
    EXPECT_NEAR(beam_part(light, direction(radians(20.0), 0.0), back), 0.5, 1e-6);
    EXPECT_FALSE(back);
    EXPECT_EQ(beam_part(light, {0, 1, 0}, back), 0.0);
}

TEST(Beam, IsSeenInThePictureAsComputed) {
    // An eye that goes round the light in steps of five degrees, 100 m off.
    LightPoint light = beam(LightBeam::two_way, 30.0, 30.0);
    light.back_colour = 2; // blue: no red in it
    light.intensity = 4.0F;
    VisualDatabase d = lights_database({light});
    d.colours[2] = {0, 0, 255, 0};
    Machine machine(d, small_machine());
    for (double deg = 0.0; deg < 360.0; deg += 5.0) {
        ChannelView view = fine_view(64, 64);
        view.eye_m = 100.0 * direction(radians(deg), 0.0);
        view.attitude.heading_rad = radians(deg) + pi;
        machine.frame(packet_of(d, view));
        const double t = std::tan(radians(deg)) / std::tan(radians(30.0));
        const double expected =
            std::fabs(std::cos(radians(deg))) < 1e-6 ? 0.0 : std::max(0.0, 1.0 - 0.5 * t * t);
        const bool front = std::cos(radians(deg)) > 0.0;
        std::uint64_t blue = 0;
        for (const std::uint32_t pixel : machine.picture(0).pixels)
            blue += pixel >> 16U & 0xffU;
        EXPECT_NEAR(static_cast<double>(sum_of_red(machine.picture(0))), front ? 4 * 255 * expected : 0.0,
                    8.0)
            << deg;
        EXPECT_NEAR(static_cast<double>(blue), 4 * 255 * expected, 8.0) << deg;
    }
}

// ---- distance, size, air, time ----------------------------------------------------------------------------------------

double total_at(const LightPoint& modelled, double range_m, float visibility_m = 0.0F) {
    LightPoint light = modelled;
    light.position = {static_cast<float>(range_m), 0, 0};
    const VisualDatabase d = lights_database({light});
    Machine machine(d, small_machine());
    FramePacket packet = packet_of(d, fine_view(64, 64));
    packet.visibility_m = visibility_m;
    machine.frame(packet);
    return static_cast<double>(sum_of_red(machine.picture(0))) / 255.0;
}

TEST(LightPoints, WeakenWithDistanceAsAuthored) {
    LightPoint light{.intensity = 3.0F, .full_to_m = 1000.0F};
    EXPECT_NEAR(total_at(light, 9000.0), 3.0, 0.03);
    light.fall_off = FallOff::linear;
    EXPECT_NEAR(total_at(light, 999.0), 3.0, 0.03);
    EXPECT_NEAR(total_at(light, 3000.0), 1.0, 0.03);
    light.fall_off = FallOff::square;
    EXPECT_NEAR(total_at(light, 2000.0), 0.75, 0.03);
}

TEST(LightPoints, AreExtinguishedByTheAirAndBringNoHorizon) {
    const LightPoint light{.intensity = 3.0F};
    for (const double range : {100.0, 1000.0, 2000.0})
        EXPECT_NEAR(total_at(light, range, 2000.0F), 3.0 * std::exp(-2.996 * range / 2000.0), 0.03) << range;
}

TEST(LightPoints, GrowWhenTheyAreNear) {
    // Pixels are milliradians: a lamp of 1 m has 1.5 pixels at 667 m and 10 at 100 m.
    const LightPoint light{.intensity = 0.5F, .size_m = 1.0F};
    EXPECT_NEAR(total_at(light, 2000.0), 0.5, 0.03);
    EXPECT_NEAR(total_at(light, 100.0), 0.5 * std::pow(10.0 / 1.5, 2), 0.5);
    EXPECT_NEAR(total_at(light, 5.0), 0.5 * std::pow(16.0 / 1.5, 2), 1.0) << "at most 16 pixels";
}

TEST(Flash, FollowsItsScheduleFromThePacketsTimeAlone) {
    const LightPoint light{.flash_hz = 2.0F, .duty = 0.25F, .phase = 0.5F};
    for (int k = -400; k < 400; ++k) {
        const double t = k / 100.0 + 0.001;
        const double in_period = t * 2.0 + 0.5 - std::floor(t * 2.0 + 0.5);
        EXPECT_EQ(is_lit(light, t), in_period < 0.25) << t;
    }
    EXPECT_TRUE(is_lit({.duty = 0.0F}, 1.0)) << "without a rate it is steady";
    const VisualDatabase d = lights_database({[&] {
        LightPoint placed = light;
        placed.position = {100, 0, 0};
        return placed;
    }()});
    Machine machine(d, small_machine());
    FramePacket packet = packet_of(d, fine_view(64, 64));
    for (const double t : {0.26, 0.1, 0.26, 7.3, 0.1}) { // no memory: any order gives the same
        packet.time_s = t;
        machine.frame(packet);
        EXPECT_EQ(machine.picture(0).pixels[32 * 64 + 32] != 0xff000000U, is_lit(light, t)) << t;
    }
}

// ---- many -------------------------------------------------------------------------------------------------------------

/// A hundred thousand lights on a plain, and boxes among them.
VisualDatabase plain_of_lights() {
    std::vector<LightPoint> lights;
    for (int k = 0; k < 100000; ++k) {
        const float x = 200.0F + 3.7F * static_cast<float>(k / 250);
        const float y = 4.1F * static_cast<float>(k % 250 - 125);
        lights.push_back({.position = {x, y, 0.3F * static_cast<float>(k % 7)},
                          .intensity = 0.3F + 0.01F * static_cast<float>(k % 100),
                          .size_m = 0.5F,
                          .full_to_m = 400.0F,
                          .flash_hz = static_cast<float>(k % 3),
                          .duty = 0.7F,
                          .colour = static_cast<std::uint16_t>(k % 3),
                          .fall_off = FallOff::linear});
    }
    VisualDatabase d = lights_database(lights);
    for (std::int32_t k = 0; k < 7; ++k) {
        const float y = 40.0F * static_cast<float>(k - 3);
        d.moving_objects.push_back("box " + std::to_string(k));
        add_box(d,
                {.from = {180, y, -5}, .to = {190, y + 13, 30}, .colour = 3, .group = 0, .moving_object = k});
    }
    return d;
}

TEST(LightPoints, AHundredThousandGiveTheSameBytesOnAnyNumberOfThreadsAndSimdLevel) {
    const VisualDatabase d = plain_of_lights();
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        std::vector<std::uint32_t> expected;
        std::uint64_t pixels = 0;
        for (const std::uint32_t threads : {1U, 3U, 8U}) {
            for (const std::string& level : threads == 3 ? simd_levels() : std::vector<std::string>{"best"}) {
                ASSERT_TRUE(use_simd_level(level));
                Configuration configuration = small_machine(scan, 512);
                configuration.threads = threads;
                configuration.edge_smoothing = true;
                Machine machine(d, configuration);
                FramePacket packet = packet_of(d, channel_at({0, 0, 60}, 0.0, -8.0));
                packet.visibility_m = 3000.0F;
                packet.time_s = 0.4;
                const FrameReport& report = machine.frame(packet);
                ASSERT_TRUE(report.errors.empty()) << report.errors[0];
                EXPECT_EQ(report.channels[0].lights_active, 100000U);
                if (expected.empty()) {
                    expected = machine.picture(0).pixels;
                    pixels = report.channels[0].light_pixels;
                    EXPECT_GT(pixels, 10000U);
                }
                EXPECT_EQ(report.channels[0].light_pixels, pixels);
                EXPECT_EQ(machine.picture(0).pixels, expected) << threads << " " << level;
            }
        }
        use_simd_level("best");
    }
}

} // namespace
} // namespace linkdig::ig
