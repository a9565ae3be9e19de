#pragma once
/// A scenario of database/scenes, set up for pictures that are measured: any
/// eye, any change of the packet.

#include "tools/flight/flight.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::tools {

struct StageOptions {
    std::uint32_t width = 640;
    std::uint32_t height = 480;
    bool edge_smoothing = false; ///< off: every pixel is one face's alone
    std::uint32_t threads = 0;
};

class Stage {
public:
    /// `scenario` below the shipped scenes, or an absolute path. 30 updates a
    /// second. Throws as Flight does.
    explicit Stage(const std::string& scenario, const StageOptions& options = {});

    /// The scenario's packet of a frame, to be changed and drawn.
    FramePacket packet(std::uint64_t frame, const host::SignalValues& signals = {});
    /// Draws it, with the planes of intensity and rank. Throws std::logic_error
    /// if it is refused.
    const ig::VideoFrame& draw(const FramePacket& packet);

    /// The sun that lights the list "sea", as a row of the packet.
    std::uint32_t sea_sun() const;
    /// Points a slot at an alternative; false if the database has no such slot.
    bool point(FramePacket& packet, const std::string& slot, std::uint32_t alternative) const;
    std::uint32_t alternatives(const std::string& slot) const; ///< 0: no such slot
    /// A moving object's row in the packet. Throws std::bad_optional_access if the database has none of that name.
    std::size_t moving_object(const std::string& name) const;

    /// 1 where a list whose name begins with one of these is seen in the last
    /// picture.
    std::vector<std::uint8_t> mask(std::span<const std::string_view> lists) const;

    const VisualDatabase& database() const { return flight_.database(); }
    Flight& flight() { return flight_; }

private:
    Flight flight_;
    database::NameDirectory directory_;
};

/// Puts the eye of channel 0 somewhere, and lets it look at a point of the
/// world; a picture of 4 to 3.
void look(FramePacket& packet, const Vec3d& eye_m, const Vec3d& aim_m, double horizontal_field_deg);
/// The same in the waterline frame of a moving object.
void look_beside(FramePacket& packet, std::size_t moving_object, const Vec3d& eye_m, const Vec3d& aim_m,
                 double horizontal_field_deg);

/// The ray through a place of a channel's picture (0 to 1 from the left, from the top), not of unit length.
/// `world_from_eye`: world_from_body() of its attitude.
Vec3d ray_through(const ChannelView& channel, const Mat3d& world_from_eye, double across, double down);

} // namespace linkdig::tools
