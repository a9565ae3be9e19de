#include "ig/scanline/scanline.h"

#include "ig/edges/edges.h"
#include "ig/scanline/fetch_ahead.h"
#include "ig/scanline/open_mask.h"
#include "ig/scanline/smoothed_lines.h"
#include "ig/simd/simd_level.h"

#include <algorithm>
#include <bit>

namespace linkdig::ig {

namespace {

class BandResolver {
public:
    BandResolver(const FaceEdges& edges, std::uint32_t elements, bool smoothing, BandScratch& scratch,
                 BandSegments& segments)
        : edges_(edges), scratch_(scratch), band_(scratch.band), out_(segments),
          elements_(static_cast<std::int32_t>(elements)), words_((elements + word_bits - 1) / word_bits),
          smoothing_(smoothing), first_line_(static_cast<std::int32_t>(segments.first_line)),
          end_line_(static_cast<std::int32_t>(segments.end_line)) {}

    void run(std::span<const std::uint32_t> ranks, std::span<const BandLight> lights,
             std::span<const SplatPixel> splats) {
        open_all();
        for (std::size_t k = 0; k < ranks.size(); ++k) {
            k += take_opaque(ranks.subspan(k), lights);
            if (k == ranks.size()) break;
            const std::uint32_t rank = ranks[k];
            fetch_ahead(edges_, ranks.subspan(k), smoothing_);
            for (; !lights.empty() && lights.front().rank <= rank; lights = lights.subspan(1))
                put_light(lights.front(), splats);
            if (band_.open_lines == 0) break; // whatever comes now is behind
            face_ = &edges_.faces[rank];
            rank_ = rank;
            const std::size_t before = out_.segments.size();
            if (smoothing_) {
                put_by_area();
            } else {
                put_by_centres();
            }
            if (const std::size_t now = out_.segments.size(); now != before)
                out_.faces.push_back({rank, static_cast<std::uint32_t>(now)});
        }
        for (const BandLight& light : lights)
            put_light(light, splats);
        leave_background();
    }

private:
    /// Takes the opaque faces that come first, up to the next light; how many they are.
    std::size_t take_opaque(std::span<const std::uint32_t> ranks, std::span<const BandLight> lights) {
        if (smoothing_ || sharing_) return 0;
        if (!lights.empty()) {
            const auto next = std::ranges::lower_bound(ranks, lights.front().rank);
            ranks = ranks.first(static_cast<std::size_t>(next - ranks.begin()));
        }
        return take_opaque_faces(edges_, ranks, band_, out_);
    }

    void open_all() {
        const auto lines = static_cast<std::size_t>(end_line_ - first_line_);
        band_.first_line = first_line_;
        band_.end_line = end_line_;
        OpenWords all_open;
        all_open.of_line.fill(~std::uint64_t{0});
        band_.open.assign(words_ + 1, all_open);
        out_.words = words_;
        out_.shared.assign(lines * words_ + 1, 0); // a spare word (smoothed_lines.h)
        const std::size_t pixels = std::size_t{band_lines} * static_cast<std::size_t>(elements_) +
                                   static_cast<std::size_t>(narrow_elements);
        if (scratch_.left.size() < pixels) scratch_.left.resize(pixels, whole_pixel);
        const std::uint32_t beyond = words_ * word_bits - static_cast<std::uint32_t>(elements_);
        for (std::size_t line = 0; line < lines && beyond > 0; ++line) {
            band_.line(line)[words_ - 1] >>= beyond;
        }
        band_.count.fill(static_cast<std::uint64_t>(elements_));
        out_.on_line.fill(0);
        band_.open_lines = static_cast<std::uint32_t>(lines);
    }

    /// A light shines through what is left of a pixel when its turn comes; it takes nothing itself.
    void put_light(const BandLight& light, std::span<const SplatPixel> splats) {
        for (const SplatPixel& splat : splats.subspan(light.first_pixel, light.pixel_count)) {
            const auto line = static_cast<std::size_t>(splat.line - first_line_);
            if (!is_set(band_.line(line), splat.element)) continue;
            const std::uint64_t weight =
                std::uint64_t{splat.weight} * left_of(line)[splat.element] / whole_pixel;
            if (weight != 0)
                out_.lights.push_back(
                    {splat.line, splat.element, static_cast<std::uint32_t>(weight), light.light});
        }
    }

