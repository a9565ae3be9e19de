#include "host/panel/signal_unit.h"

#include <fmt/format.h>

#include <cmath>

namespace linkdig::panel {

namespace {

/// Bindings of one mapping in words.
class Lines {
public:
    explicit Lines(const Mapping& mapping) : mapping_(mapping), layout_(layout_of(mapping.kind)) {}

    std::vector<std::string> all() {
        switches();
        selectors();
        for (const ButtonBinding& each : mapping_.buttons)
            add(each.at ? fmt::format("{}.{}", control(each.control), position(each.control, *each.at))
                        : control(each.control),
                each.when, act(each.step));
        for (const EncoderBinding& each : mapping_.encoders)
            add(control(each.control), each.when, act(each.step));
        for (const LampBinding& each : mapping_.lamps)
            add(fmt::format("lamp {}", layout_.lamps[each.lamp].name), each.when, lit(each));
        for (const DisplayBinding& each : mapping_.displays)
            add(fmt::format("display {}", layout_.displays[each.display].name), each.when,
                fmt::format("shows {}", name_of(each.shows)));
        return std::move(lines_);
    }

private:
    std::string control(std::size_t index) const { return layout_.controls[index].name; }
    std::string position(std::size_t control, std::size_t at) const {
        return layout_.controls[control].positions[at];
    }
    static std::string written(host::Signal signal, double value) {
        const SignalUnit unit = unit_of(signal);
        return fmt::format("{:.6g}{}", value / unit.in_si, unit.in_si != 1.0 ? " deg" : "");
    }
    void add(const std::string& input, const std::optional<Stand>& when, const std::string& does) {
        const std::string stand =
            when ? fmt::format(" [{}.{}]", control(when->control), position(when->control, when->position))
                 : "";
        lines_.push_back(fmt::format("{:<28} {}", input + stand, does));
    }

    void switches() {
        for (const SwitchBinding& each : mapping_.switches)
            add(control(each.control), {},
                fmt::format("{} = {} on, {} off", host::definition(each.signal).name,
                            written(each.signal, each.on), written(each.signal, each.off)));
    }
    void selectors() {
        for (const SelectorBinding& each : mapping_.selectors) {
            std::string values;
            for (std::size_t i = 0; i < each.values.size(); ++i)
                if (each.values[i])
                    values += fmt::format("{}{} {}", values.empty() ? "" : ", ",
                                          written(each.signal, *each.values[i]), position(each.control, i));
            add(control(each.control), {},
                fmt::format("{} = {}", host::definition(each.signal).name, values));
        }
    }
    static std::string act(const Step& step) {
        const char* name = host::definition(step.signal).name;
        if (step.to) return fmt::format("{} = {}", name, written(step.signal, *step.to));
        if (step.by)
            return fmt::format("{} {} {}{}", name, *step.by < 0.0 ? "-" : "+",
                               written(step.signal, std::abs(*step.by)),
                               step.wraps ? ", round and round" : "");
        return host::definition(step.signal).kind == host::SignalKind::pulse
                   ? std::string(name)
                   : fmt::format("{} changes over", name);
    }
    static std::string lit(const LampBinding& lamp) {
        std::string range;
        const SignalUnit unit = unit_of(lamp.shows);
        if (lamp.at_least != 0.5 || std::isfinite(lamp.below)) {
            range = fmt::format(" from {:.6g}", lamp.at_least / unit.in_si);
            if (std::isfinite(lamp.below)) range += fmt::format(" below {:.6g}", lamp.below / unit.in_si);
        }
        return fmt::format("lit by {}{}", name_of(lamp.shows), range);
    }

    const Mapping& mapping_;
    const PanelLayout& layout_;
    std::vector<std::string> lines_;
};

} // namespace

std::vector<std::string> mapping_lines(const Mapping& mapping) { return Lines(mapping).all(); }

} // namespace linkdig::panel
