#pragma once
/// The mappings that ship with the program, and those that somebody names on the command line.

#include "host/panel/mapping.h"

#include <string>
#include <vector>

namespace linkdig::tools {

/// The folder of the shipped mappings. Looked for, in this order: the environment variable LINKDIG_PANELS, the source tree this
/// program was built from, ../share/linkdig/panels beside the folder of the program. Throws std::runtime_error, naming the
/// places, if there is none.
std::string shipped_mappings();

/// The named mapping files, and the shipped mapping of every kind of panel that none of them is for. Throws BadInput with the
/// mistakes of all files.
std::vector<panel::Mapping> mappings_of(const std::vector<std::string>& paths);

} // namespace linkdig::tools
