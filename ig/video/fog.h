#pragma once
/// Limited visibility: what is seen through the air turns into the horizon's colour.
///
///   colour = t * face + (1 - t) * horizon,   t = exp(-2.996 d / V)
///
/// d is the Euclidean range of the pixel, V the meteorological optical range: at d = V five hundredths of the contrast
/// are left (Koschmieder's law with a contrast threshold of 0.05, whose negative logarithm 2.996 is).
///
/// Range is needed per pixel: 1/z is linear on the screen (DepthPlane), z times a ray-length table is the range, and t
/// comes from a table of integers in steps of 1/512 of optical depth: at most a quarter of a level off.

#include "database/model/visual_database.h"
#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace linkdig::ig {

inline constexpr double extinction_at_visibility = 2.996;
/// Transmission 1.0 in the table; 15 bits, as intensities have in the inner loop.
inline constexpr std::int32_t transmission_one = 32767;

/// Room behind the last ray length, so that whole vectors can be read.
inline constexpr std::size_t rays_padding = 64;

/// A channel's air for one frame. Tables are rebuilt only when what they depend on changes.
class Air {
public:
    /// visibility_m <= 0: clear air, and nothing else is prepared.
    void prepare(const PictureScale& scale, const Raster& raster, double visibility_m, Colour horizon);

    bool clear() const { return visibility_m_ <= 0.0; }
    Colour horizon() const { return horizon_; }
    /// Steps of the transmission table per metre of range.
    float steps_per_m() const { return steps_per_m_; }
    const std::int32_t* transmission() const { return transmission_.data(); }
    /// Ray lengths of a line's elements: range = z * ray length.
    const float* rays(std::uint32_t line) const { return rays_.data() + std::size_t{line} * elements_; }

    /// Transmission over a range, looked up as the inner loop does it.
    std::int32_t transmission_at(double range_m) const;

    /// Does the transmission change by less than half a level over the face? Then `transmission` is that of its middle.
    bool is_flat(const DepthPlane& depth, std::int32_t& transmission) const;

private:
    void make_rays(const PictureScale& scale, const Raster& raster);

    double visibility_m_ = 0.0;
    Colour horizon_;
    float steps_per_m_ = 0.0F;
    std::vector<std::int32_t> transmission_;
    std::vector<float> rays_;
    std::uint32_t elements_ = 0;
    PictureScale made_for_; ///< that the rays belong to
    Raster made_raster_{0, 0, Scan::horizontal};
};

/// Entries of the transmission table: optical depth 0 to 8 (where a third of a thousandth is left) in steps of 1/512.
inline constexpr std::int32_t transmission_entries = 4096;
inline constexpr double steps_per_optical_depth = 512.0;
/// No face is nearer to infinity than this, 1/m: keeps the division finite; transmission is nought long before.
inline constexpr float least_inverse_m = 1e-9F;

} // namespace linkdig::ig
