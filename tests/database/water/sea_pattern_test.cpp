#include "database/water/sea_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

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

constexpr double turn = 2 * 3.14159265358979323846;

/// What a vertex shows under a sun: n.s, for the C library's sines.
double shown(const Vec3f& normal, double azimuth_rad, double elevation_rad) {
    return normal.x * std::cos(azimuth_rad) * std::cos(elevation_rad) +
           normal.y * std::sin(azimuth_rad) * std::cos(elevation_rad) + normal.z * std::sin(elevation_rad);
}

void expect_normal(const Vec3f& n, double phi, const std::string& where) {
    EXPECT_NEAR(n.x, std::cos(phi) * std::cos(angle_rad), 1e-6) << where;
    EXPECT_NEAR(n.y, std::sin(phi) * std::cos(angle_rad), 1e-6) << where;
    EXPECT_NEAR(n.z, std::sin(angle_rad), 1e-6) << where;
}

TEST(SinePattern, HasItsAzimuthOnAllRowsOrMirroredOnEvenOnes) {
    constexpr double wavelength = 16.0 / 3; // in squares
    const auto swell = sine_normals(16, 3, false, NormalStream::vertices, angle_rad);
    const auto mirrored = sine_normals(16, 3, true, NormalStream::vertices, angle_rad);
    const auto squares = sine_normals(16, 3, false, NormalStream::faces, angle_rad);
    for (std::size_t row = 0; row < 16; ++row) {
        for (std::size_t x = 0; x < 16; ++x) {
            const std::string where = std::to_string(x) + ", " + std::to_string(row);
            const double phi = turn * static_cast<double>(x) / wavelength;
            expect_normal(swell[row * 16 + x], phi, where);
            expect_normal(mirrored[row * 16 + x], row % 2 == 1 ? phi : -phi, where);
            expect_normal(squares[row * 16 + x], phi + turn * 0.5 / wavelength, where);
        }
    }
}

TEST(SinePattern, BandsMoveWithOneVelocityUnderATurningSun) {
    // A wavelength of eight squares: with every eighth of a turn the picture is the old one, one square further along x,
    // on every row; on the mirrored pattern one further on odd rows and one back on even ones.
    constexpr std::size_t side = 32;
    const auto swell = sine_normals(side, 4, false, NormalStream::vertices, angle_rad);
    const auto mirrored = sine_normals(side, 4, true, NormalStream::vertices, angle_rad);
    for (int step = 0; step < 8; ++step) {
        const double before = 0.3 + turn * step / 8;
        const double after = before + turn / 8;
        for (std::size_t row = 0; row < side; ++row) {
            for (std::size_t x = 0; x < side; ++x) {
                const std::size_t next = row * side + (x + 1) % side;
                const std::size_t last = row * side + (x + side - 1) % side;
                EXPECT_NEAR(shown(swell[next], after, 0.5), shown(swell[row * side + x], before, 0.5), 1e-6);
                EXPECT_NEAR(shown(mirrored[row % 2 == 1 ? next : last], after, 0.5),
                            shown(mirrored[row * side + x], before, 0.5), 1e-6);
            }
        }
    }
}

TEST(TwoWaves, AreAppendixIsIndexIntoATableOfNormals) {
    constexpr std::uint32_t period = 32, entries = 12;
    const WholeWaves first{4, 0}, second{3, 2};
    const double l1 = period / 4.0, l2 = period / std::sqrt(13.0), between = std::atan2(2.0, 3.0);
    const auto table = two_wave_normals(period, first, second, entries, NormalStream::vertices, angle_rad);
    ASSERT_EQ(table.size(), 1024U);
    int equal = 0;
    for (std::size_t y = 0; y < period; ++y) {
        for (std::size_t x = 0; x < period; ++x) {
            const double along =
                std::sin(between) * static_cast<double>(y) + std::cos(between) * static_cast<double>(x);
            const double z = std::sin(turn * std::fmod(static_cast<double>(x), l1) / l1) +
                             std::sin(turn * std::fmod(along, l2) / l2);
            const auto wanted = static_cast<int>(std::min(std::floor((z + 2) / 4 * entries), entries - 1.0));
            int best = 0; // the entry that the normal is
            for (int i = 1; i < static_cast<int>(entries); ++i)
                if (glm::distance(table[y * period + x],
                                  table_normal(static_cast<std::uint32_t>(i), angle_rad, entries)) <
                    glm::distance(table[y * period + x],
                                  table_normal(static_cast<std::uint32_t>(best), angle_rad, entries)))
                    best = i;
            EXPECT_NEAR(best, wanted, 1)
                << x << ", " << y; // a sum on the border of two entries rounds either way
            equal += best == wanted ? 1 : 0;
        }
    }
    EXPECT_GT(equal, 850);
}

