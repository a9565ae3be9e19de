/// Ship and sea (report, 3.3): each occulting method against the ray caster,
/// and Figure 15.

#include "host/loop/ship_methods.h"
#include "tools/figures/figures.h"
#include "tools/figures/ray_caster.h"
#include "tools/figures/stage.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

namespace linkdig::tools {
namespace {

using host::Occulting;
using host::Signal;
using host::SignalValues;

constexpr StageOptions small{.width = 320, .height = 240};

/// Two kinds of error, in pixels of the small picture.
struct Errors {
    double shown = 0.0;   ///< hull where water should hide it
    double missing = 0.0; ///< hull or sea that is not there
    void operator+=(const Errors& other) {
        shown += other.shown;
        missing += other.missing;
    }
};

class Comparison {
public:
    Comparison()
        : stage_("report/methods.toml", small), ship_(ship_triangles(stage_.database(), "lph2")),
          below_(ship_triangles(stage_.database(), "lph2", ShipPart::below_waterline)),
          row_(stage_.moving_object("lph2")) {
        wakes_away_.set(Signal::face_substitution,
                        1.0); // what the scenario shows is changed over
        wakes_away_.set(Signal::churned, 1.0);
    }

    /// The ship still, with an attitude, under a method.
    FramePacket posed(Occulting method, double pitch_deg, double roll_deg) {
        SignalValues signals = wakes_away_;
        signals.set(Signal::occulting, static_cast<double>(method) + 1.0);
        signals.set(Signal::ship_motion, 0.0);
        FramePacket packet = stage_.packet(0, signals);
        MovingObject& ship = packet.moving_objects[row_];
        ship.attitude.pitch_rad = radians(pitch_deg);
        ship.attitude.roll_rad = radians(roll_deg);
        if (method != Occulting::wedges) return packet;
        const auto wedge = [&](const char* slot, double risen_rad) {
            const std::uint32_t alternatives = stage_.alternatives(slot);
            if (alternatives > 0) stage_.point(packet, slot, host::wedge_index(risen_rad, alternatives - 1));
        };
        wedge("lph2.wedge_bow", ship.attitude.pitch_rad);
        wedge("lph2.wedge_stern", -ship.attitude.pitch_rad);
        return packet;
    }

    void look_from(FramePacket& packet, const Vec3d& eye_m, const Vec3d& aim_m, double field_deg) const {
        look_beside(packet, row_, eye_m, aim_m, field_deg);
    }

    const std::vector<Hit>& expect(const FramePacket& packet) {
        expected_ = cast(ship_, packet.moving_objects[row_], packet.channels[0], small.width, small.height);
        return expected_;
    }

    /// Against the last expect(); pixels at whose side something else is expected
    /// are left out, and with `asked` those where the ship is expected and `asked` has none.
    Errors errors(const FramePacket& packet, std::span<const Hit> asked = {}) {
        stage_.draw(packet);
        constexpr std::array<std::string_view, 2> sea{"sea", "lph2.box"};
        constexpr std::array<std::string_view, 1> hull{"lph2"};
        const std::vector<std::uint8_t> water = stage_.mask(sea);
        const std::vector<std::uint8_t> ship = stage_.mask(hull);
        Errors errors;
        for (std::size_t i = small.width + 1; i + small.width + 1 < expected_.size(); ++i) {
            const Hit should = expected_[i];
            bool border = false;
            for (const std::size_t beside : {i - 1, i + 1, i - small.width, i + small.width})
                border = border || expected_[beside] != should;
            const bool left_out = !asked.empty() && should == Hit::ship && asked[i] != Hit::ship;
            if (border || left_out) continue;
            const Hit is = water[i] != 0 ? Hit::sea : ship[i] != 0 ? Hit::ship : Hit::sky;
            errors.shown += should == Hit::sea && is == Hit::ship ? 1.0 : 0.0;
            errors.missing +=
                (should == Hit::ship && is != Hit::ship) || (should == Hit::sea && is == Hit::sky) ? 1.0
                                                                                                   : 0.0;
        }
        return errors;
    }

    /// Pixels between waterline and water that show neither hull nor water, against the last expect(): only where
    /// the hull below the waterline would be seen, so that an antenna's edge is no gap.
    double gaps(const FramePacket& packet) {
        const std::vector<Hit> below =
            cast(below_, packet.moving_objects[row_], packet.channels[0], small.width, small.height);
        return errors(packet, below).missing;
    }