    // ---- which elements a face covers ----------------------------------------------------------------------------

    /// Crossings of one side of the face for the band's lines: first_element(), step by step.
    void cross(const Edge* edges, std::uint32_t count, std::array<std::int32_t, band_lines>& crossing) const {
        for (const Edge* edge = edges; edge != edges + count; ++edge) {
            const std::int32_t from = std::max(edge->first_line, first_line_);
            const std::int32_t to = std::min(edge->end_line, end_line_);
            auto at =
                static_cast<std::uint64_t>(edge->start) +
                static_cast<std::uint64_t>(from - edge->first_line) * static_cast<std::uint64_t>(edge->slope);
            for (std::int32_t line = from; line < to; ++line, at += static_cast<std::uint64_t>(edge->slope)) {
                const auto element =
                    static_cast<std::int32_t>(static_cast<std::int64_t>(at) >> crossing_bits);
                crossing[static_cast<std::size_t>(line - first_line_)] = std::clamp(element, 0, elements_);
            }
        }
    }

    void put_by_centres() {
        const Edge* edges = edges_.edges.data() + face_->first_edge;
        cross(edges, face_->leading, scratch_.begin);
        cross(edges + face_->leading, face_->trailing, scratch_.end);
        const LineRange lines = band_.lines_of(*face_);
        for (std::size_t line = lines.from; line < lines.to; ++line) {
            if (scratch_.begin[line] >= scratch_.end[line]) continue;
            const auto begin = static_cast<std::uint32_t>(scratch_.begin[line]);
            const auto end = static_cast<std::uint32_t>(scratch_.end[line]);
            if (face_->blends) {
                share_evenly(line, begin, end);
            } else {
                take(line, begin, end);
            }
        }
    }

    void put_by_area() {
        const LineRange range = band_.lines_of(*face_);
        if (!many_at_once_ || face_->blends || face_->outlines > most_outlines) {
            for (std::size_t line = range.from; line < range.to; ++line)
                put_line_by_area(line);
            return;
        }
        if (!any_open_in_box(range)) return;
        sharing_ = true;
        LinesLeft& left = scratch_.lines_left;
        put_smoothed_lines(edges_, rank_,
                           {&band_, out_.shared.data(), words_, scratch_.left.data(), elements_}, out_, left);
        for (std::uint32_t lines = left.wide; lines != 0; lines &= lines - 1)
            put_line_by_area(static_cast<std::size_t>(std::countr_zero(lines)));
        for (std::uint32_t lines = left.whole; lines != 0; lines &= lines - 1) {
            const auto line = static_cast<std::size_t>(std::countr_zero(lines));
            take(line, static_cast<std::uint32_t>(left.begin[line]),
                 static_cast<std::uint32_t>(left.end[line]));
        }
    }

    void put_line_by_area(std::size_t line) {
        // Most lines of faces that others hide are closed wherever the face may reach.
        if (band_.count[line] == 0 || !any_open(line, face_->first_element, face_->end_element)) return;
        const std::span<const OutlineEdge> outline(edges_.outlines.data() + face_->first_outline,
                                                   face_->outlines);
        trace_line(outline, first_line_ + static_cast<std::int32_t>(line), elements_, scratch_.traced);
        if (!any_open(line, scratch_.traced.begin, scratch_.traced.end)) return;
        cover_line(scratch_.traced, elements_, scratch_.coverage);
        put_covered(line);
    }

    /// Is anything open in the face's box?
    bool any_open_in_box(const LineRange& range) const {
        const auto first = static_cast<std::uint32_t>(face_->first_element);
        const auto end = static_cast<std::uint32_t>(face_->end_element);
        for (std::uint32_t word = first / word_bits; word * word_bits < end; ++word) {
            std::uint64_t open = 0;
            for (std::size_t line = range.from; line < range.to; ++line)
                open |= band_.open[word].of_line[line];
            if ((open & bits_between(word, first, end)) != 0) return true;
        }
        return false;
    }