TEST(TwoWaves, AreTheNearestThatRepeat) {
    const WholeWaves wave = nearest_whole_waves(512.0 / 48.0, 40.0 / 360.0 * turn);
    EXPECT_EQ(wave.along_x, 8);
    EXPECT_EQ(wave.along_y, 7);
    EXPECT_EQ(nearest_whole_waves(5.0, turn / 2).along_x, -5);
    EXPECT_EQ(nearest_whole_waves(0.2, 0.0).along_x, 0);
}

TEST(LevelPattern, ShowsItsLevelsWhereverTheSunStandsInAzimuth) {
    const std::vector<float> levels{0.5F, 0.75F, 1.0F, 0.25F}; // two by two, from the south
    const auto squares = level_normals(4, levels, NormalStream::faces);
    const auto vertices = level_normals(4, levels, NormalStream::vertices);
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            const double level = levels[row % 2 * 2 + column % 2];
            for (const double azimuth : {0.0, 2.0, 5.0})
                EXPECT_NEAR(shown(squares[row * 4 + column], azimuth, 0.6), level * std::sin(0.6), 1e-7);
            EXPECT_NEAR(vertices[row * 4 + column].z, 0.625, 1e-7) << "each vertex touches all four";
        }
    }
}

TEST(CoarserTables, KeepTheMeanAndEndInIt) {
    const auto fine = random_normals(3, NormalStream::vertices, 256, angle_rad);
    for (const NormalStream stream : {NormalStream::vertices, NormalStream::faces}) {
        const auto tables = with_coarser_tables(fine, 16, stream);
        ASSERT_EQ(tables.size(), 256U + 64 + 16 + 4 + 1);
        std::size_t first = 0;
        for (std::size_t side = 16; side >= 1; side /= 2) {
            Vec3d mean(0.0);
            for (std::size_t k = 0; k < side * side; ++k)
                mean += Vec3d(tables[first + k]) / static_cast<double>(side * side);
            EXPECT_LT(glm::distance(mean, Vec3d(tables.back())), 1e-6) << side;
            first += side * side;
        }
    }
}

TEST(CoarserTables, LetAWaveFadeBeforeTooFewVerticesCarryIt) {
    // Eight vertices to a wave, then four, then two. Weights 1 2 1 leave cos^2 of half a step's phase.
    const auto tables = with_coarser_tables(sine_normals(16, 2, false, NormalStream::vertices, angle_rad), 16,
                                            NormalStream::vertices);
    const double eighth = std::cos(turn / 16), quarter = std::cos(turn / 8);
    EXPECT_NEAR(tables[256].x, std::cos(angle_rad) * eighth * eighth, 1e-6);
    EXPECT_NEAR(tables[256 + 64].x, std::cos(angle_rad) * eighth * eighth * quarter * quarter, 1e-6);
    for (std::size_t k = 256 + 64 + 16; k < tables.size(); ++k)
        EXPECT_NEAR(glm::distance(tables[k], Vec3f(0, 0, tables[k].z)), 0, 1e-6) << "no wave is left";
    const auto mirrored = with_coarser_tables(sine_normals(16, 2, true, NormalStream::vertices, angle_rad),
                                              16, NormalStream::vertices);
    for (std::size_t k = 256; k < mirrored.size(); ++k)
        EXPECT_NEAR(mirrored[k].y, 0, 1e-6) << "a wave and its mirror image stand";
}

} // namespace
} // namespace linkdig::database
