/// The sea: Figures 1 to 7, and the steps of a sea whose normals are not
/// updated in every frame.

#include "host/packet/packet_json.h"
#include "ig/geometry/projected_face.h"
#include "tools/figures/figures.h"
#include "tools/figures/measures.h"
#include "tools/figures/stage.h"
#include "tools/sheet/contact_sheet.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace linkdig::tools {
namespace {

using host::Signal;
using host::SignalValues;

constexpr std::array<std::string_view, 2> sea_lists{"sea", "mounds"};

SignalValues with(Signal signal, double value) {
    SignalValues signals;
    signals.set(signal, value);
    return signals;
}

double still_gradient(const std::string& scenario, const std::string& name, Findings& findings) {
    Stage stage(scenario);
    const ig::VideoFrame& picture = stage.draw(stage.packet(0));
    findings.picture(name, picture);
    return rms_gradient(picture, stage.mask(sea_lists));
}

int still_step(const std::string& scenario, const std::string& name, Findings& findings) {
    Stage stage(scenario);
    const ig::VideoFrame& picture = stage.draw(stage.packet(0));
    findings.picture(name, picture);
    return greatest_step(picture, stage.mask(sea_lists), picture.height * 3 / 4);
}

/// The largest and the usual change from frame to frame of a sea whose normals
/// are held for so many frames.
struct Stepping {
    double largest = 0.0;
    double mean = 0.0;
};

Stepping stepping_of(Stage& stage, double every, std::uint64_t frames) {
    SignalValues signals = with(Signal::sea_method, 1.0);
    signals.set(Signal::normals_every, every);
    Stepping found;
    ig::VideoFrame before = stage.draw(stage.packet(0, signals));
    const std::vector<std::uint8_t> mask = stage.mask(sea_lists);
    for (std::uint64_t frame = 1; frame <= frames; ++frame) {
        const ig::VideoFrame& now = stage.draw(stage.packet(frame, signals));
        const double change = rms_change(before, now, mask);
        found.largest = std::max(found.largest, change);
        found.mean += change / static_cast<double>(frames);
        before = now;
    }
    return found;
}

/// Half the range through which any pixel swings in a turn of the sea's sun, as
/// intensity.
double amplitude(Stage& stage, double elevation_rad, int steps) {
    FramePacket packet = stage.packet(0);
    look(packet, {4, 4, 20}, {4.001, 4, 0}, 60.0);
    std::vector<std::int32_t> least;
    std::vector<std::int32_t> greatest;
    for (int step = 0; step < steps; ++step) {
        packet.suns[stage.sea_sun()] = Vec3f(direction(two_pi * step / steps, elevation_rad));
        const std::vector<std::int32_t>& now = stage.draw(packet).intensity;
        if (step == 0) least = greatest = now;
        for (std::size_t i = 0; i < now.size(); ++i) {
            least[i] = std::min(least[i], now[i]);
            greatest[i] = std::max(greatest[i], now[i]);
        }
    }
    std::int32_t widest = 0;
    for (std::size_t i = 0; i < least.size(); ++i)
        widest = std::max(widest, greatest[i] - least[i]);
    return widest / 2.0 / ig::intensity_one;
}

/// What n . s >= 0 leaves of the swing between sin a sin e + cos a cos e and
/// sin a sin e - cos a cos e.
double predicted(double vertical_rad, double elevation_rad) {
    const double mean = sine(vertical_rad) * sine(elevation_rad);
    const double swing = cosine(vertical_rad) * cosine(elevation_rad);
    return (std::max(0.0, mean + swing) - std::max(0.0, mean - swing)) / 2.0;
}

/// A sea of squares and a period of one's own: STEM.toml and its database, compiled from texts made here.
void write_sized_sea(const std::string& stem, double cell_m, std::uint32_t period) {
    std::ofstream(stem + "_database.toml")
        << fmt::format("[database]\nname = \"sized\"\n[[sun]]\nname = "
                       "\"ocean\"\n[[colour]]\nname = \"sea\"\nrgb = [58, 117, 149]\n"
                       "[[cluster]]\nname = \"sea\"\npriority = 20\n[[object_list]]\nname = "
                       "\"sea\"\ncluster = \"sea\"\nframe = \"world\"\n"
                       "sun = \"ocean\"\nambient = 0.35\ndiffuse = 0.65\n[[tile]]\nlist = "
                       "\"sea\"\nperiod = {}\ncell_m = {:g}\nrings = 8\n"
                       "fine_levels = 2\nhalf_width = 16\nvertical_angle_deg = 68.0\ncolour = "
                       "\"sea\"\nseed = 1979\npattern = \"random\"\n",
                       period, cell_m);
    std::ofstream(stem + ".toml") << fmt::format(
        "[scenario]\nname = \"sized\"\ndatabase = "
        "\"{}_database.toml\"\nduration_s = 5.0\n[suns.ocean]\n"
        "azimuth_deg = 60.0\nelevation_deg = 24.0\nazimuth_rate_deg_s = "
        "72.0\n[own_ship]\nkind = \"fixed\"\n"
        "position_m = [0.0, 0.0, 30.0]\naim_m = [120.0, 0.0, "
        "0.0]\n[[channel]]\nname = \"ahead\"\n"
        "horizontal_field_deg = 56.0\n[sky]\nrgb = [187, 207, 221]\n",
        std::filesystem::path(stem).filename().string());
}

void sheet_of_sizes(Findings& findings) {
    const std::string stem = std::filesystem::absolute(findings.folder() + "/sized_sea").string();
    ContactSheet sheet("3.1.4: size of the squares (down: 2, 8, 32 m) and "
                       "repetition (across: 4, 8, 16, 64 squares)",
                       640, 480);
    std::uint32_t place = 0;
    for (const double cell_m : {2.0, 8.0, 32.0}) {
        for (const std::uint32_t period : {4U, 8U, 16U, 64U}) {
            write_sized_sea(stem, cell_m, period);
            Stage stage(stem + ".toml");
            sheet.place(place++, stage.draw(stage.packet(0)),
                        fmt::format("{:g} m, {:g} m again", cell_m, cell_m * period));
        }
    }
    sheet.write(findings.folder() + "/sizes.png");
    for (const char* ending : {".toml", "_database.toml"})
        std::filesystem::remove(stem + ending);
}

} // namespace

