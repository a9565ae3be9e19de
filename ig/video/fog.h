#pragma once
/// Limited visibility: what is seen through the air turns into the horizon's colour.
///
///   colour = t * face + (1 - t) * horizon,   t = exp(-2.996 d / V)
///
/// d is the Euclidean range of the pixel, V the meteorological optical range: at d = V five hundredths of the contrast
/// are left (Koschmieder's law with a contrast threshold of 0.05, whose negative logarithm 2.996 is).
///
/// Range is needed per pixel: 1/z is linear on the screen (DepthPlane), z times a ray-length table is the range. It is
/// counted in octaves, over each of which half of the light is lost: t = 2^-octaves comes from a polynomial.

#include "database/model/visual_database.h"
#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

inline constexpr double extinction_at_visibility = 2.996;
inline constexpr double natural_logarithm_of_2 = 0.69314718055994531;
/// Transmission 1.0: 15 bits, as intensities have in the inner loop.
inline constexpr std::int32_t transmission_one = 32767;

/// Elements between two samples of the transmission where it changes little along a line: 2^bits of these.
inline constexpr int shortest_stretch_bits = 4, longest_stretch_bits = 6;
/// Ray lengths of a line that are there behind its last element: the last stretch of a run may end there.
inline constexpr std::uint32_t rays_behind = 1U << longest_stretch_bits;
/// Room behind the last ray length, so that whole vectors can be read.
inline constexpr std::size_t rays_padding = 64;

/// From here on nothing is left of 15 bits; no pixel is farther.
inline constexpr float most_octaves = 24.0F;
/// 2^-f for f in [0, 1], exact at both ends, elsewhere within 3.4e-6 of it (a Remez fit of our own): least power first.
inline constexpr std::array<float, 5> falling_octave{1.0F, -0.6930558712921329F, 0.23940567652597328F,
                                                     -0.05312767876381903F, 0.006777873529978617F};

/// What is left of the light, 1.0 at first, over a range of `octaves` in [0, most_octaves].
inline float light_left(float octaves) {
    const auto whole = static_cast<std::int32_t>(octaves);
    const float part = octaves - static_cast<float>(whole);
    float power = falling_octave[4];
    for (int k = 3; k >= 0; --k)
        power = power * part + falling_octave[static_cast<std::size_t>(k)];
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(power) - (whole << 23)); // halved by its exponent
}

/// The same with 15 bits. The inner loops do the same, step by step.
inline std::int32_t transmission_over(float octaves) {
    return static_cast<std::int32_t>(light_left(octaves) * static_cast<float>(transmission_one) + 0.5F);
}

/// Tangents of a pixel's ray: start + n * slope, n the number of its element, of its line.
struct AirRays {
    double element_start = 0, element_slope = 0;
    double line_start = 0, line_slope = 0;
};

/// A channel's air for one frame. Ray lengths are rebuilt only when what they depend on changes.
class Air {
public:
    /// visibility_m <= 0: clear air, and nothing else is prepared.
    void prepare(const PictureScale& scale, const Raster& raster, double visibility_m, Colour horizon);

    bool clear() const { return visibility_m_ <= 0.0; }
    Colour horizon() const { return horizon_; }
    /// Range over which half of the light is lost, metres.
    double m_per_octave() const { return m_per_octave_; }
    const AirRays& ray_slopes() const { return slopes_; }
    /// Ray lengths of a line's elements, and rays_behind more: range = z * ray length.
    const float* rays(std::uint32_t line) const { return rays_.data() + std::size_t{line} * rays_of_line_; }

    /// Greatest relative change of 1/z from one element to the next with which the transmission is straight enough over
    /// n = 2^bits elements. The range changes by a part g of itself from element to element, that of 1/z and at most the
    /// tangent of the angle between two elements together. Then t = exp(-x) curves by at most 0.68 g^2 from element to
    /// element, and the chord over n of them is off by an eighth of n^2 times that: with n g = 1/8 by a third of a level.
    float little_change(int bits) const { return little_change_[static_cast<std::size_t>(bits)]; }

    std::int32_t transmission_at(double range_m) const;

    /// Does the transmission change by less than half a level over the face? Then `transmission` is that of its middle.
    bool is_flat(const DepthPlane& depth, std::int32_t& transmission) const;

private:
    void make_rays(const PictureScale& scale, const Raster& raster);

    double visibility_m_ = 0.0;
    Colour horizon_;
    double m_per_octave_ = 0.0;
    AirRays slopes_;
    std::vector<float> rays_;
    std::uint32_t rays_of_line_ = 0;
    std::array<float, longest_stretch_bits + 1> little_change_{};
    PictureScale made_for_; ///< that the rays belong to
    Raster made_raster_{0, 0, Scan::horizontal};
};

} // namespace linkdig::ig
