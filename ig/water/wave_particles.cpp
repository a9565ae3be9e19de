#include "ig/water/wave_particles.h"

#include "database/model/mathematics.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

namespace linkdig::ig {

namespace {

constexpr double greatest_amplitude = 1000.0;
constexpr double finest = 65536.0;  ///< a metre in the sums, at best: 15 um
constexpr int most_reflections = 4; ///< in one frame; more is a corner that a particle does not leave
constexpr std::uint32_t band = 32;  ///< rows that one task sums, so that no two tasks write to one cell

/// 0.5 (1 + cos(pi d)) by t = 1 - d^2, within 0.0005: value and slope agree at both ends, curvature at the rim.
constexpr float bump_2 = 0.61685F;
constexpr float bump_3 = 0.29890F;
constexpr float bump_4 = 0.08425F;

/// How much of the way from `from` to `to` lies before the quay; above 1 if they do not meet.
double meeting(const Quay& quay, const Vec2d& from, const Vec2d& to) {
    const Vec2d way = to - from;
    const Vec2d wall = quay.to_m - quay.from_m;
    const double turn = way.x * wall.y - way.y * wall.x;
    if (turn == 0.0) return 2.0;
    const Vec2d between = quay.from_m - from;
    const double along_way = (between.x * wall.y - between.y * wall.x) / turn;
    const double along_wall = (between.x * way.y - between.y * way.x) / turn;
    return along_way > 0.0 && along_way <= 1.0 && along_wall >= 0.0 && along_wall <= 1.0 ? along_way : 2.0;
}

Vec2d mirrored(const Vec2d& vector, const Vec2d& unit_normal) {
    return vector - 2.0 * glm::dot(vector, unit_normal) * unit_normal;
}

/// Sends a particle that came from `from` back from the quays in its way. True if there was one.
bool reflect(WaveParticle& particle, Vec2d from, std::span<const Quay> quays) {
    const Quay* last = nullptr;
    for (int times = 0; times < most_reflections; ++times) {
        const Quay* nearest = nullptr;
        double part = 1.5;
        const Vec2d to = particle.position();
        for (const Quay& quay : quays) {
            const double here = &quay == last ? 2.0 : meeting(quay, from, to);
            if (here < part) {
                part = here;
                nearest = &quay;
            }
        }
        if (nearest == nullptr) return times > 0;
        const Vec2d wall = glm::normalize(nearest->to_m - nearest->from_m);
        const Vec2d normal(-wall.y, wall.x);
        from = from + (to - from) * part;
        particle.source = nearest->from_m + mirrored(particle.source - nearest->from_m, normal);
        particle.direction = mirrored(particle.direction, normal);
        last = nearest;
    }
    return true;
}

Vec2d turned(const Vec2d& direction, double angle_rad) {
    const SineCosine a = sine_cosine(angle_rad);
    return {direction.x * a.cosine - direction.y * a.sine, direction.x * a.sine + direction.y * a.cosine};
}

constexpr std::int64_t lanes = 4; ///< columns at a time: beyond its rim a bump is 0

/// A metre in the sums: as fine as leaves room for all amplitudes in one cell, a power of two.
double fixed_point(const std::vector<WaveParticle>& particles) {
    std::int64_t all = 0; // whole numbers: the order does not matter
    for (const WaveParticle& particle : particles)
        all += static_cast<std::int64_t>(std::fabs(particle.amplitude) * finest) + 1;
    double metre = finest;
    while (static_cast<double>(all) / finest * metre > 2147483647.0 / 1.01)
        metre *= 0.5;
    return metre;
}

} // namespace

WaveParticles::WaveParticles(const WaveParticleKind& kind) : kind_(kind) {
    if (!(kind.speed_mps > 0.0) || !(kind.radius > 0.0) || !(kind.lifetime_s > 0.0))
        throw std::invalid_argument("wave particles: speed, radius and lifetime must be above 0");
    particles_.reserve(kind.most);
}

double WaveParticles::water_of_unit() const {
    // Half the disc, less what the cosine takes: pi r^2 (1/2 - 2 / pi^2).
    return kind_.radius * kind_.radius * (0.5 * pi - 2.0 / pi);
}

bool WaveParticles::add(const WaveParticle& particle, WaveParticleCount& count) {
    if (!(std::fabs(particle.amplitude) >= kind_.least_amplitude)) return false;
    if (particles_.size() >= kind_.most) {
        ++count.refused;
        return false;
    }
    particles_.push_back(particle);
    WaveParticle& added = particles_.back();
    const double length = glm::length(added.direction);
    added.direction = length > 0.0 ? added.direction / length : Vec2d(1.0, 0.0);
    added.amplitude = std::clamp(added.amplitude, -greatest_amplitude, greatest_amplitude);
    ++count.born;
    return true;
}

void WaveParticles::add(const Silhouette& silhouette, const BoundaryWaves& waves, double duration_s,
                        WaveParticleCount& count) {
    const double per_effect = duration_s / water_of_unit();
    for (std::size_t at = 0; at < waves.boundary.size(); ++at) {
        const Vec2d middle =
            silhouette.origin + silhouette.pixel * (Vec2d(at % silhouette.size, at / silhouette.size) + 0.5);
        // Waves of a filled pixel start in the next one, clear of the hull; above a submerged hull they may run over it.
        const bool clear = silhouette.filled[at] != 0 && silhouette.submerged[at] == 0;
        const Vec2d start = clear ? middle + silhouette.pixel * waves.direction[at] : middle;
        const double angle = waves.dispersion_rad[at] > 0.0 ? waves.dispersion_rad[at] : two_pi;
        add({.source = start,
             .direction = waves.direction[at],
             .amplitude = waves.indirect[at] * per_effect,
             .dispersion_rad = waves.boundary[at] != 0 ? angle : two_pi},
            count);
        add({.source = middle, .amplitude = waves.direct[at] * per_effect, .dispersion_rad = two_pi}, count);
    }
}

void WaveParticles::advance(double duration_s, std::span<const Quay> quays, WaveParticleCount& count) {
    const double way = kind_.speed_mps * duration_s;
    const double fade = exponential(-duration_s / kind_.lifetime_s);
    const double apart = 0.5 * kind_.radius;
    const auto too_low = [this](const WaveParticle& particle) {
        return !(std::fabs(particle.amplitude) >= kind_.least_amplitude);
    };
    std::atomic<std::uint32_t> reflected = 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, particles_.size(), 1024), [&](const auto& range) {
        std::uint32_t here = 0;
        for (std::size_t k = range.begin(); k < range.end(); ++k) {
            WaveParticle& particle = particles_[k];
            const Vec2d before = particle.position();
            particle.travelled += way;
            particle.amplitude *= fade;
            if (!quays.empty() && reflect(particle, before, quays)) ++here;
        }
        reflected += here;
    });
    count.reflected += reflected;
    // Parts are looked at again in their turn, as they come after the rest.
    for (std::size_t k = 0; k < particles_.size(); ++k) {
        WaveParticle& particle = particles_[k];
        while (particle.dispersion_rad * particle.travelled > apart && !too_low(particle)) {
            if (particles_.size() + 2 > kind_.most) {
                ++count.refused;
                break;
            }
            particle.amplitude /= 3.0;
            particle.dispersion_rad /= 3.0;
            ++count.subdivided;
            for (const double angle : {-particle.dispersion_rad, particle.dispersion_rad}) {
                WaveParticle part = particle;
                part.direction = turned(particle.direction, angle);
                if (!quays.empty()) reflect(part, particle.position(), quays);
                particles_.push_back(part); // within what is reserved: `particle` stays where it is
            }
        }
    }
    const std::size_t all = particles_.size();
    std::erase_if(particles_, too_low);
    count.removed += static_cast<std::uint32_t>(all - particles_.size());
}

