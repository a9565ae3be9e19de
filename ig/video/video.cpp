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

/// The air before a face.
FaceAir air_of(const VideoInput& input, std::uint32_t rank) {
    return input.air->clear() ? FaceAir{} : input.face_air[rank];
}

const DepthPlane& depth_of(const VideoInput& input, std::uint32_t rank) {
    return input.projected->depths[static_cast<std::size_t>(input.projected->faces[rank].depth)];
}

/// Runs of one face with one colour code.
void draw_runs(const VideoInput& input, std::uint32_t rank, const FaceAir& face_air,
               std::span<const Segment> runs, const BandPixels& pixels) {
    const FaceShading& shading = input.edges->shadings[rank];
    const Colour colour = input.colours[shading.colour];
    const IntensityPlane& intensity = shading.plane;
    const Air& air = *input.air;
    if (face_air.kind == AirKind::by_pixel) {
        shade_runs_in_air(intensity, colour, depth_of(input, rank), air, runs, pixels);
    } else if (face_air.kind == AirKind::plane) {
        shade_runs_in_haze(intensity, colour, face_air.transmission, air.horizon(), runs, pixels);
    } else if (intensity.least == intensity.greatest) {
        fill_runs(shade(colour, intensity.least), runs, pixels);
    } else {
        shade_runs(intensity, colour, runs, pixels);
    }
}

void draw_coloured_segment(const VideoInput& input, std::uint32_t rank, const FaceAir& face_air,
                           const IntensityPlane* planes, const Segment& segment, std::uint32_t* pixels) {
    if (face_air.kind == AirKind::clear) {
        colour_run(planes, segment.line, segment.first, segment.count, pixels);
    } else {
        colour_run_in_air(planes, face_air, depth_of(input, rank), *input.air, segment.line, segment.first,
                          segment.count, pixels);
    }
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
    const FaceShading& shading = input.edges->shadings[rank];
    const FaceAir face_air = air_of(input, rank);
    const IntensityPlane* const tint = shading.coloured ? tint_of(*input.edges, shading).data() : nullptr;
    if (tint == nullptr) {
        draw_runs(input, rank, face_air, runs, pixels);
        if (frame.rank.empty() && frame.intensity.empty()) return;
    }
    for (const Segment& run : runs) {
        fill_plane(raster, run, static_cast<std::int32_t>(rank), frame.rank);
        if (tint != nullptr) {
            draw_coloured_segment(input, rank, face_air, tint, run, pixels.at(run));
            plane_colours(raster, tint, run, frame);
        } else {
            plane_intensities(raster, shading.plane, run, frame);
        }
    }
}

/// Asks for the faces that are soon needed.
LINKDIG_ALWAYS_INLINE void fetch_ahead(const VideoInput& input, std::span<const FaceSegments> faces) {
    constexpr std::size_t faces_ahead = 12;
    if (faces.size() <= faces_ahead) return;
    prefetch(&input.edges->shadings[faces[faces_ahead].face]);
    if (!input.air->clear()) prefetch(&input.face_air[faces[faces_ahead].face]);
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
    const bool picture_alone = frame.rank.empty() && frame.intensity.empty();
    for (std::size_t k = 0; k < band.faces.size(); ++k) {
        if (picture_alone) k = shade_faces(faces, k, beam.pixels());
        if (k == band.faces.size()) break;
        fetch_ahead(input, faces.faces.subspan(k));
        const std::uint32_t begin = k == 0 ? 0 : band.faces[k - 1].end;
        draw_face(input, raster, band.faces[k].face,
                  {band.segments.data() + begin, band.faces[k].end - begin}, beam.pixels(), frame);
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
