#include "tools/fly/keys.h"

#include <SDL_joystick.h>
#include <SDL_keycode.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace linkdig::tools {
namespace {

constexpr std::array table{
    Key{Action::pause, "space", "pause, go on", SDLK_SPACE, SDLK_p, true},
    Key{Action::step, ".", "single step", SDLK_PERIOD, SDLK_KP_PERIOD},
    Key{Action::sun_up, "up", "sea's sun up 2 deg", SDLK_UP, 0, true},
    Key{Action::sun_down, "down", "sea's sun down 2 deg", SDLK_DOWN, 0, true},
    Key{Action::sea_sun_slower, "left", "sea's sun slower", SDLK_LEFT, 0, true},
    Key{Action::sea_sun_faster, "right", "sea's sun faster", SDLK_RIGHT, 0, true},
    Key{Action::earlier, "[", "half an hour earlier", SDLK_LEFTBRACKET, 0, true},
    Key{Action::later, "]", "half an hour later", SDLK_RIGHTBRACKET, 0, true},
    Key{Action::smooth_shading, "s", "smooth shading off, on", SDLK_s, 0, true},
    Key{Action::view_ahead, "1 a", "view ahead", SDLK_1, SDLK_a, true},
    Key{Action::view_left, "2 l", "view left", SDLK_2, SDLK_l, true},
    Key{Action::view_right, "3 r", "view right", SDLK_3, SDLK_r, true},
    Key{Action::view_down, "4 d", "view down", SDLK_4, SDLK_d, true},
    Key{Action::reset, "backspace", "reset", SDLK_BACKSPACE, 0, true},
    Key{Action::help, "h", "help off, on", SDLK_h, 0, true},
    Key{Action::sea_state, "e", "sea state 0, 1-2, 3", SDLK_e, 0},
    Key{Action::elevation_rate_down, "-", "sea's sun sinks", SDLK_MINUS, SDLK_KP_MINUS},
    Key{Action::elevation_rate_up, "=", "sea's sun rises", SDLK_EQUALS, SDLK_KP_PLUS},
    Key{Action::sea_method, "n", "turn the sun, the normals", SDLK_n, 0},
    Key{Action::normals_every, "b", "normals every 1, 2, 4, 8", SDLK_b, 0},
    Key{Action::occulting, "o", "next occulting method", SDLK_o, 0},
    Key{Action::white_v, "F2", "white V", SDLK_F2, 0},
    Key{Action::blended_v, "F3", "blended V", SDLK_F3, 0},
    Key{Action::cam, "F4", "cams", SDLK_F4, 0},
    Key{Action::face_substitution, "F5", "28 faces", SDLK_F5, 0},
    Key{Action::solid, "F6", "solid bow wake", SDLK_F6, 0},
    Key{Action::churned, "F7", "churned water", SDLK_F7, 0},
    Key{Action::pitch_amplitude, "x", "pitch once, twice", SDLK_x, 0},
    Key{Action::ship_motion, "m", "ship motion off, on", SDLK_m, 0},
    Key{Action::visibility, "v", "visibility", SDLK_v, 0},
    Key{Action::profile, "t", "1980, today", SDLK_t, 0},
    Key{Action::hands_on, "g", "fly by hand: arrows, page up", SDLK_g, 0},
    Key{Action::save_state, "F9", "save the state", SDLK_F9, 0},
    Key{Action::load_state, "F10", "load the state", SDLK_F10, 0},
    Key{Action::next_effect, "tab", "next effect", SDLK_TAB, 0},
    Key{Action::switch_effect, "return", "effect off, on, its price", SDLK_RETURN, SDLK_KP_ENTER},
    Key{Action::panel, "i", "figures off, on", SDLK_i, 0},
    Key{Action::ship_slower, "j", "ships slower", SDLK_j, 0},
    Key{Action::ship_faster, "k", "ships faster", SDLK_k, 0},
    Key{Action::next_channel, "c", "next channel", SDLK_c, 0},
    Key{Action::record, "F8", "record, stop", SDLK_F8, 0},
    Key{Action::all_keys, "F1", "all keys", SDLK_F1, 0, true},
    Key{Action::quit, "q esc", "quit", SDLK_q, SDLK_ESCAPE, true},
};

} // namespace

std::span<const Key> keys() { return table; }

std::optional<Action> action_of(std::int32_t key_code) {
    const auto found = std::ranges::find_if(table, [&](const Key& key) {
        return key_code != 0 && (key.code == key_code || key.other_code == key_code);
    });
    if (found == table.end()) return std::nullopt;
    return found->action;
}

std::optional<Action> action_of_button(std::uint8_t button) {
    constexpr std::array buttons{Action::hands_on, Action::pause, Action::reset, Action::record};
    if (button >= buttons.size()) return std::nullopt;
    return buttons[button];
}

std::optional<Action> action_of_hat(std::uint8_t position) {
    switch (position) {
    case SDL_HAT_UP:
        return Action::view_ahead;
    case SDL_HAT_LEFT:
        return Action::view_left;
    case SDL_HAT_RIGHT:
        return Action::view_right;
    case SDL_HAT_DOWN:
        return Action::view_down;
    default:
        return std::nullopt;
    }
}

std::vector<std::string> help_lines(bool all) {
    std::vector<std::string> lines;
    for (const Key& key : table)
        if (all || key.first) lines.push_back(fmt::format("{:<10} {}", key.label, key.says));
    return lines;
}

bool repeats(Action action) {
    return action == Action::step || action == Action::ship_slower || action == Action::ship_faster ||
           (action >= Action::sun_up && action <= Action::later);
}

} // namespace linkdig::tools
