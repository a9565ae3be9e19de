#include "tools/compare/report_html.h"

#include "tools/compare/histogram.h"
#include "tools/compare/report_json.h"
#include "tools/compare/report_text.h"

#include <OpenImageIO/strutil.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace linkdig::compare {
namespace {

using Json = nlohmann::ordered_json;

std::string data_url(const std::vector<std::uint8_t>& png) {
    if (png.empty()) return "";
    return "data:image/png;base64," +
           OIIO::Strutil::base64_encode({reinterpret_cast<const char*>(png.data()), png.size()});
}

std::string who_line(const Culprit& culprit) {
    if (culprit.expected == culprit.actual)
        return fmt::format("{} pixels: {}, in another colour", culprit.pixels, culprit.expected);
    return fmt::format("{} pixels: expected {}; got {}", culprit.pixels, culprit.expected, culprit.actual);
}

Json frame_json(const std::string& of_case, const FrameResult& frame, ig::Scan scan) {
    const Difference& d = frame.difference;
    const auto level = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
    Json json{{"case", of_case},
              {"name", frame.name},
              {"differing", d.differing},
              {"percent", percent(d)},
              {"max", level(d.largest)},
              {"mean", level(d.mean)},
              {"rms", level(d.rms)},
              {"psnr", d.psnr_db},
              {"first", fmt::format("{}: expected {}, got {}", place_text(d.first, scan),
                                    frame.first_expected, frame.first_actual)},
              {"worst", fmt::format("{}: expected {}, got {}", place_text(d.worst, scan),
                                    frame.worst_expected, frame.worst_actual)},
              {"perceptual", frame.details.perceptual ? Json(*frame.details.perceptual) : Json(nullptr)},
              {"gain", frame.details.gain},
              {"note", frame.note},
              {"shows", Json::array()},
              {"histogram", Json::array()},
              {"expected", data_url(frame.details.expected_png)},
              {"actual", data_url(frame.details.actual_png)},
              {"difference", data_url(frame.details.difference_png)}};
    for (const Culprit& culprit : frame.details.culprits)
        json["shows"].push_back(who_line(culprit));
    for (const HistogramBar& bar : bars_of(d.histogram))
        json["histogram"].push_back({bar.levels, bar.pixels});
    return json;
}

/// JSON inside a script element: no "</" may stand in it.
std::string in_script(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6)
        text.replace(at, 1, "\\u003c");
    return text;
}

Json messages_of(const CaseResult& result) {
    Json messages = Json::array();
    if (!result.missing.empty()) messages.push_back("missing: " + names_text(result.missing));
    if (!result.extra.empty()) messages.push_back("extra: " + names_text(result.extra));
    for (const std::string& failure : result.failures)
        messages.push_back(failure);
    if (!result.better.empty()) messages.push_back(result.better);
    for (const FieldDifference& field : result.packets.fields)
        messages.push_back(fmt::format("packet of frame {}: {}: expected {}, got {}", *result.packets.first,
                                       field.field, field.expected, field.actual));
    return messages;
}

} // namespace

std::string html_of_results(const std::vector<CaseResult>& results, ig::Scan scan) {
    Json data{{"summary", closing_line(results)}, {"messages", Json::array()}, {"frames", Json::array()}};
    for (const CaseResult& result : results) {
        for (const Json& message : messages_of(result))
            data["messages"].push_back(result.name.empty() ? message.get<std::string>()
                                                           : result.name + ": " + message.get<std::string>());
        for (const FrameResult& frame : result.worst)
            data["frames"].push_back(frame_json(result.name, frame, scan));
    }
    return std::string(report_page_head) + "<script>const data = " + in_script(data) + ";</script>\n" +
           report_page_script;
}

} // namespace linkdig::compare
