#include "ig/scanline/scanline.h"

#include "ig/edges/edges.h"

#include <algorithm>
#include <bit>

namespace linkdig::ig {

namespace {

constexpr std::uint32_t word_bits = 64;

class BandResolver {
public:
    BandResolver(const FaceEdges& edges, std::uint32_t elements, BandScratch& scratch, BandSegments& segments)
        : edges_(edges), scratch_(scratch), segments_(segments),
          elements_(static_cast<std::int32_t>(elements)), words_((elements + word_bits - 1) / word_bits),
          first_line_(static_cast<std::int32_t>(segments.first_line)),
          end_line_(static_cast<std::int32_t>(segments.end_line)) {}

    void run(std::span<const std::uint32_t> ranks) {
        open_all();
        for (const std::uint32_t rank : ranks) {
            if (open_lines_ == 0) break; // whatever comes now is behind
            put(rank);
        }
        leave_background();
    }

private:
    void open_all() {
        const auto lines = static_cast<std::size_t>(end_line_ - first_line_);
        scratch_.open.assign(lines * words_, ~std::uint64_t{0});
        const std::uint32_t beyond = words_ * word_bits - static_cast<std::uint32_t>(elements_);
        for (std::size_t line = 0; line < lines && beyond > 0; ++line) {
            scratch_.open[(line + 1) * words_ - 1] >>= beyond;
        }
        scratch_.open_count.fill(static_cast<std::uint32_t>(elements_));
        open_lines_ = static_cast<std::uint32_t>(lines);
    }

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

    void put(std::uint32_t rank) {
        const EdgeFace& face = edges_.faces[rank];
        const Edge* edges = edges_.edges.data() + face.first_edge;
        cross(edges, face.leading, scratch_.begin);
        cross(edges + face.leading, face.trailing, scratch_.end);
        const std::int32_t from = std::max(face.first_line, first_line_) - first_line_;
        const std::int32_t to = std::min(face.end_line, end_line_) - first_line_;
        for (std::int32_t line = from; line < to; ++line) {
            const auto l = static_cast<std::size_t>(line);
            if (scratch_.begin[l] < scratch_.end[l] && scratch_.open_count[l] != 0) {
                take(rank, l, static_cast<std::uint32_t>(scratch_.begin[l]),
                     static_cast<std::uint32_t>(scratch_.end[l]));
            }
        }
    }

    /// Gives the face what is open of [begin, end) on a line.
    void take(std::uint32_t rank, std::size_t line, std::uint32_t begin, std::uint32_t end) {
        std::uint64_t* open = scratch_.open.data() + line * words_;
        std::uint32_t at = begin;
        while (at < end) {
            at = next_open(open, at, end);
            if (at >= end) break;
            const std::uint32_t stop = next_closed(open, at, end);
            close(open, at, stop);
            segments_.segments.push_back(
                {rank, static_cast<std::uint16_t>(first_line_ + static_cast<std::int32_t>(line)),
                 static_cast<std::uint16_t>(at), static_cast<std::uint16_t>(stop - at)});
            scratch_.open_count[line] -= stop - at;
            at = stop;
        }
        if (scratch_.open_count[line] == 0) --open_lines_;
    }

    static std::uint32_t next_open(const std::uint64_t* open, std::uint32_t at, std::uint32_t end) {
        std::uint64_t word = open[at / word_bits] >> (at % word_bits);
        if (word != 0) return at + static_cast<std::uint32_t>(std::countr_zero(word));
        for (at = (at / word_bits + 1) * word_bits; at < end; at += word_bits) {
            word = open[at / word_bits];
            if (word != 0) return at + static_cast<std::uint32_t>(std::countr_zero(word));
        }
        return end;
    }

    static std::uint32_t next_closed(const std::uint64_t* open, std::uint32_t at, std::uint32_t end) {
        std::uint64_t word = ~open[at / word_bits] >> (at % word_bits);
        if (word != 0) return std::min(end, at + static_cast<std::uint32_t>(std::countr_zero(word)));
        for (at = (at / word_bits + 1) * word_bits; at < end; at += word_bits) {
            word = ~open[at / word_bits];
            if (word != 0) return std::min(end, at + static_cast<std::uint32_t>(std::countr_zero(word)));
        }
        return end;
    }

    static void close(std::uint64_t* open, std::uint32_t begin, std::uint32_t end) {
        const std::uint32_t first = begin / word_bits;
        const std::uint32_t last = (end - 1) / word_bits;
        const std::uint64_t from = ~std::uint64_t{0} << (begin % word_bits);
        const std::uint64_t to = ~std::uint64_t{0} >> (word_bits - 1 - (end - 1) % word_bits);
        if (first == last) {
            open[first] &= ~(from & to);
            return;
        }
        open[first] &= ~from;
        for (std::uint32_t word = first + 1; word < last; ++word)
            open[word] = 0;
        open[last] &= ~to;
    }

    void leave_background() {
        for (std::int32_t line = 0; line < end_line_ - first_line_ && open_lines_ != 0; ++line) {
            const auto l = static_cast<std::size_t>(line);
            if (scratch_.open_count[l] == 0) continue;
            const std::uint64_t* open = scratch_.open.data() + l * words_;
            const auto end = static_cast<std::uint32_t>(elements_);
            for (std::uint32_t at = next_open(open, 0, end); at < end;) {
                const std::uint32_t stop = next_closed(open, at, end);
                segments_.background.push_back({0, static_cast<std::uint16_t>(first_line_ + line),
                                                static_cast<std::uint16_t>(at),
                                                static_cast<std::uint16_t>(stop - at)});
                at = stop < end ? next_open(open, stop, end) : end;
            }
        }
    }

    const FaceEdges& edges_;
    BandScratch& scratch_;
    BandSegments& segments_;
    std::int32_t elements_;
    std::uint32_t words_;
    std::int32_t first_line_;
    std::int32_t end_line_;
    std::uint32_t open_lines_ = 0;
};

} // namespace

void resolve_band(const FaceEdges& edges, std::span<const std::uint32_t> ranks, std::uint32_t elements,
                  BandScratch& scratch, BandSegments& segments) {
    segments.segments.clear();
    segments.background.clear();
    BandResolver(edges, elements, scratch, segments).run(ranks);
}

} // namespace linkdig::ig
