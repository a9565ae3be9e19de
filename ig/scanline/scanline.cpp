#include "ig/scanline/scanline.h"

#include "ig/edges/edges.h"
#include "ig/scanline/open_mask.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

class BandResolver {
public:
    BandResolver(const FaceEdges& edges, std::uint32_t elements, bool smoothing, BandScratch& scratch,
                 BandSegments& segments)
        : edges_(edges), scratch_(scratch), out_(segments), elements_(static_cast<std::int32_t>(elements)),
          words_((elements + word_bits - 1) / word_bits), smoothing_(smoothing),
          first_line_(static_cast<std::int32_t>(segments.first_line)),
          end_line_(static_cast<std::int32_t>(segments.end_line)) {}

    void run(std::span<const std::uint32_t> ranks, std::span<const BandLight> lights,
             std::span<const SplatPixel> splats) {
        open_all();
        for (const std::uint32_t rank : ranks) {
            for (; !lights.empty() && lights.front().rank <= rank; lights = lights.subspan(1))
                put_light(lights.front(), splats);
            if (open_lines_ == 0) break; // whatever comes now is behind
            face_ = &edges_.faces[rank];
            rank_ = rank;
            if (smoothing_) {
                put_by_area();
            } else {
                put_by_centres();
            }
        }
        for (const BandLight& light : lights)
            put_light(light, splats);
        leave_background();
    }

private:
    void open_all() {
        const auto lines = static_cast<std::size_t>(end_line_ - first_line_);
        scratch_.open.assign(lines * words_, ~std::uint64_t{0});
        scratch_.shared.assign(lines * words_, 0);
        scratch_.pixel.resize(lines * static_cast<std::size_t>(elements_));
        const std::uint32_t beyond = words_ * word_bits - static_cast<std::uint32_t>(elements_);
        for (std::size_t line = 0; line < lines && beyond > 0; ++line) {
            scratch_.open[(line + 1) * words_ - 1] >>= beyond;
        }
        scratch_.open_count.fill(static_cast<std::uint32_t>(elements_));
        open_lines_ = static_cast<std::uint32_t>(lines);
    }

    /// A light shines through what is left of a pixel when its turn comes; it takes nothing itself.
    void put_light(const BandLight& light, std::span<const SplatPixel> splats) {
        for (const SplatPixel& splat : splats.subspan(light.first_pixel, light.pixel_count)) {
            const auto line = static_cast<std::size_t>(splat.line - first_line_);
            const std::size_t words = line * words_;
            if (!is_set(scratch_.open.data() + words, splat.element)) continue;
            std::uint64_t weight = splat.weight;
            if (is_set(scratch_.shared.data() + words, splat.element))
                weight = weight * out_.pixels[index_of(line, splat.element)].left / whole_pixel;
            if (weight != 0)
                out_.lights.push_back(
                    {splat.line, splat.element, static_cast<std::uint32_t>(weight), light.light});
        }
    }

    // ---- which elements a face covers ----------------------------------------------------------------------------

    /// Crossings of one side of the face for the band's lines.
    void cross(const Edge* edges, std::uint32_t count, std::array<std::int32_t, band_lines>& crossing) const {
        for (const Edge* edge = edges; edge != edges + count; ++edge) {
            const std::int32_t from = std::max(edge->first_line, first_line_);
            const std::int32_t to = std::min(edge->end_line, end_line_);
            for (std::int32_t line = from; line < to; ++line) {
                crossing[static_cast<std::size_t>(line - first_line_)] =
                    std::clamp(first_element(*edge, line), 0, elements_);
            }
        }
    }

    void put_by_centres() {
        const Edge* edges = edges_.edges.data() + face_->first_edge;
        cross(edges, face_->leading, scratch_.begin);
        cross(edges + face_->leading, face_->trailing, scratch_.end);
        const std::int32_t from = std::max(face_->first_line, first_line_) - first_line_;
        const std::int32_t to = std::min(face_->end_line, end_line_) - first_line_;
        for (std::int32_t line = from; line < to; ++line) {
            const auto l = static_cast<std::size_t>(line);
            if (scratch_.begin[l] < scratch_.end[l] && scratch_.open_count[l] != 0) {
                put_run(l, static_cast<std::uint32_t>(scratch_.begin[l]),
                        static_cast<std::uint32_t>(scratch_.end[l]), whole_pixel);
            }
        }
    }

    void put_by_area() {
        const std::int32_t from = std::max(face_->first_line, first_line_);
        const std::int32_t to = std::min(face_->end_line, end_line_);
        const std::span<const OutlineEdge> outline(edges_.outlines.data() + face_->first_outline,
                                                   face_->outlines);
        for (std::int32_t line = from; line < to; ++line) {
            const auto l = static_cast<std::size_t>(line - first_line_);
            if (scratch_.open_count[l] == 0) continue;
            cover_line(outline, line, elements_, scratch_.cells, scratch_.runs);
            for (const CoverageRun& run : scratch_.runs) {
                if (scratch_.open_count[l] == 0) break;
                put_run(l, static_cast<std::uint32_t>(run.begin), static_cast<std::uint32_t>(run.end),
                        run.coverage);
            }
        }
    }

    // ---- what it gets of them ------------------------------------------------------------------------------------

