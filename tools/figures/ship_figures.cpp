/// Wakes: Figures 12 to 14.

#include "host/loop/ship_methods.h"
#include "tools/figures/figures.h"
#include "tools/figures/measures.h"
#include "tools/figures/stage.h"
#include "tools/sheet/contact_sheet.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace linkdig::tools {
namespace {

using host::Signal;
using host::SignalValues;

constexpr const char* with_every_method = "report/methods.toml";
constexpr std::uint32_t wake_faces = 28;
/// The report's pictures of wakes show her on an even keel.
FramePacket even_keel(Stage& stage, std::uint64_t frame, SignalValues signals = {}) {
    signals.set(Signal::ship_motion, 0.0);
    return stage.packet(frame, signals);
}

constexpr std::array<std::string_view, 1> port_wake{"lph2.bow_wake_port"};

/// The bow wake's own slots have a first alternative that is nothing, or not.
void show_face(const Stage& stage, FramePacket& packet, std::uint32_t face) {
    for (const char* slot :
         {"bow_wake_port", "bow_wake_starboard", "lph2.bow_wake_port", "lph2.bow_wake_starboard"}) {
        const std::uint32_t alternatives = stage.alternatives(slot);
        if (alternatives >= wake_faces) stage.point(packet, slot, face - 1 + (alternatives - wake_faces));
    }
}

/// The faces in the order of a packet stream: which, and for how many frames
/// each.
std::vector<std::pair<std::uint32_t, std::uint32_t>> faces_of(Stage& stage, std::uint64_t frames) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> faces;
    const auto& slots = stage.database().slots;
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        const FramePacket packet = stage.packet(frame);
        for (const Substitution& each : packet.substitutions) {
            if (!slots[each.slot].name.ends_with("bow_wake_port") ||
                slots[each.slot].name.find("solid") != std::string::npos)
                continue;
            const std::uint32_t face = each.index + 1 - (slots[each.slot].alternatives - wake_faces);
            if (faces.empty() || faces.back().first != face)
                faces.emplace_back(face, 1);
            else
                ++faces.back().second;
        }
    }
    return faces;
}

/// Pixels of the port wake in all 28 faces, from 60 m abeam of it at a height
/// angle.
double covered(Stage& stage, double elevation_deg) {
    const Vec3d middle(66.0, 8.0, 1.5);
    const Vec3d eye = middle + direction(pi / 2.0, radians(elevation_deg)) * 60.0;
    double pixels = 0.0;
    for (std::uint32_t face = 1; face <= wake_faces; ++face) {
        FramePacket packet = even_keel(stage, 0);
        show_face(stage, packet, face);
        look_beside(packet, stage.moving_object("lph2"), eye, middle, 40.0);
        stage.draw(packet);
        const auto mask = stage.mask(port_wake);
        pixels += static_cast<double>(std::ranges::count(mask, 1));
    }
    return pixels;
}

void sheet_of_faces(Stage& stage, Findings& findings) {
    ContactSheet sheet("Figures 12 and 13: faces of the bow wake", 640, 480);
    std::uint32_t place = 0;
    for (const std::uint32_t face : {1U, 4U, 7U, 10U, 12U, 15U, 17U, 19U, 22U, 24U, 26U, 28U}) {
        FramePacket packet = even_keel(stage, 0);
        show_face(stage, packet, face);
        look_beside(packet, stage.moving_object("lph2"), {95, 62, 5}, {62, 6, 4}, 40.0);
        const ig::VideoFrame& picture = stage.draw(packet);
        sheet.place(place++, picture, fmt::format("face {}", face));
        if (face == 1 || face == 7 || face == 28)
            findings.picture(fmt::format("figure_12_face_{:02}", face), picture);
        if (face == 4 || face == 12 || face == 17 || face == 22)
            findings.picture(fmt::format("figure_13_face_{:02}", face), picture);
    }
    sheet.write(findings.folder() + "/figure_12_13.png");
}

/// The sea's light taken away, so that what is added to it is seen alone.
void darken(const VisualDatabase& database, FramePacket& packet) {
    packet.lighting.clear();
    for (std::uint32_t list = 0; list < database.lists.size(); ++list)
        if (database.lists[list].name == "sea")
            packet.lighting.push_back(
                {.list = list, .sun = database.lists[list].sun, .ambient = 0.0F, .diffuse = 0.0F});
}

