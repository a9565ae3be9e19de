#include "ig/video/video.h"

#include "ig/edges/edges.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

/// Where the elements of a line stand in the picture: consecutive on a horizontal scan, a row apart on a
/// vertical one.
struct Beam {
    std::size_t start = 0;
    std::size_t step = 1;
};

Beam beam_of(const Raster& raster, const Segment& segment) {
    if (raster.scan == Scan::horizontal) return {std::size_t{segment.line} * raster.width + segment.first, 1};
    return {std::size_t{segment.first} * raster.width + segment.line, raster.width};
}

template <typename Value>
void fill(std::vector<Value>& plane, const Beam& beam, std::uint32_t count, Value value) {
    if (plane.empty()) return;
    Value* at = plane.data() + beam.start;
    if (beam.step == 1) {
        std::fill_n(at, count, value);
        return;
    }
    for (std::uint32_t k = 0; k < count; ++k, at += beam.step)
        *at = value;
}

/// Intensities run in modulo 2^32 and are clamped to the corners' range, where they are 0 to 2^22.
void draw_smooth(const IntensityPlane& plane, Colour colour, const Segment& segment, const Beam& beam,
                 VideoFrame& frame) {
    std::uint32_t value = plane.value +
                          static_cast<std::uint32_t>(segment.first - plane.reference_element) * plane.along +
                          static_cast<std::uint32_t>(segment.line - plane.reference_line) * plane.across;
    std::uint32_t* at = frame.pixels.data() + beam.start;
    for (std::uint32_t k = 0; k < segment.count; ++k, at += beam.step, value += plane.along) {
        *at = shade(colour, std::clamp(static_cast<std::int32_t>(value), plane.least, plane.greatest));
    }
    if (frame.intensity.empty()) return;
    std::int32_t* intensity = frame.intensity.data() + beam.start;
    for (std::uint32_t k = 0; k < segment.count; ++k, intensity += beam.step) {
        *intensity = intensity_at(plane, segment.line, static_cast<std::int32_t>(segment.first + k));
    }
}

} // namespace

void open_frame(const Raster& raster, bool intensity, bool rank, VideoFrame& frame) {
    const std::size_t size = std::size_t{raster.width} * raster.height;
    frame.width = raster.width;
    frame.height = raster.height;
    frame.pixels.resize(size);
    frame.intensity.resize(intensity ? size : 0);
    frame.rank.resize(rank ? size : 0);
}

void draw_band(const VideoInput& input, const Raster& raster, const BandSegments& band, VideoFrame& frame) {
    for (const Segment& segment : band.segments) {
        const ProjectedFace& face = input.projected->faces[segment.face];
        const Colour colour = input.colours[face.colour];
        const Beam beam = beam_of(raster, segment);
        const std::int32_t plane = input.edges->faces[segment.face].plane;
        if (plane >= 0) {
            draw_smooth(input.edges->planes[static_cast<std::size_t>(plane)], colour, segment, beam, frame);
        } else {
            fill(frame.pixels, beam, segment.count, shade(colour, face.intensity));
            fill(frame.intensity, beam, segment.count, face.intensity);
        }
        fill(frame.rank, beam, segment.count, static_cast<std::int32_t>(segment.face));
    }
    for (const Segment& segment : band.background) {
        const Beam beam = beam_of(raster, segment);
        fill(frame.pixels, beam, segment.count, shade(input.background, intensity_one));
        fill(frame.intensity, beam, segment.count, std::int32_t{none});
        fill(frame.rank, beam, segment.count, std::int32_t{none});
    }
}

} // namespace linkdig::ig
