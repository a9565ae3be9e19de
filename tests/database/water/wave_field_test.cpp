// Slopes and normals of a field, by surfaces whose own are known.

#include "database/model/mathematics.h"
#include "database/water/wave_field.h"
#include "tests/support/wave_normal.h"

#include <gtest/gtest.h>

namespace linkdig::database {
namespace {

using support::normal_at;

WaveField field_of(std::uint32_t size, double cell, double (*height)(const Vec2d&)) {
    WaveField field;
    field.size = size;
    field.cell = cell;
    field.origin = {-3.0, 7.0};
    for (std::uint32_t row = 0; row < size; ++row)
        for (std::uint32_t column = 0; column < size; ++column)
            field.heights.push_back(
                static_cast<float>(height(field.origin + cell * (Vec2d(column, row) + 0.5))));
    return field;
}

TEST(WaveField, APlanesNormalIsTheSameEverywhereItsBorderToo) {
    const WaveField field = field_of(8, 0.5, [](const Vec2d& at) { return 0.25 * at.x - 0.75 * at.y; });
    const Vec3d normal = glm::normalize(Vec3d(-0.25, 0.75, 1.0));
    for (std::uint32_t row = 0; row < 8; ++row)
        for (std::uint32_t column = 0; column < 8; ++column)
            EXPECT_LT(glm::length(Vec3d(normal_at(field, column, row)) - normal), 1e-5)
                << column << ' ' << row;
}

TEST(WaveField, NormalsOfCrossingWavesAreTheAnalyticOnes) {
    const auto height = [](const Vec2d& at) { return 0.4 * sine(0.3 * at.x) * cosine(0.2 * at.y); };
    for (const double cell : {0.4, 0.2}) {
        const WaveField field = field_of(64, cell, height);
        double greatest = 0.0;
        for (std::uint32_t row = 1; row < 63; ++row)
            for (std::uint32_t column = 1; column < 63; ++column) {
                const Vec2d at = field.origin + cell * (Vec2d(column, row) + 0.5);
                const Vec2d slope(0.4 * 0.3 * cosine(0.3 * at.x) * cosine(0.2 * at.y),
                                  -0.4 * 0.2 * sine(0.3 * at.x) * sine(0.2 * at.y));
                const Vec3d wanted = glm::normalize(Vec3d(-slope.x, -slope.y, 1.0));
                greatest = std::max(greatest, glm::length(Vec3d(normal_at(field, column, row)) - wanted));
            }
        // A central difference is off by the third derivative times cell^2 / 6: 0.4 * 0.3^3 * cell^2 / 6.
        EXPECT_LT(greatest, 1.2 * 0.4 * 0.027 * cell * cell / 6.0 + 2e-6 / cell) << cell;
    }
}

TEST(WaveField, OfOneCellIsFlat) {
    const WaveField field = field_of(1, 1.0, [](const Vec2d&) { return 5.0; });
    EXPECT_EQ(normal_at(field, 0, 0), Vec3f(0, 0, 1));
}

} // namespace
} // namespace linkdig::database
