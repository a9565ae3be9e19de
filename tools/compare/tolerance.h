#pragma once
/// How far frames may differ: buckets of pixels, as in `<=1:*, <=5:100`.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace linkdig::compare {

/// Pixels whose largest difference of a channel is above the bucket before it and at most `limit` levels
/// (255 is full intensity, at every depth).
struct Bucket {
    double limit = 0.0;
    std::uint64_t least = 1;    ///< fewer in the worst frame: better than declared
    std::uint64_t greatest = 0; ///< more in any frame: it differs
    bool operator==(const Bucket&) const = default;
};

/// Ascending by limit. Empty: exact.
using Tolerance = std::vector<Bucket>;

/// One bucket per text: "<=LEVELS:COUNT". COUNT is `*` (any number but none), `100` (1 to 100) or `0-100`.
/// A text may hold several, with commas. Throws std::invalid_argument, saying what was expected.
Tolerance parse_tolerance(std::span<const std::string> texts);

std::string tolerance_text(const Tolerance& tolerance);

/// `counts` has a place per bucket, and one more for the pixels beyond the last.
bool is_within(const Tolerance& tolerance, std::span<const std::uint64_t> counts);

/// Watches all frames of a case: is one of them as bad as the tolerance says?
class Declared {
public:
    explicit Declared(const Tolerance& tolerance) : tolerance_(tolerance), most_(tolerance.size(), 0) {}
    void take(std::span<const std::uint64_t> counts);
    /// What is better than declared, a line per bucket; empty if nothing is.
    std::string better() const;

private:
    Tolerance tolerance_;
    std::vector<std::uint64_t> most_;
};

} // namespace linkdig::compare
