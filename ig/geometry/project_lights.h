#pragma once
/// Light points on the raster: their place to a fraction of a pixel, how large they are, how bright.
///
///   total = intensity * host's factor * beam * fall-off * extinction * growth
///
/// growth is 1 for a point, and the splat's area against a point's where it is near enough to have a size. Beam and
/// fall-off: LightPoint (database/model/visual_database.h). Extinction as that of faces (ig/video/fog.h), but nothing
/// of the horizon is added: what stands behind the light brings that.

#include "ig/active/face_block.h"
#include "ig/configuration.h"
#include "ig/geometry/projected_face.h"
#include "ig/geometry/view.h"

#include <span>

namespace linkdig::ig {

/// Radius of the smallest splat: a point between four pixels still reaches all four, and one that moves keeps its
/// brightest pixel within a factor of two.
inline constexpr std::int32_t least_splat_radius = 384; // 1.5 pixels
/// Radius of the largest: bounds what a light close to the eye costs.
inline constexpr std::int32_t greatest_splat_radius = 16 * subpixels;

/// Is a flashing light lit? The period begins `phase` of a period before time 0; a light without a rate is steady.
bool is_lit(const LightPoint& light, double time_s);

/// How much of a light goes towards an eye that lies in direction `to_eye` (any length, list's frame): 0 to 1 of its
/// middle. `back`: the second beam of a two-way light is the one that is seen.
double beam_part(const LightPoint& light, const Vec3d& to_eye, bool& back);

/// What distance leaves of it.
double fall_off_at(const LightPoint& light, double range_m);

class LightProjector {
public:
    LightProjector(const ActiveDatabase& active, const View& view, const Raster& raster,
                   ProjectedFaces& projected);

    /// The lists' frame that the following lights stand in.
    void enter(const Mat3d& channel_from_list, const Vec3d& origin_m, bool at_eye);

    /// Puts out light number `index`, behind all faces put out so far, if the light step lets it through and it shines into
    /// the picture. `fade`, of 256: that of its level of detail.
    void put(std::span<const LightPoint> lights, std::uint32_t index, std::uint32_t fade);

private:
    bool project(const LightPoint& light, std::uint32_t fade, ProjectedLight& projected) const;
    double total(const LightPoint& light, double part, double range_m, std::int32_t radius) const;

    const ActiveDatabase& active_;
    const View& view_;
    ProjectedFaces& out_;
    double last_line_;    ///< 1/256 pixel
    double last_element_; ///< 1/256 pixel
    double pixels_at_one_m_;
    Mat3d channel_from_list_{1.0};
    Vec3d origin_{0};
    bool at_eye_ = false;
};

} // namespace linkdig::ig
