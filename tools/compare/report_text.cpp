#include "tools/compare/report_text.h"

#include "tools/compare/histogram.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace linkdig::compare {
namespace {

constexpr std::size_t most_names = 20;
constexpr std::size_t most_failures = 20;
constexpr std::size_t most_fields = 8;
constexpr std::size_t bar_width = 40;

std::string count_of(std::uint64_t count, const char* thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string levels_text(double levels) {
    return std::isfinite(levels) ? fmt::format("{:.4g}", levels) : std::string("unbounded");
}

std::string numbers_text(const Difference& d) {
    std::string text = fmt::format("{} of {} {} pixels ({:.3g} %)", d.differing, d.drawn,
                                   d.drawn == d.counted ? "compared" : "drawn", percent(d));
    if (!std::isfinite(d.largest)) return text;
    text += fmt::format("; levels of 255: max {}, mean {}, RMS {}, PSNR {:.2f} dB", levels_text(d.largest),
                        levels_text(d.mean), levels_text(d.rms), d.psnr_db);
    return text;
}

std::string who_text(const FrameResult& frame) {
    const std::string& a = frame.first_expected_who;
    const std::string& b = frame.first_actual_who;
    if (a.empty() && b.empty()) return "";
    if (a == b) return fmt::format("    shows    {}\n", a);
    return fmt::format("    expected {}\n    got      {}\n", a.empty() ? "(not known)" : a,
                       b.empty() ? "(not known)" : b);
}

std::string culprits_text(const std::vector<Culprit>& culprits) {
    std::string text;
    for (const Culprit& culprit : culprits) {
        text += fmt::format("  {:>8} pixels: ", culprit.pixels);
        if (culprit.expected == culprit.actual)
            text += fmt::format("{}, in another colour\n", culprit.expected);
        else if (culprit.expected.empty() || culprit.actual.empty())
            text += culprit.expected + culprit.actual + "\n";
        else
            text += fmt::format("expected {}\n{:>18} got      {}\n", culprit.expected, "", culprit.actual);
    }
    return text;
}

std::string frame_text(const FrameResult& frame, ig::Scan scan) {
    const Difference& d = frame.difference;
    std::string text = fmt::format("{}: {}\n", frame.name, numbers_text(d));
    text += fmt::format("  first at {}: expected {}, got {}\n", place_text(d.first, scan),
                        frame.first_expected, frame.first_actual);
    text += who_text(frame);
    if (!(d.worst == d.first))
        text += fmt::format("  worst at {}: expected {}, got {}\n", place_text(d.worst, scan),
                            frame.worst_expected, frame.worst_actual);
    if (!frame.note.empty()) text += "  " + frame.note + "\n";
    if (frame.details.perceptual)
        text += fmt::format("  a viewer tells {} apart (Yee's metric)\n",
                            count_of(*frame.details.perceptual, "pixel"));
    text += culprits_text(frame.details.culprits);
    text += histogram_text(d.histogram);
    return text + frame.details.map;
}

std::string worst_table(const std::vector<FrameResult>& worst) {
    std::string text = "worst frames, by RMS:\n      pixels  % drawn      max      RMS  frame\n";
    for (const FrameResult& frame : worst)
        text += fmt::format("  {:>10} {:>8.3f} {:>8} {:>8}  {}\n", frame.difference.differing,
                            percent(frame.difference), levels_text(frame.difference.largest),
                            levels_text(frame.difference.rms), frame.name);
    return text;
}

std::string fields_text(const std::vector<FieldDifference>& fields, bool alone) {
    std::string text;
    std::size_t told = 0;
    for (const FieldDifference& field : fields) {
        if (alone && !field.changes_picture) continue;
        if (told++ < most_fields)
            text += fmt::format("    {}: expected {}, got {}\n", field.field, field.expected, field.actual);
    }
    return told > most_fields ? text + fmt::format("    and {} more\n", told - most_fields) : text;
}

std::string packets_text(const PacketComparison& packets) {
    if (!packets.first) return packets.compared ? "packets: all fields the same\n" : "";
    std::string text = fmt::format("packets: {} differ, first that of frame {}:\n{}", packets.differing,
                                   *packets.first, fields_text(packets.fields, false));
    if (!packets.first_picture) return text + "  no picture differs through them\n";
    const std::string alone = fields_text(packets.picture_fields, true);
    return text +
           fmt::format("  first picture that differs: frame {}; {}\n{}", *packets.first_picture,
                       alone.empty() ? "no field changes it alone" : "fields that change it alone:", alone);
}

} // namespace

std::string place_text(const Place& place, ig::Scan scan) {
    const bool rows = scan == ig::Scan::horizontal;
    return fmt::format("line {}, element {}, channel {}", rows ? place.row : place.column,
                       rows ? place.column : place.row, place.channel);
}

std::string names_text(const std::vector<std::string>& names) {
    std::vector<std::string> shown(
        names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most_names)));
    std::string text = fmt::format("{}", fmt::join(shown, ", "));
    if (names.size() > most_names) text += fmt::format(" and {} more", names.size() - most_names);
    return text;
}

