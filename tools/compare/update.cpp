#include "tools/compare/update.h"

#include "database/format/replace_file.h"
#include "tools/compare/read_picture.h"
#include "tools/compare/report_pictures.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace linkdig::compare {
namespace {

namespace fs = std::filesystem;

bool is_wanted(const FrameResult& frame) {
    switch (frame.verdict) {
    case Verdict::differs:
    case Verdict::shape:
    case Verdict::extra:
        return true;
    case Verdict::unreadable: // a picture that cannot be read is no reference
        return frame.expected_failed &&
               (frame.actual || (!frame.actual_path.empty() && read_picture(frame.actual_path).picture));
    default:
        return false;
    }
}

std::string target_of(const FrameResult& frame, const std::string& folder) {
    if (!frame.expected_path.empty()) return frame.expected_path;
    if (!frame.actual_path.empty())
        return (fs::path(folder) / fs::path(frame.actual_path).filename()).string();
    return (fs::path(folder) / fmt::format("{}_{}.png", frame.series, frame.number.value_or(0))).string();
}

} // namespace

bool update_reference(const FrameResult& frame, const std::string& expected_folder) {
    if (!is_wanted(frame)) return false;
    const std::string target = target_of(frame, expected_folder);
    if (frame.actual_path.empty()) {
        database::replace_file(target, browser_png(*frame.actual));
        return true;
    }
    if (fs::path(target).extension() != fs::path(frame.actual_path).extension())
        throw std::runtime_error(
            fmt::format("{}: not updated: {} is another kind of file", target, frame.actual_path));
    const FileBytes file = read_file(frame.actual_path);
    if (!file.error.empty()) throw std::runtime_error(file.error);
    database::replace_file(target, file.bytes);
    return true;
}

} // namespace linkdig::compare