    bool any_open(std::size_t line, std::int32_t begin, std::int32_t end) {
        if (begin >= end) return false;
        const auto stop = static_cast<std::uint32_t>(end);
        return next_set(band_.line(line), static_cast<std::uint32_t>(begin), stop) < stop;
    }

    void put_covered(std::size_t line) {
        const LineCoverage& coverage = scratch_.coverage;
        for (const PartlyCovered& part : coverage.parts) {
            if (part.begin < part.end)
                share(line, static_cast<std::uint32_t>(part.begin), static_cast<std::uint32_t>(part.end),
                      coverage.areas.data() + part.first);
        }
        if (coverage.whole_begin < coverage.whole_end) {
            const auto begin = static_cast<std::uint32_t>(coverage.whole_begin);
            const auto end = static_cast<std::uint32_t>(coverage.whole_end);
            if (face_->blends) {
                share_evenly(line, begin, end);
            } else {
                take(line, begin, end);
            }
        }
    }

    // ---- what it gets of them ------------------------------------------------------------------------------------

    /// All that is left of [begin, end): segments where nobody else has a share, the rest of the pixels where others do.
    void take(std::size_t line, std::uint32_t begin, std::uint32_t end) {
        if (band_.count[line] == 0) return;
        const LineMask open = band_.line(line);
        const std::uint64_t* shared = out_.shared.data() + line * words_;
        if (const std::uint32_t word = begin / word_bits; word == (end - 1) / word_bits) {
            const std::uint64_t mine = open[word] & bits_between(word, begin, end);
            if ((mine & shared[word]) == 0) {
                open[word] ^= mine;
                take_alone(line, word * word_bits, mine);
                return;
            }
        }
        std::uint32_t taken = 0;
        std::uint32_t run_begin = begin,
                      run_end = begin; // the segment at hand, which may go on in the next word
        for (std::uint32_t word = begin / word_bits; word * word_bits < end; ++word) {
            std::uint64_t mine = open[word] & bits_between(word, begin, end);
            if (mine == 0) continue;
            open[word] ^= mine;
            if (const std::uint64_t others = mine & shared[word]; others != 0) {
                taken += take_rests(line, word * word_bits, others);
                mine ^= others;
            }
            while (mine != 0) {
                const BitRun run = take_run(mine);
                const std::uint32_t at = word * word_bits + run.first;
                if (at != run_end) {
                    taken += put_segment(line, run_begin, run_end);
                    run_begin = at;
                }
                run_end = at + run.count();
            }
        }
        taken += put_segment(line, run_begin, run_end);
        lose(line, taken);
    }

    /// Elements of one word, in which nobody else has a share.
    void take_alone(std::size_t line, std::uint32_t from, std::uint64_t mine) {
        std::uint32_t taken = 0;
        while (mine != 0) {
            const BitRun run = take_run(mine);
            taken += put_segment(line, from + run.first, from + run.end);
        }
        lose(line, taken);
    }

    /// These many elements of the line are not open any more.
    void lose(std::size_t line, std::uint32_t elements) {
        band_.count[line] -= elements;
        if (elements != 0 && band_.count[line] == 0) --band_.open_lines;
    }

    std::uint32_t put_segment(std::size_t line, std::uint32_t begin, std::uint32_t end) {
        if (begin == end) return 0;
        out_.segments.push_back(
            {line_number(line), static_cast<std::uint16_t>(begin), static_cast<std::uint16_t>(end - begin)});
        ++out_.on_line[line];
        return end - begin;
    }

    /// What is left of shared pixels, a word of them; how many they are.
    std::uint32_t take_rests(std::size_t line, std::uint32_t from, std::uint64_t pixels) {
        std::uint32_t* left = left_of(line);
        std::uint32_t taken = 0;
        while (pixels != 0) {
            const BitRun run = take_run(pixels);
            begin_run(line, from + run.first, run.count());
            for (std::uint32_t element = run.first; element < run.end; ++element)
                out_.weights.push_back(left[from + element]);
            taken += run.count();
        }
        return taken;
    }

