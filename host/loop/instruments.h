#pragma once
/// What the cockpit's instruments show of a frame: from its packet to the named indications.

#include "host/loop/host_loop.h"
#include "host/signals/indications.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace linkdig::host {

/// A deck is ready while she neither pitches nor rolls more, and has not done so for a second. Estimated: about half of what
/// the report calls the limits of a real landing (3.3.1: 5 and 8 degrees).
inline constexpr double quiet_pitch_rad = radians(2.5);
inline constexpr double quiet_roll_rad = radians(4.0);

class Instruments {
public:
    explicit Instruments(const HostLoop& loop);

    /// Writes the indications of the loop's last packet. `overruns`: of the frame clock, so far. Speeds are those since the call
    /// before; a frame that is not later has none.
    void read(const HostLoop& loop, const FramePacket& packet, std::uint64_t overruns,
              IndicationStore& store);

private:
    void read_own_ship(const Pose& pose, double passed_s, IndicationStore& store);
    void read_ships(const FramePacket& packet, double passed_s, IndicationStore& store);
    void read_sea(const FramePacket& packet, IndicationStore& store) const;
    void read_clock(const FramePacket& packet, std::uint64_t overruns, IndicationStore& store);
    std::size_t nearest(const FramePacket& packet) const;

    std::vector<std::uint32_t> ships_;
    std::optional<std::uint32_t> sea_sun_;
    std::uint64_t frames_per_second_;
    std::uint64_t overruns_ = 0;
    std::uint64_t calls_since_overrun_;
    double time_s_ = 0.0; ///< of the call before
    Vec3d own_ship_m_{0};
    std::vector<Vec3d> ships_m_;  ///< parallel to ships_, as is the next
    std::vector<double> quiet_s_; ///< how long each has lain quietly
    bool begun_ = false;
};

} // namespace linkdig::host
