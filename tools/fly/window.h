#pragma once
/// The window: the channel's picture, text over it, and the keys that were pressed.

#include "ig/video/line.h"
#include "tools/fly/keys.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace linkdig::tools {

/// Is there a display to open a window on? True as well where SDL_VIDEODRIVER names a driver that needs none.
bool display_present();

/// A block of text over the picture, on a darkened ground.
struct TextBlock {
    enum class Corner : std::uint8_t { top_left, bottom_left };
    Corner corner = Corner::top_left;
    std::vector<std::string> lines; ///< printable ASCII; anything else is left out
};

/// What a joystick and the keys that are held say about flying by hand; each -1 to 1.
struct Sticks {
    double fore = 0.0;
    double right = 0.0;
    double pedals_right = 0.0;
    double collective = 0.0;
    bool operator==(const Sticks&) const = default;
};

class Window {
public:
    /// Opens a window for pictures of this size, in pixels; the user may resize it, the picture then keeps
    /// its shape. Throws std::runtime_error, with SDL's reason, if there is no display, and as glyph_sheet()
    /// does.
    Window(const std::string& title, std::uint32_t width, std::uint32_t height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Shows the picture (of any size) and the text over it, at once: pacing is the frame clock's affair.
    void show(const ig::VideoFrame& picture, std::span<const TextBlock> text);
    /// What was asked for since the last call, in order. Closing the window asks for Action::quit.
    std::vector<Action> actions();
    /// How the controls stand, as of the last actions(): the first joystick's axes 0 to 3 (right, back, pedals, down) beyond a dead
    /// zone, or the arrow keys, home and end, page up and page down. Buttons and hat ask for
    /// what keys.h says.
    Sticks sticks() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace linkdig::tools
