#include "ig/video/video.h"

#include "ig/edges/edges.h"
#include "ig/video/colour_run.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

/// Where the elements of a line stand in a plane of the picture: a row on a horizontal scan, a column on a
/// vertical one.
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

/// The band's lines, element after element: the picture's own rows on a horizontal scan.
class BeamBuffer {
public:
    BeamBuffer(const Raster& raster, const BandSegments& band, VideoScratch& scratch, VideoFrame& frame)
        : vertical_(raster.scan == Scan::vertical), length_(raster.elements()), first_line_(band.first_line),
          lines_(band.end_line - band.first_line), frame_(frame) {
        if (vertical_) scratch.lines.resize(std::size_t{band_lines} * length_);
        start_ = vertical_ ? scratch.lines.data() : frame.pixels.data() + std::size_t{first_line_} * length_;
    }

    std::uint32_t* at(const Segment& segment) const {
        return start_ + std::size_t{segment.line - first_line_} * length_ + segment.first;
    }

    /// Lines that are columns go into the picture a row of the band at a time.
    void finish() const {
        if (!vertical_) return;
        for (std::uint32_t row = 0; row < length_; ++row) {
            std::uint32_t* out = frame_.pixels.data() + std::size_t{row} * frame_.width + first_line_;
            for (std::uint32_t line = 0; line < lines_; ++line)
                out[line] = start_[std::size_t{line} * length_ + row];
        }
    }

private:
    bool vertical_;
    std::uint32_t length_;
    std::uint32_t first_line_;
    std::uint32_t lines_;
    VideoFrame& frame_;
    std::uint32_t* start_ = nullptr;
};

/// A flat face's intensity as a plane that does not slope.
IntensityPlane level_plane(std::int32_t intensity) {
    return {.value = static_cast<std::uint32_t>(intensity), .least = intensity, .greatest = intensity};
}

