/// MappingReader's tables, one by one.

#include "host/panel/mapping_reader.h"
#include "host/panel/mapping_words.h"

#include <fmt/format.h>

namespace linkdig::panel {

using host::SignalDefinition;
using host::SignalKind;

void MappingReader::read_switch(TableReader& table) {
    const auto input = control(table, {ControlKind::toggle});
    const auto written = signal(table, true);
    if (!written) return pass_over(table, {"on", "off"});
    const SignalDefinition& defined = host::definition(*written);
    SwitchBinding binding{.signal = *written};
    const auto on = value(table, "on" + std::string(unit_of(*written).ending), *written);
    const auto off = value(table, "off" + std::string(unit_of(*written).ending), *written);
    if (!on && defined.kind != SignalKind::toggle)
        table.error_at("signal",
                       fmt::format("\"{}\" is no switch; expected \"on{}\" and \"off{}\"", defined.name,
                                   unit_of(*written).ending, unit_of(*written).ending));
    binding.on = on.value_or(1.0);
    binding.off = off.value_or(defined.kind == SignalKind::toggle ? 0.0 : defined.initial);
    if (!input) return;
    binding.control = *input;
    once(table, "input", fmt::format("\"{}\" writes \"{}\"", layout().controls[*input].name, defined.name));
    mapping_.switches.push_back(binding);
}

void MappingReader::read_selector(TableReader& table) {
    const auto input = control(table, {ControlKind::selector});
    const auto written = signal(table, true);
    const std::string key = "values" + std::string(written ? unit_of(*written).ending : std::string_view());
    const toml::table* values = table.table(key);
    if (!input || !written) return pass_over(table, {"values"});
    if (values == nullptr) {
        table.error_at("input", fmt::format("\"{}\" is missing; expected a table such as {{ {} = {} }}", key,
                                            layout().controls[*input].positions.front(),
                                            host::definition(*written).initial));
        return;
    }
    const Control& selector = layout().controls[*input];
    SelectorBinding binding{*input, *written, {}};
    binding.values.resize(selector.positions.size());
    TableReader reader(*values, table.file(), key, table.diagnostics());
    for (std::size_t i = 0; i < selector.positions.size(); ++i)
        binding.values[i] = value(reader, selector.positions[i], *written);
    reader.finish();
    once(table, "input", fmt::format("\"{}\" writes \"{}\"", selector.name, host::definition(*written).name));
    mapping_.selectors.push_back(std::move(binding));
}

void MappingReader::read_button(TableReader& table) {
    const auto input = control(table, {ControlKind::toggle, ControlKind::selector});
    ButtonBinding binding;
    binding.when = when(table);
    const std::string at = table.text("at", "");
    const bool selects = input && layout().controls[*input].kind == ControlKind::selector;
    if (selects && at.empty())
        table.error_at("input", fmt::format("\"{}\" is a selector; expected \"at\" with one of its positions",
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
                     at.empty() ? "" : "." + at, host::definition(*written).name, stand_text(binding.when)));
    mapping_.buttons.push_back(binding);
}

Step MappingReader::read_step(TableReader& table, Signal written) {
    const SignalDefinition& defined = host::definition(written);
    const SignalUnit unit = unit_of(written);
    Step read{.signal = written, .to = {}, .by = {}};
    const bool steps = defined.kind == SignalKind::level || defined.kind == SignalKind::selector;
    if (defined.kind != SignalKind::pulse) read.to = value(table, "to" + std::string(unit.ending), written);
    if (!steps) return read;
    read.by = step(table, written);
    read.wraps = table.boolean("wrap", false);
    if (read.to.has_value() == read.by.has_value())
        table.error_at("signal", fmt::format("\"{}\" is no switch; expected \"to{}\" or \"step{}\"",
                                             defined.name, unit.ending, unit.ending));
    return read;
}

void MappingReader::read_encoder(TableReader& table) {
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

std::optional<Shown> MappingReader::shows(TableReader& table) {
    const std::string name = table.text("shows");
    if (name.empty()) return std::nullopt;
    if (const auto indication = host::find_indication(name)) return *indication;
    if (const auto signal = host::find_signal(name)) return *signal;
    table.error_at("shows", unknown("indication or signal", name, shown_names()));
    return std::nullopt;
}

template <typename All>
MappingReader::Place MappingReader::shown_on(TableReader& table, const std::string& key, const All& all,
                                             FindPlace find) const {
    const std::string name = table.text(key);
    const auto found = find(layout(), name);
    if (!found && all.empty())
        table.error_at(key, fmt::format("the {} panel has no {}s", layout().name, key));
    else if (!found && !name.empty())
        table.error_at(key,
                       unknown(fmt::format("the {} panel's {}", layout().name, key), name, names_of(all)));
    return {found, name};
}

void MappingReader::read_lamp(TableReader& table) {
    const auto [lamp, name] = shown_on(table, "lamp", layout().lamps, find_lamp);
    LampBinding binding;
    binding.when = when(table);
    const auto shown = shows(table);
    if (!shown) return pass_over(table, {"at_least", "below"});
    const SignalUnit unit = unit_of(*shown);
    constexpr database::Range any{};
    binding.at_least = table.number("at_least" + std::string(unit.ending), 0.5, any) * unit.in_si;
    binding.below = table.number("below" + std::string(unit.ending), binding.below, any) * unit.in_si;
    if (binding.below <= binding.at_least)
        table.error_at("below" + std::string(unit.ending), "the lamp is never lit; expected \"below\" above "
                                                           "\"at_least\"");
    if (!lamp) return;
    binding.lamp = static_cast<std::uint8_t>(*lamp);
    binding.shows = *shown;
    once(table, "lamp", fmt::format("lamp \"{}\" shows something{}", name, stand_text(binding.when)));
    mapping_.lamps.push_back(binding);
}

void MappingReader::read_display(TableReader& table) {
    const auto [display, name] = shown_on(table, "display", layout().displays, find_display);
    DisplayBinding binding;
    binding.when = when(table);
    const auto shown = shows(table);
    binding.decimals = static_cast<std::uint32_t>(table.integer("decimals", 0, 0, 4));
    if (display && binding.decimals != 0 && !layout().displays[*display].with_dot)
        table.error_at("decimals", fmt::format("display \"{}\" has no dots; expected 0", name));
    if (!display || !shown) return;
    binding.display = static_cast<std::uint8_t>(*display);
    binding.shows = *shown;
    once(table, "display", fmt::format("display \"{}\" shows something{}", name, stand_text(binding.when)));
    mapping_.displays.push_back(binding);
}

} // namespace linkdig::panel
