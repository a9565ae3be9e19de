#include "ig/machine/make_up.h"

#include "ig/scanline/scanline.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

PixelShare share_of(const VideoInput& video, std::uint32_t rank, std::uint32_t weight, std::uint32_t line,
                    std::uint32_t element) {
    PixelShare share;
    share.rank = rank;
    share.weight = weight;
    if (rank == background_rank) {
        share.code = video.background;
        share.seen.light = lit(video.background, intensity_one);
        return share;
    }
    const ProjectedFace& face = video.projected->faces[rank];
    share.code = video.colours[face.colour];
    share.seen = see(video, rank, line, element);
    share.added_to = face.added_to;
    return share;
}

bool holds(const Segment& segment, std::uint32_t line, std::uint32_t element) {
    return segment.line == line && element >= segment.first &&
           element < std::uint32_t{segment.first} + segment.count;
}

void add_shares(const VideoInput& video, const BandSegments& band, std::uint32_t line, std::uint32_t element,
                std::vector<PixelShare>& shares) {
    std::size_t at = 0;
    for (const FaceSegments& face : band.faces)
        for (; at < face.end; ++at)
            if (holds(band.segments[at], line, element))
                shares.push_back(share_of(video, face.face, whole_pixel, line, element));
    for (const Segment& segment : band.background)
        if (holds(segment, line, element))
            shares.push_back(share_of(video, background_rank, whole_pixel, line, element));
    for (const ShareRun& run : band.shares) {
        if (run.line != line || element < run.first || element >= std::uint32_t{run.first} + run.count)
            continue;
        const std::uint32_t weight = band.weights[run.first_weight + element - run.first];
        if (weight != 0) shares.push_back(share_of(video, run.face, weight, line, element));
    }
}

/// Light that is added falls on opaque faces of its list up to the first semi-opaque one, as video has it (ig/video/share_sums.h).
bool falls_on_none(const ProjectedFaces& projected, const std::vector<PixelShare>& shares,
                   std::size_t light) {
    for (std::size_t k = light + 1; k < shares.size(); ++k) {
        if (shares[k].rank == background_rank || shares[k].added_to >= 0) continue;
        const ProjectedFace& face = projected.faces[shares[k].rank];
        if (static_cast<std::int32_t>(face.list) == shares[light].added_to) return false;
        if (face.opacity < opaque) return true;
    }
    return true;
}

PixelLight light_of(const VideoInput& video, const LightPixel& pixel) {
    const ProjectedLight& light = video.projected->lights[pixel.light];
    PixelLight made{.code = video.light_colours[light.colour]};
    const double part = light.total / 256.0 * pixel.weight / whole_splat;
    const std::uint8_t components[3] = {made.code.red, made.code.green, made.code.blue};
    for (std::size_t k = 0; k < 3; ++k)
        made.levels[k] = std::min(255.0, components[k] * part);
    return made;
}

} // namespace

PixelMakeUp make_up(const DrawnChannel& drawn, std::uint32_t line, std::uint32_t element) {
    const std::uint32_t number = line / band_lines;
    BandScratch scratch;
    BandSegments band;
    band.first_line = number * band_lines;
    band.end_line = std::min(band.first_line + band_lines, drawn.raster.lines());
    resolve_band(*drawn.video.edges, drawn.bands->of(number), drawn.splats->of(number), drawn.splats->pixels,
                 drawn.raster.elements(), drawn.smoothing, scratch, band);
    PixelMakeUp made;
    made.horizon = drawn.video.air->horizon();
    add_shares(drawn.video, band, line, element, made.shares);
    for (std::size_t k = 0; k < made.shares.size(); ++k)
        if (made.shares[k].added_to >= 0)
            made.shares[k].falls_on_none = falls_on_none(*drawn.video.projected, made.shares, k);
    for (const LightPixel& pixel : band.lights)
        if (pixel.line == line && pixel.element == element)
            made.lights.push_back(light_of(drawn.video, pixel));
    return made;
}

} // namespace linkdig::ig
