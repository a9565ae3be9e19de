#include "database/format/write.h"

#include "database/format/file_header.h"
#include "database/format/replace_file.h"
#include "database/format/stored_records.h"
#include "database/format/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <type_traits>

namespace linkdig::database {

namespace {

using Builder = flatbuffers::FlatBufferBuilder;

template <typename Record>
auto stored_records(Builder& builder, const std::vector<Record>& records) {
    using Stored = decltype(to_stored(std::declval<const Record&>()));
    std::vector<Stored> stored;
    stored.reserve(records.size());
    for (const Record& record : records)
        stored.push_back(to_stored(record));
    return builder.CreateVectorOfStructs(stored);
}

template <typename Record>
auto stored_names(Builder& builder, const std::vector<Record>& records) {
    std::vector<std::string> names;
    names.reserve(records.size());
    for (const Record& record : records)
        names.push_back(record.name);
    return builder.CreateVectorOfStrings(names);
}

std::vector<std::uint32_t> alternatives(const std::vector<SubstitutionSlot>& slots) {
    std::vector<std::uint32_t> counts;
    counts.reserve(slots.size());
    for (const SubstitutionSlot& slot : slots)
        counts.push_back(slot.alternatives);
    return counts;
}

std::uint64_t bytes_of(const std::vector<std::string>& names) {
    std::uint64_t bytes = 0;
    for (const std::string& name : names)
        bytes += name.size() + 16; // offset, length, terminator, padding
    return bytes;
}

/// Not less than the payload will take. FlatBuffers itself asserts at 2 GiB, too late for a message.
std::uint64_t most_bytes(const VisualDatabase& d) {
    const auto named = [](const auto& records) {
        std::uint64_t bytes = 0;
        for (const auto& record : records)
            bytes += record.name.size() + 16 + sizeof(record);
        return bytes;
    };
    return 4096 + d.name.size() + bytes_of(d.source_files) + bytes_of(d.colour_names) + bytes_of(d.suns) +
           bytes_of(d.moving_objects) + named(d.slots) + named(d.details) + named(d.clusters) +
           named(d.lists) + named(d.objects) + d.colours.size() * sizeof(Colour) +
           d.groups.size() * sizeof(PriorityGroup) + d.detail_levels.size() * sizeof(stored::DetailLevel) +
           d.planes.size() * sizeof(stored::PlaneNode) + d.run_leaves.size() * sizeof(RunLeaf) +
           d.runs.size() * sizeof(stored::FaceRun) + d.faces.size() * sizeof(stored::Face) +
           d.corners.size() * sizeof(std::uint32_t) + d.corner_colours.size() * sizeof(stored::Colour) +
           d.vertices.size() * sizeof(stored::Vertex) + d.lights.size() * sizeof(stored::LightPoint) +
           d.tiles.size() * sizeof(stored::RepeatedTile) + d.tile_normals.size() * sizeof(stored::Vec3);
}

/// One statement per field: the order of building is the order of bytes, and C++ does not fix that of
/// arguments.
void build(Builder& builder, const VisualDatabase& d) {
    const auto name = builder.CreateString(d.name);
    const auto source_files = builder.CreateVectorOfStrings(d.source_files);
    const auto colours = stored_records(builder, d.colours);
    const auto colour_names = builder.CreateVectorOfStrings(d.colour_names);
    const auto suns = builder.CreateVectorOfStrings(d.suns);
    const auto moving_objects = builder.CreateVectorOfStrings(d.moving_objects);
    const auto slot_names = stored_names(builder, d.slots);
    const auto slot_alternatives = builder.CreateVector(alternatives(d.slots));
    const auto details = stored_records(builder, d.details);
    const auto detail_names = stored_names(builder, d.details);
    const auto detail_levels = stored_records(builder, d.detail_levels);
    const auto groups = stored_records(builder, d.groups);
    const auto clusters = stored_records(builder, d.clusters);
    const auto cluster_names = stored_names(builder, d.clusters);
    const auto lists = stored_records(builder, d.lists);
    const auto list_names = stored_names(builder, d.lists);
    const auto objects = stored_records(builder, d.objects);
    const auto object_names = stored_names(builder, d.objects);
    const auto planes = stored_records(builder, d.planes);
    const auto run_leaves = stored_records(builder, d.run_leaves);
    const auto runs = stored_records(builder, d.runs);
    const auto faces = stored_records(builder, d.faces);
    const auto corners = builder.CreateVector(d.corners);
    const auto corner_colours = stored_records(builder, d.corner_colours);
    const auto vertices = stored_records(builder, d.vertices);
    const auto lights = stored_records(builder, d.lights);
    const auto tiles = stored_records(builder, d.tiles);
    const auto tile_normals = stored_records(builder, d.tile_normals);
    const auto root = stored::CreateVisualDatabase(
        builder, name, source_files, colours, colour_names, suns, moving_objects, slot_names,
        slot_alternatives, details, detail_names, detail_levels, groups, clusters, cluster_names, lists,
        list_names, objects, object_names, planes, run_leaves, runs, faces, corners, corner_colours, vertices,
        lights, tiles, tile_normals);
    stored::FinishVisualDatabaseBuffer(builder, root);
}

} // namespace

std::vector<std::uint8_t> encode_database(const VisualDatabase& database) {
    if (most_bytes(database) > max_payload_bytes)
        throw std::length_error(fmt::format("the database takes some {} MiB; a file holds at most {} MiB",
                                            most_bytes(database) >> 20U, max_payload_bytes >> 20U));
    Builder builder;
    build(builder, database);
    assert(builder.GetSize() <= max_payload_bytes);
    std::vector<std::uint8_t> file(header_bytes + builder.GetSize());
    std::copy_n(builder.GetBufferPointer(), builder.GetSize(), file.begin() + header_bytes);
    seal_header(file);
    return file;
}

std::uint64_t database_id(const VisualDatabase& database) {
    const std::vector<std::uint8_t> file = encode_database(database);
    return payload_id(std::span(file).subspan(header_bytes));
}

void write_database(const VisualDatabase& database, const std::string& path) {
    if (const std::string unsound = validate(database); !unsound.empty())
        throw std::runtime_error(
            fmt::format("cannot write {}: the database is not sound: {}", path, unsound));
    std::vector<std::uint8_t> file;
    try {
        file = encode_database(database);
    } catch (const std::length_error& too_long) {
        throw std::runtime_error(fmt::format("cannot write {}: {}", path, too_long.what()));
    }
    replace_file(path, file);
}

} // namespace linkdig::database
