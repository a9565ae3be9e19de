#include "host/panel/mapping_words.h"

#include "database/text/diagnostic.h"
#include "host/signals/indications.h"
#include "host/signals/signals.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace linkdig::panel {

std::vector<std::string> panel_names() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < panel_kinds; ++i)
        names.emplace_back(layout_of(static_cast<PanelKind>(i)).name);
    return names;
}

std::vector<std::string> shown_names() {
    std::vector<std::string> names = host::indication_names();
    for (std::string& signal : host::signal_names())
        names.push_back(std::move(signal));
    return names;
}

std::string unknown(std::string_view what, std::string_view name, const std::vector<std::string>& known) {
    const std::string closest = database::suggestion(name, known);
    if (!closest.empty()) return fmt::format("{} \"{}\" is unknown; did you mean {}?", what, name, closest);
    return fmt::format("{} \"{}\" is unknown; expected one of: {}", what, name, fmt::join(known, ", "));
}

const char* word_of(ControlKind kind) {
    switch (kind) {
    case ControlKind::toggle:
        return "a switch or button";
    case ControlKind::selector:
        return "a selector";
    case ControlKind::encoder:
        return "an encoder";
    }
    return "";
}

} // namespace linkdig::panel
