#include "tools/compare/load_pair.h"

#include "tools/compare/read_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace linkdig::compare {
namespace {

/// Every pixel that is not the background in both. Levels are compared to half a level.
std::vector<std::uint8_t> unlike_background(const Picture& a, const Picture& b,
                                            const std::array<double, 3>& background) {
    std::vector<std::uint8_t> drawn(a.pixels(), 0);
    std::vector<double> levels(std::size_t{a.width} * a.channels);
    for (const Picture* picture : {&a, &b}) {
        for (std::uint32_t row = 0; row < a.height; ++row) {
            row_levels(*picture, row, levels.data());
            for (std::uint32_t x = 0; x < a.width; ++x)
                for (std::uint32_t k = 0; k < std::min(a.channels, 3U); ++k)
                    if (std::abs(levels[std::size_t{x} * a.channels + k] - background[k]) > 0.5)
                        drawn[std::size_t{row} * a.width + x] = 1;
        }
    }
    return drawn;
}

void unreadable(FrameResult& frame, std::string message, bool expected_failed) {
    frame.verdict = Verdict::unreadable;
    frame.message += (frame.message.empty() ? "" : "; ") + std::move(message);
    frame.expected_failed = frame.expected_failed || expected_failed;
}

std::shared_ptr<const Picture> read_again(const std::string& path) {
    ReadPicture read = read_picture(path);
    return read.picture ? std::make_shared<const Picture>(std::move(*read.picture)) : nullptr;
}

} // namespace

std::unique_ptr<Lens> lens_of(const Case& which, ig::Scan scan, const FrameResult& frame) {
    auto lens = std::make_unique<Lens>();
    const Picture& expected = *frame.expected;
    lens->counted = counted_pixels(which.regions, expected.width, expected.height);
    const Ids none_known;
    lens->drawn = drawn_pixels(frame.expected_ids ? *frame.expected_ids : none_known,
                               frame.actual_ids ? *frame.actual_ids : none_known);
    if (lens->drawn.empty() && which.background && !expected.names_things())
        lens->drawn = unlike_background(expected, *frame.actual, *which.background);
    lens->measure = {lens->counted, lens->drawn, which.tolerance, scan};
    return lens;
}

Loader::Loader(const Case& which, const Settings& settings)
    : which_(which), settings_(settings),
      expected_(open_side(which.expected, settings.expected_frames, settings.empty_references)),
      actual_(open_side(which.actual, settings.actual_frames)),
      pairs_(align(expected_, actual_, which.frames)), expected_planes_(plane_files(expected_)),
      actual_planes_(plane_files(actual_)) {
    packets_.compared = expected_.recording && actual_.recording;
}

Loader::PlaneFiles Loader::plane_files(const Side& side) {
    PlaneFiles files;
    for (const Entry& entry : side.entries)
        if (!entry.key.plane.empty() && entry.key.plane != "rank" && entry.key.plane != "intensity" &&
            entry.key.number)
            files[{entry.key.plane, entry.key.prefix, *entry.key.number}] = entry.path;
    return files;
}

std::shared_ptr<FrameResult> Loader::next() {
    if (next_ == pairs_.size()) return nullptr;
    const Pair& pair = pairs_[next_++];
    auto frame = std::make_shared<FrameResult>();
    const Entry& entry = pair.expected ? expected_.entries[*pair.expected] : actual_.entries[*pair.actual];
    frame->name = entry.name;
    frame->number = entry.key.number;
    frame->series = entry.key.series;
    frame->expected_entry = pair.expected;
    frame->actual_entry = pair.actual;
    if (pair.expected) frame->expected_path = expected_.entries[*pair.expected].path;
    if (pair.actual) frame->actual_path = actual_.entries[*pair.actual].path;
    if (!pair.actual) frame->verdict = Verdict::missing;
    if (!pair.expected) frame->verdict = Verdict::extra;
    draw(pair, *frame);
    return frame;
}

void Loader::draw(const Pair& pair, FrameResult& frame) {
    const auto draw_side = [&](Side& side, const std::optional<std::size_t>& at, bool is_expected) {
        if (!at || !side.recording) return;
        const Entry& entry = side.entries[*at];
        const std::string refusal = side.recording->go_to(entry.packet);
        if (!refusal.empty())
            return unreadable(frame,
                              fmt::format("{}: {}: cannot be drawn: {}", side.path, entry.name, refusal),
                              is_expected);
        auto picture = std::make_shared<const Picture>(side.recording->picture(entry.channel));
        auto ids = std::make_shared<const Ids>(side.recording->ids(entry.channel));
        (is_expected ? frame.expected : frame.actual) = std::move(picture);
        (is_expected ? frame.expected_ids : frame.actual_ids) = std::move(ids);
    };
    draw_side(expected_, pair.expected, true);
    draw_side(actual_, pair.actual, false);
    if (packets_.compared && pair.expected && pair.actual) compare_packets(frame);
}

void Loader::compare_packets(FrameResult& frame) {
    const FramePacket& a = expected_.recording->packet();
    const FramePacket& b = actual_.recording->packet();
    const std::uint32_t channel = expected_.entries[*frame.expected_entry].channel;
    std::vector<FieldDifference> fields = differing_fields(a, b);
    if (fields.empty()) return;
    const std::uint64_t packet = expected_.entries[*frame.expected_entry].packet;
    if (last_differing_ != packet) ++packets_.differing; // once for all its channels
    last_differing_ = packet;
    if (!packets_.first) {
        packets_.first = a.frame;
        packets_.fields = fields;
    }
    if (packets_.first_picture || !frame.expected || !frame.actual ||
        frame.expected->bytes == frame.actual->bytes)
        return;
    packets_.first_picture = a.frame;
    bisect(a, b, settings_.expected_frames, expected_.recording->history_before(), channel, fields);
    packets_.picture_fields = std::move(fields);
}