    /// Shares of the open elements of [begin, end), of which the face covers these areas. New coverage is at most what
    /// is left: neighbours of a mesh fill a pixel exactly.
    void share(std::size_t line, std::uint32_t begin, std::uint32_t end, const std::int32_t* areas) {
        const LineMask open = band_.line(line);
        for (std::uint32_t at = next_set(open, begin, end); at < end;) {
            const std::uint32_t stop = next_clear(open, at, end);
            share_open(line, at, stop, areas + (at - begin));
            at = stop < end ? next_set(open, stop, end) : end;
        }
    }

    /// The same where it covers them all wholly.
    void share_evenly(std::size_t line, std::uint32_t begin, std::uint32_t end) {
        std::vector<std::int32_t>& areas = scratch_.coverage.areas;
        const std::size_t first = areas.size();
        areas.resize(first + (end - begin), static_cast<std::int32_t>(whole_pixel));
        share(line, begin, end, areas.data() + first);
        areas.resize(first);
    }

    void share_open(std::size_t line, std::uint32_t begin, std::uint32_t end, const std::int32_t* areas) {
        for (; begin < end && areas[0] == 0; ++begin)
            ++areas;
        for (; begin < end && areas[end - begin - 1] == 0;)
            --end;
        if (begin == end) return;
        sharing_ = true;
        set_bits(out_.shared.data() + line * words_, begin, end);
        begin_run(line, begin, end - begin);
        const std::size_t first = out_.weights.size();
        out_.weights.resize(first + (end - begin));
        std::uint32_t* weights = out_.weights.data() + first;
        if (!face_->blends) {
            share_opaque(line, begin, end, areas, weights);
        } else if (face_->additive) {
            share_light(line, begin, end, areas, weights);
        } else {
            for (std::uint32_t element = begin; element < end; ++element)
                weights[element - begin] =
                    blend(line, element, static_cast<std::uint32_t>(areas[element - begin]));
        }
    }

    void share_opaque(std::size_t line, std::uint32_t begin, std::uint32_t end, const std::int32_t* areas,
                      std::uint32_t* weights) {
        std::uint32_t* left = left_of(line);
        for (std::uint32_t element = begin; element < end; ++element) {
            const std::uint32_t weight =
                std::min(static_cast<std::uint32_t>(areas[element - begin]), left[element]);
            weights[element - begin] = weight;
            left[element] -= weight;
            if (left[element] == 0) close(line, element);
        }
    }

    /// An additive face's: it takes nothing from what is behind it.
    void share_light(std::size_t line, std::uint32_t begin, std::uint32_t end, const std::int32_t* areas,
                     std::uint32_t* weights) {
        const std::uint32_t* left = left_of(line) + begin;
        const std::uint32_t fade = face_->fade;
        for (std::uint32_t k = 0; k < end - begin; ++k)
            weights[k] = part_of(std::min(static_cast<std::uint32_t>(areas[k]), left[k]), fade);
    }

    /// The share of one pixel that a semi-opaque or a fading face gets.
    std::uint32_t blend(std::size_t line, std::uint32_t element, std::uint32_t coverage) {
        std::uint32_t& left = left_of(line)[element];
        const std::uint32_t weight = face_->level < 0 ? part_of(std::min(coverage, left), face_->opacity)
                                                      : fading(line, element, coverage, left);
        left -= weight;
        if (left == 0) close(line, element);
        return weight;
    }

    static std::uint32_t part_of(std::uint32_t amount, std::uint32_t part) {
        return part >= 256 ? amount : (amount >> 8U) * part;
    }

    /// A share of a face whose level of detail fades: the level as a whole lets through what is behind it, not each of its
    /// faces what is behind that one.
    std::uint32_t fading(std::size_t line, std::uint32_t element, std::uint32_t coverage,
                         std::uint32_t left) {
        if (scratch_.fading.size() < scratch_.left.size()) scratch_.fading.resize(scratch_.left.size());
        fading_ = true;
        FadingPixel& pixel = scratch_.fading[line * static_cast<std::size_t>(elements_) + element];
        if (pixel.level != face_->level) pixel = {face_->level, left};
        const std::uint32_t taken = part_of(std::min(coverage, pixel.left_by_level), face_->opacity);
        pixel.left_by_level -= taken;
        return std::min(part_of(taken, face_->fade), left);
    }

