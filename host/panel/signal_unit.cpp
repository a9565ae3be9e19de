#include "host/panel/signal_unit.h"

#include "database/model/mathematics.h"

namespace linkdig::panel {

SignalUnit unit_of(host::Signal signal) {
    const std::string_view unit = host::definition(signal).unit;
    if (unit == "rad") return {"_deg", radians(1.0)};
    if (unit == "rad/s") return {"_deg_s", radians(1.0)};
    if (unit == "h") return {"_h", 1.0};
    if (unit == "s") return {"_s", 1.0};
    return {"", 1.0};
}

SignalUnit unit_of(const Shown& shown) {
    const auto* signal = std::get_if<host::Signal>(&shown);
    return signal != nullptr ? unit_of(*signal) : SignalUnit{};
}

const char* name_of(const Shown& shown) {
    if (const auto* signal = std::get_if<host::Signal>(&shown)) return host::definition(*signal).name;
    return host::indication_directory()[static_cast<std::size_t>(std::get<host::Indication>(shown))].name;
}

} // namespace linkdig::panel
