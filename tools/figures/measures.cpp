#include "tools/figures/measures.h"

#include "ig/geometry/projected_face.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace linkdig::tools {
namespace {

constexpr double full_intensity = ig::intensity_one;

/// Calls visit(i, j) for neighbours beside and below, both in the mask, from a
/// row on.
template <typename Visit>
void neighbours(const ig::VideoFrame& picture, std::span<const std::uint8_t> mask, std::uint32_t first_row,
                const Visit& visit) {
    const std::size_t width = picture.width;
    for (std::size_t y = first_row; y < picture.height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = y * width + x;
            if (mask[i] == 0) continue;
            if (x + 1 < width && mask[i + 1] != 0) visit(i, i + 1);
            if (y + 1 < picture.height && mask[i + width] != 0) visit(i, i + width);
        }
    }
}

double correlation(std::span<const double> a, std::span<const double> b) {
    double mean_a = 0.0;
    double mean_b = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        mean_a += a[i];
        mean_b += b[i];
    }
    mean_a /= static_cast<double>(a.size());
    mean_b /= static_cast<double>(a.size());
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(std::max(aa * bb, 1e-30));
}

} // namespace

double rms_gradient(const ig::VideoFrame& picture, std::span<const std::uint8_t> mask) {
    double sum = 0.0;
    std::size_t count = 0;
    neighbours(picture, mask, 0, [&](std::size_t i, std::size_t j) {
        const double difference = level(picture.pixels[i]) - level(picture.pixels[j]);
        sum += difference * difference;
        ++count;
    });
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

int greatest_step(const ig::VideoFrame& picture, std::span<const std::uint8_t> mask,
                  std::uint32_t first_row) {
    int greatest = 0;
    neighbours(picture, mask, first_row, [&](std::size_t i, std::size_t j) {
        if (picture.rank[i] != picture.rank[j])
            greatest = std::max(greatest, std::abs(level(picture.pixels[i]) - level(picture.pixels[j])));
    });
    return greatest;
}

double rms_change(const ig::VideoFrame& before, const ig::VideoFrame& after,
                  std::span<const std::uint8_t> mask) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        const double difference = (after.intensity[i] - before.intensity[i]) * 255.0 / full_intensity;
        sum += difference * difference;
        ++count;
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

std::vector<double> row_means(const ig::VideoFrame& picture) {
    std::vector<double> means(picture.height, 0.0);
    for (std::size_t y = 0; y < picture.height; ++y) {
        for (std::size_t x = 0; x < picture.width; ++x)
            means[y] += picture.intensity[y * picture.width + x];
        means[y] /= picture.width * full_intensity;
    }
    return means;
}

double shift(std::span<const double> first, std::span<const double> later, int most) {
    const auto at = [&](int moved) {
        const auto overlap = first.size() - static_cast<std::size_t>(std::abs(moved));
        return moved >= 0 ? correlation(first.first(overlap), later.last(overlap))
                          : correlation(first.last(overlap), later.first(overlap));
    };
    int best = -most;
    double highest = -2.0;
    for (int moved = -most; moved <= most; ++moved) {
        const double found = at(moved);
        if (found > highest) {
            highest = found;
            best = moved;
        }
    }
    if (best == -most || best == most) return best;
    const double before = at(best - 1);
    const double after = at(best + 1);
    return best + 0.5 * (before - after) / std::min(before - 2.0 * highest + after, -1e-30);
}

double Flow::anisotropy() const {
    const double middle = (xx + yy) / 2.0;
    const double radius = std::sqrt((xx - yy) * (xx - yy) / 4.0 + xy * xy);
    return (middle + radius) / std::max(middle - radius, 1e-30);
}

Flow flow(const ig::VideoFrame& picture, const ig::VideoFrame& after) {
    Flow flow;
    double xt = 0.0;
    double yt = 0.0;
    const std::size_t width = picture.width;
    const auto value = [&](std::size_t i) {
        return static_cast<double>(picture.intensity[i]) + static_cast<double>(after.intensity[i]);
    };
    for (std::size_t y = 1; y + 1 < picture.height; ++y) {
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const std::size_t i = y * width + x;
            const double dx = (value(i + 1) - value(i - 1)) / 4.0; // of the mean of the two pictures
            const double dy = (value(i + width) - value(i - width)) / 4.0;
            const double dt =
                static_cast<double>(after.intensity[i]) - static_cast<double>(picture.intensity[i]);
            flow.xx += dx * dx;
            flow.xy += dx * dy;
            flow.yy += dy * dy;
            xt += dx * dt;
            yt += dy * dt;
        }
    }
    const double determinant = flow.xx * flow.yy - flow.xy * flow.xy;
    if (determinant > 0.0) {
        flow.right = -(flow.yy * xt - flow.xy * yt) / determinant;
        flow.down = -(flow.xx * yt - flow.xy * xt) / determinant;
    }
    return flow;
}

} // namespace linkdig::tools