    /// Gives the face at hand what is left of [begin, end) on a line, of which it covers `coverage` of each element.
    void put_run(std::size_t line, std::uint32_t begin, std::uint32_t end, std::uint32_t coverage) {
        const std::uint64_t* open = scratch_.open.data() + line * words_;
        const bool alone = coverage == whole_pixel && !face_->blends;
        for (std::uint32_t at = next_set(open, begin, end); at < end;) {
            const std::uint32_t stop = next_clear(open, at, end);
            if (alone) {
                take(line, at, stop);
            } else {
                for (std::uint32_t element = at; element < stop; ++element)
                    share(line, element, coverage);
            }
            at = stop < end ? next_set(open, stop, end) : end;
        }
        if (scratch_.open_count[line] == 0) --open_lines_;
    }

    /// All that is left of a run of open elements: segments, and the rest of pixels that others have shares of.
    void take(std::size_t line, std::uint32_t begin, std::uint32_t end) {
        const std::uint64_t* shared = scratch_.shared.data() + line * words_;
        for (std::uint32_t at = begin; at < end;) {
            const std::uint32_t stop = next_set(shared, at, end);
            if (at < stop) {
                out_.segments.push_back({rank_, line_number(line), static_cast<std::uint16_t>(at),
                                         static_cast<std::uint16_t>(stop - at)});
            }
            at = stop;
            for (; at < end && is_set(shared, at); ++at) {
                SharedPixel& pixel = out_.pixels[index_of(line, at)];
                out_.shares.push_back({rank_, index_of(line, at), pixel.left});
                pixel.left = 0;
            }
        }
        clear_bits(scratch_.open.data() + line * words_, begin, end);
        scratch_.open_count[line] -= end - begin;
    }

    /// A share of one open element. New coverage is at most what is left: neighbours of a mesh fill a pixel exactly.
    void share(std::size_t line, std::uint32_t element, std::uint32_t coverage) {
        const std::uint32_t index = shared_pixel(line, element);
        SharedPixel& pixel = out_.pixels[index];
        const std::uint32_t covered = std::min(coverage, pixel.left);
        if (face_->additive) {
            out_.shares.push_back({rank_, index, part_of(covered, face_->fade)});
            return;
        }
        const std::uint32_t weight =
            face_->level < 0 ? part_of(covered, face_->opacity) : fading(pixel, coverage);
        if (weight == 0) return;
        out_.shares.push_back({rank_, index, weight});
        pixel.left -= weight;
        if (pixel.left != 0) return;
        clear_bits(scratch_.open.data() + line * words_, element, element + 1);
        --scratch_.open_count[line];
    }

    static std::uint32_t part_of(std::uint32_t amount, std::uint32_t part) {
        return part >= 256 ? amount : (amount >> 8U) * part;
    }

    /// A share of a face whose level of detail fades: the level as a whole lets through what is behind it, not each of its
    /// faces what is behind that one.
    std::uint32_t fading(SharedPixel& pixel, std::uint32_t coverage) const {
        if (pixel.level != face_->level) {
            pixel.level = face_->level;
            pixel.left_by_level = pixel.left;
        }
        const std::uint32_t taken = part_of(std::min(coverage, pixel.left_by_level), face_->opacity);
        pixel.left_by_level -= taken;
        return std::min(part_of(taken, face_->fade), pixel.left);
    }

    std::uint32_t& index_of(std::size_t line, std::uint32_t element) {
        return scratch_.pixel[line * static_cast<std::size_t>(elements_) + element];
    }

    std::uint32_t shared_pixel(std::size_t line, std::uint32_t element) {
        std::uint64_t& word = scratch_.shared[line * words_ + element / word_bits];
        const std::uint64_t bit = std::uint64_t{1} << (element % word_bits);
        if ((word & bit) == 0) {
            word |= bit;
            index_of(line, element) = static_cast<std::uint32_t>(out_.pixels.size());
            out_.pixels.push_back({line_number(line), static_cast<std::uint16_t>(element)});
        }
        return index_of(line, element);
    }

    std::uint16_t line_number(std::size_t line) const {
        return static_cast<std::uint16_t>(first_line_ + static_cast<std::int32_t>(line));
    }

    void leave_background() {
        const auto end = static_cast<std::uint32_t>(elements_);
        for (std::int32_t number = 0; number < end_line_ - first_line_ && open_lines_ != 0; ++number) {
            const auto line = static_cast<std::size_t>(number);
            const std::uint64_t* open = scratch_.open.data() + line * words_;
            const std::uint64_t* shared = scratch_.shared.data() + line * words_;
            for (std::uint32_t at = next_set(open, 0, end); at < end; at = next_set(open, at, end)) {
                if (is_set(shared, at)) {
                    out_.shares.push_back(
                        {background_rank, index_of(line, at), out_.pixels[index_of(line, at)].left});
                    if (++at == end) break;
                    continue;
                }
                const std::uint32_t stop = std::min(next_clear(open, at, end), next_set(shared, at, end));
                out_.background.push_back({background_rank, line_number(line), static_cast<std::uint16_t>(at),
                                           static_cast<std::uint16_t>(stop - at)});
                if ((at = stop) == end) break;
            }
        }
    }

    const FaceEdges& edges_;
    BandScratch& scratch_;
    BandSegments& out_;
    std::int32_t elements_;
    std::uint32_t words_;
    bool smoothing_;
    std::int32_t first_line_;
    std::int32_t end_line_;
    std::uint32_t open_lines_ = 0;
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
    segments.segments.clear();
    segments.background.clear();
    segments.pixels.clear();
    segments.shares.clear();
    segments.lights.clear();
    BandResolver(edges, elements, smoothing, scratch, segments).run(ranks, lights, splats);
}

} // namespace linkdig::ig
