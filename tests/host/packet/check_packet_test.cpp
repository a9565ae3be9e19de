#include "host/packet/check_packet.h"

#include "tests/host/packet/sample_packet.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace linkdig {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Fault {
    const char* told;
    std::function<void(FramePacket&)> make;
};

void expect_told(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) {
        FramePacket packet = sample_packet();
        fault.make(packet);
        EXPECT_EQ(check_packet(packet, sample_limits()), fault.told);
    }
}

TEST(CheckPacket, SampleCanBeDrawn) { EXPECT_EQ(check_packet(sample_packet(), sample_limits()), ""); }

TEST(CheckPacket, ADefaultPacketHasNoChannel) {
    EXPECT_EQ(check_packet({}, {}), "channels has 0 rows; expected 1 to 8");
    FramePacket packet;
    packet.channels.resize(8);
    EXPECT_EQ(check_packet(packet, {}), "");
    packet.channels.resize(9);
    EXPECT_EQ(check_packet(packet, {}), "channels has 9 rows; expected 1 to 8");
}

TEST(CheckPacket, Channels) {
    expect_told({
        {"channels[0].eye_m is not finite", [](auto& p) { p.channels[0].eye_m.z = infinity; }},
        {"channels[1].eye_m is not finite",
         [](auto& p) { p.channels[1].eye_m.x = nan; }}, // one that is off, too
        {"channels[0].eye_m has the coordinate -10000001; expected no more than 10000000 m",
         [](auto& p) { p.channels[0].eye_m.y = -1e7 - 1; }},
        {"channels[0].attitude.heading_rad is not finite",
         [](auto& p) { p.channels[0].attitude.heading_rad = nan; }},
        {"channels[0].attitude.roll_rad is 2000000; expected -1000000 to 1000000",
         [](auto& p) { p.channels[0].attitude.roll_rad = 2e6; }},
        {"channels[0].left_tangent is not finite", [](auto& p) { p.channels[0].left_tangent = -infinity; }},
        {"channels[0].top_tangent is 20.5; expected -20 to 20",
         [](auto& p) { p.channels[0].top_tangent = 20.5; }},
        {"channels[0].right_tangent is -0.5; expected more than left_tangent, -0.5",
         [](auto& p) { p.channels[0].right_tangent = -0.5; }},
        {"channels[0].top_tangent is -1; expected more than bottom_tangent, 1",
         [](auto& p) { p.channels[0].bottom_tangent = 1, p.channels[0].top_tangent = -1; }},
    });
}

TEST(CheckPacket, Suns) {
    expect_told({
        {"suns has 1 rows; the database has 2 suns", [](auto& p) { p.suns.pop_back(); }},
        {"suns[1] is not finite", [](auto& p) { p.suns[1].x = nan; }},
        {"suns[0] is 2 long; expected a unit vector",
         [](auto& p) {
             p.suns[0] = {0, 0, 2};
         }},
        {"suns[0] is 0 long; expected a unit vector",
         [](auto& p) {
             p.suns[0] = {0, 0, 0};
         }},
        {"suns[0] is 0.9980000257492065 long; expected a unit vector",
         [](auto& p) {
             p.suns[0] = {0, 0, 0.998F};
         }},
        {"",
         [](auto& p) {
             p.suns[0] = {0, 0, 1.0009F};
         }},
    });
}

