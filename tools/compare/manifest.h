#pragma once
/// Cases from a text file.
///
///   [[case]]
///   name = "approach"
///   tolerance = ["<=1:*", "<=5:100"]
///   ignore = [[0, 0, 64, 16]]

#include "tools/compare/compare.h"

#include <optional>
#include <string>
#include <vector>

namespace linkdig::compare {

/// Where the two sides' paths begin.
struct Roots {
    std::string expected;
    std::string actual;
};

/// Without roots, paths are relative to the manifest. Throws tools::BadInput with all mistakes of the file, each
/// at its line and column.
std::vector<Case> read_manifest(const std::string& path, const std::optional<Roots>& roots);

} // namespace linkdig::compare
