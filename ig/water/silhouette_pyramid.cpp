#include "ig/water/silhouette_pyramid.h"

#include "database/model/mathematics.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

constexpr std::array<std::array<int, 2>, 4> beside{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

using Level = PyramidLevel;

void clear(std::uint32_t side, Level& level) {
    const std::size_t count = std::size_t{side} * side;
    level.size = side;
    level.boundary.assign(count, 0);
    level.direction.assign(count, Vec2d(0.0));
    level.effect.assign(count, 0.0);
}

class Neighbours {
public:
    explicit Neighbours(const Silhouette& silhouette) : silhouette_(silhouette) {}
    /// Index of the pixel beside, or of none where the square ends.
    bool find(std::size_t at, int right, int up, std::size_t& found) const {
        const auto size = static_cast<std::int64_t>(silhouette_.size);
        const std::int64_t column = static_cast<std::int64_t>(at) % size + right;
        const std::int64_t row = static_cast<std::int64_t>(at) / size + up;
        if (column < 0 || row < 0 || column >= size || row >= size) return false;
        found = static_cast<std::size_t>(row * size + column);
        return true;
    }

private:
    const Silhouette& silhouette_;
};

/// Step 3: boundary pixels, each with the sum of the ways out.
void find_boundary(const Silhouette& silhouette, SilhouetteBoundary kind, Level& level) {
    clear(silhouette.size, level);
    level.effect = silhouette.indirect;
    const Neighbours neighbours(silhouette);
    const bool inner = kind == SilhouetteBoundary::inner;
    for (std::size_t at = 0; at < level.boundary.size(); ++at) {
        if ((silhouette.filled[at] != 0) != inner) continue;
        bool submerged = silhouette.submerged[at] != 0;
        for (const auto& [right, up] : beside) {
            std::size_t other = 0;
            const bool there = neighbours.find(at, right, up, other);
            const bool filled = there && silhouette.filled[other] != 0;
            if (filled == inner) continue;
            level.boundary[at] = 1;
            level.direction[at] += (inner ? 1.0 : -1.0) * Vec2d(right, up);
            if (!inner) submerged = submerged || silhouette.submerged[other] != 0;
        }
        if (submerged) level.direction[at] = -level.direction[at];
    }
}

std::size_t parent_of(std::size_t at, std::uint32_t size) {
    return at / size / 2 * (size / 2) + at % size / 2;
}

/// Step 4: half the resolution. What a pixel sends up it no longer has.
void send_up(Level& below, Level& above) {
    clear(below.size / 2, above);
    for (std::size_t at = 0; at < below.boundary.size(); ++at) {
        const std::size_t parent = parent_of(at, below.size);
        const double sent = below.boundary[at] != 0 ? 0.5 * below.effect[at] : below.effect[at];
        below.effect[at] -= sent;
        above.effect[parent] += sent;
        above.direction[parent] += below.direction[at];
        if (below.boundary[at] != 0) ++above.boundary[parent];
    }
}

/// Step 5: back to the finer one, which takes the mean of both directions and its part of the coarser one's effect.
void hand_down(const Level& above, Level& below) {
    for (std::size_t at = 0; at < below.boundary.size(); ++at) {
        const std::size_t parent = parent_of(at, below.size);
        below.direction[at] = 0.5 * (below.direction[at] + above.direction[parent]);
        if (below.boundary[at] != 0)
            below.effect[at] += above.effect[parent] / static_cast<double>(above.boundary[parent]);
    }
}

/// Step 6: the mean angle between a pixel's direction and those of the boundary around it.
double dispersion(const BoundaryWaves& waves, const Neighbours& neighbours, std::size_t at) {
    double sum = 0.0;
    int count = 0;
    for (int up = -1; up <= 1; ++up)
        for (int right = -1; right <= 1; ++right) {
            std::size_t other = 0;
            if ((right == 0 && up == 0) || !neighbours.find(at, right, up, other)) continue;
            if (waves.boundary[other] == 0 || waves.direction[other] == Vec2d(0.0)) continue;
            sum += arc_cosine(glm::dot(waves.direction[at], waves.direction[other]));
            ++count;
        }
    return count == 0 || waves.direction[at] == Vec2d(0.0) ? two_pi : sum / count;
}

} // namespace

BoundaryWaves boundary_waves(const Silhouette& silhouette, SilhouetteBoundary kind) {
    std::vector<PyramidLevel> levels;
    BoundaryWaves waves;
    boundary_waves(silhouette, kind, levels, waves);
    return waves;
}

void boundary_waves(const Silhouette& silhouette, SilhouetteBoundary kind, std::vector<PyramidLevel>& levels,
                    BoundaryWaves& waves) {
    std::size_t count = 1;
    for (std::uint32_t size = silhouette.size; size > 1; size /= 2)
        ++count;
    levels.resize(count);
    find_boundary(silhouette, kind, levels.front());
    waves.boundary = levels.front().boundary;
    waves.direct = silhouette.direct;
    waves.indirect = silhouette.indirect;
    waves.direction.assign(waves.boundary.size(), Vec2d(0.0));
    waves.dispersion_rad.assign(waves.boundary.size(), 0.0);
    if (std::ranges::find(waves.boundary, 1) == waves.boundary.end()) return;

    for (std::size_t k = 1; k < levels.size(); ++k)
        send_up(levels[k - 1], levels[k]);
    for (std::size_t k = levels.size() - 1; k > 0; --k)
        hand_down(levels[k], levels[k - 1]);

    const Level& finished = levels.front();
    waves.indirect = finished.effect;
    constexpr double no_direction = 1e-9; // what rounding leaves of opposite ones
    for (std::size_t at = 0; at < waves.boundary.size(); ++at) {
        const double length = glm::length(finished.direction[at]);
        if (waves.boundary[at] != 0 && length > no_direction)
            waves.direction[at] = finished.direction[at] / length;
    }
    const Neighbours neighbours(silhouette);
    for (std::size_t at = 0; at < waves.boundary.size(); ++at)
        if (waves.boundary[at] != 0) waves.dispersion_rad[at] = dispersion(waves, neighbours, at);
}

} // namespace linkdig::ig
