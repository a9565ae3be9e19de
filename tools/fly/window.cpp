#include "tools/fly/window.h"

#include "tools/sheet/text.h"

#include <SDL.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>

namespace linkdig::tools {
namespace {

constexpr int letter_px = 15;
constexpr int margin_px = 8;
constexpr double dead_zone = 0.08; ///< of a joystick's axis: estimated

struct Destroy {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
    void operator()(SDL_Joystick* joystick) const { SDL_JoystickClose(joystick); }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

[[noreturn]] void fail(const char* what) {
    throw std::runtime_error(fmt::format("{}: {}", what, SDL_GetError()));
}

bool set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

/// SDL itself, while a window stands.
struct Session {
    Session() {
        if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("no window can be opened");
        SDL_InitSubSystem(SDL_INIT_JOYSTICK); // without one the keys fly
        // Where no display answers SDL draws where nobody looks, and calls that a success.
        const std::string driver = SDL_GetCurrentVideoDriver();
        if (!set("SDL_VIDEODRIVER") && (driver == "offscreen" || driver == "dummy")) {
            SDL_QuitSubSystem(SDL_INIT_VIDEO);
            throw std::runtime_error("no window can be opened: the display does not answer");
        }
    }
    ~Session() {
        SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
};

/// Largest rectangle of the picture's shape, in the middle of the window.
SDL_Rect fitted(int width, int height, int window_width, int window_height) {
    const double scale =
        std::min(static_cast<double>(window_width) / width, static_cast<double>(window_height) / height);
    const int w = std::max(1, static_cast<int>(width * scale));
    const int h = std::max(1, static_cast<int>(height * scale));
    return {(window_width - w) / 2, (window_height - h) / 2, w, h};
}

/// What a joystick's event asks for.
std::optional<Action> action_of(const SDL_Event& event) {
    if (event.type == SDL_JOYBUTTONDOWN) return action_of_button(event.jbutton.button);
    if (event.type == SDL_JOYHATMOTION) return action_of_hat(event.jhat.value);
    return std::nullopt;
}

} // namespace

bool display_present() { return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("SDL_VIDEODRIVER"); }

struct Window::State {
    Session session;
    GlyphSheet glyphs = glyph_sheet(letter_px);
    Owned<SDL_Window> window;
    Owned<SDL_Renderer> renderer;
    Owned<SDL_Texture> picture;
    Owned<SDL_Texture> letters; ///< drawn once: changing text costs no more than standing text
    Owned<SDL_Joystick> joystick;
    int width = 0;
    int height = 0;

