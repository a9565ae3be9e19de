#include "database/water/kelvin_wake.h"

#include "database/model/mathematics.h"
#include "database/water/kelvin_curve.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace linkdig::database {

namespace {

/// Samples of neighbouring curves are shifted against each other, so that they do not line up: the curve of number k by
/// so many eighths of a sample (van der Corput's order).
constexpr std::array<int, 8> shifts{0, 4, 2, 6, 1, 5, 3, 7};

/// Samples of the curve of psi = 1 on one side; each has its mirror image on the other.
struct Shape {
    struct Sample {
        double two_cosine = 2.0; ///< s' / psi
        double ahead = 1.0;      ///< cos^3 u, along T from P(s')
        double right = 0.0;      ///< sin u cos^2 u, along -N; of the mirror image along N
        double weight = 1.0;     ///< length that the sample stands for; 1 in the column's way
    };
    std::array<std::vector<Sample>, shifts.size()> samples;
};

Shape::Sample sample_at(double u, double weight) {
    const CurvePlace at = curve_place(u);
    const double square = at.cosine * at.cosine;
    return {2.0 * at.cosine, square * at.cosine, at.sine * square, weight};
}

/// What is left of a wave that is so many cells long: the grid cannot hold one under two, and shows four as it is.
double kept_on_grid(double cells_long) { return smooth_step(0.5 * (cells_long - 2.0)); }

/// Length that a sample at u stands for, times what the grid keeps of its wave: it runs u off the swimmer's way, and is
/// cos^2 u times as long as the transverse waves.
double weight_at(double u, KelvinSampling sampling, std::uint32_t steps, double cells_long) {
    if (sampling == KelvinSampling::column) return 1.0;
    const double square = cosine(u) * cosine(u);
    const double stands_for =
        sampling == KelvinSampling::even ? kelvin_total_length() : pi * std::fabs(3.0 * square - 2.0);
    return stands_for / steps * kept_on_grid(cells_long * square);
}

/// `cells_long`: length of the transverse waves.
Shape shape_of(KelvinSampling sampling, std::uint32_t steps, double cells_long) {
    Shape shape;
    const std::uint32_t half = (steps + 1) / 2;
    for (std::size_t shift = 0; shift < shifts.size(); ++shift) {
        const double first = sampling == KelvinSampling::column ? 0.5 : (shifts[shift] + 0.5) / shifts.size();
        for (std::uint32_t i = 0; i < half; ++i) {
            const double share = 0.5 + 0.5 * (i + first) / half;
            const double u = sampling == KelvinSampling::even ? kelvin_u_at(share) : pi * (share - 0.5);
            const double weight = weight_at(u, sampling, 2 * half, cells_long);
            if (!(weight > 0.0)) continue;
            shape.samples[shift].push_back(sample_at(u, weight));
        }
    }
    return shape;
}

/// Length of the transverse waves, in cells: 2 pi U / c.
double transverse_cells(const KelvinWakes& wakes, const KelvinSwimmer& swimmer) {
    if (swimmer.oscillation_rad_s <= 0.0) return 1e9; // it does not oscillate: no wave, and nothing too short
    return two_pi * swimmer.speed / swimmer.oscillation_rad_s * wakes.size / wakes.side;
}

std::uint64_t curves_of(const KelvinWakes& wakes, double length) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(length * wakes.psi_per_unit + 0.5));
}

/// A unit of height in fixed point: as large a power of two as lets every sample of all swimmers fall into one cell.
double fixed_point_one(const KelvinWakes& wakes) {
    double greatest = 1.0;
    for (const KelvinSwimmer& swimmer : wakes.swimmers) {
        const double length = path_length(swimmer.path);
        const double cells = length * wakes.size / wakes.side;
        const double samples = static_cast<double>(curves_of(wakes, length)) * (wakes.u_steps + 1.0);
        greatest +=
            std::fabs(swimmer.amplitude) *
            (wakes.sampling == KelvinSampling::column ? samples : kelvin_total_length() * cells * cells);
    }
    return std::ldexp(1.0, 61 - std::ilogb(greatest));
}

/// Samples of a curve that were drawn, and of them those beyond the grid.
struct Drawn {
    std::uint64_t all = 0;
    std::uint64_t outside = 0;
    void add(bool on_grid) {
        ++all;
        if (!on_grid) ++outside;
    }
    Drawn operator+(const Drawn& other) const { return {all + other.all, outside + other.outside}; }
};

/// One swimmer's curves.
class Sweep {
public:
    Sweep(const KelvinWakes& wakes, const KelvinSwimmer& swimmer, double one)
        : one_(one), wakes_(wakes), swimmer_(swimmer),
          shape_(shape_of(wakes.sampling, wakes.u_steps, transverse_cells(wakes, swimmer))),
          length_(path_length(swimmer.path)) {
        const double cell = wakes.side / wakes.size;
        path_ = sample_path(swimmer.path, std::min(0.125 * cell, length_ / 64.0), 2.0 * length_ + cell);
        per_step_ = 1.0 / path_.step;
        dpsi_ = length_ / static_cast<double>(curves_of(wakes, length_));
        farthest_ = wakes.before == KelvinBefore::rest ? length_ : 2.0 * length_;
        per_cell_area_ = dpsi_ / (cell * cell);
    }

