#include "database/compiler/sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <system_error>
#include <utility>

namespace linkdig::database {

namespace {

namespace fs = std::filesystem;

/// What identifies a file however its path is written.
fs::path identity(const fs::path& path) {
    std::error_code failed;
    fs::path canonical = fs::weakly_canonical(path, failed);
    return failed ? path.lexically_normal() : canonical;
}

class Including {
public:
    Including(const std::string& root, Diagnostics& diagnostics)
        : folder_(fs::path(root).parent_path()), diagnostics_(&diagnostics) {}

    /// Reads the file and, before it, what it includes. `at`: the include, or nothing for the root file.
    void add(const fs::path& path, const std::optional<SourceLocation>& at) {
        const fs::path id = identity(path);
        if (std::find(open_.begin(), open_.end(), id) != open_.end()) {
            diagnostics_->error(*at, fmt::format("\"{}\" includes itself, directly or through another file; "
                                                 "expected no cycle",
                                                 name_of(path)));
            return;
        }
        if (!done_.insert(id).second) return;
        sources.tried.push_back(path.generic_string());
        std::optional<Document> document = parse(path, at);
        if (!document) return;
        open_.push_back(id);
        add_includes(*document, path);
        open_.pop_back();
        sources.files.push_back({document->path, name_of(path), std::move(document->root)});
    }

    Sources sources;

private:
    std::string name_of(const fs::path& path) const {
        return path.lexically_proximate(folder_.empty() ? fs::path(".") : folder_).generic_string();
    }

    /// Faults of the file as a whole are the including line's: there the author has to look.
    std::optional<Document> parse(const fs::path& path, const std::optional<SourceLocation>& at) {
        Diagnostics found;
        std::optional<Document> document = parse_file(path.generic_string(), found);
        for (const Diagnostic& each : found.all()) {
            if (at && each.at.line == 0)
                diagnostics_->error(*at,
                                    fmt::format("cannot include \"{}\": {}", each.at.file, each.message));
            else
                diagnostics_->error(each.at, each.message);
        }
        return document;
    }

    void add_includes(const Document& document, const fs::path& path) {
        const toml::node* include = document.root.get("include");
        const toml::array* array = include == nullptr ? nullptr : include->as_array();
        if (array == nullptr) return; // another type is reported by gather_tables
        for (const toml::node& each : *array) {
            const auto text = each.value_exact<std::string>();
            if (!text) continue;
            const SourceLocation at = location_of(each, document.path);
            if (text->empty() || fs::path(*text).is_absolute())
                diagnostics_->error(
                    at, fmt::format("cannot include \"{}\"; expected a path relative to this file", *text));
            else if (sources.files.size() + open_.size() > std::numeric_limits<std::uint16_t>::max() - 1U)
                diagnostics_->error(at, "more than 65534 files; expected fewer");
            else
                add((path.parent_path() / *text).lexically_normal(), at);
        }
    }

    fs::path folder_;
    Diagnostics* diagnostics_;
    std::vector<fs::path> open_;
    std::set<fs::path> done_;
};

void gather_file(const Sources& sources, std::uint16_t file, AuthoredTables& tables,
                 Diagnostics& diagnostics) {
    const Source& source = sources.files[file];
    TableReader reader(source.root, source.path, "the file", diagnostics);
    reader.texts("include");
    if (const toml::table* table = reader.table("database")) {
        if (file + 1U == sources.files.size())
            tables.database = AuthoredTable{table, file};
        else
            reader.error_at("database",
                            "[database] stands in an included file; expected only in the root file");
    }
    const auto gather = [&](const char* kind, std::vector<AuthoredTable>& into) {
        for (const toml::table* table : reader.tables(kind))
            into.push_back({table, file});
    };
    gather("colour", tables.colours);
    gather("sun", tables.suns);
    gather("moving_object", tables.moving_objects);
    gather("slot", tables.slots);
    gather("cluster", tables.clusters);
    gather("cluster_plane", tables.cluster_planes);
    gather("group_plane", tables.group_planes);
    gather("object_list", tables.lists);
    gather("object", tables.objects);
    gather("mesh", tables.meshes);
    gather("sequence", tables.sequences);
    gather("churn", tables.churns);
    gather("mounds", tables.mounds);
    gather("patchwork", tables.patchworks);
    gather("wake_field", tables.wake_fields);
    gather("tile", tables.tiles);
    gather("detail", tables.details);
    reader.finish();
}

} // namespace

Sources read_sources(const std::string& path, Diagnostics& diagnostics) {
    Including including(path, diagnostics);
    including.add(fs::path(path), std::nullopt);
    return std::move(including.sources);
}

AuthoredTables gather_tables(const Sources& sources, Diagnostics& diagnostics) {
    AuthoredTables tables;
    for (std::size_t file = 0; file < sources.files.size(); ++file)
        gather_file(sources, static_cast<std::uint16_t>(file), tables, diagnostics);
    if (!tables.database && !sources.files.empty())
        diagnostics.error({sources.files.back().path, 0, 0},
                          "lacks a [database] table; expected one with a `name`");
    return tables;
}

TableReader reader_of(AuthoredTable authored, const Sources& sources, const char* kind,
                      Diagnostics& diagnostics) {
    std::string what = fmt::format("[[{}]]", kind);
    if (const auto name = (*authored.table)["name"].value_exact<std::string>())
        what += fmt::format(" \"{}\"", *name);
    return {*authored.table, sources.files[authored.file].path, std::move(what), diagnostics};
}

Place place_of(const toml::node& node, std::uint16_t file) {
    const toml::source_position at = node.source().begin;
    return {file, at.line, at.column};
}

} // namespace linkdig::database