void static_seas(Findings& findings) {
    const double flat = still_gradient("report/mounds.toml", "figure_01_flat", findings);
    const double smooth = still_gradient("report/mounds_smooth.toml", "figure_01", findings);
    findings.at_least("1", "gradient of the flat-shaded mounds, rms levels a pixel", flat, 0.5);
    findings.at_most("1", "gradient smooth over flat", smooth / flat, 1.0 / 3.0);
    findings.at_least("2", "greatest step across face borders, flat, levels",
                      still_step("report/regular.toml", "figure_02", findings), 3.0);
    findings.at_most("3", "greatest step across face borders, smooth, levels",
                     still_step("report/regular_smooth.toml", "figure_03", findings), 2.0);
    for (const char* remedy : {"outlined", "checkered", "exaggerated"}) {
        Stage stage(fmt::format("report/mounds_{}.toml", remedy));
        findings.picture(fmt::format("mounds_{}", remedy), stage.draw(stage.packet(0)));
    }
}

void stepping(Findings& findings) {
    Stage stage("report/confused.toml");
    Table table{"Normals updated every n frames (3.1.4): change of the picture "
                "from frame to frame, rms levels",
                {"frames", "largest", "mean"},
                {}};
    double every_frame = 0.0;
    for (const double every : {1.0, 2.0, 4.0, 8.0}) {
        const Stepping found = stepping_of(stage, every, findings.quick() ? 8 : 24);
        table.rows.push_back({fmt::format("{:g}", every), fmt::format("{:.2f}", found.largest),
                              fmt::format("{:.2f}", found.mean)});
        if (every == 1.0)
            every_frame = found.largest;
        else
            findings.at_least("3.1.4",
                              fmt::format("largest step, normals every {:g} frames over every frame", every),
                              found.largest / every_frame, 0.8 * every);
    }
    findings.table(std::move(table));
    if (!findings.quick()) sheet_of_sizes(findings);
}

void sea_states(Findings& findings) {
    const int steps = findings.quick() ? 36 : 72;
    Stage stage("report/confused.toml");
    const double vertical = static_cast<double>(stage.database().tiles.front().vertical_angle_rad);
    const double diffuse =
        static_cast<double>(stage.database().lists[stage.database().tiles.front().list].diffuse);
    for (const auto& [figure, state] : {std::pair{4, 1.0}, std::pair{5, 2.0}, std::pair{6, 3.0}})
        findings.picture(fmt::format("figure_{:02}", figure),
                         stage.draw(stage.packet(0, with(Signal::sea_state, state))));
    findings.at_most("4", "contrast at 90 degrees, intensity", amplitude(stage, pi / 2.0, steps), 0.0);
    for (const auto& [figure, elevation_deg] :
         {std::pair{"5", 60.0}, std::pair{"6", 24.0}, std::pair{"6", 40.0}}) {
        const double e = radians(elevation_deg);
        findings.between(figure, fmt::format("amplitude over cos a cos e at {:g} degrees", elevation_deg),
                         amplitude(stage, e, steps) / (diffuse * cosine(vertical) * cosine(e)), 0.99, 1.01);
    }
    const double low = radians(10.0);
    findings.between("6", "amplitude over the clamped one at 10 degrees",
                     amplitude(stage, low, steps) / (diffuse * predicted(vertical, low)), 0.99, 1.01);
}

void ocean_sun(Findings& findings) {
    Stage stage("report/confused.toml");
    const std::uint32_t ocean = stage.sea_sun();
    std::ofstream log(findings.folder() + "/figure_07_packets.jsonl");
    SignalValues signals;
    signals.set(Signal::sea_sun_elevation_rate, radians(-3.0));
    FramePacket before = stage.packet(0, signals);
    double azimuth_error = 0.0;
    double elevation_error = 0.0;
    double others = 0.0;
    for (std::uint64_t frame = 1; frame <= 60; ++frame) {
        const FramePacket now = stage.packet(frame, signals);
        log << to_json(now) << '\n';
        for (std::size_t row = 0; row < now.suns.size(); ++row)
            if (row != ocean && now.suns[row] != before.suns[row]) others += 1.0;
        const auto azimuth = [&](const FramePacket& packet) {
            return arc_tangent(packet.suns[ocean].y, packet.suns[ocean].x);
        };
        const auto elevation = [&](const FramePacket& packet) { return arc_sine(packet.suns[ocean].z); };
        const double turned = modulo(azimuth(before) - azimuth(now),
                                     two_pi); // clockwise, as the file counts
        azimuth_error = std::max(azimuth_error, std::fabs(turned - radians(72.0 / 30.0)));
        elevation_error =
            std::max(elevation_error, std::fabs(elevation(before) - elevation(now) - radians(3.0 / 30.0)));
        before = now;
    }
    findings.at_most("7", "other suns that moved in 60 packets", others, 0.0);
    findings.at_most("7", "error of the azimuth's increment, degrees", degrees(azimuth_error), 1e-4);
    findings.at_most("7", "error of the elevation's increment, degrees", degrees(elevation_error), 1e-4);
}

} // namespace linkdig::tools
