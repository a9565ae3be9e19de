#pragma once
/// Where the databases and scenarios that ship with the program stand.

#include <string>

namespace linkdig::tools {

/// The folder of the shipped scenes. Looked for, in this order: the environment variable LINKDIG_SCENES, the
/// source tree this program was built from, ../share/linkdig/scenes beside the folder of the program. Throws
/// std::runtime_error, naming the places, if there is none.
std::string shipped_scenes();

} // namespace linkdig::tools
