#pragma once
/// A ship's methods in a frame: which alternative each of her slots points at (report, 3.2 and 3.3).

#include "host/loop/face_sequence.h"
#include "host/packet/frame_packet.h"
#include "host/scenario/bind_methods.h"
#include "host/signals/signals.h"

namespace linkdig::host {

/// Greatest pitch, up or down, for which the wedges fill the gap: what the report drove the ship at (3.3.2).
inline constexpr double wedge_range_rad = radians(10.0);

/// Which of `wedges` growing wedges stands under an end of the ship that has risen by an angle: 0 none, 1 to wedges. The
/// k-th reaches k / wedges of the range, so that the gap is always filled.
std::uint32_t wedge_index(double risen_rad, std::uint32_t wedges);

class ShipMethods {
public:
    ShipMethods(const MethodsSection& section, const ShipSlots& slots, const std::string& ship,
                double update_rate_hz);

    /// Appends the ship's substitutions and, if she goes behind the sea, her priority. Nothing at all while neither the
    /// scenario nor a signal names a method.
    void put(const MovingObject& ship, const SignalValues& signals, std::uint64_t frame,
             FramePacket& packet) const;
    /// Asks for the wakes that the machine makes itself, of a ship of this speed.
    void put_made_wakes(const SignalValues& signals, double speed_mps, FramePacket& packet) const;
    /// Lights her lights, if she has any, or leaves them dark.
    void put_lights(bool full_day, FramePacket& packet) const;
    /// Rolls her cams, if she has any.
    void roll_cams(const MovingObject& ship, const SignalValues& signals, std::uint64_t frame,
                   FramePacket& packet) const;

    Occulting occulting(const SignalValues& signals) const;
    bool shows(Wake wake, const SignalValues& signals) const;
    bool can(Occulting occulting) const { return can_occult_[static_cast<std::size_t>(occulting)]; }
    bool can(Wake wake) const { return can_wake_[static_cast<std::size_t>(wake)]; }
    std::size_t most_rows() const { return 12; }

private:
    bool named(const SignalValues& signals) const;
    void put_occulting(const MovingObject& ship, Occulting method, FramePacket& packet) const;
    void put_wakes(const SignalValues& signals, std::uint64_t frame, FramePacket& packet) const;

    MethodsSection section_;
    ShipSlots slots_;
    std::array<bool, occulting_names.size()> can_occult_{};
    Wakes can_wake_{};
    FaceSequence port_, starboard_, solid_;
    double frames_per_roll_ = 1.0;
};

} // namespace linkdig::host
