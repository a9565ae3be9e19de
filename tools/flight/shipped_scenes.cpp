#include "tools/flight/shipped_scenes.h"

#include "tools/flight/shipped_folder.h"

namespace linkdig::tools {

std::string shipped_scenes() {
    return shipped_folder({.what = "the shipped scenes",
                           .variable = "LINKDIG_SCENES",
                           .source = LINKDIG_SOURCE_SCENES,
                           .installed = "share/linkdig/scenes"});
}

} // namespace linkdig::tools
