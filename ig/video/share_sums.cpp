#include "ig/video/share_sums.h"

#include "ig/edges/edges.h"
#include "ig/video/colour_run.h"
#include "ig/video/share_run.h"

#include <algorithm>
#include <bit>

namespace linkdig::ig {

namespace {

constexpr std::uint32_t brightest = 255U << 7U; ///< of Components
constexpr std::uint32_t word_bits = 64;

/// What is seen of a face in one pixel.
struct Seen {
    Components light;
    std::int32_t intensity = -1;
};

class ShareSummer {
public:
    ShareSummer(const VideoInput& input, const Raster& raster, const BandSegments& band, ShareSums& sums,
                const VideoFrame& frame)
        : input_(input), raster_(raster), band_(band), sums_(sums), elements_(raster.elements()),
          tells_(band.added || !frame.rank.empty() || !frame.intensity.empty()) {
        const std::size_t size = std::size_t{band_lines} * elements_ + sums_padding;
        for (std::vector<std::uint32_t>* sum : {&sums_.red, &sums_.green, &sums_.blue})
            if (sum->size() < size) sum->resize(size);
        if (tells_ && sums_.tales.size() < size) sums_.tales.resize(size);
        sums_.pending.clear();
    }

    void add_up() {
        for (const ShareRun& run : band_.shares) {
            if (!tells_ && add_fast(run)) continue;
            add_one_by_one(run);
        }
    }

    void write(const BeamBuffer& beam, VideoFrame& frame) {
        for (std::uint32_t line = band_.first_line; line < band_.end_line; ++line) {
            const std::uint64_t* shared =
                band_.shared.data() + std::size_t{line - band_.first_line} * band_.words;
            for (std::uint32_t word = 0; word < band_.words; ++word) {
                for (std::uint64_t pixels = shared[word]; pixels != 0;) {
                    const auto first = static_cast<std::uint32_t>(std::countr_zero(pixels));
                    const auto count = static_cast<std::uint32_t>(std::countr_one(pixels >> first));
                    write_run(line, word * word_bits + first, count, beam, frame);
                    pixels &= first + count < word_bits ? ~std::uint64_t{0} << (first + count) : 0;
                }
            }
        }
    }

private:
    std::size_t place(std::uint32_t line, std::uint32_t element) const {
        return std::size_t{line - band_.first_line} * elements_ + element;
    }

    // ---- runs whose pixels need nothing but their colour ---------------------------------------------------------

    /// False if the run's pixels must be looked at one by one.
    bool add_fast(const ShareRun& run) {
        RunColour colour{.colour = input_.background, .plane = {}, .horizon = input_.air->horizon()};
        if (run.face == background_rank) {
            colour.plane.value = intensity_one;
            colour.plane.least = colour.plane.greatest = intensity_one;
        } else if (!colour_of(run.face, colour)) {
            return false;
        }
        const std::size_t at = place(run.line, run.first);
        add_share_run(colour, run.line, run.first, run.count, band_.weights.data() + run.first_weight,
                      {sums_.red.data() + at, sums_.green.data() + at, sums_.blue.data() + at});
        return true;
    }

    bool colour_of(std::uint32_t rank, RunColour& run) const {
        const ProjectedFace& face = input_.projected->faces[rank];
        const EdgeFace& edges = input_.edges->faces[rank];
        if (edges.coloured) return false;
        run.colour = input_.colours[face.colour];
        if (edges.plane >= 0) {
            run.plane = input_.edges->planes[static_cast<std::size_t>(edges.plane)];
        } else {
            run.plane.value = static_cast<std::uint32_t>(face.intensity);
            run.plane.least = run.plane.greatest = face.intensity;
        }
        if (input_.air->clear() || face.depth < 0) return true;
        return input_.air->is_flat(input_.projected->depths[static_cast<std::size_t>(face.depth)],
                                   run.transmission);
    }

    // ---- pixel by pixel ------------------------------------------------------------------------------------------

    void add_one_by_one(const ShareRun& run) {
        for (std::uint32_t k = 0; k < run.count; ++k) {
            const std::uint32_t weight = band_.weights[run.first_weight + k];
            if (weight == 0) continue;
            const std::uint32_t element = run.first + k;
            const std::size_t at = place(run.line, element);
            if (run.face == background_rank) {
                add(at, weight, {lit(input_.background, intensity_one), -1}, run.face, none, true);
                continue;
            }
            const ProjectedFace& face = input_.projected->faces[run.face];
            const bool added = face.added_to != none;
            const Seen seen = see(run.face, run.line, element, added);
            if (added) {
                wait(at, weight, seen.light, face.added_to);
            } else {
                add(at, weight, seen, run.face, static_cast<std::int32_t>(face.list), face.opacity >= opaque);
            }
        }
    }

