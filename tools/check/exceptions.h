#pragma once
/// What shows in front of something nearer by design: `check.toml` beside a database says which and why.

#include "database/model/visual_database.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace linkdig::tools {

/// A face of one of the lists `front` may be seen though one of the lists `behind` is nearer, by at most so much.
struct DesignException {
    std::vector<std::string> front_names; ///< as written: object lists or clusters
    std::vector<std::string> behind_names;
    std::string reason;
    double by_at_most_m = std::numeric_limits<double>::infinity();
    std::vector<bool> front; ///< parallel to VisualDatabase::lists
    std::vector<bool> behind;
};

/// Reads the manifest. Throws BadInput with every mistake; an unknown list or cluster is one.
std::vector<DesignException> read_exceptions(const std::string& path, const VisualDatabase& database);

/// The manifest beside a database, or nothing if none stands there.
std::string manifest_beside(const std::string& database_path);

/// The exception by which `front` may be seen though `behind` is `nearer_by_m` nearer, or none.
std::int32_t exception_for(const std::vector<DesignException>& exceptions, std::uint32_t front,
                           std::uint32_t behind, double nearer_by_m);

} // namespace linkdig::tools
