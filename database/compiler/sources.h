#pragma once
/// Pass 1: the root file and all it includes, and the tables they contribute, in order.

#include "database/text/table_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::database {

/// Where something was written: small enough to stand in every vertex and face.
struct Place {
    std::uint16_t file = 0; ///< into Sources::files
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

struct Source {
    std::string path; ///< as opened, and as shown in messages
    std::string name; ///< relative to the root file's folder: what the compiled database keeps
    toml::table root;
};

/// In the order in which they contribute: a file's includes before itself, depth first, each file once.
struct Sources {
    std::vector<Source> files;
    std::vector<std::string> tried; ///< every path that was to be read, those that could not be too
    SourceLocation location(Place place) const { return {files[place.file].path, place.line, place.column}; }
};

/// A file that cannot be read is reported at the line that includes it, and contributes nothing.
Sources read_sources(const std::string& path, Diagnostics& diagnostics);

struct AuthoredTable {
    const toml::table* table = nullptr;
    std::uint16_t file = 0;
};

/// The top-level tables of all files, by kind.
struct AuthoredTables {
    std::optional<AuthoredTable> database;
    std::vector<AuthoredTable> colours, suns, moving_objects, slots, clusters, cluster_planes, group_planes,
        lists, objects, meshes, sequences, churns, mounds, patchworks, wake_fields, tiles, details;
};

AuthoredTables gather_tables(const Sources& sources, Diagnostics& diagnostics);

/// A reader of the table that names it in messages as `[[kind]] "name"`.
TableReader reader_of(AuthoredTable authored, const Sources& sources, const char* kind,
                      Diagnostics& diagnostics);

Place place_of(const toml::node& node, std::uint16_t file);

} // namespace linkdig::database
