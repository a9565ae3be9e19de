#pragma once
/// The host's loop: from a frame number and the signals to the frame packet.

#include "host/loop/face_sequence.h"
#include "host/motion/approach_path.h"
#include "host/motion/daylight.h"
#include "host/motion/ship.h"
#include "host/motion/sun.h"
#include "host/packet/frame_packet.h"
#include "host/scenario/bind.h"
#include "host/scenario/scenario.h"
#include "host/signals/signals.h"

#include <cstdint>
#include <vector>

namespace linkdig::host {

/// What the view signal turns all channels by, off the own ship's nose: ahead, left, right, down. Estimated:
/// side by side windows of about 48 degrees, looked at a little further out, and a chin window.
inline constexpr std::array<Attitude, 4> view_offsets{Attitude{}, Attitude{.heading_rad = radians(60.0)},
                                                      Attitude{.heading_rad = radians(-60.0)},
                                                      Attitude{.pitch_rad = radians(-45.0)}};

class HostLoop {
public:
    /// All rates of the scenario are per second and converted here: the flight is the same at every update
    /// rate. `picture_aspect` (width / height) gives the vertical field of channels that have none of their
    /// own. Throws std::invalid_argument, with the diagnostics of bind() as text, if a name is not in the
    /// directory, and if the rate or the aspect is not above 0.
    HostLoop(const Scenario& scenario, const NameDirectory& directory, double update_rate_hz,
             double picture_aspect = 4.0 / 3.0);

    /// The packet of a simulated frame: a pure function of the frame number and the signals. Valid until the
    /// next call. Nothing is allocated after the first call.
    const FramePacket& packet(std::uint64_t frame, const SignalValues& signals);

    /// The signals with another sea_sun_rate, and with sea_sun_azimuth so that turning suns stand where they
    /// stood in this frame: the sea changes its pace without a jump. Exact for the first turning sun.
    SignalValues with_sea_sun_rate(const SignalValues& signals, double rate, std::uint64_t frame) const;

    /// Frames of the whole scenario, at least 1.
    std::uint64_t frames() const { return frames_; }
    double update_rate_hz() const { return update_rate_hz_; }

private:
    struct TurningSun {
        std::uint32_t row;
        OceanSun sun;
    };
    struct Ship {
        std::uint32_t row;
        ShipTrack track;
        ShipMotion motion;
    };
    /// What the time of day starts from.
    struct Day {
        double hour = 12.0;
        double hours_per_s = 0.0;
        double lamps_by_day = 0.3;
        Vec3f sky{0};
        std::vector<Colour> colours;      ///< the database's
        std::vector<std::uint32_t> bands; ///< of them the sky's, from the horizon up
    };
    struct Pointer {
        std::uint32_t slot;
        FaceSequence sequence;
    };

    void place_suns(const Scenario& scenario, const Binding& binding);
    void place_ships(const Scenario& scenario, const Binding& binding);
    void place_channels(const Scenario& scenario, double picture_aspect);
    void start_sequences(const Scenario& scenario, const Binding& binding);
    void choose_approach(const Scenario& scenario);
    void fill_constants(const Scenario& scenario);
    void light_without_smoothing(const NameDirectory& directory, const Binding& binding);
    void remember_day(const Scenario& scenario, const NameDirectory& directory, const Binding& binding);

    void turn_suns(std::uint64_t frame, const SignalValues& signals);
    void move_ships(double time_s, const SignalValues& signals);
    void point_slots(std::uint64_t frame);
    void look(double time_s, const SignalValues& signals);
    void shade(const SignalValues& signals);
    void see(const SignalValues& signals);
    void pass_day(const SignalValues& signals);
    void colour(const Daylight& light);
    void dim(const Daylight& light, const SignalValues& signals);

    double update_rate_hz_;
    std::uint64_t frames_ = 1;
    std::vector<TurningSun> turning_suns_;
    std::vector<Ship> ships_;
    std::vector<Pointer> pointers_;
    std::vector<Attitude> mounts_; ///< of the channels on the own ship
    ApproachPath approach_;
    std::size_t approached_ = 0; ///< index into ships_
    double visibility_m_ = 0.0;
    Day day_;
    std::vector<ListLighting> without_smoothing_;
    FramePacket packet_;
};

} // namespace linkdig::host
