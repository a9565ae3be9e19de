#include "tools/panel/lamp_test.h"

#include <algorithm>

namespace linkdig::tools {

std::vector<panel::PanelFace> lamp_test_faces(const panel::PanelLayout& layout) {
    const panel::PanelFace dark = panel::dark_face(layout);
    std::vector<panel::PanelFace> faces;
    for (std::size_t i = 0; i < layout.lamps.size(); ++i) {
        faces.push_back(dark);
        faces.back().lamps[i] = true;
    }
    const auto show = [&](const auto& text_on) {
        faces.push_back(dark);
        std::ranges::transform(layout.displays, faces.back().texts.begin(), text_on);
    };
    if (!layout.displays.empty()) {
        for (char digit = '0'; digit <= '9'; ++digit)
            show([&](const panel::Display&) { return std::string(panel::display_digits, digit); });
        show([](const panel::Display& display) {
            return display.with_dot ? "1.2.3.4.5." : display.dash ? "-----" : "12345";
        });
        show([](const panel::Display& display) { return display.dash ? "-----" : ""; });
        show([](const panel::Display&) { return std::string(panel::display_digits, '8'); });
    } else {
        faces.push_back(dark);
    }
    faces.back().lamps.assign(layout.lamps.size(), true);
    faces.push_back(dark);
    return faces;
}

void LampTest::attached(const panel::PanelPlace& place) {
    detached(place);
    panels_.push_back({place, lamp_test_faces(panel::layout_of(place.kind)), now_s_});
    ++running_;
}

void LampTest::detached(const panel::PanelPlace& place) {
    std::erase_if(panels_, [&](const Panel& each) {
        if (each.place != place) return false;
        running_ -= each.over ? 0 : 1;
        return true;
    });
}

void LampTest::turn(double now_s) {
    now_s_ = now_s;
    for (Panel& each : panels_) {
        const bool over = now_s - each.begin_s > step_s_ * static_cast<double>(each.faces.size());
        if (!over || each.over) continue;
        each.over = true;
        ++done_;
        --running_;
    }
}

std::vector<std::uint8_t> LampTest::wanted(const panel::PanelPlace& place) {
    const auto found = std::ranges::find(panels_, place, &Panel::place);
    if (found == panels_.end()) return {};
    const auto step = static_cast<std::size_t>((now_s_ - found->begin_s) / step_s_);
    return panel::feature_report(panel::layout_of(place.kind),
                                 found->faces[std::min(step, found->faces.size() - 1)]);
}

} // namespace linkdig::tools
