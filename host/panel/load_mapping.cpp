#include "host/panel/mapping.h"

#include "database/model/mathematics.h"
#include "database/text/table_reader.h"
#include "host/panel/signal_unit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace linkdig::panel {

namespace {

using database::TableReader;
using host::Signal;
using host::SignalDefinition;
using host::SignalKind;

template <typename All>
std::vector<std::string> names_of(const All& all) {
    std::vector<std::string> names;
    for (const auto& each : all)
        names.emplace_back(each.name);
    return names;
}

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

/// Reads the tables of one file.
class MappingReader {
public:
    MappingReader(const database::Document& document, database::Diagnostics& diagnostics)
        : root_(document.root, document.path, "the mapping", diagnostics) {
        mapping_.path = document.path;
    }

    Mapping read() {
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

private:
    const PanelLayout& layout() const { return layout_of(mapping_.kind); }

    bool read_head() {
        const toml::table* table = root_.table("panel");
        if (table == nullptr) {
            if (!root_.has("panel"))
                root_.error_at("panel", "the table [panel] is missing; expected its kind");
            return false;
        }
        TableReader reader(*table, root_.file(), "[panel]", root_.diagnostics());
        const std::string name = reader.text("kind");
        const auto kind = find_panel(name);
        if (!kind && !name.empty()) reader.error_at("kind", unknown("panel", name, panel_names()));
        mapping_.port = reader.text("port", "");
        if (!mapping_.port.empty() && !is_port(mapping_.port))
            reader.error_at("port",
                            fmt::format("port \"{}\"; expected bus and port as \"linkdig panel list\" "
                                        "shows them, such as \"1-4\" or \"3-1.4\"",
                                        mapping_.port));
        reader.finish();
        mapping_.kind = kind.value_or(PanelKind::switches);
        return kind.has_value();
    }

    void each_table(const char* key, const std::function<void(TableReader&)>& read_one) {
        for (const toml::table* table : root_.tables(key)) {
            TableReader reader(*table, root_.file(), fmt::format("[[{}]]", key), root_.diagnostics());
            read_one(reader);
            reader.finish();
        }
    }

    /// The named control, if it is there and of this kind.
    std::optional<std::uint8_t> control(TableReader& table, std::initializer_list<ControlKind> kinds) {
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

    /// `state`: the signal is to take a state that stays, which a pulse has none of.
    std::optional<Signal> signal(TableReader& table, bool state) {
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

    /// A value of the signal under `stem` with the signal's unit in the key.
    std::optional<double> value(TableReader& table, const char* stem, Signal signal) {
        const SignalUnit unit = unit_of(signal);
        const SignalDefinition& defined = host::definition(signal);
        const std::string key = stem + std::string(unit.ending);
        if (table.node(key) == nullptr) return std::nullopt;
        const double written =
            table.number(key, 0.0, {defined.minimum / unit.in_si, defined.maximum / unit.in_si});
        if (defined.kind != SignalKind::level && written != std::round(written))
            table.error_at(key, fmt::format("\"{}\" is {}; signal \"{}\" takes whole numbers", key, written,
                                            defined.name));
        return written * unit.in_si;
    }

    std::optional<double> step(TableReader& table, Signal signal) {
        const SignalUnit unit = unit_of(signal);
        const SignalDefinition& defined = host::definition(signal);
        const std::string key = "step" + std::string(unit.ending);
        if (table.node(key) == nullptr) return std::nullopt;
        const double most = (defined.maximum - defined.minimum) / unit.in_si;
        const double written = table.number(key, 0.0, {-most, most});
        if (written == 0.0) table.error_at(key, fmt::format("\"{}\" is 0; expected a step", key));
        if (defined.kind == SignalKind::selector && written != std::round(written))
            table.error_at(key, fmt::format("\"{}\" is {}; signal \"{}\" takes whole steps", key, written,
                                            defined.name));
        return written * unit.in_si;
    }

    /// "selector.alt": a selector of this panel and one of its positions.
    std::optional<Stand> when(TableReader& table) {
        const std::string text = table.text("when", "");
        if (text.empty()) return std::nullopt;
        const std::size_t dot = text.find('.');
        const auto control = find_control(layout(), text.substr(0, dot));
        if (dot == std::string::npos || !control ||
            layout().controls[*control].kind != ControlKind::selector) {
            table.error_at("when", fmt::format("\"when\" is \"{}\"; expected {}", text, stands()));
            return std::nullopt;
        }
        const auto position = this->position(table, "when", *control, text.substr(dot + 1));
        if (!position) return std::nullopt;
        return Stand{static_cast<std::uint8_t>(*control), *position};
    }

    std::string stands() const {
        std::vector<std::string> known;
        for (const Control& each : layout().controls)
            if (each.kind == ControlKind::selector)
                known.push_back(fmt::format("\"{}.{}\"", each.name, each.positions.front()));
        return fmt::format("a selector and its position, such as {}", fmt::join(known, " or "));
    }

    std::optional<std::uint8_t> position(TableReader& table, const char* key, std::size_t control,
                                         const std::string& name) {
        const Control& selector = layout().controls[control];
        if (const auto found = find_position(selector, name)) return static_cast<std::uint8_t>(*found);
        table.error_at(key, unknown(fmt::format("\"{}\" has no position; position", selector.name), name,
                                    {selector.positions.begin(), selector.positions.end()}));
        return std::nullopt;
    }

    /// Is this the first of its kind in the file? If not, says where that is.
    void once(TableReader& table, const char* key, const std::string& what) {
        const database::SourceLocation at = table.at(key);
        const auto [earlier, first] = seen_.emplace(what, at.line);
        if (!first) table.error_at(key, fmt::format("{} already in line {}", what, earlier->second));
    }

    std::string stand_text(const std::optional<Stand>& stand) const {
        if (!stand) return "";
        const Control& selector = layout().controls[stand->control];
        return fmt::format(" when {}.{}", selector.name, selector.positions[stand->position]);
    }

    void read_switch(TableReader& table) {
        const auto input = control(table, {ControlKind::toggle});
        const auto written = signal(table, true);
        if (!written) return pass_over(table, {"on", "off"});
        const SignalDefinition& defined = host::definition(*written);
        SwitchBinding binding{.signal = *written};
        const auto on = value(table, "on", *written);
        const auto off = value(table, "off", *written);
        if (!on && defined.kind != SignalKind::toggle)
            table.error_at("signal",
                           fmt::format("\"{}\" is no switch; expected \"on{}\" and \"off{}\"", defined.name,
                                       unit_of(*written).ending, unit_of(*written).ending));
        binding.on = on.value_or(1.0);
        binding.off = off.value_or(defined.kind == SignalKind::toggle ? 0.0 : defined.initial);
        if (!input) return;
        binding.control = *input;
        once(table, "input",
             fmt::format("\"{}\" writes \"{}\"", layout().controls[*input].name, defined.name));
        mapping_.switches.push_back(binding);
    }

    void read_selector(TableReader& table) {
        const auto input = control(table, {ControlKind::selector});
        const auto written = signal(table, true);
        const std::string key =
            "values" + std::string(written ? unit_of(*written).ending : std::string_view());
        const toml::table* values = table.table(key);
        if (!input || !written) return pass_over(table, {"values"});
        if (values == nullptr) {
            table.error_at("input", fmt::format("\"{}\" is missing; expected a table such as {{ {} = {} }}",
                                                key, layout().controls[*input].positions.front(),
                                                host::definition(*written).initial));
            return;
        }
        const Control& selector = layout().controls[*input];
        SelectorBinding binding{*input, *written, {}};
        binding.values.resize(selector.positions.size());
        TableReader reader(*values, table.file(), key, table.diagnostics());
        const SignalUnit unit = unit_of(*written);
        for (std::size_t i = 0; i < selector.positions.size(); ++i)
            binding.values[i] = position_value(reader, selector.positions[i], *written, unit);
        reader.finish();
        once(table, "input",
             fmt::format("\"{}\" writes \"{}\"", selector.name, host::definition(*written).name));
        mapping_.selectors.push_back(std::move(binding));
    }

    static std::optional<double> position_value(TableReader& reader, const char* position, Signal signal,
                                                const SignalUnit& unit) {
        const SignalDefinition& defined = host::definition(signal);
        if (reader.node(position) == nullptr) return std::nullopt;
        const double written =
            reader.number(position, 0.0, {defined.minimum / unit.in_si, defined.maximum / unit.in_si});
        if (defined.kind != SignalKind::level && written != std::round(written))
            reader.error_at(position, fmt::format("\"{}\" is {}; signal \"{}\" takes whole numbers", position,
                                                  written, defined.name));
        return written * unit.in_si;
    }

    void read_button(TableReader& table) {
        const auto input = control(table, {ControlKind::toggle, ControlKind::selector});
        ButtonBinding binding;
        binding.when = when(table);
        const std::string at = table.text("at", "");
        const bool selects = input && layout().controls[*input].kind == ControlKind::selector;
        if (selects && at.empty())
            table.error_at("input",
                           fmt::format("\"{}\" is a selector; expected \"at\" with one of its positions",
                                       layout().controls[*input].name));
        if (input && !selects && !at.empty())
            table.error_at("at", "\"at\" is for selectors; a button has no positions");
        if (selects && !at.empty()) binding.at = position(table, "at", *input, at);
        const auto written = signal(table, false);
        if (!written) return pass_over(table, {"to", "step", "wrap"});
        binding.step = read_step(table, *written);
        if (!input) return;
        binding.control = *input;
        once(table, "input",
             fmt::format("\"{}{}\" does something to \"{}\"{}", layout().controls[*input].name,
                         at.empty() ? "" : "." + at, host::definition(*written).name,
                         stand_text(binding.when)));
        mapping_.buttons.push_back(binding);
    }

    Step read_step(TableReader& table, Signal written) {
        const SignalDefinition& defined = host::definition(written);
        const SignalUnit unit = unit_of(written);
        Step read{.signal = written, .to = {}, .by = {}};
        const bool steps = defined.kind == SignalKind::level || defined.kind == SignalKind::selector;
        if (defined.kind != SignalKind::pulse) read.to = value(table, "to", written);
        if (!steps) return read;
        read.by = step(table, written);
        read.wraps = table.boolean("wrap", false);
        if (read.to.has_value() == read.by.has_value())
            table.error_at("signal", fmt::format("\"{}\" is no switch; expected \"to{}\" or \"step{}\"",
                                                 defined.name, unit.ending, unit.ending));
        return read;
    }

    void read_encoder(TableReader& table) {
        const auto input = control(table, {ControlKind::encoder});
        EncoderBinding binding;
        binding.when = when(table);
        const auto written = signal(table, true);
        if (!written) return pass_over(table, {"step", "wrap"});
        const SignalDefinition& defined = host::definition(*written);
        binding.step.signal = *written;
        binding.step.by = step(table, *written);
        binding.step.wraps = table.boolean("wrap", false);
        if (!binding.step.by)
            table.error_at("signal", fmt::format("expected \"step{}\", what a notch adds to \"{}\"",
                                                 unit_of(*written).ending, defined.name));
        if (!input) return;
        binding.control = *input;
        once(table, "input",
             fmt::format("\"{}\" turns \"{}\"{}", layout().controls[*input].name, defined.name,
                         stand_text(binding.when)));
        mapping_.encoders.push_back(binding);
    }

    std::optional<Shown> shows(TableReader& table) {
        const std::string name = table.text("shows");
        if (name.empty()) return std::nullopt;
        if (const auto indication = host::find_indication(name)) return *indication;
        if (const auto signal = host::find_signal(name)) return *signal;
        table.error_at("shows", unknown("indication or signal", name, shown_names()));
        return std::nullopt;
    }

    void read_lamp(TableReader& table) {
        const std::string name = table.text("lamp");
        const auto lamp = find_lamp(layout(), name);
        if (!lamp && layout().lamps.empty())
            table.error_at("lamp", fmt::format("the {} panel has no lamps", layout().name));
        else if (!lamp && !name.empty())
            table.error_at("lamp", unknown(fmt::format("the {} panel's lamp", layout().name), name,
                                           names_of(layout().lamps)));
        LampBinding binding;
        binding.when = when(table);
        const auto shown = shows(table);
        if (!shown) return pass_over(table, {"at_least", "below"});
        const SignalUnit unit = unit_of(*shown);
        constexpr database::Range any{};
        binding.at_least = table.number("at_least" + std::string(unit.ending), 0.5, any) * unit.in_si;
        binding.below = table.number("below" + std::string(unit.ending), binding.below, any) * unit.in_si;
        if (binding.below <= binding.at_least)
            table.error_at("below" + std::string(unit.ending),
                           "the lamp is never lit; expected \"below\" above "
                           "\"at_least\"");
        if (!lamp) return;
        binding.lamp = static_cast<std::uint8_t>(*lamp);
        binding.shows = *shown;
        once(table, "lamp", fmt::format("lamp \"{}\" shows something{}", name, stand_text(binding.when)));
        mapping_.lamps.push_back(binding);
    }

    void read_display(TableReader& table) {
        const std::string name = table.text("display");
        const auto display = find_display(layout(), name);
        if (!display && layout().displays.empty())
            table.error_at("display", fmt::format("the {} panel has no displays", layout().name));
        else if (!display && !name.empty())
            table.error_at("display", unknown(fmt::format("the {} panel's display", layout().name), name,
                                              names_of(layout().displays)));
        DisplayBinding binding;
        binding.when = when(table);
        const auto shown = shows(table);
        binding.decimals = static_cast<std::uint32_t>(table.integer("decimals", 0, 0, 4));
        if (display && binding.decimals != 0 && !layout().displays[*display].with_dot)
            table.error_at("decimals", fmt::format("display \"{}\" has no dots; expected 0", name));
        if (!display || !shown) return;
        binding.display = static_cast<std::uint8_t>(*display);
        binding.shows = *shown;
        once(table, "display",
             fmt::format("display \"{}\" shows something{}", name, stand_text(binding.when)));
        mapping_.displays.push_back(binding);
    }

    /// Keys whose meaning hangs on a name that is wrong: one mistake, told once.
    static void pass_over(TableReader& table, std::initializer_list<const char*> stems) {
        for (const char* stem : stems)
            for (const char* ending : unit_endings)
                table.node(stem + std::string(ending));
    }

    TableReader root_;
    Mapping mapping_;
    std::map<std::string, std::uint32_t> seen_;
};

} // namespace

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
