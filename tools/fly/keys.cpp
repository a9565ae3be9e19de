#include "tools/fly/keys.h"

#include <SDL_keycode.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace linkdig::tools {
namespace {

constexpr std::array table{
    Key{Action::pause, "space", "pause, go on", SDLK_SPACE, SDLK_p},
    Key{Action::step, ".", "single step", SDLK_PERIOD, SDLK_KP_PERIOD},
    Key{Action::sun_up, "up", "sea's sun up 2 deg", SDLK_UP, 0},
    Key{Action::sun_down, "down", "sea's sun down 2 deg", SDLK_DOWN, 0},
    Key{Action::sea_sun_slower, "left", "sea's sun slower", SDLK_LEFT, 0},
    Key{Action::sea_sun_faster, "right", "sea's sun faster", SDLK_RIGHT, 0},
    Key{Action::earlier, "[", "half an hour earlier", SDLK_LEFTBRACKET, SDLK_PAGEDOWN},
    Key{Action::later, "]", "half an hour later", SDLK_RIGHTBRACKET, SDLK_PAGEUP},
    Key{Action::smooth_shading, "s", "smooth shading off, on", SDLK_s, 0},
    Key{Action::view_ahead, "1 a", "view ahead", SDLK_1, SDLK_a},
    Key{Action::view_left, "2 l", "view left", SDLK_2, SDLK_l},
    Key{Action::view_right, "3 r", "view right", SDLK_3, SDLK_r},
    Key{Action::view_down, "4 d", "view down", SDLK_4, SDLK_d},
    Key{Action::reset, "backspace", "reset", SDLK_BACKSPACE, 0},
    Key{Action::help, "h", "help off, on", SDLK_h, SDLK_F1},
    Key{Action::quit, "q esc", "quit", SDLK_q, SDLK_ESCAPE},
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

std::vector<std::string> help_lines() {
    std::vector<std::string> lines;
    lines.reserve(table.size());
    for (const Key& key : table)
        lines.push_back(fmt::format("{:<10} {}", key.label, key.says));
    return lines;
}

} // namespace linkdig::tools