    bool can(Occulting method) { return stage_.flight().loop().ship_methods().front().can(method); }

private:
    Stage stage_;
    ShipTriangles ship_;
    ShipTriangles below_;
    std::size_t row_;
    SignalValues wakes_away_;
    std::vector<Hit> expected_;
};

constexpr std::array heights_m{2.0, 10.0, 50.0, 200.0};

/// Bearings and attitudes over which the errors of a method are averaged.
struct Range {
    std::vector<double> bearings_deg, pitches_deg, rolls_deg;
};

Range range_of(bool quick) {
    if (quick) return {{35.0, 150.0}, {-10.0, 10.0}, {0.0}};
    return {{35.0, 90.0, 150.0}, {-10.0, -5.0, 0.0, 5.0, 10.0}, {-6.8, 0.0, 6.8}};
}

/// Mean over the attitudes, from abaft, abeam and before, at about 250 m.
Errors mean_errors(Comparison& comparison, const Range& range, Occulting method, double height_m) {
    Errors sum;
    double pictures = 0.0;
    for (const double bearing_deg : range.bearings_deg) {
        const Vec3d eye = direction(radians(bearing_deg), 0.0) * 250.0 + Vec3d(0, 0, height_m);
        for (const double pitch : range.pitches_deg) {
            for (const double roll : range.rolls_deg) {
                FramePacket packet = comparison.posed(method, pitch, roll);
                comparison.look_from(packet, eye, {0, 0, 8}, 50.0);
                comparison.expect(packet);
                sum += comparison.errors(packet);
                pictures += 1.0;
            }
        }
    }
    return {sum.shown / pictures, sum.missing / pictures};
}

void table_of_methods(Comparison& comparison, Findings& findings) {
    const Range range = range_of(findings.quick());
    Table table{
        fmt::format("Occulting (3.3): pixels of 320 x 240 that show hull where water should hide it / that "
                    "miss hull or sea; mean over pitch {:g}, roll {:g} degrees, seen from {:g} degrees "
                    "off the bow at 250 m",
                    fmt::join(range.pitches_deg, ", "), fmt::join(range.rolls_deg, ", "),
                    fmt::join(range.bearings_deg, ", ")),
        {"method", "2 m", "10 m", "50 m", "200 m"},
        {}};
    Errors box[heights_m.size()];
    Errors fitted[heights_m.size()];
    for (std::size_t m = 0; m < host::occulting_names.size(); ++m) {
        const auto method = static_cast<Occulting>(m);
        if (!comparison.can(method)) continue;
        std::vector<std::string> row{host::occulting_names[m]};
        for (std::size_t h = 0; h < heights_m.size(); ++h) {
            const Errors found = mean_errors(comparison, range, method, heights_m[h]);
            row.push_back(fmt::format("{:.0f} / {:.0f}", found.shown, found.missing));
            if (method == Occulting::box) box[h] = found;
            if (method == Occulting::fitted_box) fitted[h] = found;
        }
        table.rows.push_back(std::move(row));
    }
    findings.table(std::move(table));
    const auto all = [](const Errors& errors) { return errors.shown + errors.missing; };
    findings.at_least("3.3.1.1", "plain box: errors from 200 m over those from 2 m",
                      all(box[3]) / std::max(1.0, all(box[0])), 1.0);
    findings.at_most("3.3.1.1", "fitted over plain box: what their errors grow by from 2 to 200 m",
                     (all(fitted[3]) - all(fitted[0])) / std::max(1.0, all(box[3]) - all(box[0])), 1.0);
}

void wedge_gaps(Comparison& comparison, Findings& findings) {
    double gaps = 0.0;
    double without = 0.0;
    const double step = findings.quick() ? 4.0 : 1.0;
    for (double pitch = -10.0; pitch <= 10.0; pitch += step) {
        const double end = pitch >= 0.0 ? 1.0 : -1.0; // the one that rises
        const Vec3d eye(end * 140.0, 70.0, 2.0);
        const Vec3d aim(end * 70.0, 0.0, 3.0);
        for (const Occulting method : {Occulting::wedges, Occulting::waterline}) {
            FramePacket packet = comparison.posed(method, pitch, 0.0);
            comparison.look_from(packet, eye, aim, 50.0);
            comparison.expect(packet);
            (method == Occulting::wedges ? gaps : without) += comparison.gaps(packet);
        }
    }
    findings.at_most("15", "gap pixels under bow and stern, pitch -10 to 10 degrees, with wedges", gaps, 0.0);
    findings.at_least("15", "the same without wedges", without, 100.0);
}

} // namespace

void occulting(Findings& findings) {
    Comparison comparison;
    table_of_methods(comparison, findings);
    if (comparison.can(Occulting::wedges)) wedge_gaps(comparison, findings);
    Stage stage("report/methods.toml");
    for (std::size_t m = 0; m < host::occulting_names.size(); ++m) {
        FramePacket packet = comparison.posed(static_cast<Occulting>(m), 8.0, 4.0);
        comparison.look_from(packet, {150, 80, 4}, {45, 0, 9}, 50.0);
        const ig::VideoFrame& picture = stage.draw(packet);
        findings.picture(fmt::format("occulting_{}", host::occulting_names[m]), picture);
        if (static_cast<Occulting>(m) == Occulting::wedges) findings.picture("figure_15", picture);
    }
}

} // namespace linkdig::tools
