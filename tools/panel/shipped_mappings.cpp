#include "tools/panel/shipped_mappings.h"

#include "tools/flight/bad_input.h"
#include "tools/flight/shipped_folder.h"

#include <algorithm>

namespace linkdig::tools {

std::string shipped_mappings() {
    return shipped_folder({.what = "the panels' mappings",
                           .variable = "LINKDIG_PANELS",
                           .source = LINKDIG_SOURCE_MAPPINGS,
                           .installed = "share/linkdig/panels"});
}

std::vector<panel::Mapping> mappings_of(const std::vector<std::string>& paths) {
    std::vector<panel::Mapping> mappings;
    std::string mistakes;
    const auto read = [&](const std::string& path) {
        panel::MappingResult result = panel::load_mapping(path);
        if (result.mapping)
            mappings.push_back(std::move(*result.mapping));
        else
            mistakes += result.diagnostics.text();
    };
    for (const std::string& path : paths)
        read(path);
    for (std::size_t i = 0; i < panel::panel_kinds; ++i) {
        const auto kind = static_cast<panel::PanelKind>(i);
        // One that is for a single port leaves the others of its kind to the shipped one.
        const auto for_all = [&](const panel::Mapping& each) {
            return each.kind == kind && each.port.empty();
        };
        if (std::ranges::none_of(mappings, for_all))
            read(shipped_mappings() + "/" + panel::layout_of(kind).name + ".toml");
    }
    if (!mistakes.empty()) throw BadInput(mistakes);
    return mappings;
}

} // namespace linkdig::tools
