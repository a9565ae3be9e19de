#include "ig/video/share_sums.h"

#include "ig/prefetch.h"
#include "ig/scanline/open_mask.h"
#include "ig/video/see.h"
#include "ig/video/share_run.h"

#include <algorithm>
#include <bit>
#include <span>

namespace linkdig::ig {

namespace {

class ShareSummer {
public:
    ShareSummer(const VideoInput& input, const Raster& raster, const BandSegments& band, ShareSums& sums,
                const VideoFrame& frame)
        : input_(input), raster_(raster), band_(band), sums_(sums), elements_(raster.elements()),
          tells_(!frame.rank.empty() || !frame.intensity.empty()) {
        const std::size_t size = std::size_t{band_lines} * elements_ + sums_padding;
        for (std::vector<std::uint32_t>* sum : {&sums_.red, &sums_.green, &sums_.blue})
            if (sum->size() < size) sum->resize(size);
        if (tells_ && sums_.tales.size() < size) sums_.tales.resize(size);
        sums_at_ = {sums_.red.data(), sums_.green.data(), sums_.blue.data(), band.first_line, elements_};
        sums_.lists_waiting = 0;
    }

    void add_up() {
        for (std::span<const ShareRun> left = band_.shares; !left.empty();) {
            std::size_t count = 1; // runs of a face come one after the other
            while (count < left.size() && left[count].face == left.front().face)
                ++count;
            const std::span<const ShareRun> runs = left.first(count);
            fetch_ahead(left);
            left = left.subspan(count);
            if (!tells_ && add_fast(runs)) continue;
            for (const ShareRun& run : runs)
                add_one_by_one(run);
        }
    }

    void write(const BeamBuffer& beam, VideoFrame& frame) {
        for (std::uint32_t line = band_.first_line; line < band_.end_line; ++line) {
            const std::uint64_t* shared =
                band_.shared.data() + std::size_t{line - band_.first_line} * band_.words;
            for (std::uint32_t word = 0; word < band_.words; ++word) {
                if (shared[word] == 0) continue;
                const std::uint32_t first = word * word_bits;
                write_shares(sums_at_, line, first, shared[word], beam.pixels().at(line, first));
                if (tells_) write_tales(line, first, shared[word], frame);
            }
        }
        for (std::size_t k = 0; k < sums_.lists_waiting; ++k)
            put_out(sums_.waiting[k]);
    }

private:
    std::size_t place(std::uint32_t line, std::uint32_t element) const { return sums_at_.at(line, element); }

    /// Asks for a face that is soon needed.
    LINKDIG_ALWAYS_INLINE void fetch_ahead(std::span<const ShareRun> runs) const {
        constexpr std::size_t runs_ahead = 32;
        if (runs.size() > runs_ahead && runs[runs_ahead].face != background_rank)
            prefetch(&input_.edges->shadings[runs[runs_ahead].face]);
    }

    // ---- runs whose pixels need nothing but their colour ---------------------------------------------------------

    /// False if the pixels of a face's runs must be looked at one by one.
    bool add_fast(std::span<const ShareRun> runs) {
        const std::uint32_t* const weights = band_.weights.data();
        RunColour colour{
            .colour = input_.background, .plane = {}, .transmission = {}, .horizon = input_.air->horizon()};
        const std::uint32_t rank = runs.front().face;
        if (rank == background_rank) {
            colour.plane.value = intensity_one;
            colour.plane.least = colour.plane.greatest = intensity_one;
        } else if (!colour_of(rank, colour)) {
            return false;
        } else if (input_.edges->faces[rank].additive) {
            colour.horizon = {}; // light that is added brings no horizon of its own: the face behind it does
            WaitingLight& light = waiting_for(input_.projected->faces[rank].added_to);
            for (const ShareRun& run : runs)
                set_bits(there(light, run.line), run.first, std::uint32_t{run.first} + run.count);
            add_light_runs(colour, runs, weights, light_of(light));
            return true;
        } else if (sums_.lists_waiting != 0) {
            for (const ShareRun& run : runs)
                add_behind_light(input_.projected->faces[rank], colour, run);
            return true;
        }
        add_share_runs(colour, runs, weights, sums_at_);
        return true;
    }

    /// A run of an ordinary face where light may wait for it.
    void add_behind_light(const ProjectedFace& face, const RunColour& colour, const ShareRun& run) {
        if (WaitingLight* const light = waiting(run, static_cast<std::int32_t>(face.list)))
            add_lit_runs(colour, {&run, 1}, band_.weights.data(), light_of(*light), sums_at_);
        else
            add_share_runs(colour, {&run, 1}, band_.weights.data(), sums_at_);
        if (face.opacity < opaque) end_light(run);
    }

    /// False if the transmission is taken pixel by pixel, or the face has three interpolants.
    bool colour_of(std::uint32_t rank, RunColour& run) const {
        const FaceShading& shading = input_.edges->shadings[rank];
        if (shading.coloured) return false;
        run.colour = input_.colours[shading.colour];
        run.plane = shading.plane;
        if (input_.air->clear()) return true;
        const FaceAir& air = input_.face_air[rank];
        run.in_air = air.kind != AirKind::clear;
        run.transmission = air.transmission;
        return air.kind != AirKind::by_pixel;
    }

    // ---- light that is added -------------------------------------------------------------------------------------
    //
    // It falls on all opaque faces of its list that divide the pixel among them (or a mesh would show its seams through it), and
    // ends at a semi-opaque one, which lies before the whole pixel.

