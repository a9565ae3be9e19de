#include "ig/video/video.h"

#include "ig/edges/edges.h"
#include "ig/video/colour_run.h"
#include "ig/video/see.h"

namespace linkdig::ig {

namespace {

/// A face that shade_faces() leaves: it has three interpolants, or its air is taken pixel by pixel.
void draw_face(const VideoInput& input, std::uint32_t rank, std::span<const Segment> runs,
               const BandPixels& pixels) {
    const FaceShading& shading = input.edges->shadings[rank];
    const Air& air = *input.air;
    const auto depth = [&]() -> const DepthPlane& {
        return input.projected->depths[static_cast<std::size_t>(input.projected->faces[rank].depth)];
    };
    if (!shading.coloured) {
        shade_runs_in_air(shading.plane, input.colours[shading.colour], depth(), air, runs, pixels);
        return;
    }
    const IntensityPlane* const planes = tint_of(*input.edges, shading).data();
    const bool clear = air.clear() || input.face_air[rank].kind == AirKind::clear;
    for (const Segment& run : runs) {
        if (clear) {
            colour_run(planes, run.line, run.first, run.count, pixels.at(run));
        } else {
            colour_run_in_air(planes, input.face_air[rank], depth(), air, run.line, run.first, run.count,
                              pixels.at(run));
        }
    }
}

/// What the planes beside the picture tell of a face's runs.
void tell_face(const VideoInput& input, const Raster& raster, std::uint32_t rank,
               std::span<const Segment> runs, VideoFrame& frame) {
    for (const Segment& run : runs) {
        fill_plane(raster, run, static_cast<std::int32_t>(rank), frame.rank);
        for (std::uint16_t k = 0; k < run.count && !frame.intensity.empty(); ++k) {
            const Segment one{run.line, static_cast<std::uint16_t>(run.first + k), 1};
            fill_plane(raster, one, see(input, rank, one.line, one.first).intensity, frame.intensity);
        }
    }
}

/// The runs of the band's face number k.
std::span<const Segment> runs_of(const BandSegments& band, std::size_t k) {
    const std::uint32_t begin = k == 0 ? 0 : band.faces[k - 1].end;
    return {band.segments.data() + begin, band.faces[k].end - begin};
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
    const BandFaces faces{band.faces,    band.segments,  input.edges->shadings,
                          input.colours, input.face_air, input.air->horizon()};
    for (std::size_t k = shade_faces(faces, 0, beam.pixels()); k < band.faces.size();
         k = shade_faces(faces, k + 1, beam.pixels()))
        draw_face(input, band.faces[k].face, runs_of(band, k), beam.pixels());
    const bool tells = !frame.rank.empty() || !frame.intensity.empty();
    for (std::size_t k = 0; tells && k < band.faces.size(); ++k)
        tell_face(input, raster, band.faces[k].face, runs_of(band, k), frame);
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