/// False if the frame is done: the files are the same, or one cannot be read.
bool Loader::read_files(FrameResult& frame) const {
    FileBytes files[2];
    if (!frame.expected) files[0] = read_file(frame.expected_path);
    if (!frame.actual) files[1] = read_file(frame.actual_path);
    for (const bool expected : {true, false}) {
        const FileBytes& file = files[expected ? 0 : 1];
        if (!file.error.empty()) unreadable(frame, file.error, expected);
    }
    if (frame.verdict == Verdict::unreadable) return false;
    const bool same_bytes = !frame.expected && !frame.actual && files[0].bytes == files[1].bytes;
    if (same_bytes && is_whole_png(files[0].bytes)) return false;
    const auto decode = [&](FileBytes& file, const std::string& path, std::shared_ptr<const Picture>& picture,
                            bool expected) {
        if (picture) return;
        ReadPicture read = decode_picture(path, file.bytes);
        if (read.picture)
            picture = std::make_shared<const Picture>(std::move(*read.picture));
        else
            unreadable(frame, read.error, expected);
    };
    decode(files[0], frame.expected_path, frame.expected, true);
    if (same_bytes) return false;
    decode(files[1], frame.actual_path, frame.actual, false);
    return frame.verdict != Verdict::unreadable;
}

bool Loader::is_comparable(FrameResult& frame) const {
    const Picture& a = *frame.expected;
    const Picture& b = *frame.actual;
    if (!same_shape(a, b)) {
        frame.verdict = Verdict::shape;
        const char* what = a.width != b.width || a.height != b.height ? "another size" : "other channels";
        frame.message =
            fmt::format("{}: {}: expected {}; got {}", frame.name, what, shape_text(a), shape_text(b));
        return false;
    }
    const std::string mistake = mask_mistake(which_.regions, a.width, a.height);
    if (!mistake.empty()) unreadable(frame, fmt::format("{}: {}", frame.name, mistake), false);
    return mistake.empty() && (a.sample != b.sample || a.bytes != b.bytes);
}

void Loader::measure(FrameResult& frame) const {
    if (frame.verdict != Verdict::same) return;
    if (!read_files(frame) || !is_comparable(frame)) return;
    add_ids(frame);
    const Picture& a = *frame.expected;
    const Picture& b = *frame.actual;
    const auto lens = lens_of(which_, settings_.scan, frame);
    frame.difference = compare::measure(a, b, lens->measure);
    const Difference& d = frame.difference;
    if (d.differing == 0) return;
    frame.verdict = !which_.tolerance.empty() && is_within(which_.tolerance, d.buckets) ? Verdict::tolerated
                                                                                        : Verdict::differs;
    frame.first_expected = pixel_text(a, d.first.column, d.first.row);
    frame.first_actual = pixel_text(b, d.first.column, d.first.row);
    frame.worst_expected = pixel_text(a, d.worst.column, d.worst.row);
    frame.worst_actual = pixel_text(b, d.worst.column, d.worst.row);
    frame.expected_hash = picture_hash(a);
    frame.actual_hash = picture_hash(b);
    if (a.depth != b.depth) frame.note = fmt::format("depth: {} against {}", a.depth, b.depth);
    const std::size_t at = std::size_t{d.first.row} * a.width + d.first.column;
    if (frame.expected_ids)
        frame.first_expected_who = who(*frame.expected_ids, at, settings_.expected_frames.database);
    if (frame.actual_ids)
        frame.first_actual_who = who(*frame.actual_ids, at, settings_.actual_frames.database);
}

std::shared_ptr<const Ids> Loader::ids_beside(const Entry& entry, const PlaneFiles& files,
                                              const Picture& picture) {
    if (files.empty() || !entry.key.plane.empty() || !entry.key.number) return nullptr;
    Ids ids;
    for (auto [plane, numbers] :
         {std::pair("list", &ids.list), std::pair("object", &ids.object), std::pair("face", &ids.face)}) {
        auto found = files.find({plane, entry.key.prefix, *entry.key.number});
        // A lone set of planes belongs to the pictures whatever these are called.
        if (found == files.end()) found = files.find({plane, "", *entry.key.number});
        if (found == files.end()) continue;
        const ReadPicture read = read_picture(found->second); // one that cannot be read is told of by itself
        if (!read.picture || !read.picture->names_things() || read.picture->width != picture.width ||
            read.picture->height != picture.height)
            continue;
        numbers->resize(picture.pixels());
        for (std::size_t k = 0; k < numbers->size(); ++k)
            (*numbers)[k] = number_at(*read.picture, k);
    }
    return ids.any() ? std::make_shared<const Ids>(std::move(ids)) : nullptr;
}

void Loader::add_ids(FrameResult& frame) const {
    if (!frame.expected_ids && frame.expected_entry)
        frame.expected_ids =
            ids_beside(expected_.entries[*frame.expected_entry], expected_planes_, *frame.expected);
    if (!frame.actual_ids && frame.actual_entry)
        frame.actual_ids = ids_beside(actual_.entries[*frame.actual_entry], actual_planes_, *frame.actual);
}

void Loader::restore(FrameResult& frame) const {
    if (!frame.expected) frame.expected = read_again(frame.expected_path);
    if (!frame.actual) frame.actual = read_again(frame.actual_path);
    if (frame.expected && frame.actual) add_ids(frame);
}

} // namespace linkdig::compare
