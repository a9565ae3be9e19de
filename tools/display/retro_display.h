#pragma once
/// A monitor of the period: one field at a time, lines with dark gaps between them, a phosphor that glows on.
///
///   light held by a pixel       P += fields * picture     when the beam passes it
///   light that leaves a field   E  = min(255, P (1 - persistence)),   P -= E
///
/// Nothing is lost: over a whole update a standing picture gives back exactly its own levels. What a bright line cannot
/// give in its middle it gives at its borders: bright lines are broad ones. All figures are estimated (EST); levels are
/// display-referred, as everywhere.

#include "ig/configuration.h"
#include "ig/video/line.h"

#include <cstdint>
#include <vector>

namespace linkdig::tools {

/// The display enlarges a picture by this factor each way, so that there is room between the lines.
inline constexpr std::uint32_t display_scale = 2;

/// Part of a pixel's light that is still there a field later (EST).
inline constexpr double phosphor_persistence = 0.45;
/// How much brighter a line's middle is than its mean, and its border darker (EST).
inline constexpr double line_contrast = 0.3;

class RetroDisplay {
public:
    /// `raster`: of the pictures; `fields`: that one is scanned out in, at least 1.
    RetroDisplay(const ig::Raster& raster, std::uint32_t fields);

    /// Scans out one field of a picture: the beam passes lines field, field + fields, ... The result is what the screen
    /// shows for that field's time, display_scale times as large; valid until the next call.
    const ig::VideoFrame& show(const ig::VideoFrame& picture, std::uint32_t field);

    /// All fields of a picture, as a camera sees it whose shutter is open for one update.
    const ig::VideoFrame& photograph(const ig::VideoFrame& picture);

    std::uint32_t fields() const { return fields_; }
    std::uint32_t width() const { return glass_.width; }
    std::uint32_t height() const { return glass_.height; }

private:
    void scan(const ig::VideoFrame& picture, std::uint32_t field);
    void glow();
    void enlarge();

    /// A line's light at twice its elements, three components each: in its middle and at its borders.
    struct LineLight {
        std::vector<std::uint32_t> middle, border;
    };
    void smear(std::uint32_t line, LineLight& out) const;
    std::uint32_t& glass_at(std::uint32_t line, std::uint32_t element);

    ig::Raster raster_;
    std::uint32_t fields_;
    std::vector<std::uint32_t> held_;    ///< three components a pixel, 1/256 level
    std::vector<std::uint32_t> emitted_; ///< of the field at hand, 1/256 level, at most 255 levels
    std::vector<std::uint32_t> exposed_; ///< sums of a photograph
    LineLight line_light_[2];
    ig::VideoFrame glass_;
};

} // namespace linkdig::tools
