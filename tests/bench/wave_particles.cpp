// 100,000 wave particles advanced and summed onto 512 x 512 cells: milliseconds a frame. bench_wave_particles [frames]

#include "ig/water/wave_particles.h"
#include "database/model/mathematics.h"
#include "database/model/random.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

int main(int count, char** values) {
    using namespace linkdig;
    const int frames = std::max(count > 1 ? std::atoi(values[1]) : 200, 1);
    const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
    constexpr std::uint32_t number = 100'000;
    ig::WaveParticles water({.radius = 3.0, .least_amplitude = 1e-9, .lifetime_s = 600.0, .most = number});
    ig::WaveParticleCount happened;
    for (std::uint32_t k = 0; k < number; ++k) {
        const SineCosine way = sine_cosine(two_pi * random_unit(3, k));
        water.add({.source = {400.0 * random_unit(1, k) - 200.0, 400.0 * random_unit(2, k) - 200.0},
                   .direction = {way.cosine, way.sine},
                   .amplitude = random_unit(4, k) - 0.5,
                   .dispersion_rad = 0.001},
                  happened);
    }
    const std::vector<Quay> quays{{{240, -300}, {240, 300}}, {{-240, -300}, {-240, 300}}};
    std::vector<double> times;
    const std::clock_t before = std::clock();
    for (int frame = 0; frame < frames; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        water.advance(1.0 / 60.0, quays, happened);
        const database::WaveField& field =
            water.surface({.size = 512, .cell = 1.0, .centre = {0.1 * frame, 0}});
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        if (field.heights.empty()) return 1;
    }
    const double work = 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / frames;
    std::ranges::sort(times);
    std::printf("%zu particles, 512 x 512 cells, radius 3 cells, two threads: median %.2f ms, 95 of 100 "
                "within %.2f ms; %.2f ms of processor time a frame\n",
                water.particles().size(), times[times.size() / 2], times[times.size() * 95 / 100], work);
    return 0;
}
