#pragma once
/// What a panel's controls do and what its lamps and displays show: a mapping file as a value.
///
///   [panel] kind, port; [[switch]], [[selector]], [[button]], [[encoder]]: control to signal; [[lamp]], [[display]]: signal or
///   indication to the panel (docs/panel.md).

#include "database/text/diagnostic.h"
#include "host/panel/layout.h"
#include "host/signals/indications.h"
#include "host/signals/signals.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace linkdig::panel {

/// A selector at a position.
struct Stand {
    std::uint8_t control = 0;
    std::uint8_t position = 0;
    bool operator==(const Stand&) const = default;
};

/// A switch that stays: it writes one value when it is on and one when it is off.
struct SwitchBinding {
    std::uint8_t control = 0;
    host::Signal signal{};
    double on = 1.0;
    double off = 0.0;
};

/// A selector: it writes the value of its position, if that has one.
struct SelectorBinding {
    std::uint8_t control = 0;
    host::Signal signal{};
    std::vector<std::optional<double>> values; ///< by position
};

/// Something that is done once: to a signal, at a press or a notch.
struct Step {
    host::Signal signal{};
    std::optional<double>
        to; ///< this value; otherwise `by` is added, and without one a switch changes sides and a pulse is given
    std::optional<double> by;
    bool wraps = false; ///< beyond the greatest value comes the least
};

/// A button, or a selector's arrival at a position.
struct ButtonBinding {
    std::uint8_t control = 0;
    std::optional<std::uint8_t> at;
    std::optional<Stand> when; ///< counts only while this selector stands there
    Step step;
};

struct EncoderBinding {
    std::uint8_t control = 0;
    std::optional<Stand> when;
    Step step; ///< of a notch up; down it is the opposite
};

using Shown = std::variant<host::Signal, host::Indication>;

/// Lit while at_least <= value < below.
struct LampBinding {
    std::uint8_t lamp = 0;
    Shown shows;
    std::optional<Stand> when;
    double at_least = 0.5;
    double below = std::numeric_limits<double>::infinity();
};

struct DisplayBinding {
    std::uint8_t display = 0;
    Shown shows;
    std::optional<Stand> when;
    std::uint32_t decimals = 0;
};

struct Mapping {
    std::string path;
    PanelKind kind{};
    std::string port; ///< only the panel there; empty: any that no other mapping names
    std::vector<SwitchBinding> switches;
    std::vector<SelectorBinding> selectors;
    std::vector<ButtonBinding> buttons;
    std::vector<EncoderBinding> encoders;
    std::vector<LampBinding> lamps;
    std::vector<DisplayBinding> displays;
};

struct MappingResult {
    std::optional<Mapping> mapping; ///< nothing if there is any diagnostic
    database::Diagnostics diagnostics;
};

/// Reads a mapping file. All its mistakes are told at once.
MappingResult load_mapping(const std::string& path);

/// The mapping of a panel: of those of its kind the one that names its port, or else the first that names none.
const Mapping* mapping_for(const std::vector<Mapping>& mappings, PanelKind kind, const std::string& port);

/// The mapping in words, a line per binding.
std::vector<std::string> mapping_lines(const Mapping& mapping);

} // namespace linkdig::panel
