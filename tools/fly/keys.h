#pragma once
/// The keys of the window: one table, from which both the meaning of a key and the help on the screen are
/// taken.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace linkdig::tools {

enum class Action : std::uint8_t {
    pause,
    step,
    sun_up,
    sun_down,
    sea_sun_slower,
    sea_sun_faster,
    earlier,
    later,
    smooth_shading,
    view_ahead,
    view_left,
    view_right,
    view_down,
    reset,
    help,
    elevation_rate_down,
    elevation_rate_up,
    sea_state,
    sea_method,
    normals_every,
    occulting,
    white_v,
    blended_v,
    cam,
    face_substitution,
    solid,
    churned,
    pitch_amplitude,
    ship_motion,
    visibility,
    profile,
    hands_on,
    save_state,
    load_state,
    next_effect,
    switch_effect,
    panel,
    all_keys,
    ship_slower,
    ship_faster,
    next_channel,
    record,
    quit,
};

struct Key {
    Action action;
    const char* label;       ///< as shown
    const char* says;        ///< what it does, as shown
    std::int32_t code;       ///< SDL_Keycode
    std::int32_t other_code; ///< a second one that does the same, or 0
    bool first = false;      ///< stands in the short help
};

std::span<const Key> keys();

/// What an SDL_Keycode does, if anything.
std::optional<Action> action_of(std::int32_t key_code);

/// What a joystick's button does, from 0, if anything.
std::optional<Action> action_of_button(std::uint8_t button);
/// What its hat does when it is pushed one way (SDL_HAT_UP and so on), if anything.
std::optional<Action> action_of_hat(std::uint8_t position);

/// The help on the screen, a line per key: those of the first flight, or all.
std::vector<std::string> help_lines(bool all);

/// Does a held key act again and again?
bool repeats(Action action);

} // namespace linkdig::tools
