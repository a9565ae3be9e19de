#pragma once
/// Where the elements of a line stand in the picture.

#include "ig/configuration.h"
#include "ig/scanline/segment.h"
#include "ig/video/line.h"
#include "ig/video/pixel_run.h"

#include <cstdint>
#include <vector>

namespace linkdig::ig {

/// Fills the elements of a segment in a plane of the picture: a row on a horizontal scan, a column on a vertical one. A
/// plane that nobody asked for is empty and stays so.
template <typename Value>
void fill_plane(const Raster& raster, const Segment& segment, Value value, std::vector<Value>& plane) {
    if (plane.empty()) return;
    const bool horizontal = raster.scan == Scan::horizontal;
    const std::size_t start = horizontal ? std::size_t{segment.line} * raster.width + segment.first
                                         : std::size_t{segment.first} * raster.width + segment.line;
    const std::size_t step = horizontal ? 1 : raster.width;
    for (std::size_t k = 0; k < segment.count; ++k)
        plane[start + k * step] = value;
}

/// The band's lines, element after element: the picture's own rows on a horizontal scan.
class BeamBuffer {
public:
    /// `lines` is the working storage of a vertical scan.
    BeamBuffer(const Raster& raster, const BandSegments& band, std::vector<std::uint32_t>& lines,
               VideoFrame& frame);

    const BandPixels& pixels() const { return pixels_; }

    /// Lines that are columns go into the picture a row of the band at a time.
    void finish() const;

private:
    bool vertical_;
    std::uint32_t lines_;
    VideoFrame& frame_;
    BandPixels pixels_;
};

} // namespace linkdig::ig
