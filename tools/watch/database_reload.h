#pragma once
/// A database that is opened again when its files change: for a flight in a window, while its author works on it.

#include "tools/flight/open_database.h"
#include "tools/watch/file_watch.h"

#include <future>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::tools {

class DatabaseReload {
public:
    /// Watches `files`: what the database at `path` was made from.
    DatabaseReload(std::string path, const std::vector<std::string>& files);

    /// What opening it again has led to: a database, or why it was refused.
    struct Outcome {
        std::optional<OpenedDatabase> database;
        std::string refused; ///< all mistakes, a line each
    };
    /// Looks at the files and, when one of them has changed, begins to open the database on a thread of its own, so that no
    /// frame waits for it. Returns the outcome once, when it is there.
    std::optional<Outcome> poll();

private:
    std::string path_;
    FileWatch watch_;
    std::future<Outcome> opening_;
    std::vector<std::string> files_; ///< of the database that is being opened; its thread writes them
};

} // namespace linkdig::tools
