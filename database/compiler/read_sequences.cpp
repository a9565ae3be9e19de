/// Sequences: the animator's method that the report names in 3.2.2: key shapes are drawn, those between are
/// computed.

#include "database/compiler/model_object.h"
#include "database/compiler/primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace linkdig::database {

namespace {

struct Key {
    std::int64_t frame = 0;
    std::vector<Vec3d> corners;
};

std::optional<Key> read_key(const toml::table& table, const TableReader& sequence, const Reading& reading,
                            std::int64_t frames) {
    const std::size_t errors_before = reading.diagnostics->all().size();
    TableReader reader(table, sequence.file(), "[[sequence.key]] of " + sequence.what(),
                       *reading.diagnostics);
    Key key;
    key.frame = reader.integer("frame", 1, frames);
    key.corners = reader.points_m("corners");
    if (reader.has("corners_m") && (key.corners.size() < 3 || key.corners.size() > most_corners))
        reader.error_at("corners_m", fmt::format("the key shape has {} corners; expected 3 to {}",
                                                 key.corners.size(), most_corners));
    reader.finish();
    if (reading.diagnostics->all().size() != errors_before) return std::nullopt;
    return key;
}

/// Keys in ascending order from frame 1 to the last, all with equally many corners; empty if there is a
/// mistake.
std::vector<Key> read_keys(TableReader& sequence, const Reading& reading, std::int64_t frames) {
    std::vector<Key> keys;
    bool complete = true;
    for (const toml::table* table : sequence.tables("key")) {
        std::optional<Key> key = read_key(*table, sequence, reading, frames);
        complete = complete && key;
        if (!key) continue;
        const auto mistake = [&](std::string message) {
            reading.diagnostics->error(location_of(*table, sequence.file()), std::move(message));
            complete = false;
        };
        if (!keys.empty() && key->frame <= keys.back().frame)
            mistake(fmt::format("the key frame {} follows {}; expected ascending frames", key->frame,
                                keys.back().frame));
        if (!keys.empty() && key->corners.size() != keys.front().corners.size())
            mistake(fmt::format("the key shape has {} corners and the first one {}; expected equal numbers",
                                key->corners.size(), keys.front().corners.size()));
        keys.push_back(std::move(*key));
    }
    if (complete && (keys.empty() || keys.front().frame != 1 || keys.back().frame != frames)) {
        reading.diagnostics->error(sequence.here(),
                                   fmt::format("the key frames of {} do not reach from 1 to {}; expected "
                                               "[[sequence.key]]s for both",
                                               sequence.what(), frames));
        complete = false;
    }
    return complete ? keys : std::vector<Key>();
}

std::vector<Vec3d> shape_between(const std::vector<Key>& keys, std::int64_t frame) {
    const auto after =
        std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.frame >= frame; });
    if (after->frame == frame) return after->corners;
    const Key& before = *(after - 1);
    const double part =
        static_cast<double>(frame - before.frame) / static_cast<double>(after->frame - before.frame);
    std::vector<Vec3d> corners;
    for (std::size_t i = 0; i < before.corners.size(); ++i)
        corners.push_back(before.corners[i] + part * (after->corners[i] - before.corners[i]));
    return corners;
}

} // namespace

void read_sequence(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects) {
    TableReader reader = reader_of(table, *reading.sources, "sequence", *reading.diagnostics);
    ModelObject base;
    const std::string name = reader.text("name");
    base.at = place_of(*table.table, table.file);
    read_membership(reader, reading, true, base);
    FaceStyle inherited;
    inherited.two_sided = true;
    const FaceStyle style = read_style(reader, reading, inherited);
    if (!style.colour)
        reading.error(base.at, fmt::format("{} has no colour; expected `colour`", reader.what()));
    const bool mirrored = read_mirror(reader);
    const std::int64_t frames = base.slot == none
                                    ? most_alternatives
                                    : reading.registry->alternatives[static_cast<std::size_t>(base.slot)];
    const std::vector<Key> keys = base.slot == none ? std::vector<Key>() : read_keys(reader, reading, frames);
    reader.tables("key");
    reader.finish();
    if (keys.empty()) return;
    for (std::int64_t frame = 1; frame <= frames; ++frame) {
        ModelObject object = base;
        object.name = fmt::format("{}.{}", name, frame);
        object.alternative = static_cast<std::uint32_t>(frame - 1);
        ModelFace face;
        face.style = style;
        face.at = base.at;
        for (Vec3d corner : shape_between(keys, frame)) {
            if (mirrored) corner.y = -corner.y;
            face.corners.push_back(static_cast<std::uint32_t>(object.vertices.size()));
            object.vertices.push_back({as_float(corner), {}, {}, base.at});
        }
        if (mirrored) std::reverse(face.corners.begin() + 1, face.corners.end());
        object.faces.push_back(std::move(face));
        objects.push_back(std::move(object));
    }
}

} // namespace linkdig::database
