#include "tools/check/exceptions.h"

#include "database/text/table_reader.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <filesystem>

namespace linkdig::tools {
namespace {

/// Marks the lists that the names mean. A cluster's name means all its lists.
std::vector<bool> lists_named(database::TableReader& reader, const char* key,
                              const std::vector<std::string>& names, const VisualDatabase& database) {
    std::vector<bool> marked(database.lists.size(), false);
    std::vector<std::string> known;
    for (const ObjectList& list : database.lists)
        known.push_back(list.name);
    for (const Cluster& cluster : database.clusters)
        known.push_back(cluster.name);
    if (names.empty())
        reader.error_at(key, fmt::format("\"{}\" is missing; expected an array of names", key));
    for (const std::string& name : names) {
        bool found = false;
        for (std::size_t i = 0; i < database.lists.size(); ++i) {
            const ObjectList& list = database.lists[i];
            if (list.name != name && database.clusters[list.cluster].name != name) continue;
            marked[i] = true;
            found = true;
        }
        if (found) continue;
        const std::string closest = database::suggestion(name, known);
        reader.error_at(key, fmt::format("no object list or cluster is named \"{}\"; {}", name,
                                         closest.empty() ? "expected one of the database"
                                                         : fmt::format("did you mean {}?", closest)));
    }
    return marked;
}

} // namespace

std::vector<DesignException> read_exceptions(const std::string& path, const VisualDatabase& database) {
    database::Diagnostics diagnostics;
    std::vector<DesignException> exceptions;
    if (const auto document = database::parse_file(path, diagnostics)) {
        database::TableReader root(document->root, path, "the manifest", diagnostics);
        for (const toml::table* table : root.tables("exception")) {
            database::TableReader reader(*table, path, "[[exception]]", diagnostics);
            DesignException made;
            made.front_names = reader.texts("front");
            made.behind_names = reader.texts("behind");
            made.reason = reader.text("reason");
            made.by_at_most_m = reader.length_m("by_at_most", made.by_at_most_m, {.least = 0.0});
            made.front = lists_named(reader, "front", made.front_names, database);
            made.behind = lists_named(reader, "behind", made.behind_names, database);
            reader.finish();
            exceptions.push_back(std::move(made));
        }
        root.finish();
    }
    if (diagnostics.any()) throw BadInput(diagnostics.text());
    return exceptions;
}

std::string manifest_beside(const std::string& database_path) {
    const std::filesystem::path manifest = std::filesystem::path(database_path).parent_path() / "check.toml";
    return std::filesystem::exists(manifest) ? manifest.string() : std::string();
}

std::int32_t exception_for(const std::vector<DesignException>& exceptions, std::uint32_t front,
                           std::uint32_t behind, double nearer_by_m) {
    for (std::size_t i = 0; i < exceptions.size(); ++i)
        if (exceptions[i].front[front] && exceptions[i].behind[behind] &&
            nearer_by_m <= exceptions[i].by_at_most_m)
            return static_cast<std::int32_t>(i);
    return none;
}

} // namespace linkdig::tools
