#include "host/panel/mapping.h"

#include "host/panel/mapping_reader.h"

#include <utility>

namespace linkdig::panel {

MappingResult load_mapping(const std::string& path) {
    MappingResult result;
    const auto document = database::parse_file(path, result.diagnostics);
    if (!document) return result;
    Mapping mapping = MappingReader(*document, result.diagnostics).read();
    if (!result.diagnostics.any()) result.mapping = std::move(mapping);
    return result;
}

const Mapping* mapping_for(const std::vector<Mapping>& mappings, PanelKind kind, const std::string& port) {
    const Mapping* any = nullptr;
    for (const Mapping& each : mappings) {
        if (each.kind != kind) continue;
        if (each.port == port) return &each;
        if (each.port.empty() && any == nullptr) any = &each;
    }
    return any;
}

} // namespace linkdig::panel
