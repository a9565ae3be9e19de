#include "ig/video/beam.h"

#include "ig/video/turn_lines.h"

namespace linkdig::ig {

namespace {

/// A line's pixels are this much apart from the next line's beyond their number: or, in a picture of 1024 rows, the
/// pixels of a row would all want the same place in the cache.
constexpr std::uint32_t line_gap = 16;

/// A picture of more bytes than this finds no place in the caches until its pixels are asked for, and would have to be
/// fetched before it is written over (an estimate: half of what a core has of the last cache on the machines at hand).
constexpr std::size_t most_cached_bytes = std::size_t{8} << 20U;

} // namespace

BeamBuffer::BeamBuffer(const Raster& raster, const BandSegments& band, std::vector<std::uint32_t>& lines,
                       VideoFrame& frame)
    : vertical_(raster.scan == Scan::vertical), lines_(band.end_line - band.first_line),
      frame_(frame), pixels_{nullptr, band.first_line, raster.elements() + (vertical_ ? line_gap : 0)} {
    if (vertical_) lines.resize(std::size_t{band_lines} * pixels_.length);
    pixels_.past_caches = !vertical_ && frame.pixels.size() * sizeof(std::uint32_t) > most_cached_bytes;
    pixels_.start =
        vertical_ ? lines.data() : frame.pixels.data() + std::size_t{band.first_line} * pixels_.length;
}

void BeamBuffer::finish() const {
    settle_pixels(pixels_);
    if (!vertical_) return;
    turn_lines({.pixels = pixels_.start,
                .length = pixels_.length,
                .lines = lines_,
                .elements = pixels_.length - line_gap,
                .picture = frame_.pixels.data() + pixels_.first_line,
                .width = frame_.width});
}

} // namespace linkdig::ig