    std::uint64_t curves() const { return curves_of(wakes_, length_); }

    /// Curve number k, in the middle of its share of psi.
    Drawn draw(std::uint64_t k, SplatGrid& grid) const {
        const double psi = (static_cast<double>(k) + 0.5) * dpsi_;
        const double t = psi / swimmer_.speed;
        const double decay = swimmer_.damping_per_s * t;
        const double height =
            swimmer_.amplitude * cosine(swimmer_.oscillation_rad_s * t) * exponential(-decay * decay);
        const bool alike = wakes_.sampling == KelvinSampling::column;
        const double amount = one_ * height * (alike ? 1.0 : psi * per_cell_area_);
        const auto& samples = shape_.samples[alike ? 0 : k % shifts.size()];
        return wakes_.layout == KelvinLayout::rays ? rays(psi, amount, samples, grid)
                                                   : along_tangent(psi, amount, samples, grid);
    }

private:
    struct Place {
        Vec2d point;
        Vec2d tangent;
    };
    Place at(double s) const {
        const double steps = s * per_step_;
        const auto i = static_cast<std::size_t>(steps);
        const double f = steps - static_cast<double>(i);
        return {path_.points[i] + f * (path_.points[i + 1] - path_.points[i]),
                path_.tangents[i] + f * (path_.tangents[i + 1] - path_.tangents[i])};
    }

    /// A sample and its mirror image.
    static void draw_both(const Place& from, double ahead, double right, double amount, SplatGrid& grid,
                          Drawn& drawn) {
        const double x = from.point.x + ahead * from.tangent.x;
        const double y = from.point.y + ahead * from.tangent.y;
        const double across_x = right * from.tangent.y, across_y = right * from.tangent.x;
        drawn.add(grid.add(x + across_x, y - across_y, amount));
        drawn.add(grid.add(x - across_x, y + across_y, amount));
    }

    Drawn rays(double psi, double amount, const std::vector<Shape::Sample>& samples, SplatGrid& grid) const {
        Drawn drawn;
        for (const Shape::Sample& sample : samples) {
            const double s = psi * sample.two_cosine;
            if (s > farthest_) continue;
            draw_both(at(s), psi * sample.ahead, psi * sample.right, amount * sample.weight, grid, drawn);
        }
        return drawn;
    }

    Drawn along_tangent(double psi, double amount, const std::vector<Shape::Sample>& samples,
                        SplatGrid& grid) const {
        Drawn drawn;
        const Place middle = at(psi);
        for (const Shape::Sample& sample : samples) {
            const double ahead =
                psi * (1.0 - sample.two_cosine + sample.ahead); // K(psi, 0) falls on the path
            draw_both(middle, ahead, psi * sample.right, amount * sample.weight, grid, drawn);
        }
        return drawn;
    }

    double one_;
    const KelvinWakes& wakes_;
    const KelvinSwimmer& swimmer_;
    Shape shape_;
    double length_ = 0.0;
    SampledPath path_;
    double per_step_ = 0.0;
    double dpsi_ = 0.0;
    double farthest_ = 0.0;
    double per_cell_area_ = 0.0;
};

} // namespace

double sample_count(const KelvinWakes& wakes) {
    double count = 0.0;
    for (const KelvinSwimmer& swimmer : wakes.swimmers)
        count += (path_length(swimmer.path) * wakes.psi_per_unit + 1.0) * wakes.u_steps;
    return count;
}

KelvinResult kelvin_field(const KelvinWakes& wakes) {
    const double one = fixed_point_one(wakes);
    const SplatGrid empty(wakes.size, wakes.side / wakes.size, wakes.origin, one);
    tbb::enumerable_thread_specific<SplatGrid> grids(empty);
    KelvinResult result;
    for (const KelvinSwimmer& swimmer : wakes.swimmers) {
        const Sweep sweep(wakes, swimmer, one);
        tbb::enumerable_thread_specific<Drawn> drawn;
        tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, sweep.curves(), 32), [&](const auto& curves) {
            SplatGrid& grid = grids.local();
            for (std::uint64_t k = curves.begin(); k != curves.end(); ++k)
                drawn.local() = drawn.local() + sweep.draw(k, grid);
        });
        const Drawn all = drawn.combine(std::plus<>());
        result.swimmers.push_back(
            {sweep.curves() * wakes.u_steps, all.all, all.outside, transverse_cells(wakes, swimmer)});
    }
    SplatGrid sum = empty;
    for (const SplatGrid& grid : grids)
        sum.add(grid);
    result.field = sum.field();
    return result;
}

} // namespace linkdig::database
