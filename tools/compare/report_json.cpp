#include "tools/compare/report_json.h"

#include "tools/compare/report_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace linkdig::compare {
namespace {

using Json = nlohmann::ordered_json;

Json bounded(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json place_json(const Place& place, ig::Scan scan) {
    const bool rows = scan == ig::Scan::horizontal;
    return {{"line", rows ? place.row : place.column},
            {"element", rows ? place.column : place.row},
            {"channel", place.channel}};
}

Json pixel_json(const Place& place, ig::Scan scan, const std::string& expected, const std::string& actual) {
    Json json = place_json(place, scan);
    json["expected"] = expected;
    json["actual"] = actual;
    return json;
}

Json frame_json(const FrameResult& frame, ig::Scan scan) {
    const Difference& d = frame.difference;
    Json json{{"frame", frame.name},
              {"number", frame.number ? Json(*frame.number) : Json(nullptr)},
              {"differing", d.differing},
              {"counted", d.counted},
              {"drawn", d.drawn},
              {"percent_of_drawn", percent(d)},
              {"max", bounded(d.largest)},
              {"mean", bounded(d.mean)},
              {"rms", bounded(d.rms)},
              {"psnr_db", d.psnr_db},
              {"perceptual", frame.details.perceptual ? Json(*frame.details.perceptual) : Json(nullptr)},
              {"first", pixel_json(d.first, scan, frame.first_expected, frame.first_actual)},
              {"worst", pixel_json(d.worst, scan, frame.worst_expected, frame.worst_actual)},
              {"expected_hash", fmt::format("{:016x}", frame.expected_hash)},
              {"actual_hash", fmt::format("{:016x}", frame.actual_hash)},
              {"histogram", d.histogram},
              {"shows", Json::array()}};
    for (const Culprit& culprit : frame.details.culprits)
        json["shows"].push_back(
            {{"expected", culprit.expected}, {"actual", culprit.actual}, {"pixels", culprit.pixels}});
    return json;
}

Json fields_json(const std::vector<FieldDifference>& fields) {
    Json json = Json::array();
    for (const FieldDifference& field : fields)
        json.push_back({{"field", field.field},
                        {"expected", field.expected},
                        {"actual", field.actual},
                        {"changes_picture", field.changes_picture}});
    return json;
}

Json packets_json(const PacketComparison& packets) {
    if (!packets.compared) return nullptr;
    Json json{{"differing", packets.differing}};
    if (packets.first) json.update({{"first", *packets.first}, {"fields", fields_json(packets.fields)}});
    if (packets.first_picture)
        json.update({{"first_picture", *packets.first_picture},
                     {"picture_fields", fields_json(packets.picture_fields)}});
    return json;
}

Json case_json(const CaseResult& result, ig::Scan scan) {
    Json json{{"name", result.name},
              {"exit_code", result.exit_code()},
              {"frames", result.frames()},
              {"counts", Json::object()}};
    for (std::size_t k = 0; k < verdicts; ++k)
        json["counts"][verdict_text(static_cast<Verdict>(k))] = result.counts[k];
    json["missing"] = result.missing;
    json["extra"] = result.extra;
    json["failures"] = result.failures;
    json["better_than_declared"] = !result.better.empty();
    json["ignored_pixels"] = result.ignored;
    json["first"] = result.first ? frame_json(*result.first, scan) : Json(nullptr);
    json["worst"] = Json::array();
    for (const FrameResult& frame : result.worst)
        json["worst"].push_back(frame_json(frame, scan));
    json["packets"] = packets_json(result.packets);
    return json;
}

/// Characters that XML cannot hold at all become '?'.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
    return out;
}

std::string reason(const FrameResult& frame, ig::Scan scan) {
    if (!frame.message.empty()) return frame.message;
    if (frame.verdict != Verdict::differs) return verdict_text(frame.verdict);
    return fmt::format("{} pixels differ, at most {:.4g} levels; first at {}: expected {}, got {}",
                       frame.difference.differing, frame.difference.largest,
                       place_text(frame.difference.first, scan), frame.first_expected, frame.first_actual);
}

} // namespace

std::string json_of_results(const std::vector<CaseResult>& results, ig::Scan scan) {
    int code = 0;
    Json cases = Json::array();
    for (const CaseResult& result : results) {
        code = heavier(code, result.exit_code());
        cases.push_back(case_json(result, scan));
    }
    const Json json{{"exit_code", code}, {"summary", closing_line(results)}, {"cases", cases}};
    // Names of files may hold bytes that are no text.
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

void JunitFile::begin(const std::string& name) {
    name_ = escaped(name);
    frames_.clear();
    tests_ = failures_ = 0;
}

void JunitFile::take(const FrameResult& frame, ig::Scan scan) {
    ++tests_;
    frames_ += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", name_, escaped(frame.name));
    if (frame.verdict == Verdict::same || frame.verdict == Verdict::tolerated) {
        frames_ += "/>\n";
        return;
    }
    ++failures_;
    frames_ += fmt::format(">\n      <failure type=\"{}\" message=\"{}\"/>\n    </testcase>\n",
                           verdict_text(frame.verdict), escaped(reason(frame, scan)));
}

void JunitFile::end(const CaseResult& result) {
    if (!result.better.empty()) {
        ++tests_;
        ++failures_;
        frames_ += fmt::format("    <testcase classname=\"{0}\" name=\"tolerance\">\n      <failure "
                               "type=\"better\" message=\"{1}\"/>\n    </testcase>\n",
                               name_, escaped(result.better));
    }
    suites_ +=
        fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}  </testsuite>\n",
                    name_, tests_, failures_, frames_);
}

std::string JunitFile::text() const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n" + suites_ + "</testsuites>\n";
}

} // namespace linkdig::compare