    WaitingLight& waiting_for(std::int32_t list) {
        for (std::size_t k = 0; k < sums_.lists_waiting; ++k)
            if (sums_.waiting[k].list == list) return sums_.waiting[k];
        if (sums_.waiting.size() == sums_.lists_waiting) sums_.waiting.emplace_back();
        WaitingLight& light = sums_.waiting[sums_.lists_waiting++];
        light.list = list;
        const std::size_t size = std::size_t{band_lines} * elements_ + sums_padding;
        for (std::vector<std::uint32_t>* sum : {&light.red, &light.green, &light.blue})
            if (sum->size() < size) sum->resize(size);
        light.there.assign(std::size_t{band_lines} * band_.words, 0);
        return light;
    }

    BandSums light_of(WaitingLight& light) const {
        return {light.red.data(), light.green.data(), light.blue.data(), band_.first_line, elements_};
    }

    std::uint64_t* there(WaitingLight& light, std::uint32_t line) const {
        return light.there.data() + std::size_t{line - band_.first_line} * band_.words;
    }

    /// Light over some of the run's pixels for a face of this list behind them; null if there is none.
    WaitingLight* waiting(const ShareRun& run, std::int32_t list) {
        const std::uint32_t end = std::uint32_t{run.first} + run.count;
        for (std::size_t k = 0; k < sums_.lists_waiting; ++k) {
            WaitingLight& light = sums_.waiting[k];
            if (light.list == list && next_set(there(light, run.line), run.first, end) < end) return &light;
        }
        return nullptr;
    }

    /// Ends all light over the run's pixels, where the run has a share.
    void end_light(const ShareRun& run) {
        const std::size_t at = place(run.line, run.first);
        for (std::size_t w = 0; w < sums_.lists_waiting; ++w) {
            WaitingLight& light = sums_.waiting[w];
            for (std::uint32_t k = 0; k < run.count; ++k)
                if (band_.weights[run.first_weight + k] != 0)
                    light.red[at + k] = light.green[at + k] = light.blue[at + k] = 0;
        }
    }

    /// Makes all of the light nought.
    void put_out(WaitingLight& light) {
        for (std::uint32_t line = band_.first_line; line < band_.end_line; ++line)
            for (std::uint32_t word = 0; word < band_.words; ++word)
                for (std::uint64_t bits = there(light, line)[word]; bits != 0;) {
                    const BitRun run = take_run(bits);
                    const std::size_t at = place(line, word * word_bits + run.first);
                    for (std::vector<std::uint32_t>* sum : {&light.red, &light.green, &light.blue})
                        std::fill_n(sum->begin() + static_cast<std::ptrdiff_t>(at), run.count(), 0U);
                }
    }

    // ---- pixel by pixel ------------------------------------------------------------------------------------------

    void add_one_by_one(const ShareRun& run) {
        const ProjectedFace* const face =
            run.face == background_rank ? nullptr : &input_.projected->faces[run.face];
        WaitingLight* const light = face == nullptr ? nullptr
                                    : face->added_to == none
                                        ? waiting(run, static_cast<std::int32_t>(face->list))
                                        : &waiting_for(face->added_to);
        for (std::uint32_t k = 0; k < run.count; ++k) {
            const std::uint32_t weight = band_.weights[run.first_weight + k];
            if (weight == 0) continue;
            const std::uint32_t element = run.first + k;
            const std::size_t at = place(run.line, element);
            if (face == nullptr) {
                add(at, weight, {lit(input_.background, intensity_one)}, run.face);
            } else if (const Seen seen = see(input_, run.face, run.line, element); face->added_to != none) {
                set_bits(there(*light, run.line), element, element + 1);
                light->red[at] += seen.light.red * weight >> whole_pixel_bits;
                light->green[at] += seen.light.green * weight >> whole_pixel_bits;
                light->blue[at] += seen.light.blue * weight >> whole_pixel_bits;
            } else {
                add(at, weight, light == nullptr ? seen : brightened(seen, *light, at), run.face);
            }
        }
        if (face != nullptr && face->added_to == none && face->opacity < opaque) end_light(run);
    }

    static Seen brightened(Seen seen, const WaitingLight& light, std::size_t at) {
        seen.light = {std::min(seen.light.red + light.red[at], brightest),
                      std::min(seen.light.green + light.green[at], brightest),
                      std::min(seen.light.blue + light.blue[at], brightest)};
        return seen;
    }

    void add(std::size_t at, std::uint32_t weight, const Seen& seen, std::uint32_t rank) {
        sums_.red[at] += seen.light.red * weight;
        sums_.green[at] += seen.light.green * weight;
        sums_.blue[at] += seen.light.blue * weight;
        if (!tells_) return;
        PixelTale& tale = sums_.tales[at];
        if (weight > tale.rank_weight) tale = {rank, weight, seen.intensity};
    }

    // ---- writing -------------------------------------------------------------------------------------------------

    void write_tales(std::uint32_t line, std::uint32_t first, std::uint64_t shared, VideoFrame& frame) {
        for (; shared != 0; shared &= shared - 1) {
            const std::uint32_t element = first + static_cast<std::uint32_t>(std::countr_zero(shared));
            PixelTale& tale = sums_.tales[place(line, element)];
            const Segment one{static_cast<std::uint16_t>(line), static_cast<std::uint16_t>(element), 1};
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
    BandSums sums_at_;
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
