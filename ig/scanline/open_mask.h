#pragma once
/// A bit per element of a line, in words of 64: which are set, where runs begin and end.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace linkdig::ig {

inline constexpr std::uint32_t word_bits = 64;

/// A line's words, each this many words of memory behind the one before.
struct LineMask {
    std::uint64_t* first = nullptr;
    std::size_t step = 1;
    std::uint64_t& operator[](std::size_t word) const { return first[word * step]; }
};

/// Bits [first, end) of a word.
struct BitRun {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
    std::uint32_t count() const { return end - first; }
};

/// Takes the lowest run of set bits off `bits`, which are not all clear.
inline BitRun take_run(std::uint64_t& bits) {
    const auto first = static_cast<std::uint32_t>(std::countr_zero(bits));
    const std::uint64_t rest =
        bits + (std::uint64_t{1} << first); // carries to the first clear bit behind the run
    bits &= rest;
    return {first, rest == 0 ? word_bits : static_cast<std::uint32_t>(std::countr_zero(rest))};
}

/// First element in [at, end) whose bit, exclusive-ored with `inverted`, is set; end if there is none. `Bits`: a pointer to the
/// words, or a LineMask.
template <typename Bits>
std::uint32_t next_bit(const Bits& bits, std::uint32_t at, std::uint32_t end, std::uint64_t inverted) {
    std::uint64_t word = (bits[at / word_bits] ^ inverted) >> (at % word_bits);
    if (word != 0) return std::min(end, at + static_cast<std::uint32_t>(std::countr_zero(word)));
    for (at = (at / word_bits + 1) * word_bits; at < end; at += word_bits) {
        word = bits[at / word_bits] ^ inverted;
        if (word != 0) return std::min(end, at + static_cast<std::uint32_t>(std::countr_zero(word)));
    }
    return end;
}

template <typename Bits>
std::uint32_t next_set(const Bits& bits, std::uint32_t at, std::uint32_t end) {
    return next_bit(bits, at, end, 0);
}
template <typename Bits>
std::uint32_t next_clear(const Bits& bits, std::uint32_t at, std::uint32_t end) {
    return next_bit(bits, at, end, ~std::uint64_t{0});
}

/// The bits of a word that lie in [begin, end), which reaches into it.
inline std::uint64_t bits_between(std::uint32_t word, std::uint32_t begin, std::uint32_t end) {
    std::uint64_t bits = ~std::uint64_t{0};
    if (word == begin / word_bits) bits <<= begin % word_bits;
    if (word == (end - 1) / word_bits) bits &= ~std::uint64_t{0} >> (word_bits - 1 - (end - 1) % word_bits);
    return bits;
}

/// Sets the bits of [begin, end), begin < end.
inline void set_bits(std::uint64_t* bits, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t word = begin / word_bits; word <= (end - 1) / word_bits; ++word)
        bits[word] |= bits_between(word, begin, end);
}

template <typename Bits>
bool is_set(const Bits& bits, std::uint32_t at) {
    return (bits[at / word_bits] >> (at % word_bits) & 1U) != 0;
}

} // namespace linkdig::ig
