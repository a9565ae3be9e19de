#include "tests/tools/pictures.h"
#include "tools/figures/findings.h"
#include "tools/figures/measures.h"
#include "tools/figures/ray_caster.h"

#include "database/model/mathematics.h"

#include <gmock/gmock.h>

#include <vector>

namespace linkdig::tools {
namespace {

/// A picture of intensities alone: so many waves across, moved on to the right, and so many down.
ig::VideoFrame waves(double across, double down, double moved = 0.0) {
    ig::VideoFrame picture;
    picture.width = 64;
    picture.height = 64;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const double wave = sine(two_pi * across * (x - moved) / 64.0) + sine(two_pi * down * y / 64.0);
            picture.intensity.push_back(static_cast<std::int32_t>(1048576.0 * (2.0 + wave)));
        }
    return picture;
}

TEST(Measures, ShiftIsFoundToAPartOfAnElement) {
    std::vector<double> first;
    std::vector<double> later;
    for (int i = 0; i < 200; ++i) {
        first.push_back(sine(two_pi * i / 50.0));
        later.push_back(sine(two_pi * (i - 7.3) / 50.0));
    }
    EXPECT_NEAR(shift(first, later, 24), 7.3, 0.2);
    EXPECT_NEAR(shift(later, first, 24), -7.3, 0.2);
}

TEST(Measures, FlowTellsTheMotionAndThePreferredDirection) {
    EXPECT_GT(flow(waves(4, 0), waves(4, 0)).anisotropy(), 1000.0) << "stripes";
    EXPECT_LT(flow(waves(4, 4), waves(4, 4)).anisotropy(), 1.1) << "crosswise";
    const Flow moved = flow(waves(4, 4), waves(4, 4, 0.5));
    EXPECT_NEAR(moved.right, 0.5, 0.03);
    EXPECT_NEAR(moved.down, 0.0, 0.01);
}

TEST(Measures, ChangeIsThatOfIntensities) {
    ig::VideoFrame before = waves(0, 0);
    ig::VideoFrame after = before;
    for (std::int32_t& intensity : after.intensity)
        intensity += 4194304 / 255 / 4; // a quarter of a level
    const std::vector<std::uint8_t> all(before.intensity.size(), 1);
    EXPECT_NEAR(rms_change(before, after, all), 0.25, 1e-3);
    EXPECT_EQ(rms_change(before, after, std::vector<std::uint8_t>(all.size(), 0)), 0.0);
}

TEST(RayCaster, TheSeaHidesWhatIsBelowIt) {
    ShipTriangles wall; // across the view, 50 m ahead, from 5 m below the water to 5 m above
    wall.triangles.push_back({Vec3d(50, 100, -5), Vec3d(50, -100, -5), Vec3d(50, 100, 5)});
    wall.triangles.push_back({Vec3d(50, -100, -5), Vec3d(50, -100, 5), Vec3d(50, 100, 5)});
    ChannelView channel;
    channel.eye_m = {0, 0, 2};
    channel.left_tangent = -0.2;
    channel.right_tangent = 0.2;
    channel.top_tangent = 0.2;
    channel.bottom_tangent = -0.2;
    const std::vector<Hit> hits = cast(wall, MovingObject{}, channel, 9, 100);
    const auto at = [&](double tangent) {
        return hits[static_cast<std::size_t>((0.2 - tangent) / 0.004) * 9 + 4];
    };
    EXPECT_EQ(at(0.07), Hit::sky) << "over the wall, whose top is 3 m above the eye";
    EXPECT_EQ(at(0.05), Hit::ship);
    EXPECT_EQ(at(-0.03), Hit::ship) << "down to the water, 2 m below the eye";
    EXPECT_EQ(at(-0.05), Hit::sea) << "in front of the wall's foot";
}

TEST(Findings, OneFailedCheckFails) {
    const TemporaryFolder folder;
    Findings findings(folder.file("made"));
    findings.at_most("1", "a", 2.0, 2.0);
    findings.at_least("2", "b", 2.0, 2.0);
    EXPECT_TRUE(findings.passed());
    findings.between("3", "c", 2.0, 3.0, 4.0);
    EXPECT_FALSE(findings.passed());
    EXPECT_THAT(findings.text(), testing::HasSubstr("FAILED figure 3         c: 2; 3 to 4"));
    EXPECT_THAT(findings.json(), testing::HasSubstr("\"passed\": false"));
}

} // namespace
} // namespace linkdig::tools