    Seen see(std::uint32_t rank, std::uint32_t line, std::uint32_t element, bool added) const {
        const ProjectedFace& face = input_.projected->faces[rank];
        const EdgeFace& edges = input_.edges->faces[rank];
        const auto l = static_cast<std::int32_t>(line), e = static_cast<std::int32_t>(element);
        const IntensityPlane* planes = input_.edges->planes.data() + std::max(edges.plane, 0);
        Seen seen;
        if (edges.coloured) {
            const Tint tint = tint_at(planes, l, e);
            seen = {lit(tint), std::max({tint[0], tint[1], tint[2]})};
        } else {
            seen.intensity = edges.plane < 0 ? face.intensity : intensity_at(*planes, l, e);
            seen.light = lit(input_.colours[face.colour], seen.intensity);
        }
        const Air& air = *input_.air;
        if (air.clear() || face.depth < 0) return seen;
        const DepthPlane& depth = input_.projected->depths[static_cast<std::size_t>(face.depth)];
        std::int32_t transmission = 0;
        if (!air.is_flat(depth, transmission)) transmission = transmission_of(depth, air, l, e);
        // Light that is added brings no horizon of its own: the face behind it does.
        seen.light = through_air(seen.light, transmission, added ? Colour{} : air.horizon());
        return seen;
    }

    void wait(std::size_t at, std::uint32_t weight, const Components& light, std::int32_t added_to) {
        const auto part = [weight](std::uint32_t component) {
            return static_cast<std::uint32_t>((std::uint64_t{component} * weight) / whole_pixel);
        };
        PixelTale& tale = sums_.tales[at];
        sums_.pending.push_back(
            {part(light.red), part(light.green), part(light.blue), added_to, tale.pending});
        tale.pending = static_cast<std::int32_t>(sums_.pending.size() - 1);
    }

    /// Adds a share, brightened by the additive faces in front of it that name its list; clamps once. Added
    /// light falls on all opaque faces that divide the pixel among them (or a mesh would show its seams through
    /// it), and ends at a semi-opaque one, which lies before the whole pixel.
    void add(std::size_t at, std::uint32_t weight, Seen seen, std::uint32_t rank, std::int32_t list,
             bool is_opaque) {
        if (tells_) tell(at, weight, seen, rank, list, is_opaque);
        sums_.red[at] += std::min(seen.light.red, brightest) * weight;
        sums_.green[at] += std::min(seen.light.green, brightest) * weight;
        sums_.blue[at] += std::min(seen.light.blue, brightest) * weight;
    }

    void tell(std::size_t at, std::uint32_t weight, Seen& seen, std::uint32_t rank, std::int32_t list,
              bool is_opaque) {
        PixelTale& tale = sums_.tales[at];
        for (std::int32_t k = tale.pending; k >= 0; k = sums_.pending[static_cast<std::size_t>(k)].before) {
            const PendingLight& light = sums_.pending[static_cast<std::size_t>(k)];
            if (light.added_to != list || list == none) continue;
            seen.light = {seen.light.red + light.red, seen.light.green + light.green,
                          seen.light.blue + light.blue};
        }
        if (!is_opaque) tale.pending = -1;
        if (weight <= tale.rank_weight) return;
        tale.rank_weight = weight;
        tale.rank = rank;
        tale.intensity = seen.intensity;
    }

    // ---- writing -------------------------------------------------------------------------------------------------

    void write_run(std::uint32_t line, std::uint32_t first, std::uint32_t count, const BeamBuffer& beam,
                   VideoFrame& frame) {
        constexpr std::uint32_t half = whole_pixel << 6U;
        const std::size_t at = place(line, first);
        std::uint32_t* red = sums_.red.data() + at;
        std::uint32_t* green = sums_.green.data() + at;
        std::uint32_t* blue = sums_.blue.data() + at;
        std::uint32_t* pixels = beam.pixels().at(line, first);
        for (std::uint32_t k = 0; k < count; ++k)
            pixels[k] = ((red[k] + half) >> 24U) | ((green[k] + half) >> 24U) << 8U |
                        ((blue[k] + half) >> 24U) << 16U | 0xff000000U;
        for (std::uint32_t* sum : {red, green, blue})
            std::fill_n(sum, count, 0U);
        if (!tells_) return;
        for (std::uint32_t k = 0; k < count; ++k) {
            PixelTale& tale = sums_.tales[at + k];
            const Segment one{tale.rank, static_cast<std::uint16_t>(line),
                              static_cast<std::uint16_t>(first + k), 1};
            fill_plane(raster_, one, static_cast<std::int32_t>(tale.rank), frame.rank);
            fill_plane(raster_, one, tale.intensity, frame.intensity);
            tale = {};
        }
    }

    const VideoInput& input_;
    const Raster& raster_;
    const BandSegments& band_;
    ShareSums& sums_;
    std::uint32_t elements_;
    bool tells_;
};

} // namespace

void draw_shares(const VideoInput& input, const Raster& raster, const BandSegments& band,
                 const BeamBuffer& beam, ShareSums& sums, VideoFrame& frame) {
    if (band.shares.empty()) return;
    ShareSummer summer(input, raster, band, sums, frame);
    summer.add_up();
    summer.write(beam, frame);
}

} // namespace linkdig::ig
