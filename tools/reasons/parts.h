#pragma once
/// Figures of a pixel's parts, in levels and parts of one: shared by the words and the JSON.

#include "ig/geometry/projected_face.h"
#include "ig/machine/explain.h"

namespace linkdig::tools {

inline const char* tree_name(ig::PlaneTaken::Tree tree) {
    constexpr const char* names[] = {"group", "cluster", "list"};
    return names[static_cast<int>(tree)];
}
inline const char* side_name(ig::PlaneTaken::Side side) {
    constexpr const char* names[] = {"front", "on", "back"};
    return names[static_cast<int>(side)];
}

inline double unit(std::int32_t intensity) { return intensity / static_cast<double>(ig::intensity_one); }

/// Of 255, with fractions.
struct Levels {
    double red = 0, green = 0, blue = 0;
};

/// As seen, through the air.
inline Levels levels_of(const ig::PixelShare& share) {
    const ig::Components& light = share.seen.light;
    return {light.red / 128.0, light.green / 128.0, light.blue / 128.0};
}

/// Before the air.
inline Levels own_levels(const ig::Layer& layer, const ig::PixelShare& share) {
    if (layer.coloured)
        return {255.0 * unit(layer.tint[0]), 255.0 * unit(layer.tint[1]), 255.0 * unit(layer.tint[2])};
    const double intensity = unit(layer.intensity);
    return {share.code.red * intensity, share.code.green * intensity, share.code.blue * intensity};
}

inline double part(const ig::PixelShare& share) {
    return share.weight / static_cast<double>(ig::whole_pixel);
}

inline double transmission(const ig::PixelShare& share) {
    return share.seen.transmission / static_cast<double>(ig::transmission_one);
}

/// The layer of a rank; null: the background.
const ig::Layer* layer_of(const ig::PixelReasons& reasons, std::uint32_t rank);

} // namespace linkdig::tools
