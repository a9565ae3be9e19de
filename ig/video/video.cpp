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

/// A flat face's intensity as a plane that does not slope.
IntensityPlane level_plane(std::int32_t intensity) {
    return {.value = static_cast<std::uint32_t>(intensity), .least = intensity, .greatest = intensity};
}

/// Runs of one face with one colour code.
void draw_runs(const VideoInput& input, const ProjectedFace& face, const IntensityPlane& intensity,
               std::span<const Segment> runs, const BandPixels& pixels) {
    const Colour colour = input.colours[face.colour];
    const Air& air = *input.air;
    const bool level = intensity.least == intensity.greatest;
    if (air.clear() || face.depth < 0) {
        if (level) {
            fill_runs(shade(colour, intensity.least), runs, pixels);
        } else {
            shade_runs(intensity, colour, runs, pixels);
        }
        return;
    }
    const DepthPlane& depth = input.projected->depths[static_cast<std::size_t>(face.depth)];
    std::int32_t transmission = 0;
    if (!air.is_flat(depth, transmission)) {
        shade_runs_in_air(intensity, colour, depth, air, runs, pixels);
    } else if (level) {
        fill_runs(shade_through_air(colour, intensity.least, transmission, air.horizon()), runs, pixels);
    } else {
        shade_runs_in_haze(intensity, colour, transmission, air.horizon(), runs, pixels);
    }
}

void draw_coloured_segment(const VideoInput& input, const ProjectedFace& face, const IntensityPlane* planes,
                           const Segment& segment, std::uint32_t* pixels) {
    const Air& air = *input.air;
    if (air.clear() || face.depth < 0) {
        colour_run(planes, segment.line, segment.first, segment.count, pixels);
        return;
    }
    const DepthPlane& depth = input.projected->depths[static_cast<std::size_t>(face.depth)];
    std::int32_t transmission = 0;
    const bool flat = air.is_flat(depth, transmission);
    colour_run_in_air(planes, flat ? nullptr : &depth, transmission, air, segment.line, segment.first,
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
void draw_face(const VideoInput& input, const Raster& raster, std::uint32_t rank,
               std::span<const Segment> runs, const BandPixels& pixels, VideoFrame& frame) {
    const ProjectedFace& face = input.projected->faces[rank];
    const EdgeFace& edges = input.edges->faces[rank];
    const IntensityPlane* planes = input.edges->planes.data() + std::max(edges.plane, 0);
    const IntensityPlane intensity = edges.plane >= 0 ? *planes : level_plane(face.intensity);
    if (!edges.coloured) {
        draw_runs(input, face, intensity, runs, pixels);
        if (frame.rank.empty() && frame.intensity.empty()) return;
    }
    for (const Segment& run : runs) {
        fill_plane(raster, run, static_cast<std::int32_t>(rank), frame.rank);
        if (edges.coloured) {
            draw_coloured_segment(input, face, planes, run, pixels.at(run));
            plane_colours(raster, planes, run, frame);
        } else {
            plane_intensities(raster, intensity, run, frame);
        }
    }
}

/// Asks for faces that are soon needed, their planes when they are there. `faces`: those that are still to come.
LINKDIG_ALWAYS_INLINE void fetch_ahead(const VideoInput& input, std::span<const FaceSegments> faces) {
    constexpr std::size_t faces_ahead = 16, planes_ahead = 6;
    if (faces.size() > faces_ahead) {
        prefetch(&input.projected->faces[faces[faces_ahead].face]);
        prefetch(&input.edges->faces[faces[faces_ahead].face]);
    }
    if (faces.size() > planes_ahead)
        prefetch(input.edges->planes.data() + std::max(input.edges->faces[faces[planes_ahead].face].plane, 0));
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
    const std::span<const FaceSegments> faces = band.faces;
    std::size_t first = 0;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        fetch_ahead(input, faces.subspan(k));
        draw_face(input, raster, faces[k].face, {band.segments.data() + first, faces[k].end - first},
                  beam.pixels(), frame);
        first = faces[k].end;
    }
    fill_runs(shade(input.background, intensity_one), band.background, beam.pixels());
    for (const Segment& segment : band.background) {
        fill_plane(raster, segment, std::int32_t{none}, frame.intensity);
        fill_plane(raster, segment, std::int32_t{none}, frame.rank);
    }
    draw_shares(input, raster, band, beam, scratch.shares, frame);
    beam.finish();
    scratch.light_pixels =
        add_lights(input.projected->lights, input.light_colours, raster, band, scratch.lights, frame);
}

} // namespace linkdig::ig
