// A scene made in code, so that a picture's hash depends on the machine alone: a plane of smooth-shaded
// squares, and a rotor of face-shaded blades that turns over it.

#include "database/model/random.h"
#include "tests/determinism/picture_table.h"

#include <gtest/gtest.h>

namespace linkdig::determinism {

namespace {

/// A cluster with one list, one object and one run; faces are appended to the run.
void begin_list(VisualDatabase& database, const std::string& name, std::int32_t moving_object) {
    const auto index = static_cast<std::uint32_t>(database.lists.size());
    database.groups.push_back({.number = static_cast<std::int32_t>(index), .root = none});
    Cluster cluster;
    cluster.name = name;
    cluster.group = index;
    cluster.moving_object = moving_object;
    cluster.half_extent_m = {100, 100, 1};
    cluster.root = leaf_reference(index);
    database.clusters.push_back(cluster);
    ObjectList list;
    list.name = name;
    list.cluster = index;
    list.attachment = moving_object == none ? Attachment::world : Attachment::body;
    list.ambient = 0.3F;
    list.diffuse = 0.7F;
    list.root = leaf_reference(index);
    database.lists.push_back(list);
    Object object;
    object.name = name;
    object.list = index;
    database.objects.push_back(object);
    database.run_leaves.push_back({.first_run = index, .run_count = 1});
    FaceRun run;
    run.first_face = static_cast<std::uint32_t>(database.faces.size());
    run.radius = -1;
    database.runs.push_back(run);
}

void add_face(VisualDatabase& database, const std::vector<std::uint32_t>& corners, Face face) {
    face.first_corner = static_cast<std::uint32_t>(database.corners.size());
    face.corner_count = static_cast<std::uint16_t>(corners.size());
    face.object = static_cast<std::uint32_t>(database.objects.size() - 1);
    database.corners.insert(database.corners.end(), corners.begin(), corners.end());
    database.faces.push_back(face);
    ++database.runs.back().face_count;
}

/// A fan of blades with gaps between them: no two share an edge, all meet in the hub.
void add_rotor(VisualDatabase& database) {
    begin_list(database, "rotor", 0);
    constexpr std::uint32_t blades = 7;
    const auto hub = static_cast<std::uint32_t>(database.vertices.size());
    database.vertices.push_back({.position = {0, 0, 0, 1}});
    for (std::uint32_t corner = 0; corner < 2 * blades; ++corner) {
        const Vec3d tip = 20.0 * direction(two_pi * corner / (2 * blades), 0.0);
        database.vertices.push_back({.position = {Vec3f(tip), 1.0F}});
    }
    for (std::uint32_t blade = 0; blade < blades; ++blade)
        add_face(
            database, {hub, hub + 1 + 2 * blade, hub + 2 + 2 * blade},
            {.colour = static_cast<std::uint16_t>(1 + blade % 2), .shading = Shading::face, .two_sided = 1});
}

/// 20 x 20 squares of 10 m with normals of random azimuth.
void add_plane(VisualDatabase& database) {
    begin_list(database, "plane", none);
    constexpr std::uint32_t side = 20;
    const auto first = static_cast<std::uint32_t>(database.vertices.size());
    for (std::uint32_t k = 0; k < (side + 1) * (side + 1); ++k) {
        const Vec4f position(10.0F * static_cast<float>(k % (side + 1)) - 100.0F,
                             10.0F * static_cast<float>(k / (side + 1)) - 100.0F, 0.0F, 1.0F);
        database.vertices.push_back(
            {position, Vec3f(direction(two_pi * random_unit(1979, k), radians(65.0)))});
    }
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t corner = first + y * (side + 1) + x;
            add_face(database, {corner, corner + 1, corner + side + 2, corner + side + 1},
                     {.colour = 0, .shading = Shading::vertex});
        }
}

VisualDatabase small_scene() {
    VisualDatabase database;
    database.name = "small";
    database.colours = {{30, 110, 140, 0}, {220, 60, 40, 0}, {240, 220, 180, 0}};
    database.colour_names = {"water", "red", "cream"};
    database.source_files = {"made in code"};
    database.suns = {"sun"};
    database.moving_objects = {"rotor"};
    add_rotor(database);
    add_plane(database);
    return database;
}

FramePacket packet_at(std::uint64_t frame) {
    FramePacket packet;
    packet.frame = frame;
    const double turn = 0.37 * static_cast<double>(frame);
    ChannelView channel;
    channel.eye_m = {-60.0 + turn, 5.0, 14.0};
    channel.attitude = {.heading_rad = 0.1 * turn, .pitch_rad = -0.2, .roll_rad = 0.15 * turn};
    packet.channels = {channel};
    packet.suns = {Vec3f(direction(turn, 0.8))};
    MovingObject rotor;
    rotor.position_m = {0, 0, 9};
    rotor.attitude = {.heading_rad = turn, .pitch_rad = 0.3, .roll_rad = 0.2};
    packet.moving_objects = {rotor};
    return packet;
}

void expect_scan(const std::string& name, ig::Scan scan) {
    const VisualDatabase database = small_scene();
    std::vector<NamedPacket> packets;
    for (const std::uint64_t frame : {0U, 1U, 5U})
        packets.push_back({"small_scene/" + name + "/" + std::to_string(frame), packet_at(frame)});
    expect_pictures(database, packets, {320, 240, scan});
}

} // namespace

TEST(SmallScene, HorizontalScanKeepsItsBytes) { expect_scan("horizontal", ig::Scan::horizontal); }

TEST(SmallScene, VerticalScanKeepsItsBytes) { expect_scan("vertical", ig::Scan::vertical); }

} // namespace linkdig::determinism
