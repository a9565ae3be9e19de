// Wakes that the machine makes itself: within their reserve, the same for any threads and after a replay, never changing at once.

#include "database/model/mathematics.h"
#include "ig/machine/history_bytes.h"
#include "ig/machine/machine.h"
#include "ig/water/particle_wake.h"
#include "ig/water/silhouette.h"
#include "tests/ig/shipped_flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace linkdig::ig {
namespace {

Configuration small(std::uint32_t threads) {
    return {.raster = {192, 144, Scan::horizontal}, .edge_smoothing = true, .threads = threads};
}

WakeReport report_of(const FrameReport& report, std::size_t wake) {
    return wake < report.wakes.size() ? report.wakes[wake] : WakeReport{};
}

TEST(MadeWakes, StayWithinTheirReserveAndTellWhatTheyTake) {
    ShippedFlight flight = wake_flight(50.0, 20, 2.0);
    for (FramePacket& packet : flight.packets)
        for (WakeRequest& wake : packet.wakes)
            wake.most_faces = 700;
    Machine machine(flight.database, small(1));
    FrameReport last;
    for (const FramePacket& packet : flight.packets) {
        last = machine.frame(packet);
        ASSERT_TRUE(last.errors.empty()) << last.errors.front();
        ASSERT_EQ(last.wakes.size(), 4U); // two ships, two methods
        for (const WakeReport& wake : last.wakes)
            EXPECT_LE(wake.faces, 700U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_GT(report_of(last, k).faces, 50U) << k;
        EXPECT_EQ(report_of(last, k).particles > 0,
                  flight.packets.back().wakes[k].method == WakeMethod::wave_particles);
    }
    EXPECT_GT(last.wakes_s, 0.0);
    // Without them the frame has as many edges less as they are told to have.
    FramePacket without = flight.packets.back();
    without.wakes.clear();
    std::uint64_t edges = 0;
    for (const WakeReport& wake : last.wakes)
        edges += wake.edges;
    const FrameReport bare = machine.frame(without);
    EXPECT_EQ(bare.channels[0].edges + edges, last.channels[0].edges);
    EXPECT_TRUE(bare.wakes.empty());
    EXPECT_TRUE(machine.history().trails.empty());
    EXPECT_TRUE(machine.history().particle_wakes.empty());
}

// What is counted, left out under load and told by `why` goes by objects: a made face must not be taken for another list's.
TEST(MadeWakes, TheirFacesBelongToTheirOwnLists) {
    const ShippedFlight flight = wake_flight(60.0, 12, 2.0);
    Machine machine(flight.database, small(1));
    FrameReport report;
    for (const FramePacket& packet : flight.packets)
        report = machine.frame(packet);
    std::vector<std::uint64_t> made(flight.database.lists.size(), 0);
    for (std::int32_t rank = 0;; ++rank) {
        const Machine::Source source = machine.source(0, rank);
        if (source.face == nullptr) break;
        ASSERT_EQ(flight.database.objects[source.object].list, source.list) << "rank " << rank;
        ++made[source.list];
    }
    for (const WakeReport& wake : report.wakes)
        EXPECT_EQ(made[wake.list] > 0, wake.edges > 0) << flight.database.lists[wake.list].name;
}

TEST(MadeWakes, AreTheSameForAnyNumberOfThreads) {
    const ShippedFlight flight = wake_flight(60.0, 12, 2.0);
    std::vector<std::vector<std::uint32_t>> pictures;
    History history;
    for (std::uint32_t threads = 1; threads <= 8; ++threads) {
        Machine machine(flight.database, small(threads));
        for (std::size_t k = 0; k < flight.packets.size(); ++k) {
            machine.frame(flight.packets[k]);
            if (threads == 1)
                pictures.push_back(machine.picture(0).pixels);
            else
                ASSERT_EQ(machine.picture(0).pixels, pictures[k]) << threads << " threads, packet " << k;
        }
        if (threads == 1) history = machine.history();
        EXPECT_EQ(encode_history(machine.history()), encode_history(history)) << threads << " threads";
    }
}

TEST(MadeWakes, GoOnFromTheBytesOfTheirHistory) {
    const ShippedFlight flight = wake_flight(60.0, 24, 4.0);
    Machine flown(flight.database, small(1));
    for (std::size_t k = 0; k < 12; ++k)
        flown.frame(flight.packets[k]);
    const auto remembered = decode_history(encode_history(flown.history()));
    ASSERT_TRUE(remembered);
    EXPECT_EQ(remembered->trails.size(), 2U);
    ASSERT_EQ(remembered->particle_wakes.size(), 2U);
    EXPECT_FALSE(remembered->particle_wakes[0].particles.empty());
    Machine taken_up(flight.database, small(1));
    taken_up.restore(*remembered);
    Machine without(flight.database,
                    small(1)); // begins anew: another picture, or nothing would have been shown
    bool matters = false;
    for (std::size_t k = 12; k < 24; ++k) {
        flown.frame(flight.packets[k]);
        taken_up.frame(flight.packets[k]);
        without.frame(flight.packets[k]);
        EXPECT_EQ(taken_up.picture(0).pixels, flown.picture(0).pixels) << k;
        matters = matters || without.picture(0).pixels != flown.picture(0).pixels;
    }
    EXPECT_TRUE(matters);
    EXPECT_EQ(taken_up.history(), flown.history());
}

/// Sum over a pixel's three colours of how far wakes change it.
std::vector<int> what_wakes_add(const VideoFrame& with, const VideoFrame& without) {
    std::vector<int> added(with.pixels.size());
    for (std::size_t p = 0; p < added.size(); ++p)
        for (unsigned shift = 0; shift < 24; shift += 8)
            added[p] += static_cast<int>(with.pixels[p] >> shift & 255U) -
                        static_cast<int>(without.pixels[p] >> shift & 255U);
    return added;
}

TEST(MadeWakes, NothingIsReplacedAtOnceThroughTheCrossingOfTheEight) {
    // The ships go over from one circle to the other; the eye stands still above, and the ships are out of the picture's way.
    ShippedFlight flight = wake_flight(190.0, 60 * 6, 60.0);
    const Vec3d first = flight.packets.front()
                            .moving_objects[flight.packets.front().wakes[0].moving_object]
                            .waterline_position_m;
    Machine with(flight.database, small(1));
    Machine without(flight.database, small(1));
    std::vector<int> before;
    double greatest_mean = 0.0;
    int greatest = 0;
    std::int64_t seen = 0;
    for (FramePacket& packet : flight.packets) {
        packet.channels[0].eye_m = first + Vec3d(0.0, 0.0, 600.0);
        packet.channels[0].attitude = {.heading_rad = 0.0, .pitch_rad = -1.55, .roll_rad = 0.0};
        for (MovingObject& object : packet.moving_objects)
            object.attitude.pitch_rad = object.attitude.roll_rad = 0.0;
        with.frame(packet);
        FramePacket bare = packet;
        bare.wakes.clear();
        without.frame(bare);
        std::vector<int> now = what_wakes_add(with.picture(0), without.picture(0));
        if (!before.empty()) {
            std::int64_t sum = 0;
            for (std::size_t p = 0; p < now.size(); ++p) {
                greatest = std::max(greatest, std::abs(now[p] - before[p]));
                sum += std::abs(now[p] - before[p]);
                seen += std::abs(now[p]);
            }
            greatest_mean =
                std::max(greatest_mean, static_cast<double>(sum) / static_cast<double>(now.size()));
        }
        before = std::move(now);
    }
    EXPECT_GT(seen, 0);
    // A pixel is 4 m: a crest's edge of 300 levels (three colours) that a ship moves by 0.12 m a frame changes it by 9.
    EXPECT_LT(greatest, 60);
    EXPECT_LT(greatest_mean, 1.0);
    RecordProperty("greatest", greatest);
    RecordProperty("greatest_mean", std::to_string(greatest_mean));
}

/// Water that the hull pushes away, m^3/s.
double pushed(const std::vector<HullTriangle>& hull, const HullMotion& motion, Silhouette& silhouette) {
    silhouette = draw_silhouette(hull, motion, 64);
    double sum = 0.0;
    for (std::size_t p = 0; p < silhouette.direct.size(); ++p)
        sum += silhouette.direct[p] + silhouette.indirect[p];
    return sum;
}

double length_of(const Silhouette& silhouette) {
    std::uint32_t first = silhouette.size, last = 0;
    for (std::uint32_t row = 0; row < silhouette.size; ++row)
        for (std::uint32_t column = 0; column < silhouette.size; ++column)
            if (silhouette.filled[silhouette.at(column, row)] != 0) {
                first = std::min(first, column);
                last = std::max(last, column);
            }
    return silhouette.pixel * static_cast<double>(last + 1 - first);
}

TEST(ParticleWake, TakesTheHullAsItFloats) {
    const ShippedFlight flight = wake_flight(0.0, 1, 1.0);
    const auto wake =
        std::ranges::find(flight.packets[0].wakes, WakeMethod::wave_particles, &WakeRequest::method);
    ASSERT_NE(wake, flight.packets[0].wakes.end());
    ASSERT_NE(wake->hull_above, none);
    WakeRequest below = *wake;
    below.hull_above = none;
    const std::vector<HullTriangle> whole = hull_of(flight.database, *wake);
    const std::vector<HullTriangle> cut = hull_of(flight.database, below);
    EXPECT_GT(whole.size(), cut.size());
    Silhouette silhouette;
    // Sinking by 1 m/s she pushes away her waterplane's area a second. LPH-2's sides flare: 4 m deeper it is greater, and so is its
    // length; the hull below the waterline alone would not know.
    const HullMotion level{.velocity_mps = {0.0, 0.0, -1.0}};
    const HullMotion deep{.position = {0.0, 0.0, -4.0}, .velocity_mps = {0.0, 0.0, -1.0}};
    const double at_rest = pushed(whole, level, silhouette);
    const double length_at_rest = length_of(silhouette);
    EXPECT_NEAR(at_rest, pushed(cut, level, silhouette), 0.005 * at_rest);
    EXPECT_GT(at_rest, 0.7 * 166.0 * 25.6 * 0.9); // waterplane coefficient above 0.63
    EXPECT_LT(at_rest, 166.5 * 25.6);
    const double sunk = pushed(whole, deep, silhouette);
    EXPECT_GT(sunk, 1.02 * at_rest);
    EXPECT_GE(length_of(silhouette), length_at_rest);
    EXPECT_NEAR(pushed(cut, deep, silhouette), at_rest, 0.005 * at_rest);
}

} // namespace
} // namespace linkdig::ig
