#pragma once
/// Two sequences of frames against each other: what changed, where, and why.

#include "tools/compare/align.h"
#include "tools/compare/difference.h"
#include "tools/compare/ids.h"
#include "tools/compare/packet_difference.h"
#include "tools/compare/region.h"
#include "tools/compare/side.h"
#include "tools/compare/tolerance.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::compare {

/// What came of a frame. The order is that of the exit codes' weight (exit_code()).
enum class Verdict : std::uint8_t {
    same,
    tolerated, ///< unlike, within the tolerance
    differs,
    missing, ///< only the expected side has it
    extra,   ///< only the actual side has it
    shape,   ///< another size, or other channels
    unreadable,
};
inline constexpr std::size_t verdicts = 7;
const char* verdict_text(Verdict verdict);

/// A comparison, as a manifest or the command line declares it.
struct Case {
    std::string name;
    std::string why; ///< may be empty
    std::string expected;
    std::string actual;
    Tolerance tolerance;   ///< empty: exact
    bool declared = false; ///< the tolerance is a statement: better is a failure, too
    Regions regions;
    std::optional<tools::FrameRange> frames;
    std::optional<std::array<double, 3>> background; ///< levels: the colour of pixels that are not drawn
};

/// What holds for all cases of a run.
struct Settings {
    FramesOf expected_frames; ///< its database, if any, also names what planes show
    FramesOf actual_frames;
    ig::Scan scan = ig::Scan::horizontal;
    std::uint32_t threads = 0;     ///< 0: as many as the machine has
    std::size_t worst = 8;         ///< frames that are looked at closely
    bool empty_references = false; ///< the expected folder may hold no picture yet
    bool pictures = false;         ///< details hold pictures as PNG, for a report
    bool perceptual = false;       ///< Yee's metric for large pictures, too
    bool progress = false;
};

/// What the frames that are told of get besides.
struct Details {
    std::string map; ///< rows of characters: where it differs, and how much
    std::vector<Culprit> culprits;
    std::optional<std::uint64_t> perceptual; ///< pixels that a viewer tells apart (perceptual_difference())
    std::vector<std::uint8_t> expected_png, actual_png, difference_png; ///< empty unless asked for
    double gain = 1.0;                                                  ///< of the difference's picture
};

struct FrameResult {
    std::string name;
    std::optional<std::uint64_t> number;
    std::string series; ///< FrameName::series of the expected side's frame, or else of the actual's
    Verdict verdict = Verdict::same;
    std::string message;          ///< of unreadable frames and those of another shape: what was found
    bool expected_failed = false; ///< unreadable: it was the expected side
    std::string expected_path, actual_path;                  ///< empty: drawn, or not there
    std::optional<std::size_t> expected_entry, actual_entry; ///< into the sides' entries
    std::shared_ptr<const Picture> expected, actual; ///< of frames that are not the same, while they are kept
    std::shared_ptr<const Ids> expected_ids, actual_ids;

    // Of frames that are tolerated or differ:
    Difference difference;
    std::string first_expected, first_actual; ///< the pixel's values
    std::string worst_expected, worst_actual;
    std::string first_expected_who, first_actual_who; ///< empty: not known
    std::uint64_t expected_hash = 0, actual_hash = 0; ///< picture_hash()
    std::string note;                                 ///< "depth: uint8 against uint16"
    Details details; ///< once compare_case() is done, of the first and the worst
};

/// Holds no more for long sequences than for short ones, but for the names of missing and extra frames and the messages.
struct CaseResult {
    std::string name;
    std::string why;
    std::array<std::uint64_t, verdicts> counts{};
    std::vector<std::string> missing, extra; ///< names
    std::vector<std::string> failures;       ///< messages of frames unreadable or of another shape
    std::optional<FrameResult> first;        ///< the first that differs
    std::vector<FrameResult> worst;          ///< those that differ, the greatest change first
    std::array<std::uint64_t, beyond_levels + 1> histogram{}; ///< over all frames measured
    std::uint64_t ignored = 0;                                ///< unlike pixels in ignored regions
    std::string better;                                       ///< what is better than declared
    PacketComparison packets;                                 ///< of two recordings

    std::uint64_t frames() const;
    std::uint64_t count(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
    /// 0 same, 1 differs (or better than declared), 2 unreadable, 3 missing or extra, 4 another shape. Of several, the first
    /// in the order 2, 4, 3, 1.
    int exit_code() const;
};

/// Called for every frame in order, whatever its verdict; once at a time.
using EachFrame = std::function<void(const FrameResult&)>;

/// Throws tools::BadInput for what can't be compared at all.
CaseResult compare_case(const Case& which, const Settings& settings, const EachFrame& each);

/// What measure() looks through at a frame of a case.
struct Lens {
    std::vector<std::uint8_t> counted;
    std::vector<std::uint8_t> drawn;
    Measure measure; ///< points into the two above
};
/// For a frame whose pictures are there and of one shape.
std::unique_ptr<Lens> lens_of(const Case& which, ig::Scan scan, const FrameResult& frame);

/// Of several exit codes, the one that weighs most: 2, 4, 3, 1, 0.
int heavier(int a, int b);

} // namespace linkdig::compare