    void size_picture(int picture_width, int picture_height);
    void open(const std::string& title);
    void draw(const TextBlock& block, int window_height);
};

void Window::State::open(const std::string& title) {
    window.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width,
                                  height, SDL_WINDOW_RESIZABLE));
    if (!window) fail("no window can be opened");
    renderer.reset(SDL_CreateRenderer(window.get(), -1, 0));
    if (!renderer) renderer.reset(SDL_CreateRenderer(window.get(), -1, SDL_RENDERER_SOFTWARE));
    if (!renderer) fail("the window cannot be drawn into");
    SDL_SetRenderDrawBlendMode(renderer.get(), SDL_BLENDMODE_BLEND);
    size_picture(width, height);
    letters.reset(SDL_CreateTexture(renderer.get(), SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC,
                                    glyphs.width(), glyphs.height()));
    if (!letters) fail("the window's textures cannot be made");
    SDL_SetTextureBlendMode(letters.get(), SDL_BLENDMODE_BLEND);
    SDL_UpdateTexture(letters.get(), nullptr, glyphs.pixels.data(), glyphs.width() * 4);
}

void Window::State::size_picture(int picture_width, int picture_height) {
    width = picture_width;
    height = picture_height;
    picture.reset(SDL_CreateTexture(renderer.get(), SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STREAMING,
                                    width, height));
    if (!picture) fail("the window's textures cannot be made");
    SDL_SetTextureBlendMode(picture.get(), SDL_BLENDMODE_NONE);
}

void Window::State::draw(const TextBlock& block, int window_height) {
    if (block.lines.empty()) return;
    const auto longest = std::ranges::max(block.lines, {}, &std::string::size).size();
    const int rows = static_cast<int>(block.lines.size());
    const int block_width = static_cast<int>(longest) * glyphs.cell_width + 2 * margin_px;
    const int block_height = rows * glyphs.cell_height + 2 * margin_px;
    const int top = block.corner == TextBlock::Corner::top_left ? 0 : window_height - block_height;
    const SDL_Rect ground{0, top, block_width, block_height};
    SDL_SetRenderDrawColor(renderer.get(), 10, 14, 20, 150);
    SDL_RenderFillRect(renderer.get(), &ground);
    for (int row = 0; row < rows; ++row) {
        SDL_Rect to{margin_px, top + margin_px + row * glyphs.cell_height, glyphs.cell_width,
                    glyphs.cell_height};
        for (const char letter : block.lines[static_cast<std::size_t>(row)]) {
            const int index = letter - GlyphSheet::first;
            const SDL_Rect from{index % GlyphSheet::columns * glyphs.cell_width,
                                index / GlyphSheet::columns * glyphs.cell_height, glyphs.cell_width,
                                glyphs.cell_height};
            if (letter >= GlyphSheet::first && letter <= GlyphSheet::last)
                SDL_RenderCopy(renderer.get(), letters.get(), &from, &to);
            to.x += glyphs.cell_width;
        }
    }
}

Window::Window(const std::string& title, std::uint32_t width, std::uint32_t height)
    : state_(std::make_unique<State>()) {
    state_->width = static_cast<int>(width);
    state_->height = static_cast<int>(height);
    state_->open(title);
}

Window::~Window() = default;

void Window::show(const ig::VideoFrame& picture, std::span<const TextBlock> text) {
    SDL_Renderer* renderer = state_->renderer.get();
    int window_width = 0;
    int window_height = 0;
    SDL_GetRendererOutputSize(renderer, &window_width, &window_height);
    SDL_SetRenderDrawColor(renderer, 0, 0, 0, 255);
    SDL_RenderClear(renderer);
    if (!picture.pixels.empty()) {
        const auto picture_width = static_cast<int>(picture.width);
        const auto picture_height = static_cast<int>(picture.height);
        if (picture_width != state_->width || picture_height != state_->height)
            state_->size_picture(picture_width, picture_height);
        SDL_UpdateTexture(state_->picture.get(), nullptr, picture.pixels.data(), state_->width * 4);
        const SDL_Rect place = fitted(state_->width, state_->height, window_width, window_height);
        SDL_RenderCopy(renderer, state_->picture.get(), nullptr, &place);
    }
    for (const TextBlock& block : text)
        state_->draw(block, window_height);
    SDL_RenderPresent(renderer);
}

std::vector<Action> Window::actions() {
    std::vector<Action> asked;
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
        if (event.type == SDL_QUIT) asked.push_back(Action::quit);
        if (event.type == SDL_JOYDEVICEADDED && !state_->joystick)
            state_->joystick.reset(SDL_JoystickOpen(event.jdevice.which));
        if (event.type == SDL_JOYDEVICEREMOVED &&
            SDL_JoystickGetAttached(state_->joystick.get()) == SDL_FALSE)
            state_->joystick.reset();
        if (const auto action = action_of(event)) asked.push_back(*action);
        if (event.type != SDL_KEYDOWN) continue;
        const auto action = action_of(event.key.keysym.sym);
        // Held keys repeat where a value goes up or down or frames are stepped, not where something is
        // switched.
        if (action && (event.key.repeat == 0 || repeats(*action))) asked.push_back(*action);
    }
    return asked;
}

Sticks Window::sticks() const {
    const Uint8* held = SDL_GetKeyboardState(nullptr);
    const auto between = [&](SDL_Scancode less, SDL_Scancode more) {
        return static_cast<double>(held[more]) - static_cast<double>(held[less]);
    };
    const Sticks keys{.fore = between(SDL_SCANCODE_DOWN, SDL_SCANCODE_UP),
                      .right = between(SDL_SCANCODE_LEFT, SDL_SCANCODE_RIGHT),
                      .pedals_right = between(SDL_SCANCODE_HOME, SDL_SCANCODE_END),
                      .collective = between(SDL_SCANCODE_PAGEDOWN, SDL_SCANCODE_PAGEUP)};
    if (keys != Sticks{} || !state_->joystick) return keys;
    const auto axis = [&](int number) {
        const double value = SDL_JoystickGetAxis(state_->joystick.get(), number) / 32768.0;
        return std::abs(value) < dead_zone ? 0.0 : value;
    };
    return {.fore = -axis(1), .right = axis(0), .pedals_right = axis(2), .collective = -axis(3)};
}

} // namespace linkdig::tools