TEST(CheckPacket, Lighting) {
    expect_told({
        {"lighting has 4 rows; the database has 3 lists", [](auto& p) { p.lighting.resize(4); }},
        {"lighting[1].list is 3, but the database has 3 lists", [](auto& p) { p.lighting[1].list = 3; }},
        {"lighting[1].sun is 2, but the database has 2 suns", [](auto& p) { p.lighting[1].sun = 2; }},
        {"lighting[1].colour is 2, but the database has 2 colours",
         [](auto& p) { p.lighting[1].colour = 2; }},
        {"lighting[1].colour is -2, but the database has 2 colours",
         [](auto& p) { p.lighting[1].colour = -2; }},
        {"lighting[1].ambient is 1.5; expected 0 to 1", [](auto& p) { p.lighting[1].ambient = 1.5F; }},
        {"lighting[1].diffuse is not finite", [](auto& p) { p.lighting[1].diffuse = nan; }},
        {"lighting[0].method is none of as_modelled, no_smooth",
         [](auto& p) { p.lighting[0].method = static_cast<ShadingMethod>(2); }},
        {"", [](auto& p) { p.lighting.clear(); }}, // as the database has it
    });
}

TEST(CheckPacket, MovingObjectsAndSubstitutions) {
    expect_told({
        {"moving_objects has 0 rows; the database has 1 moving objects",
         [](auto& p) { p.moving_objects.clear(); }},
        {"moving_objects[0].position_m is not finite",
         [](auto& p) { p.moving_objects[0].position_m.x = nan; }},
        {"moving_objects[0].attitude.pitch_rad is not finite",
         [](auto& p) { p.moving_objects[0].attitude.pitch_rad = infinity; }},
        {"moving_objects[0].waterline_position_m has the coordinate 1e+300; expected no more than 10000000 m",
         [](auto& p) { p.moving_objects[0].waterline_position_m.z = 1e300; }},
        {"moving_objects[0].waterline_heading_rad is not finite",
         [](auto& p) { p.moving_objects[0].waterline_heading_rad = nan; }},
        {"substitutions has 3 rows; the database has 2 slots", [](auto& p) { p.substitutions.resize(3); }},
        {"substitutions[0].slot is 2, but the database has 2 slots",
         [](auto& p) { p.substitutions[0].slot = 2; }},
        {"substitutions[0].index is 28, but slot 0 has 28 alternatives",
         [](auto& p) { p.substitutions[0].index = 28; }},
    });
}

TEST(CheckPacket, NormalUpdates) {
    expect_told({
        {"normal_updates[1].list is 3, but the database has 3 lists",
         [](auto& p) { p.normal_updates[1].list = 3; }},
        {"normal_updates[0].first is 4294967294: the last normal's index passes 32 bits",
         [](auto& p) { p.normal_updates[0].first = 0xfffffffeU; }},
        {"normal_updates[0].normals[1] is not finite, or longer than 1",
         [](auto& p) { p.normal_updates[0].normals[1].x = 1.0F; }},
        {"normal_updates[2].normals[0] is not finite, or longer than 1",
         [](auto& p) { p.normal_updates[2].normals[0].y = nan; }},
    });
}

TEST(CheckPacket, Environment) {
    expect_told({
        {"database_id is 0000000000000001; the database in use has fedcba9876543210",
         [](auto& p) { p.database_id = 1; }},
        {"", [](auto& p) { p.database_id = 0; }}, // do not check
        {"time_s is not finite", [](auto& p) { p.time_s = nan; }},
        {"lod_bias is not finite", [](auto& p) { p.lod_bias = nan; }},
        {"lod_bias is -16.5; expected -16 to 16", [](auto& p) { p.lod_bias = -16.5F; }},
        {"visibility_m is not finite", [](auto& p) { p.visibility_m = static_cast<float>(infinity); }},
        {"sky.y is 1.5; expected 0 to 1", [](auto& p) { p.sky.y = 1.5F; }},
        {"time_of_day_h is 25; expected 0 to 24", [](auto& p) { p.time_of_day_h = 25.0F; }},
        {"colours has 1 rows; expected none, or the database's 2", [](auto& p) { p.colours.pop_back(); }},
        {"", [](auto& p) { p.colours.clear(); }},
        {"light_points is -1; expected 0 to 100", [](auto& p) { p.light_points = -1.0F; }},
        {"sea.state is -1; expected 0 to 9", [](auto& p) { p.sea.state = -1.0F; }},
        {"sea.current_east_mps is not finite", [](auto& p) { p.sea.current_east_mps = nan; }},
    });
}