    void close(std::size_t line, std::uint32_t element) {
        band_.line(line)[element / word_bits] ^= std::uint64_t{1} << (element % word_bits);
        lose(line, 1);
    }

    void begin_run(std::size_t line, std::uint32_t first, std::uint32_t count) {
        out_.shares.push_back({rank_, static_cast<std::uint32_t>(out_.weights.size()), line_number(line),
                               static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(count)});
    }

    std::uint32_t* left_of(std::size_t line) {
        return scratch_.left.data() + line * static_cast<std::size_t>(elements_);
    }

    std::uint16_t line_number(std::size_t line) const {
        return static_cast<std::uint16_t>(first_line_ + static_cast<std::int32_t>(line));
    }

    void leave_background() {
        const auto end = static_cast<std::uint32_t>(elements_);
        rank_ = background_rank;
        for (std::int32_t number = 0; number < end_line_ - first_line_ && band_.open_lines != 0; ++number) {
            const auto line = static_cast<std::size_t>(number);
            const LineMask open = band_.line(line);
            const std::uint64_t* shared = out_.shared.data() + line * words_;
            for (std::uint32_t word = 0; word < words_; ++word) {
                if (const std::uint64_t rests = open[word] & shared[word]; rests != 0)
                    take_rests(line, word * word_bits, rests);
                open[word] &= ~shared[word];
            }
            for (std::uint32_t at = next_set(open, 0, end); at < end;) {
                const std::uint32_t stop = next_clear(open, at, end);
                out_.background.push_back({line_number(line), static_cast<std::uint16_t>(at),
                                           static_cast<std::uint16_t>(stop - at)});
                at = stop < end ? next_set(open, stop, end) : end;
            }
        }
        out_.weights.resize(out_.weights.size() + weights_padding);
        forget_shared();
    }

    /// Makes the working storage of shared pixels as it was.
    void forget_shared() {
        for (std::size_t line = 0; line < static_cast<std::size_t>(end_line_ - first_line_); ++line) {
            for (std::uint32_t word = 0; word < words_; ++word) {
                std::uint64_t pixels = out_.shared[line * words_ + word];
                while (pixels != 0) {
                    const BitRun run = take_run(pixels);
                    std::uint32_t* left = left_of(line) + word * word_bits + run.first;
                    std::fill_n(left, run.count(), whole_pixel);
                    if (fading_)
                        std::fill_n(scratch_.fading.begin() + (left - scratch_.left.data()), run.count(),
                                    FadingPixel{});
                }
            }
        }
    }

    const FaceEdges& edges_;
    BandScratch& scratch_;
    OpenBand& band_;
    BandSegments& out_;
    std::int32_t elements_;
    std::uint32_t words_;
    bool smoothing_;
    bool many_at_once_ = !simd_is_off();
    std::int32_t first_line_;
    std::int32_t end_line_;
    bool sharing_ = false; ///< some pixel has a share already
    bool fading_ = false;  ///< some pixel of scratch_.fading is in use
    const EdgeFace* face_ = nullptr;
    std::uint32_t rank_ = 0;
};

} // namespace

void resolve_band(const FaceEdges& edges, std::span<const std::uint32_t> ranks, std::uint32_t elements,
                  bool smoothing, BandScratch& scratch, BandSegments& segments) {
    resolve_band(edges, ranks, {}, {}, elements, smoothing, scratch, segments);
}

void resolve_band(const FaceEdges& edges, std::span<const std::uint32_t> ranks,
                  std::span<const BandLight> lights, std::span<const SplatPixel> splats,
                  std::uint32_t elements, bool smoothing, BandScratch& scratch, BandSegments& segments) {
    segments.faces.clear();
    segments.segments.clear();
    segments.background.clear();
    segments.shares.clear();
    segments.weights.clear();
    segments.lights.clear();
    BandResolver(edges, elements, smoothing, scratch, segments).run(ranks, lights, splats);
}

} // namespace linkdig::ig
