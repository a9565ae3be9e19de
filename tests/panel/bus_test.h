#pragma once
/// What the tests of the panels' link share.

#include "host/panel/panel_link.h"
#include "tests/panel/mock_panel.h"

#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace linkdig::panel {

/// Polls, up to a limit that only a hang reaches.
[[nodiscard]] inline bool until(const std::function<bool()>& true_now) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!true_now()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

/// Keeps words, from any thread.
class Words {
public:
    Tell tell() {
        return [this](const std::string& words) { add(words); };
    }
    void add(std::string words) {
        const std::lock_guard lock(mutex_);
        words_.push_back(std::move(words));
    }
    std::vector<std::string> all() const {
        const std::lock_guard lock(mutex_);
        return words_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<std::string> words_;
};

/// The shipped mappings.
inline std::vector<Mapping> shipped_mappings() {
    std::vector<Mapping> all;
    for (std::size_t i = 0; i < panel_kinds; ++i) {
        const std::string name = layout_of(static_cast<PanelKind>(i)).name;
        all.push_back(*load_mapping(LINKDIG_SOURCE_DIR "/host/panel/mappings/" + name + ".toml").mapping);
    }
    return all;
}

} // namespace linkdig::panel