void WaveParticles::add_bump(const Splat& splat, float radius, const Band& rows, Sums& sums) {
    const float per_square = 1.0F / (radius * radius);
    const auto row_at = [&rows](float row) {
        return static_cast<std::uint32_t>(
            std::clamp(row, static_cast<float>(rows.first), static_cast<float>(rows.last)));
    };
    // Cell k has its middle at k + 1/2.
    const std::uint32_t low = row_at(std::ceil(splat.row - radius - 0.5F));
    const std::uint32_t high = row_at(std::floor(splat.row + radius + 0.5F));
    const float left = std::ceil(splat.column - radius - 0.5F);
    const float right = std::floor(splat.column + radius + 0.5F);
    const auto runs = (static_cast<std::int64_t>(right - left) + lanes - 1) / lanes;
    const float first = left + 0.5F - splat.column;
    for (std::uint32_t row = low; row < high; ++row) {
        const float up = static_cast<float>(row) + 0.5F - splat.row;
        const float rest = 1.0F - up * up * per_square;
        std::int32_t* at = sums.cells.data() + static_cast<std::int64_t>(row) * sums.stride +
                           sums.columns_before + static_cast<std::int64_t>(left);
        float across = first;
        for (std::int64_t run = 0; run < runs; ++run) {
            for (std::int64_t lane = 0; lane < lanes; ++lane) {
                const float x = across + static_cast<float>(lane);
                const float t = std::max(rest - x * x * per_square, 0.0F);
                const float shape = t * t * (bump_2 + t * (bump_3 + t * bump_4));
                at[lane] += static_cast<std::int32_t>(splat.amplitude * shape);
            }
            at += lanes;
            across += static_cast<float>(lanes);
        }
    }
}

