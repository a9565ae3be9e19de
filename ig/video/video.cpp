#include "ig/video/video.h"

#include "ig/edges/edges.h"
#include "ig/prefetch.h"
#include "ig/video/colour_run.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

void plane_intensities(const Raster& raster, const IntensityPlane& plane, const Segment& segment,
                       VideoFrame& frame) {
    if (frame.intensity.empty()) return;
    for (std::uint32_t k = 0; k < segment.count; ++k) {
        Segment one = segment;
        one.first = static_cast<std::uint16_t>(segment.first + k);
        one.count = 1;
        fill_plane(raster, one, intensity_at(plane, segment.line, one.first), frame.intensity);
    }
}

/// The face's depth plane where its range counts, else null.
const DepthPlane* depth_of(const VideoInput& input, const FaceShading& shading, std::uint32_t rank) {
    if (input.air->clear() || !shading.through_air) return nullptr;
    return &input.projected->depths[static_cast<std::size_t>(input.projected->faces[rank].depth)];
}

void fill_runs(std::uint32_t pixel, std::span<const Segment> runs, const BandPixels& pixels) {
    for (const Segment& run : runs)
        std::fill_n(pixels.at(run), run.count, pixel);
}

/// Runs of one face with one colour code.
void draw_runs(const VideoInput& input, const FaceShading& shading, const DepthPlane* depth,
               std::span<const Segment> runs, const BandPixels& pixels) {
    const Colour colour = input.colours[shading.colour];
    const IntensityPlane& intensity = shading.plane;
    const Air& air = *input.air;
    const bool level = intensity.least == intensity.greatest;
    if (depth == nullptr) {
        if (level) {
            fill_runs(shade(colour, intensity.least), runs, pixels);
        } else {
            shade_runs(intensity, colour, runs, pixels);
        }
        return;
    }
    std::int32_t transmission = 0;
    if (!air.is_flat(*depth, transmission)) {
        shade_runs_in_air(intensity, colour, *depth, air, runs, pixels);
    } else if (level) {
        fill_runs(shade_through_air(colour, intensity.least, transmission, air.horizon()), runs, pixels);
    } else {
        shade_runs_in_haze(intensity, colour, transmission, air.horizon(), runs, pixels);
    }
}

void draw_coloured_segment(const VideoInput& input, const IntensityPlane* planes, const DepthPlane* depth,
                           const Segment& segment, std::uint32_t* pixels) {
    if (depth == nullptr) {
        colour_run(planes, segment.line, segment.first, segment.count, pixels);
        return;
    }
    const Air& air = *input.air;
    std::int32_t transmission = 0;
    const bool flat = air.is_flat(*depth, transmission);
    colour_run_in_air(planes, flat ? nullptr : depth, transmission, air, segment.line, segment.first,
                      segment.count, pixels);
}

/// The brightest of the three interpolants stands for a coloured face in the intensity plane.
std::int32_t brightest_of(const Tint& tint) { return std::max({tint[0], tint[1], tint[2]}); }

void plane_colours(const Raster& raster, const IntensityPlane* planes, const Segment& segment,
                   VideoFrame& frame) {
    if (frame.intensity.empty()) return;
    for (std::uint32_t k = 0; k < segment.count; ++k) {
        Segment one = segment;
        one.first = static_cast<std::uint16_t>(segment.first + k);
        one.count = 1;
        fill_plane(raster, one, brightest_of(tint_at(planes, segment.line, one.first)), frame.intensity);
    }
}

/// The runs of one face.
void draw_face(const VideoInput& input, const Raster& raster, std::span<const Segment> runs,
               const BandPixels& pixels, VideoFrame& frame) {
    const std::uint32_t rank = runs.front().face;
    const FaceShading& shading = input.edges->shadings[rank];
    const DepthPlane* const depth = depth_of(input, shading, rank);
    const IntensityPlane* const tint = shading.coloured ? tint_of(*input.edges, shading).data() : nullptr;
    if (tint == nullptr) draw_runs(input, shading, depth, runs, pixels);
    for (const Segment& run : runs) {
        fill_plane(raster, run, static_cast<std::int32_t>(rank), frame.rank);
        if (tint != nullptr) {
            draw_coloured_segment(input, tint, depth, run, pixels.at(run));
            plane_colours(raster, tint, run, frame);
        } else {
            plane_intensities(raster, shading.plane, run, frame);
        }
    }
}

/// Asks for the faces that are soon needed.
LINKDIG_ALWAYS_INLINE void fetch_ahead(const VideoInput& input, std::span<const Segment> runs) {
    constexpr std::size_t faces_ahead = 64;
    if (runs.size() <= faces_ahead) return;
    prefetch(&input.edges->shadings[runs[faces_ahead].face]);
    if (!input.air->clear()) prefetch(&input.projected->faces[runs[faces_ahead].face]);
}

/// The runs that follow each other and are of one face.
std::span<const Segment> first_face(std::span<const Segment> runs) {
    std::size_t count = 1;
    while (count < runs.size() && runs[count].face == runs.front().face)
        ++count;
    return runs.first(count);
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

void draw_band(const VideoInput& input, const Raster& raster, const BandSegments& band, VideoScratch& scratch,
               VideoFrame& frame) {
    const BeamBuffer beam(raster, band, scratch.lines, frame);
    for (std::span<const Segment> left = band.segments; !left.empty();) {
        const std::span<const Segment> runs = first_face(left);
        fetch_ahead(input, left);
        draw_face(input, raster, runs, beam.pixels(), frame);
        left = left.subspan(runs.size());
    }
    for (const Segment& segment : band.background) {
        std::fill_n(beam.pixels().at(segment), segment.count, shade(input.background, intensity_one));
        fill_plane(raster, segment, std::int32_t{none}, frame.intensity);
        fill_plane(raster, segment, std::int32_t{none}, frame.rank);
    }
    draw_shares(input, raster, band, beam, scratch.shares, frame);
    beam.finish();
    scratch.light_pixels =
        add_lights(input.projected->lights, input.light_colours, raster, band, scratch.lights, frame);
}

} // namespace linkdig::ig
