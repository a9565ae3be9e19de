#include "tests/host/packet/sample_packet.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <vector>

namespace linkdig {

namespace {

/// The bits of every field, in the order of the structs, written down apart from the code under test.
class Bits {
public:
    explicit Bits(const FramePacket& p) {
        add(p.frame, p.time_s, p.database_id, p.channels.size(), p.suns.size(), p.lighting.size());
        add(p.moving_objects.size(), p.substitutions.size(), p.normal_updates.size());
        for (const ChannelView& c : p.channels)
            add(c.on, c.eye_m, c.attitude, c.left_tangent, c.right_tangent, c.bottom_tangent, c.top_tangent);
        for (const Vec3f& sun : p.suns)
            add(sun);
        for (const ListLighting& l : p.lighting)
            add(l.list, l.sun, l.ambient, l.diffuse, l.colour, static_cast<int>(l.method));
        for (const MovingObject& m : p.moving_objects)
            add(m.visible, m.position_m, m.attitude, m.waterline_position_m, m.waterline_heading_rad);
        for (const Substitution& s : p.substitutions)
            add(s.slot, s.index);
        for (const VertexNormalUpdate& u : p.normal_updates) {
            add(u.list, u.first, u.normals.size());
            for (const Vec3f& normal : u.normals)
                add(normal);
        }
        add(p.lod_bias, p.visibility_m, p.sky, p.time_of_day_h, p.seed, p.discontinuity);
        add(p.priorities.size(), p.host_values.size());
        for (const ClusterPriority& c : p.priorities)
            add(c.cluster, c.number);
        for (const HostValue& h : p.host_values)
            add(h.index, h.value);
        add(p.sea.state, p.sea.current_east_mps, p.sea.current_north_mps, p.light_points, p.colours.size());
        for (const Colour& c : p.colours)
            add(c.red, c.green, c.blue);
        add(p.wakes.size());
        for (const WakeRequest& w : p.wakes)
            add(w.list, w.moving_object, static_cast<int>(w.method), w.heights, w.colour, w.most_faces,
                w.age_s, w.strength, w.speed_mps, w.length_m, w.beam_m, w.hull, w.hull_above);
        add(p.quays.size());
        for (const Quay& q : p.quays)
            add(q.from_m.x, q.from_m.y, q.to_m.x, q.to_m.y);
    }
    std::vector<std::uint64_t> bits;

private:
    template <typename... Values>
    void add(const Values&... values) {
        (one(values), ...);
    }
    template <std::integral Integer>
    void one(Integer value) {
        bits.push_back(static_cast<std::uint64_t>(value));
    }
    void one(double value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); }
    void one(float value) { bits.push_back(std::bit_cast<std::uint32_t>(value)); }
    void one(const Vec3d& v) { add(v.x, v.y, v.z); }
    void one(const Vec3f& v) { add(v.x, v.y, v.z); }
    void one(const Attitude& a) { add(a.heading_rad, a.pitch_rad, a.roll_rad); }
};

} // namespace

FramePacket sample_packet() {
    FramePacket p;
    p.frame = 0x1'0000'0001ULL;
    p.time_s = 1.0 / 3.0;
    p.database_id = 0xfedcba9876543210ULL; // no double holds it
    p.channels.push_back({.on = true,
                          .eye_m = {1234.5678901, -0.0, 5e-324},
                          .attitude = {0.1, -0.2, 1e-17},
                          .left_tangent = -0.5,
                          .right_tangent = 0.25,
                          .bottom_tangent = -1.0 / 7.0,
                          .top_tangent = 2.0});
    p.channels.push_back({.on = false, .attitude = {}});
    p.suns = {{0.6F, 0.0F, 0.8F}, {-0.0F, 1.0F, 1e-45F}};
    p.lighting = {{.list = 2,
                   .sun = 1,
                   .ambient = 0.1F,
                   .diffuse = 0.7F,
                   .colour = 1,
                   .method = ShadingMethod::no_smooth},
                  {.list = 0}};
    p.moving_objects = {{.visible = false,
                         .position_m = {1e7, -1e7, 0.1},
                         .attitude = {3.0, 0.01, -0.02},
                         .waterline_position_m = {1, 2, 3},
                         .waterline_heading_rad = 2.9}};
    p.substitutions = {{.slot = 0, .index = 27}, {.slot = 1, .index = 0}};
    p.normal_updates = {{.list = 1, .first = 5, .normals = {{0, 0, 1}, {0.6F, 0, 0.8F}}},
                        {.list = 2, .first = 0, .normals = {}},
                        {.list = 0, .first = 1, .normals = {{0.0F, 0.1F, 0.2F}}}};
    p.lod_bias = -0.5F;
    p.visibility_m = 3704.0F;
    p.sky = {0.1F, 0.2F, 0.3F};
    p.time_of_day_h = 6.3F;
    p.sea = {1.5F, -0.4F, 0.3F};
    p.seed = 0xffffffffffffffffULL;
    p.discontinuity = true;
    p.colours = {{255, 0, 7, 0}, {1, 2, 3, 0}};
    p.light_points = 0.75F;
    p.priorities = {{.cluster = 1, .number = -3}, {.cluster = 0, .number = 21}};
    p.host_values = {{.index = 3, .value = -0.0}, {.index = 1000, .value = 1e-300}};
    p.wakes = {{.list = 1,
                .moving_object = 0,
                .heights = true,
                .colour = 1,
                .most_faces = 777,
                .age_s = 33.3F,
                .strength = 0.1F,
                .speed_mps = -2.5F,
                .length_m = 171.5F,
                .beam_m = 17.1F},
               {.list = 2, .method = WakeMethod::wave_particles, .hull = 0, .hull_above = 1}};
    p.quays = {{.from_m = {-0.0, 1e6}, .to_m = {5e-324, 0.1}}, {.from_m = {1, 2}, .to_m = {3, 4}}};
    return p;
}

PacketLimits sample_limits() {
    return {.suns = 2,
            .moving_objects = 1,
            .lists = 3,
            .colours = 2,
            .clusters = 2,
            .alternatives = {28, 1},
            .database_id = 0xfedcba9876543210ULL};
}

std::string difference(const FramePacket& a, const FramePacket& b) {
    const std::vector<std::uint64_t> left = Bits(a).bits;
    const std::vector<std::uint64_t> right = Bits(b).bits;
    if (left.size() != right.size()) return "tables of other lengths";
    for (std::size_t i = 0; i < left.size(); ++i)
        if (left[i] != right[i]) return "value " + std::to_string(i) + " of " + std::to_string(left.size());
    return {};
}

TestFile::TestFile(const std::string& name) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = testing::TempDir() + "linkdig-" + test->test_suite_name() + "." + test->name() + "-" +
            std::to_string(::getpid()) + "-" + name;
    std::filesystem::remove_all(path_);
}

TestFile::~TestFile() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace linkdig