void WaveParticles::sort_into_bands(const SurfaceGrid& grid, const Vec2d& corner, double one) {
    bands_.resize((grid.size + band - 1) / band);
    for (std::vector<Splat>& splats : bands_)
        splats.clear();
    const double reach = kind_.radius / grid.cell;
    const auto size = static_cast<double>(grid.size);
    for (const WaveParticle& particle : particles_) {
        const Vec2d at = particle.position() / grid.cell - corner;
        if (!(at.x > -reach && at.y > -reach && at.x < size + reach && at.y < size + reach)) continue;
        const double grown =
            particle.travelled < kind_.rise_m ? smooth_step(particle.travelled / kind_.rise_m) : 1.0;
        const auto first = static_cast<std::uint32_t>(std::max(at.y - reach, 0.0)) / band;
        const auto last = static_cast<std::uint32_t>(std::min(at.y + reach, size - 1.0)) / band;
        for (std::uint32_t k = first; k <= last; ++k)
            bands_[k].push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                                 static_cast<float>(particle.amplitude * grown * one)});
    }
}

const database::WaveField& WaveParticles::surface(const SurfaceGrid& grid) {
    if (!(grid.cell > 0.0) || grid.size == 0)
        throw std::invalid_argument("a surface grid needs cells, and their side must be above 0");
    const double half = 0.5 * static_cast<double>(grid.size);
    const Vec2d corner(std::floor(grid.centre.x / grid.cell - half + 0.5),
                       std::floor(grid.centre.y / grid.cell - half + 0.5)); // in cells
    field_.size = grid.size;
    field_.cell = grid.cell;
    field_.origin = corner * grid.cell;
    field_.heights.resize(std::size_t{grid.size} * grid.size);

    const double one = fixed_point(particles_);
    sort_into_bands(grid, corner, one);
    const auto radius = static_cast<float>(kind_.radius / grid.cell);
    sums_.columns_before = static_cast<std::int64_t>(std::ceil(2.0F * radius)) + lanes;
    sums_.stride = static_cast<std::int64_t>(grid.size) + 2 * sums_.columns_before + 2 * lanes;
    sums_.cells.resize(static_cast<std::size_t>(sums_.stride) * grid.size);
    tbb::parallel_for(std::size_t{0}, bands_.size(), [&](std::size_t k) {
        const auto number = static_cast<std::uint32_t>(k);
        const Band rows{number * band, std::min(grid.size, (number + 1) * band)};
        const auto cells = [this](std::uint32_t row) {
            return sums_.cells.begin() + static_cast<std::int64_t>(row) * sums_.stride;
        };
        std::fill(cells(rows.first), cells(rows.last), 0);
        for (const Splat& splat : bands_[k])
            add_bump(splat, radius, rows, sums_);
        const double metre = 1.0 / one; // a power of two: exact
        for (std::uint32_t row = rows.first; row < rows.last; ++row) {
            const auto from = cells(row) + sums_.columns_before;
            std::transform(from, from + grid.size,
                           field_.heights.begin() + static_cast<std::int64_t>(row) * grid.size,
                           [metre](std::int32_t sum) { return static_cast<float>(sum * metre); });
        }
    });
    return field_;
}

} // namespace linkdig::ig
