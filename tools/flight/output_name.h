#pragma once
/// Names of files to write: each ends as what is written does, so that no file is something else than its name says.

#include <initializer_list>
#include <string>
#include <string_view>

namespace linkdig::tools {

/// Throws std::invalid_argument, saying what was expected, unless `path` ends in one of `endings` (".png") and has a name
/// before it. `kind` is what is written there, as "a PNG picture". To be called before the work: whatever stands at `path` is
/// then untouched.
void require_ending(const std::string& path, std::string_view kind,
                    std::initializer_list<std::string_view> endings);

/// Recordings may have any name but those of what a flight is made from: throws std::invalid_argument for .toml and .igdb, and
/// for none at all.
void require_recording_name(const std::string& path);

/// One file by two names? A file that is not there is another.
bool same_file(const std::string& a, const std::string& b);

/// Throws std::invalid_argument if `output` is the file `input`, by whatever name, which is read while `output` is written.
void require_other_file(const std::string& output, const std::string& input);

} // namespace linkdig::tools