TEST(CheckPacket, HostValues) {
    expect_told({
        {"host_values[1].value is not finite", [](auto& p) { p.host_values[1].value = nan; }},
        {"host_values[0].value is not finite", [](auto& p) { p.host_values[0].value = -infinity; }},
        {"", [](auto& p) { p.host_values[0].index = 0xffffffffU; }}, // the host's own numbering
    });
}

TEST(CheckPacket, Wakes) {
    expect_told({
        {"wakes[0].list is 3, but the database has 3 lists", [](auto& p) { p.wakes[0].list = 3; }},
        {"wakes[1].list is 1, as wakes[0].list is", [](auto& p) { p.wakes[1].list = 1; }},
        {"wakes[1].moving_object is 7, but the database has 1 moving objects",
         [](auto& p) { p.wakes[1].moving_object = 7; }},
        {"wakes[0].method is none of kelvin, wave_particles",
         [](auto& p) { p.wakes[0].method = static_cast<WakeMethod>(2); }},
        {"wakes[0].colour is 2, but the database has 2 colours", [](auto& p) { p.wakes[0].colour = 2; }},
        {"wakes[0].most_faces is 4294967295; expected 0 to 100000",
         [](auto& p) { p.wakes[0].most_faces = ~0U; }},
        {"wakes[0].age_s is not finite", [](auto& p) { p.wakes[0].age_s = nan; }},
        {"wakes[0].strength is -1; expected 0 to 10", [](auto& p) { p.wakes[0].strength = -1.0F; }},
        {"wakes[0].speed_mps is not finite",
         [](auto& p) { p.wakes[0].speed_mps = static_cast<float>(infinity); }},
        {"wakes[1].length_m is 0; expected 1 to 1000", [](auto& p) { p.wakes[1].length_m = 0.0F; }},
        {"wakes[1].beam_m is not finite", [](auto& p) { p.wakes[1].beam_m = nan; }},
        {"wakes[1].hull is -1, but the database has 3 lists", [](auto& p) { p.wakes[1].hull = none; }},
        {"wakes[0].hull is 3, but the database has 3 lists", [](auto& p) { p.wakes[0].hull = 3; }},
        {"", [](auto& p) { p.wakes[0].speed_mps = 0.0F; }}, // she lies still
    });
}

TEST(CheckPacket, Quays) {
    expect_told({
        {"wakes[1].hull_above is 3, but the database has 3 lists",
         [](auto& p) { p.wakes[1].hull_above = 3; }},
        {"quays[1].to_m is not finite", [](auto& p) { p.quays[1].to_m.y = nan; }},
        {"quays[0].from_m has the coordinate 20000000; expected no more than 10000000 m",
         [](auto& p) { p.quays[0].from_m.x = 2e7; }},
        {"quays[1] has no length; expected 0.01 m at least",
         [](auto& p) { p.quays[1].to_m = p.quays[1].from_m; }},
        {"quays has 65 rows; expected at most 64", [](auto& p) { p.quays.resize(65, p.quays[1]); }},
    });
}

TEST(PacketLimits, AreTheSizesOfTheDatabasesTables) {
    VisualDatabase database;
    database.suns = {"a", "b", "c"};
    database.moving_objects = {"ship"};
    database.lists.resize(4);
    database.colours.resize(5);
    database.slots = {{"wake", 28}, {"flag", 2}};
    const PacketLimits limits = packet_limits(database, 77);
    EXPECT_EQ(limits.suns, 3U);
    EXPECT_EQ(limits.moving_objects, 1U);
    EXPECT_EQ(limits.lists, 4U);
    EXPECT_EQ(limits.colours, 5U);
    EXPECT_EQ(limits.alternatives, (std::vector<std::uint32_t>{28, 2}));
    EXPECT_EQ(limits.database_id, 77U);
}

} // namespace

} // namespace linkdig