void draw_segment(const VideoInput& input, const ProjectedFace& face, const IntensityPlane& intensity,
                  const Segment& segment, std::uint32_t* pixels) {
    const Colour colour = input.colours[face.colour];
    const Air& air = *input.air;
    const bool level = intensity.least == intensity.greatest;
    if (air.clear() || face.depth < 0) {
        if (level) {
            std::fill_n(pixels, segment.count, shade(colour, intensity.least));
        } else {
            shade_run(intensity, colour, segment.line, segment.first, segment.count, pixels);
        }
        return;
    }
    const DepthPlane& depth = input.projected->depths[static_cast<std::size_t>(face.depth)];
    std::int32_t transmission = 0;
    if (!air.is_flat(depth, transmission)) {
        shade_run_in_air(intensity, colour, depth, air, segment.line, segment.first, segment.count, pixels);
    } else if (level) {
        std::fill_n(pixels, segment.count,
                    shade_through_air(colour, intensity.least, transmission, air.horizon()));
    } else {
        shade_run_in_haze(intensity, colour, transmission, air.horizon(), segment.line, segment.first,
                          segment.count, pixels);
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

constexpr std::uint32_t brightest = 255U << 7U; ///< of Components

/// Adds up the shares of the band's shared pixels, front to back, and writes each pixel once.
class ShareSummer {
public:
    ShareSummer(const VideoInput& input, const Raster& raster, const BandSegments& band,
                VideoScratch& scratch)
        : input_(input), raster_(raster), band_(band), sums_(scratch.sums), pending_(scratch.pending) {
        sums_.assign(band.pixels.size(), {});
        pending_.clear();
    }

    void add_up() {
        for (const Share& share : band_.shares) {
            if (share.face == background_rank) {
                add(share, lit(input_.background, intensity_one), none, none, true);
                continue;
            }
            const ProjectedFace& face = input_.projected->faces[share.face];
            std::int32_t intensity = 0;
            const Components shown = lit_share(share, face, intensity);
            if (face.added_to != none) {
                wait(share, through(share, face, shown, true), face.added_to);
            } else {
                add(share, through(share, face, shown, false), static_cast<std::int32_t>(face.list),
                    intensity, face.opacity >= opaque);
            }
        }
    }

    void write(const BeamBuffer& beam, VideoFrame& frame) const {
        for (std::size_t k = 0; k < sums_.size(); ++k) {
            const PixelSum& sum = sums_[k];
            const Segment at{sum.rank, band_.pixels[k].line, band_.pixels[k].element, 1};
            constexpr std::uint32_t half = whole_pixel << 6U;
            *beam.at(at) = ((sum.red + half) >> 24U) | ((sum.green + half) >> 24U) << 8U |
                           ((sum.blue + half) >> 24U) << 16U | 0xff000000U;
            fill_plane(raster_, at, static_cast<std::int32_t>(sum.rank), frame.rank);
            fill_plane(raster_, at, sum.intensity, frame.intensity);
        }
    }

private:
    Components lit_share(const Share& share, const ProjectedFace& face, std::int32_t& intensity) const {
        const EdgeFace& edges = input_.edges->faces[share.face];
        const SharedPixel& pixel = band_.pixels[share.pixel];
        const IntensityPlane* planes = input_.edges->planes.data() + std::max(edges.plane, 0);
        if (edges.coloured) {
            const Tint tint = tint_at(planes, pixel.line, pixel.element);
            intensity = brightest_of(tint);
            return lit(tint);
        }
        intensity = edges.plane < 0 ? face.intensity : intensity_at(*planes, pixel.line, pixel.element);
        return lit(input_.colours[face.colour], intensity);
    }

    /// Light that is added brings no horizon of its own: the face behind it does.
    Components through(const Share& share, const ProjectedFace& face, const Components& shown,
                       bool added) const {
        const Air& air = *input_.air;
        if (air.clear() || face.depth < 0) return shown;
        const DepthPlane& depth = input_.projected->depths[static_cast<std::size_t>(face.depth)];
        const SharedPixel& pixel = band_.pixels[share.pixel];
        std::int32_t transmission = 0;
        if (!air.is_flat(depth, transmission))
            transmission = transmission_of(depth, air, pixel.line, pixel.element);
        return through_air(shown, transmission, added ? Colour{} : air.horizon());
    }

    void wait(const Share& share, const Components& light, std::int32_t added_to) {
        PixelSum& sum = sums_[share.pixel];
        const auto part = [&share](std::uint32_t component) {
            return static_cast<std::uint32_t>((std::uint64_t{component} * share.weight) / whole_pixel);
        };
        pending_.push_back({part(light.red), part(light.green), part(light.blue), added_to, sum.pending});
        sum.pending = static_cast<std::int32_t>(pending_.size() - 1);
    }

    /// Adds a share, brightened by the additive faces in front of it that name its list; clamps once. Added
    /// light falls on all opaque faces that divide the pixel among them (or a mesh would show its seams through
    /// it), and ends at a semi-opaque one, which lies before the whole pixel.
    void add(const Share& share, Components seen, std::int32_t list, std::int32_t intensity, bool is_opaque) {
        PixelSum& sum = sums_[share.pixel];
        for (std::int32_t k = sum.pending; k >= 0; k = pending_[static_cast<std::size_t>(k)].before) {
            const PendingLight& light = pending_[static_cast<std::size_t>(k)];
            if (light.added_to != list || list == none) continue;
            seen = {seen.red + light.red, seen.green + light.green, seen.blue + light.blue};
        }
        if (!is_opaque) sum.pending = -1;
        sum.red += std::min(seen.red, brightest) * share.weight;
        sum.green += std::min(seen.green, brightest) * share.weight;
        sum.blue += std::min(seen.blue, brightest) * share.weight;
        if (share.weight <= sum.rank_weight) return;
        sum.rank_weight = share.weight;
        sum.rank = share.face;
        sum.intensity = intensity;
    }

    const VideoInput& input_;
    const Raster& raster_;
    const BandSegments& band_;
    std::vector<PixelSum>& sums_;
    std::vector<PendingLight>& pending_;
};

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
    const BeamBuffer beam(raster, band, scratch, frame);
    for (const Segment& segment : band.segments) {
        const ProjectedFace& face = input.projected->faces[segment.face];
        const std::int32_t plane = input.edges->faces[segment.face].plane;
        fill_plane(raster, segment, static_cast<std::int32_t>(segment.face), frame.rank);
        if (input.edges->faces[segment.face].coloured) {
            const IntensityPlane* planes = input.edges->planes.data() + plane;
            draw_coloured_segment(input, face, planes, segment, beam.at(segment));
            plane_colours(raster, planes, segment, frame);
            continue;
        }
        const IntensityPlane intensity =
            plane >= 0 ? input.edges->planes[static_cast<std::size_t>(plane)] : level_plane(face.intensity);
        draw_segment(input, face, intensity, segment, beam.at(segment));
        plane_intensities(raster, intensity, segment, frame);
    }
    for (const Segment& segment : band.background) {
        std::fill_n(beam.at(segment), segment.count, shade(input.background, intensity_one));
        fill_plane(raster, segment, std::int32_t{none}, frame.intensity);
        fill_plane(raster, segment, std::int32_t{none}, frame.rank);
    }
    ShareSummer shares(input, raster, band, scratch);
    shares.add_up();
    shares.write(beam, frame);
    beam.finish();
    scratch.light_pixels =
        add_lights(input.projected->lights, input.light_colours, raster, band, scratch.lights, frame);
}

} // namespace linkdig::ig