/// Seen with the sea's light, without the churn, and without the sea's light:
/// the first is the sum of the others.
int worst_sum(Stage& stage, const FramePacket& with_churn, std::size_t& compared) {
    const ig::VideoFrame both = stage.draw(with_churn);
    FramePacket packet = with_churn;
    darken(stage.database(), packet);
    const ig::VideoFrame churn = stage.draw(packet);
    packet = with_churn;
    stage.point(packet, "lph2.churn", 0);
    const ig::VideoFrame sea = stage.draw(packet);
    constexpr std::array<std::string_view, 1> sea_list{"sea"};
    const std::vector<std::uint8_t> mask = stage.mask(sea_list);
    int worst = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0 || (churn.pixels[i] & 0xFFFFFFU) == 0) continue;
        ++compared;
        for (const unsigned component : {0U, 8U, 16U}) {
            const auto at = [&](const ig::VideoFrame& picture) {
                return static_cast<int>((picture.pixels[i] >> component) & 0xFFU);
            };
            worst = std::max(worst, std::abs(at(both) - std::min(255, at(sea) + at(churn))));
        }
    }
    return worst;
}

} // namespace

void bow_wakes(Findings& findings) {
    Stage stage(with_every_method);
    const auto faces = faces_of(stage, std::uint64_t{wake_faces} * 3 * 2);
    double wrong = faces.size() == std::size_t{wake_faces} * 2 ? 0.0 : 1.0;
    for (std::size_t i = 0; i < faces.size(); ++i)
        wrong += faces[i] == std::pair(static_cast<std::uint32_t>(i % wake_faces + 1), 3U) ? 0.0 : 1.0;
    findings.at_most("12", "faces out of order, or not of 3 packets at 30 Hz, in two rounds", wrong, 0.0);
    if (!findings.quick()) sheet_of_faces(stage, findings);
    const double low = covered(stage, 5.0);
    findings.at_least("13", "pixels of the port face from 5 degrees, all 28", low, 1000.0);
    findings.at_most("13", "covered from 80 degrees down over covered from 5", covered(stage, 80.0) / low,
                     0.15);
    FramePacket packet = even_keel(stage, 0);
    show_face(stage, packet, 12);
    look_beside(packet, stage.moving_object("lph2"), {70, 10, 90}, {66, 0, 0}, 60.0);
    findings.picture("figure_13_from_above", stage.draw(packet));
    for (const auto& [name, signal] :
         {std::pair{"white_v", Signal::white_v}, std::pair{"blended_v", Signal::blended_v},
          std::pair{"cam", Signal::cam}, std::pair{"solid", Signal::solid}}) {
        SignalValues signals;
        signals.set(Signal::face_substitution, 1.0); // away with the scenario's own
        signals.set(Signal::churned, 1.0);
        signals.set(signal, 1.0);
        FramePacket other = even_keel(stage, 40, signals);
        look_beside(other, stage.moving_object("lph2"), {140, 130, 45}, {0, 10, 0}, 56.0);
        findings.picture(fmt::format("wake_{}", name), stage.draw(other));
    }
}

void churned_water(Findings& findings) {
    Stage stage(with_every_method);
    const std::size_t ship = stage.moving_object("lph2");
    SignalValues flat;
    flat.set(Signal::smooth_shading, 0.0);
    FramePacket stern = even_keel(stage, 30, flat);
    look_beside(stern, ship, {-260, 40, 40}, {-110, 0, 0}, 50.0);
    findings.picture("figure_14_stern_flat", stage.draw(stern));
    FramePacket both = even_keel(stage, 30);
    look_beside(both, ship, {-230, 110, 60}, {-30, 0, 0}, 60.0);
    findings.picture("figure_14", stage.draw(both));
    std::size_t compared = 0;
    double worst = 0.0;
    for (const std::uint64_t frame : {30ULL, 75ULL, 140ULL}) {
        FramePacket packet = even_keel(stage, frame);
        look_beside(packet, ship, {-230, 110, 60}, {-30, 0, 0}, 60.0);
        worst = std::max(worst, static_cast<double>(worst_sum(stage, packet, compared)));
    }
    findings.at_most("14", "error of the sum of sea and churned water, levels", worst, 1.0);
    findings.at_least("14", "pixels compared", static_cast<double>(compared), 1000.0);
}

} // namespace linkdig::tools
