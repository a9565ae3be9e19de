#pragma once
/// The host's loop: from a frame number and the signals to the frame packet.

#include "host/loop/face_sequence.h"
#include "host/loop/own_ship.h"
#include "host/loop/ship_methods.h"
#include "host/motion/daylight.h"
#include "host/motion/ship.h"
#include "host/motion/sun.h"
#include "host/packet/frame_packet.h"
#include "host/scenario/bind.h"
#include "host/scenario/scenario.h"
#include "host/signals/signals.h"

#include <cstdint>
#include <optional>
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

    /// The packet of a simulated frame: a pure function of the frame number and the signals, and, while the own ship is flown by
    /// hand, of her state in the frame before. Valid until the next call. Nothing is allocated after the first call of each
    /// sea method.
    const FramePacket& packet(std::uint64_t frame, const SignalValues& signals);

    /// Takes up a flight where a packet of it stands: the next frame follows that packet's.
    void resume(const FramePacket& packet);

    /// The signals with another sea_sun_rate, and with sea_sun_azimuth so that turning suns stand where they
    /// stood in this frame: the sea changes its pace without a jump. Exact for the first of the sea's suns.
    SignalValues with_sea_sun_rate(const SignalValues& signals, double rate, std::uint64_t frame) const;
    /// The same for the other increment: sea_sun_elevation_rate, with sea_sun_elevation_phase.
    SignalValues with_sea_sun_elevation_rate(const SignalValues& signals, double rate_rad_s,
                                             std::uint64_t frame) const;

    /// The same for the ships: ship_speed, with ship_way.
    SignalValues with_ship_speed(const SignalValues& signals, double factor, std::uint64_t frame) const;

    /// What each ship shows and can show, in the scenario's order; names as in the scenario.
    const std::vector<ShipMethods>& ship_methods() const { return methods_; }
    const std::vector<std::string>& ship_names() const { return ship_names_; }
    bool can_turn_normals() const { return !sea_normals_.empty(); }
    SeaMethod sea_method(const SignalValues& signals) const;

    /// Of the scenario.
    std::size_t channels() const { return mounts_.size(); }
    /// Frames of the whole scenario, at least 1.
    std::uint64_t frames() const { return frames_; }
    double update_rate_hz() const { return update_rate_hz_; }

    /// Where the own ship was in the last packet; a channel's attitude is hers with the view and its mount.
    const Pose& own_ship() const { return pose_; }
    /// Rows of FramePacket::moving_objects that are the scenario's ships, in its order.
    std::vector<std::uint32_t> ship_rows() const;
    /// Row of FramePacket::suns of the first sun that the sea's signals reach, if there is one.
    std::optional<std::uint32_t> sea_sun_row() const {
        return sea_suns_.empty() ? std::nullopt : std::optional(sea_suns_.front().row);
    }

private:
    struct TurningSun {
        std::uint32_t row;
        OceanSun sun;
    };
    struct Ship {
        std::uint32_t row;
        ShipTrack track;
        ShipMover mover;
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
    void check_ways(const Scenario& scenario, const NameDirectory& directory) const;
    void choose_sea(const Scenario& scenario, const NameDirectory& directory, const Binding& binding);
    void begin_own_ship(const Scenario& scenario);
    static OwnShipProgram program_of(const Scenario& scenario);
    static ShipTrack track_of(const Scenario& scenario, const std::string& moving_object);
    void place_channels(const Scenario& scenario, double picture_aspect);
    void start_sequences(const Scenario& scenario, const Binding& binding);
    void fill_constants(const Scenario& scenario);
    void light_without_smoothing(const NameDirectory& directory, const Binding& binding);
    void remember_day(const Scenario& scenario, const NameDirectory& directory, const Binding& binding);

    void turn_suns(std::uint64_t frame, const SignalValues& signals);
    SunPosition sea_sun(const TurningSun& sun, std::uint64_t frame, const SignalValues& signals) const;
    void turn_the_normals(std::uint64_t frame, const SignalValues& signals);
    void move_ships(double time_s, const SignalValues& signals);
    void point_slots(std::uint64_t frame, const SignalValues& signals);
    void look(std::uint64_t frame, const SignalValues& signals);
    void shade(const SignalValues& signals);
    void see(const SignalValues& signals);
    void pass_day(const SignalValues& signals);
    void colour(const Daylight& light);
    void dim(const Daylight& light, const SignalValues& signals);

    double update_rate_hz_;
    std::uint64_t frames_ = 1;
    std::vector<TurningSun> sea_suns_;   ///< that the signals reach
    std::vector<TurningSun> other_suns_; ///< turning ones that they leave alone: the churned water's
    std::vector<Ship> ships_;
    std::vector<Pointer> pointers_;
    std::vector<Attitude> mounts_; ///< of the channels on the own ship
    OwnShip own_ship_;
    Pose pose_;
    std::vector<ShipMethods> methods_; ///< parallel to ships_
    std::vector<std::string> ship_names_;
    SeaMethod sea_method_ = SeaMethod::sun;
    std::uint32_t normals_every_ = 1;
    std::uint32_t sea_sun_row_ = 0; ///< of the sea's list
    std::vector<Vec3f> sea_normals_;
    VertexNormalUpdate sea_update_; ///< while the packet has none
    float sea_state_ = 0.0F;
    double visibility_m_ = 0.0;
    Day day_;
    std::vector<ListLighting> without_smoothing_;
    FramePacket packet_;
};

} // namespace linkdig::host
