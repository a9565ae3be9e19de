#include "database/water/sea_pattern.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"

#include <algorithm>
#include <cmath>

namespace linkdig::database {

namespace {

/// Twice the vertices' coordinates, so that the squares' middles are whole numbers too.
std::uint32_t doubled(std::uint32_t index, NormalStream stream) {
    return 2 * index + (stream == NormalStream::faces ? 1U : 0U);
}

/// Phase of a whole wave at doubled coordinates (x, y), as turns of `period` halves: exact, and the same a period on.
double phase(WholeWaves waves, std::uint32_t x, std::uint32_t y, std::uint32_t period) {
    const std::int64_t steps = std::int64_t{waves.along_x} * x + std::int64_t{waves.along_y} * y;
    const std::int64_t whole = 2 * std::int64_t{period};
    return two_pi * static_cast<double>(((steps % whole) + whole) % whole) / static_cast<double>(whole);
}

Vec3f normal_at(double phi, double vertical_angle_rad) {
    const SineCosine azimuth = sine_cosine(phi);
    const SineCosine a = sine_cosine(vertical_angle_rad);
    return {static_cast<float>(azimuth.cosine * a.cosine), static_cast<float>(azimuth.sine * a.cosine),
            static_cast<float>(a.sine)};
}

/// Normals of all (column, row), row by row.
template <typename Normal>
std::vector<Vec3f> table_of(std::uint32_t period, Normal normal) {
    std::vector<Vec3f> table;
    table.reserve(std::size_t{period} * period);
    for (std::uint32_t row = 0; row < period; ++row)
        for (std::uint32_t column = 0; column < period; ++column)
            table.push_back(normal(column, row));
    return table;
}

} // namespace

Vec3f table_normal(std::uint32_t azimuth_index, double vertical_angle_rad, std::uint32_t azimuths) {
    return normal_at(two_pi * azimuth_index / azimuths, vertical_angle_rad);
}

std::vector<Vec3f> random_normals(std::uint64_t seed, NormalStream stream, std::size_t count,
                                  double vertical_angle_rad) {
    std::vector<Vec3f> table;
    for (std::uint32_t i = 0; i < normal_azimuths; ++i)
        table.push_back(table_normal(i, vertical_angle_rad));
    // Seeds of the streams: two outputs of the generator itself, so that neighbouring seeds share nothing.
    const std::uint64_t stream_seed = random_bits(seed, static_cast<std::uint64_t>(stream));
    std::vector<Vec3f> normals;
    normals.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        normals.push_back(table[random_bits(stream_seed, i) % normal_azimuths]);
    return normals;
}

std::vector<Vec3f> sine_normals(std::uint32_t period, std::uint32_t waves, bool mirrored, NormalStream stream,
                                double vertical_angle_rad) {
    const WholeWaves wave{static_cast<std::int32_t>(waves), 0};
    return table_of(period, [&](std::uint32_t column, std::uint32_t row) {
        const double phi = phase(wave, doubled(column, stream), 0, period);
        return normal_at(mirrored && row % 2 == 0 ? -phi : phi, vertical_angle_rad);
    });
}

WholeWaves nearest_whole_waves(double waves, double angle_rad) {
    const SineCosine angle = sine_cosine(angle_rad);
    return {static_cast<std::int32_t>(std::floor(waves * angle.cosine + 0.5)),
            static_cast<std::int32_t>(std::floor(waves * angle.sine + 0.5))};
}

std::vector<Vec3f> two_wave_normals(std::uint32_t period, WholeWaves first, WholeWaves second,
                                    std::uint32_t table_size, NormalStream stream,
                                    double vertical_angle_rad) {
    return table_of(period, [&](std::uint32_t column, std::uint32_t row) {
        const std::uint32_t x = doubled(column, stream);
        const std::uint32_t y = doubled(row, stream);
        const double z = sine(phase(first, x, y, period)) + sine(phase(second, x, y, period)); // -2 to 2
        const double entry = std::floor((z + 2.0) / 4.0 * table_size);
        const auto index = static_cast<std::uint32_t>(std::clamp(entry, 0.0, table_size - 1.0));
        return table_normal(index, vertical_angle_rad, table_size);
    });
}

std::vector<Vec3f> level_normals(std::uint32_t period, const std::vector<float>& levels,
                                 NormalStream stream) {
    std::uint32_t side = 1;
    while (std::size_t{side} * side < levels.size())
        ++side;
    const auto level = [&](std::uint32_t column, std::uint32_t row) {
        return levels[std::size_t{row % side} * side + column % side];
    };
    return table_of(period, [&](std::uint32_t column, std::uint32_t row) {
        if (stream == NormalStream::faces) return Vec3f(0, 0, level(column, row));
        const std::uint32_t west = column + side - 1; // of the squares on both sides of the vertex
        const std::uint32_t south = row + side - 1;
        const float sum =
            (level(west, south) + level(column, south)) + (level(west, row) + level(column, row));
        return Vec3f(0, 0, 0.25F * sum);
    });
}

namespace {

/// The next coarser table of `side` x `side`, made of `fine`, which has twice the side.
std::vector<Vec3f> coarser(const Vec3f* fine, std::uint32_t side, NormalStream stream) {
    const std::uint32_t fine_side = 2 * side;
    const auto at = [&](std::uint32_t column, std::uint32_t row) {
        return Vec3d(fine[std::size_t{row % fine_side} * fine_side + column % fine_side]);
    };
    const auto across = [&](std::uint32_t column, std::uint32_t row) { // 1 2 1 about the vertex
        return 0.25 * (at(column + fine_side - 1, row) + 2.0 * at(column, row) + at(column + 1, row));
    };
    return table_of(side, [&](std::uint32_t column, std::uint32_t row) {
        const std::uint32_t x = 2 * column;
        const std::uint32_t y = 2 * row;
        if (stream == NormalStream::faces)
            return Vec3f(0.25 * ((at(x, y) + at(x + 1, y)) + (at(x, y + 1) + at(x + 1, y + 1))));
        return Vec3f(0.25 * (across(x, y + fine_side - 1) + 2.0 * across(x, y) + across(x, y + 1)));
    });
}

} // namespace

std::vector<Vec3f> with_coarser_tables(std::vector<Vec3f> pattern, std::uint32_t period,
                                       NormalStream stream) {
    std::size_t first = 0;
    for (std::uint32_t side = period / 2; side >= 1; side /= 2) {
        const std::vector<Vec3f> table = coarser(pattern.data() + first, side, stream);
        first = pattern.size();
        pattern.insert(pattern.end(), table.begin(), table.end());
    }
    return pattern;
}

} // namespace linkdig::database
