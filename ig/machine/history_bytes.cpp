#include "ig/machine/history_bytes.h"

#include "ig/active/light_steps.h"
#include "ig/active/shedding.h"
#include "ig/water/particle_wake.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <type_traits>

namespace linkdig::ig {

namespace {

constexpr std::uint32_t version_without_light_steps = 1;
constexpr std::uint32_t version_without_wakes = 2;
constexpr std::uint32_t version_with_wakes = 3;

void put(std::uint32_t number, std::vector<std::uint8_t>& bytes) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

void put_value(double value, std::vector<std::uint8_t>& bytes) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    put(static_cast<std::uint32_t>(bits), bytes);
    put(static_cast<std::uint32_t>(bits >> 32U), bytes);
}

/// The values of a row, in their order in the bytes.
template <typename Sample>
requires std::same_as<std::remove_const_t<Sample>, TrackSample>
auto values_of(Sample& s) {
    return std::array{&s.time_s, &s.position_m.x, &s.position_m.y, &s.forward.x, &s.forward.y, &s.speed_mps};
}
template <typename Particle>
requires std::same_as<std::remove_const_t<Particle>, WaveParticle>
auto values_of(Particle& p) {
    return std::array{&p.source.x,  &p.source.y,  &p.direction.x,   &p.direction.y,
                      &p.travelled, &p.amplitude, &p.dispersion_rad};
}
template <typename Wake>
requires std::same_as<std::remove_const_t<Wake>, ParticleWake>
auto values_of(Wake& w) {
    return std::array{&w.time_s,       &w.born_s,         &w.position_m.x,   &w.position_m.y,
                      &w.position_m.z, &w.attitude_rad.x, &w.attitude_rad.y, &w.attitude_rad.z};
}

template <typename Row>
void put_row(const Row& row, std::vector<std::uint8_t>& bytes) {
    for (const double* value : values_of(row))
        put_value(*value, bytes);
}

template <typename Row>
void put_rows(const std::vector<Row>& rows, std::vector<std::uint8_t>& bytes) {
    put(static_cast<std::uint32_t>(rows.size()), bytes);
    for (const Row& row : rows)
        put_row(row, bytes);
}

void put_wakes(const History& history, std::vector<std::uint8_t>& bytes) {
    put(static_cast<std::uint32_t>(history.trails.size()), bytes);
    for (const WakeTrail& trail : history.trails) {
        put(trail.list, bytes);
        put_rows(trail.samples, bytes);
    }
    put(static_cast<std::uint32_t>(history.particle_wakes.size()), bytes);
    for (const ParticleWake& wake : history.particle_wakes) {
        put(wake.list, bytes);
        put(wake.begun ? 1 : 0, bytes);
        put_row(wake, bytes);
        put_rows(wake.particles, bytes);
    }
}

/// Takes numbers off the front; `whole` turns false where there are none left.
struct Reading {
    std::span<const std::uint8_t> bytes;
    bool whole = true;

    std::uint32_t next() {
        whole = whole && bytes.size() >= 4;
        if (!whole) return 0;
        std::uint32_t number = 0;
        for (unsigned k = 0; k < 4; ++k)
            number |= std::uint32_t{bytes[k]} << (8 * k);
        bytes = bytes.subspan(4);
        return number;
    }

    /// A number that is not finite is none that a machine remembers.
    double next_value() {
        const std::uint64_t low = next();
        const auto value = std::bit_cast<double>(low | std::uint64_t{next()} << 32U);
        whole = whole && std::isfinite(value);
        return value;
    }

    template <typename Row>
    void read_row(Row& row) {
        for (double* value : values_of(row))
            *value = next_value();
    }

    /// How many things of at least so many bytes follow.
    std::uint32_t next_count(std::size_t bytes_of_each) {
        const std::uint32_t count = next();
        whole = whole && count <= bytes.size() / bytes_of_each;
        return whole ? count : 0;
    }

    template <typename Row>
    void read_rows(std::vector<Row>& rows) {
        Row row;
        const std::uint32_t count = next_count(sizeof(double) * values_of(row).size());
        for (std::uint32_t k = 0; k < count; ++k) {
            read_row(row);
            rows.push_back(row);
        }
    }

    void read_wakes(History& history) {
        const std::uint32_t trails = next_count(8);
        for (std::uint32_t k = 0; k < trails; ++k) {
            WakeTrail& trail = history.trails.emplace_back();
            trail.list = next();
            read_rows(trail.samples);
            whole = whole && std::ranges::is_sorted(trail.samples, {}, &TrackSample::time_s);
        }
        const std::uint32_t wakes = next_count(12);
        for (std::uint32_t k = 0; k < wakes; ++k) {
            ParticleWake& wake = history.particle_wakes.emplace_back();
            wake.list = next();
            wake.begun = next() != 0;
            read_row(wake);
            read_rows(wake.particles);
            whole = whole && wake.particles.size() <= most_particles;
        }
    }
};

} // namespace

std::vector<std::uint8_t> encode_history(const History& history) {
    std::vector<std::uint8_t> bytes;
    const bool wakes = !history.trails.empty() || !history.particle_wakes.empty();
    put(wakes ? version_with_wakes : version_without_wakes, bytes);
    put(static_cast<std::uint32_t>(history.held_level.size()), bytes);
    for (const std::uint32_t level : history.held_level)
        put(level, bytes);
    for (const std::uint32_t number : {history.load.step, history.load.calm, history.load.over,
                                       history.load.light_step, history.load.light_calm})
        put(number, bytes);
    if (wakes) put_wakes(history, bytes);
    return bytes;
}

std::optional<History> decode_history(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return History{};
    Reading reading{bytes};
    const std::uint32_t version = reading.next();
    if (version < version_without_light_steps || version > version_with_wakes) return std::nullopt;
    const std::uint32_t details = reading.next();
    if (!reading.whole || details > reading.bytes.size() / 4) return std::nullopt;
    History history;
    for (std::uint32_t d = 0; d < details; ++d)
        history.held_level.push_back(reading.next());
    history.load.step = reading.next();
    history.load.calm = reading.next();
    history.load.over = reading.next();
    if (version > version_without_light_steps) {
        history.load.light_step = reading.next();
        history.load.light_calm = reading.next();
    }
    if (history.load.step > most_steps || history.load.light_step > light_steps) return std::nullopt;
    if (version == version_with_wakes) reading.read_wakes(history);
    if (!reading.whole || !reading.bytes.empty()) return std::nullopt;
    return history;
}

} // namespace linkdig::ig
