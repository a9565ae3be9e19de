#include "host/panel/mapping_reader.h"

#include "host/panel/mapping_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace linkdig::panel {

using host::Signal;
using host::SignalDefinition;
using host::SignalKind;

namespace {

bool is_port(const std::string& text) {
    // bus-port, and behind hubs a port of each: 3-1.4
    std::size_t numbers = 0;
    bool digits = false;
    for (const char letter : text) {
        if (letter >= '0' && letter <= '9') {
            numbers += digits ? 0 : 1;
            digits = true;
        } else if (digits && letter == (numbers == 1 ? '-' : '.')) {
            digits = false;
        } else {
            return false;
        }
    }
    return digits && numbers >= 2;
}

} // namespace

MappingReader::MappingReader(const database::Document& document, database::Diagnostics& diagnostics)
    : root_(document.root, document.path, "the mapping", diagnostics) {
    mapping_.path = document.path;
}

Mapping MappingReader::read() {
    if (!read_head()) return mapping_; // without its kind no name in it can be looked up
    each_table("switch", [this](TableReader& table) { read_switch(table); });
    each_table("selector", [this](TableReader& table) { read_selector(table); });
    each_table("button", [this](TableReader& table) { read_button(table); });
    each_table("encoder", [this](TableReader& table) { read_encoder(table); });
    each_table("lamp", [this](TableReader& table) { read_lamp(table); });
    each_table("display", [this](TableReader& table) { read_display(table); });
    root_.finish();
    return std::move(mapping_);
}

bool MappingReader::read_head() {
    const toml::table* table = root_.table("panel");
    if (table == nullptr) {
        if (!root_.has("panel")) root_.error_at("panel", "the table [panel] is missing; expected its kind");
        return false;
    }
    TableReader reader(*table, root_.file(), "[panel]", root_.diagnostics());
    const std::string name = reader.text("kind");
    const auto kind = find_panel(name);
    if (!kind && !name.empty()) reader.error_at("kind", unknown("panel", name, panel_names()));
    mapping_.port = reader.text("port", "");
    if (!mapping_.port.empty() && !is_port(mapping_.port))
        reader.error_at("port", fmt::format("port \"{}\"; expected bus and port as \"linkdig panel list\" "
                                            "shows them, such as \"1-4\" or \"3-1.4\"",
                                            mapping_.port));
    reader.finish();
    mapping_.kind = kind.value_or(PanelKind::switches);
    return kind.has_value();
}

void MappingReader::each_table(const char* key, const std::function<void(TableReader&)>& read_one) {
    for (const toml::table* table : root_.tables(key)) {
        TableReader reader(*table, root_.file(), fmt::format("[[{}]]", key), root_.diagnostics());
        read_one(reader);
        reader.finish();
    }
}

std::optional<std::uint8_t> MappingReader::control(TableReader& table,
                                                   std::initializer_list<ControlKind> kinds) {
    const std::string name = table.text("input");
    if (name.empty()) return std::nullopt;
    const auto found = find_control(layout(), name);
    if (!found) {
        table.error_at("input", unknown(fmt::format("the {} panel's input", layout().name), name,
                                        names_of(layout().controls)));
        return std::nullopt;
    }
    const ControlKind kind = layout().controls[*found].kind;
    if (std::ranges::find(kinds, kind) != kinds.end()) return static_cast<std::uint8_t>(*found);
    table.error_at("input", fmt::format("\"{}\" is {}; expected {} in {}", name, word_of(kind),
                                        word_of(*kinds.begin()), table.what()));
    return std::nullopt;
}

std::optional<Signal> MappingReader::signal(TableReader& table, bool state) {
    const std::string name = table.text("signal");
    if (name.empty()) return std::nullopt;
    const auto found = host::find_signal(name);
    if (!found) {
        table.error_at("signal", unknown("signal", name, host::signal_names()));
        return std::nullopt;
    }
    if (state && host::definition(*found).kind == SignalKind::pulse) {
        table.error_at("signal", fmt::format("\"{}\" is done once; expected it in [[button]]", name));
        return std::nullopt;
    }
    return found;
}

std::optional<double> MappingReader::value(TableReader& table, const std::string& key, Signal signal) {
    const SignalUnit unit = unit_of(signal);
    const SignalDefinition& defined = host::definition(signal);
    if (table.node(key) == nullptr) return std::nullopt;
    const double written =
        table.number(key, 0.0, {defined.minimum / unit.in_si, defined.maximum / unit.in_si});
    if (defined.kind != SignalKind::level && written != std::round(written))
        table.error_at(
            key, fmt::format("\"{}\" is {}; signal \"{}\" takes whole numbers", key, written, defined.name));
    return written * unit.in_si;
}

std::optional<double> MappingReader::step(TableReader& table, Signal signal) {
    const SignalUnit unit = unit_of(signal);
    const SignalDefinition& defined = host::definition(signal);
    const std::string key = "step" + std::string(unit.ending);
    if (table.node(key) == nullptr) return std::nullopt;
    const double most = (defined.maximum - defined.minimum) / unit.in_si;
    const double written = table.number(key, 0.0, {-most, most});
    if (written == 0.0) table.error_at(key, fmt::format("\"{}\" is 0; expected a step", key));
    if (defined.kind == SignalKind::selector && written != std::round(written))
        table.error_at(
            key, fmt::format("\"{}\" is {}; signal \"{}\" takes whole steps", key, written, defined.name));
    return written * unit.in_si;
}

std::optional<Stand> MappingReader::when(TableReader& table) {
    const std::string text = table.text("when", "");
    if (text.empty()) return std::nullopt;
    const std::size_t dot = text.find('.');
    const auto control = find_control(layout(), text.substr(0, dot));
    if (dot == std::string::npos || !control || layout().controls[*control].kind != ControlKind::selector) {
        table.error_at("when", fmt::format("\"when\" is \"{}\"; expected {}", text, stands()));
        return std::nullopt;
    }
    const auto position = this->position(table, "when", *control, text.substr(dot + 1));
    if (!position) return std::nullopt;
    return Stand{static_cast<std::uint8_t>(*control), *position};
}

std::string MappingReader::stands() const {
    std::vector<std::string> known;
    for (const Control& each : layout().controls)
        if (each.kind == ControlKind::selector)
            known.push_back(fmt::format("\"{}.{}\"", each.name, each.positions.front()));
    return fmt::format("a selector and its position, such as {}", fmt::join(known, " or "));
}

std::optional<std::uint8_t> MappingReader::position(TableReader& table, const char* key, std::size_t control,
                                                    const std::string& name) {
    const Control& selector = layout().controls[control];
    if (const auto found = find_position(selector, name)) return static_cast<std::uint8_t>(*found);
    table.error_at(key, unknown(fmt::format("\"{}\" has no position; position", selector.name), name,
                                {selector.positions.begin(), selector.positions.end()}));
    return std::nullopt;
}

void MappingReader::once(TableReader& table, const char* key, const std::string& what) {
    const database::SourceLocation at = table.at(key);
    const auto [earlier, first] = seen_.emplace(what, at.line);
    if (!first) table.error_at(key, fmt::format("{} already in line {}", what, earlier->second));
}

std::string MappingReader::stand_text(const std::optional<Stand>& stand) const {
    if (!stand) return "";
    const Control& selector = layout().controls[stand->control];
    return fmt::format(" when {}.{}", selector.name, selector.positions[stand->position]);
}

void MappingReader::pass_over(TableReader& table, std::initializer_list<const char*> stems) {
    for (const char* stem : stems)
        for (const char* ending : unit_endings)
            table.node(stem + std::string(ending));
}

} // namespace linkdig::panel
