#pragma once
/// What the machine is built as: two profiles, and the constants of its number formats.
///
/// Labels: S sourced, CK common knowledge, EST estimated (see docs/sources.md). An estimated figure is not history.

#include <cstdint>

namespace linkdig::ig {

/// Which way the beam runs. A *line* runs along the scan, an *element* is a pixel on it.
enum class Scan : std::uint8_t { horizontal, vertical };

/// Raster of one channel. Width and height are those of the picture as a viewer sees it, in pixels, 1 to 4096.
struct Raster {
    std::uint32_t width = 1024;
    std::uint32_t height = 1024;
    Scan scan = Scan::horizontal;
    std::uint32_t lines() const { return scan == Scan::horizontal ? height : width; }
    std::uint32_t elements() const { return scan == Scan::horizontal ? width : height; }
    bool operator==(const Raster&) const = default;
};

/// What the machine takes of one frame; 0: whatever comes. Beyond a limit the frame is completed all the same, and the
/// frames after it are drawn with less detail (ig/active/shedding.h). What the machine of 1979 took is not known: no
/// profile sets a limit.
struct Capacity {
    std::uint64_t edges = 0;               ///< of all channels together
    std::uint64_t crossings_on_a_line = 0; ///< edges that span one line, seen or hidden
    std::uint64_t light_points = 0;        ///< that shine into a picture, of all channels together
    bool limited() const { return edges != 0 || crossings_on_a_line != 0 || light_points != 0; }
};

struct Configuration {
    const char* name = "modern";
    Raster raster{};
    double update_rate_hz = 60.0;
    /// Whole update periods between a packet and the first line of its picture. Modelled time: frame N of a dump is the
    /// picture of packet N, the delay belongs to display and report.
    std::uint32_t pipeline_updates = 0;
    /// Fields that a picture is scanned out in: 2 with 2:1 interlace.
    std::uint32_t fields = 1;
    /// Pixels that an edge crosses show each face by its share of their area.
    bool edge_smoothing = false;
    Capacity capacity{};
    /// Threads that project parts of the faces and draw bands; 0: as many as the machine has. The picture does not depend on it.
    std::uint32_t threads = 0;
};

/// `modern`: horizontal scan, 60 Hz progressive, 1024 x 1024, smoothed edges.
inline Configuration modern_profile() { return {.edge_smoothing = true}; }

/// `ames`: vertical scan (S: report, section 1.0); 30 Hz update (CK: norm of the time); raster size estimated (EST: it
/// could not be established; a 4:3 picture of roughly a thousand lines of the period). Two updates of computing and one of
/// scanning out (EST: gives the 83 ms at mid-screen that are remembered, CK low, of the simulator's reports). Smoothed edges are the maker's
/// design style of those years (S: US 4208719, filed 1978, and US 4371872, filed 1979), for this machine estimated.
inline Configuration ames_profile() {
    return {.name = "ames",
            .raster = {.width = 768, .height = 576, .scan = Scan::vertical},
            .update_rate_hz = 30.0,
            .pipeline_updates = 2,
            .fields = 2,
            .edge_smoothing = true};
}

/// When a field's first and last line are shown, counted from the packet.
struct FieldTimes {
    double first_line_s = 0.0;
    double last_line_s = 0.0;
};

/// Both fields of an update show one packet: field f has lines f, f + fields, f + 2 fields ..., scanned out evenly, one
/// field after the other over one update. A line is shown when the beam begins it.
inline FieldTimes field_times(const Configuration& configuration, std::uint32_t field) {
    const double field_s = 1.0 / (configuration.update_rate_hz * configuration.fields);
    const double first = configuration.pipeline_updates / configuration.update_rate_hz + field * field_s;
    const std::uint32_t lines = configuration.raster.lines();
    const std::uint32_t lines_of_field = (lines + configuration.fields - 1 - field) / configuration.fields;
    return {first, lines_of_field == 0 ? first : first + field_s * (lines_of_field - 1) / lines_of_field};
}

/// From a packet to the middle of the time for which its picture is scanned out.
inline double mid_screen_delay_s(const Configuration& configuration) {
    return (configuration.pipeline_updates + 0.5) / configuration.update_rate_hz;
}

/// Largest raster side, and so the bound of every fixed-point format below.
inline constexpr std::uint32_t max_raster_side = 4096;

/// Near plane, metres before the eye. Only this plane clips in 3D.
inline constexpr double near_plane_m = 0.25;

} // namespace linkdig::ig
