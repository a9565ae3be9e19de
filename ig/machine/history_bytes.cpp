#include "ig/machine/history_bytes.h"

#include "ig/active/light_steps.h"
#include "ig/active/shedding.h"

namespace linkdig::ig {

namespace {

constexpr std::uint32_t version = 2;
constexpr std::uint32_t version_without_light_steps = 1;

void put(std::uint32_t number, std::vector<std::uint8_t>& bytes) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// Takes numbers off the front; `whole` turns false where there are none left.
struct Reading {
    std::span<const std::uint8_t> bytes;
    bool whole = true;

    std::uint32_t next() {
        whole = whole && bytes.size() >= 4;
        if (!whole) return 0;
        std::uint32_t number = 0;
        for (unsigned k = 0; k < 4; ++k)
            number |= std::uint32_t{bytes[k]} << (8 * k);
        bytes = bytes.subspan(4);
        return number;
    }
};

} // namespace

std::vector<std::uint8_t> encode_history(const History& history) {
    std::vector<std::uint8_t> bytes;
    put(version, bytes);
    put(static_cast<std::uint32_t>(history.held_level.size()), bytes);
    for (const std::uint32_t level : history.held_level)
        put(level, bytes);
    for (const std::uint32_t number : {history.load.step, history.load.calm, history.load.over,
                                       history.load.light_step, history.load.light_calm})
        put(number, bytes);
    return bytes;
}

std::optional<History> decode_history(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return History{};
    Reading reading{bytes};
    const std::uint32_t written_as = reading.next();
    if (written_as != version && written_as != version_without_light_steps) return std::nullopt;
    const std::uint32_t details = reading.next();
    if (!reading.whole || details > reading.bytes.size() / 4) return std::nullopt;
    History history;
    for (std::uint32_t d = 0; d < details; ++d)
        history.held_level.push_back(reading.next());
    history.load.step = reading.next();
    history.load.calm = reading.next();
    history.load.over = reading.next();
    if (written_as == version) {
        history.load.light_step = reading.next();
        history.load.light_calm = reading.next();
    }
    if (history.load.step > most_steps || history.load.light_step > light_steps) return std::nullopt;
    if (!reading.whole || !reading.bytes.empty()) return std::nullopt;
    return history;
}

} // namespace linkdig::ig
