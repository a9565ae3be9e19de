#pragma once
/// What the flight tells the people at the controls: named values that the loop writes and lamps and displays of a panel show.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::host {

enum class Indication : std::uint8_t {
    deck_ready,
    overrun,
    overruns,
    sea_state,
    heading,
    altitude_ft,
    altitude_m,
    speed_kt,
    climb_fpm,
    hour,
    visibility_m,
    ship_pitch,
    ship_roll,
    ship_heading,
    ship_speed_kt,
    range_m,
    sea_sun_height,
    frame,
};
inline constexpr std::size_t indication_count = 18;

struct IndicationDefinition {
    Indication indication;
    const char* name;
    const char* meaning; ///< one clause with the unit, as shown in a list
};

/// All indications, in the order of the enumeration.
std::span<const IndicationDefinition> indication_directory();
std::optional<Indication> find_indication(std::string_view name);
std::vector<std::string> indication_names();

/// Where the indications stand between two frames. The loop writes, any thread reads, and neither waits for the other. A NaN, as at the
/// beginning, means that there is nothing to show.
class IndicationStore {
public:
    IndicationStore();
    IndicationStore(const IndicationStore&) = delete;
    IndicationStore& operator=(const IndicationStore&) = delete;

    void write(Indication indication, double value) {
        values_[static_cast<std::size_t>(indication)].store(value, std::memory_order_relaxed);
    }
    double value(Indication indication) const {
        return values_[static_cast<std::size_t>(indication)].load(std::memory_order_relaxed);
    }

private:
    static_assert(std::atomic<double>::is_always_lock_free);

    std::array<std::atomic<double>, indication_count> values_;
};

} // namespace linkdig::host
