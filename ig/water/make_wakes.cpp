#include "ig/water/make_wakes.h"

#include "ig/active/made_faces.h"

#include <algorithm>

namespace linkdig::ig {

namespace {

bool is_there(const WakeRequest& wake, const FramePacket& packet) {
    return packet.moving_objects[wake.moving_object].visible;
}

/// Forgets what the packet does not ask for.
template <typename Wake>
void keep_wanted(const FramePacket& packet, WakeMethod method, std::vector<Wake>& wakes) {
    std::erase_if(wakes, [&](const Wake& each) {
        return std::ranges::none_of(packet.wakes, [&](const WakeRequest& wake) {
            return wake.method == method && wake.list == each.list && is_there(wake, packet);
        });
    });
}

template <typename Wake>
Wake* find_wake(std::vector<Wake>& wakes, std::uint32_t list) {
    const auto found = std::ranges::find(wakes, list, &Wake::list);
    return found == wakes.end() ? nullptr : &*found;
}

template <typename Wake>
Wake& history_of(std::vector<Wake>& wakes, std::uint32_t list) {
    if (Wake* const wake = find_wake(wakes, list)) return *wake;
    wakes.push_back({.list = list});
    return wakes.back();
}

ParticleWakeMaker& maker_for(const VisualDatabase& database, const WakeRequest& wake, WakeMakers& makers) {
    const auto found =
        std::ranges::find_if(makers.particles, [&](const auto& maker) { return maker->list() == wake.list; });
    std::unique_ptr<ParticleWakeMaker>& maker =
        found != makers.particles.end() ? *found : makers.particles.emplace_back();
    if (!maker || !maker->serves(wake)) maker = std::make_unique<ParticleWakeMaker>(database, wake);
    return *maker;
}

} // namespace

void follow_wakes(const VisualDatabase& database, const FramePacket& packet, WakeMakers& makers,
                  History& history) {
    keep_wanted(packet, WakeMethod::kelvin, history.trails);
    keep_wanted(packet, WakeMethod::wave_particles, history.particle_wakes);
    for (const WakeRequest& wake : packet.wakes) {
        if (!is_there(wake, packet)) continue;
        if (wake.method == WakeMethod::kelvin)
            follow_track(wake, packet, history_of(history.trails, wake.list));
        else
            maker_for(database, wake, makers)
                .follow(wake, packet, history_of(history.particle_wakes, wake.list));
    }
}

void make_wake_faces(const FramePacket& packet, History& history, WakeMakers& makers, ActiveDatabase& active,
                     std::vector<WakeReport>& reports) {
    for (const WakeRequest& wake : packet.wakes) {
        WakeReport& report = reports.emplace_back(WakeReport{.list = wake.list});
        const auto block = std::ranges::find(active.blocks, wake.list, &FaceBlock::list);
        if (block == active.blocks.end()) continue;
        const std::size_t before = active.made_faces.size();
        if (const WakeTrail* const trail = find_wake(history.trails, wake.list)) {
            make_trail_faces(wake, *trail, track_sample(wake, packet), makers.rows, active, *block);
        } else if (ParticleWake* const particles = find_wake(history.particle_wakes, wake.list)) {
            maker_for(*active.database, wake, makers).make_faces(wake, packet, *particles, active, *block);
            report.particles = static_cast<std::uint32_t>(particles->particles.size());
        }
        give_to_list(wake.list, before, active);
        report.faces = static_cast<std::uint32_t>(active.made_faces.size() - before);
    }
    settle_made_faces(active);
}

} // namespace linkdig::ig
