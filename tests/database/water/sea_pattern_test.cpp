#include "database/water/sea_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace linkdig::database {
namespace {

constexpr double angle_rad = 1.2;

TEST(SeaPattern, NormalsAreUnitVectorsOfOneVerticalAngle) {
    // The C library's sine is the second opinion here; it is no good for data, for it differs between
    // machines.
    for (std::uint32_t i = 0; i < normal_azimuths; ++i) {
        const Vec3f n = table_normal(i, angle_rad);
        const double phi = 2 * 3.14159265358979 * i / 256;
        EXPECT_NEAR(n.x, std::cos(phi) * std::cos(angle_rad), 1e-7);
        EXPECT_NEAR(n.y, std::sin(phi) * std::cos(angle_rad), 1e-7);
        EXPECT_NEAR(n.z, std::sin(angle_rad), 1e-7);
    }
}

TEST(SeaPattern, AzimuthsAreUniform) {
    constexpr int count = 65536;
    std::set<float> azimuths;
    Vec3d mean(0.0);
    for (const Vec3f& n : random_normals(7, NormalStream::vertices, count, angle_rad)) {
        azimuths.insert(n.x * 2 + n.y);
        mean += Vec3d(n) / static_cast<double>(count);
    }
    EXPECT_GT(azimuths.size(), 200U);
    // Standard error of the mean: cos a / sqrt(2 count) = 0.001.
    EXPECT_NEAR(mean.x, 0, 0.005);
    EXPECT_NEAR(mean.y, 0, 0.005);
    EXPECT_NEAR(mean.z, std::sin(angle_rad), 1e-6);
}

TEST(SeaPattern, IsAFunctionOfSeedStreamAndIndex) {
    const auto a = random_normals(1, NormalStream::vertices, 100, angle_rad);
    EXPECT_EQ(a, random_normals(1, NormalStream::vertices, 100, angle_rad));
    EXPECT_NE(a, random_normals(2, NormalStream::vertices, 100, angle_rad));
    EXPECT_NE(a, random_normals(1, NormalStream::faces, 100, angle_rad));
    const auto longer = random_normals(1, NormalStream::vertices, 200, angle_rad);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), longer.begin()));
}

} // namespace
} // namespace linkdig::database
