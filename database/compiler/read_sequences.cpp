/// Sequences: the animator's method that the report names in 3.2.2: key shapes are drawn, those between are
/// computed.

#include "database/compiler/model_object.h"
#include "database/compiler/primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
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

/// The faces that the shape has, as numbers of corners from 0; one of all its corners if the author names none.
std::vector<std::vector<std::uint32_t>> read_faces(TableReader& sequence, std::size_t corners) {
    std::vector<std::vector<std::uint32_t>> faces;
    if (!sequence.has("faces")) {
        faces.emplace_back();
        for (std::uint32_t i = 0; i < corners; ++i)
            faces.back().push_back(i);
        return faces;
    }
    const toml::array* array = sequence.node("faces")->as_array();
    for (std::size_t f = 0; array != nullptr && f < array->size(); ++f) {
        faces.emplace_back();
        const toml::array* numbers = array->get(f)->as_array();
        for (std::size_t i = 0; numbers != nullptr && i < numbers->size(); ++i) {
            const std::int64_t number = numbers->get(i)->value_exact<std::int64_t>().value_or(0);
            if (number < 1 || number > static_cast<std::int64_t>(corners)) return {};
            faces.back().push_back(static_cast<std::uint32_t>(number - 1));
        }
        const std::set<std::uint32_t> distinct(faces.back().begin(), faces.back().end());
        if (distinct.size() < 3 || distinct.size() != faces.back().size()) return {};
    }
    return faces;
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

void add_shape(const std::vector<Vec3d>& corners, const std::vector<std::vector<std::uint32_t>>& faces,
               const FaceStyle& style, bool mirrored, ModelObject& object) {
    for (Vec3d corner : corners) {
        if (mirrored) corner.y = -corner.y;
        object.vertices.push_back({as_float(corner), {}, {}, object.at});
    }
    for (const std::vector<std::uint32_t>& numbers : faces) {
        ModelFace face;
        face.style = style;
        face.at = object.at;
        face.corners = numbers;
        if (mirrored) std::reverse(face.corners.begin() + 1, face.corners.end());
        object.faces.push_back(std::move(face));
    }
}

} // namespace

void read_sequence(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects) {
    TableReader reader = reader_of(table, *reading.sources, "sequence", *reading.diagnostics);
    ModelObject base;
    const std::string name = reader.text("name");
    reader.describe("colour", reading.registry->colour_names.reference(), {});
    reader.describe("faces", "array of arrays of corner numbers, from 1", "one face of all corners");
    base.at = place_of(*table.table, table.file);
    read_membership(reader, reading, true, base);
    FaceStyle inherited;
    inherited.two_sided = true;
    const FaceStyle style = read_style(reader, reading, inherited);
    if (!style.colour)
        reading.error(base.at, fmt::format("{} has no colour; expected `colour`", reader.what()));
    const bool mirrored = read_mirror(reader);
    const auto slot = static_cast<std::size_t>(base.slot);
    // In a slot whose first alternative is nothing, frame and alternative have one number.
    const std::uint32_t first = base.slot == none ? 0 : reading.registry->first_objects[slot];
    const std::int64_t frames =
        base.slot == none ? most_alternatives : std::int64_t{reading.registry->alternatives[slot]} - first;
    const std::vector<Key> keys = base.slot == none ? std::vector<Key>() : read_keys(reader, reading, frames);
    reader.tables("key");
    reader.node("faces");
    if (!keys.empty()) {
        const std::size_t corners = keys.front().corners.size();
        const std::vector<std::vector<std::uint32_t>> faces = read_faces(reader, corners);
        if (faces.empty())
            reader.error_at("faces",
                            fmt::format("\"faces\" of {} holds something else; expected arrays of three "
                                        "or more distinct corner numbers, 1 to {}",
                                        reader.what(), corners));
        for (std::int64_t frame = 1; !faces.empty() && frame <= frames; ++frame) {
            ModelObject object = base;
            object.name = fmt::format("{}.{}", name, frame);
            object.alternative = static_cast<std::uint32_t>(frame - 1) + first;
            add_shape(shape_between(keys, frame), faces, style, mirrored, object);
            objects.push_back(std::move(object));
        }
    }
    reader.finish();
}

} // namespace linkdig::database