std::string histogram_text(const std::array<std::uint64_t, beyond_levels + 1>& histogram) {
    const std::vector<HistogramBar> bars = bars_of(histogram);
    std::uint64_t most = 1;
    for (const HistogramBar& bar : bars)
        most = std::max(most, bar.pixels);
    std::string text;
    for (const HistogramBar& bar : bars) {
        if (bar.pixels == 0) continue;
        const auto width =
            static_cast<std::size_t>(std::max<std::uint64_t>(1, bar.pixels * bar_width / most));
        text += fmt::format("  {:>10} levels {:>10} pixels {}\n", bar.levels, bar.pixels,
                            std::string(width, '='));
    }
    return text;
}

std::string text_of(const CaseResult& result, ig::Scan scan) {
    std::string text;
    if (!result.missing.empty())
        text += fmt::format("missing: {}: {}\n", count_of(result.missing.size(), "frame"),
                            names_text(result.missing));
    if (!result.extra.empty())
        text +=
            fmt::format("extra: {}: {}\n", count_of(result.extra.size(), "frame"), names_text(result.extra));
    for (std::size_t k = 0; k < std::min(result.failures.size(), most_failures); ++k)
        text += result.failures[k] + "\n";
    if (result.failures.size() > most_failures)
        text += fmt::format("and {} more\n", result.failures.size() - most_failures);
    if (result.first) {
        text += "first frame that differs: " + frame_text(*result.first, scan);
        if (result.worst.front().name != result.first->name)
            text += "worst frame: " + frame_text(result.worst.front(), scan);
        if (result.worst.size() > 1) text += worst_table(result.worst);
    }
    if (result.exit_code() != 0 || result.packets.first) text += packets_text(result.packets);
    if (result.ignored > 0)
        text += fmt::format("ignored: {} in regions that do not count\n",
                            count_of(result.ignored, "differing pixel"));
    text += result.better;
    if (text.empty()) return "";
    const std::string heading =
        result.name.empty() ? "" : result.name + (result.why.empty() ? ":\n" : " (" + result.why + "):\n");
    return heading + text;
}

std::string closing_line(const std::vector<CaseResult>& results) {
    std::array<std::uint64_t, verdicts> counts{};
    std::uint64_t frames = 0;
    int code = 0;
    std::size_t better = 0;
    const FrameResult* first = nullptr;
    for (const CaseResult& result : results) {
        for (std::size_t k = 0; k < verdicts; ++k)
            counts[k] += result.counts[k];
        frames += result.frames();
        code = heavier(code, result.exit_code());
        better += result.better.empty() ? 0 : 1;
        if (first == nullptr && result.first) first = &*result.first;
    }
    std::vector<std::string> parts;
    constexpr Verdict told[] = {Verdict::unreadable, Verdict::shape,   Verdict::missing,
                                Verdict::extra,      Verdict::differs, Verdict::tolerated};
    constexpr const char* words[] = {"unreadable", "of another size or other channels", "missing", "extra",
                                     "differ",     "differ within the tolerance"};
    for (std::size_t k = 0; k < std::size(told); ++k)
        if (const std::uint64_t n = counts[static_cast<std::size_t>(told[k])]; n > 0)
            parts.push_back(fmt::format("{} {}", n, words[k]));
    if (better > 0) parts.push_back(fmt::format("{} better than declared", count_of(better, "case")));
    if (first != nullptr) parts.push_back("first " + first->name);
    constexpr const char* names[] = {"same", "differs", "unreadable", "missing or extra frames",
                                     "size or channels differ"};
    std::string line = fmt::format("{}: {}", names[code], count_of(frames, "frame"));
    return parts.empty() ? line : fmt::format("{}; {}", line, fmt::join(parts, ", "));
}

} // namespace linkdig::compare
