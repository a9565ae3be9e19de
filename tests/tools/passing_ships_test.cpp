// Two ships with boxes and wakes pass each other and a pier, all in one priority group: from every side each pixel shows
// what the ray caster finds nearest.

#include "tools/check/check.h"

#include "database/model/mathematics.h"
#include "tests/database/compiler/authored.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace linkdig::tools {
namespace {

constexpr const char* head = R"([database]
name = "passing"
[[sun]]
name = "world"
[[colour]]
name = "sea"
rgb = [40, 80, 110]
[[colour]]
name = "grey"
rgb = [140, 140, 140]
[[colour]]
name = "foam"
rgb = [230, 235, 235]
[[cluster]]
name = "sea"
priority = 20
[[object_list]]
name = "sea"
cluster = "sea"
sun = "world"
[[tile]]
list = "sea"
period = 16
cell_m = 20.0
rings = 4
fine_levels = 0
half_width = 8
vertical_angle_deg = 70.0
colour = "sea"
seed = 1
pattern = "random"
)";

/// A hull with vertical sides and a bridge, a box about the waterplane, a wake on each side. The wakes stand outside the box,
/// beyond every roll of the hull.
std::string ship(const std::string& s) {
    const std::string lists[] = {"bridge", "wake_port", "wake_starboard", "box", "hull"};
    std::string text =
        fmt::format("[[moving_object]]\nname = \"{0}\"\n[[cluster]]\nname = \"{0}\"\npriority = 10\n"
                    "moving_object = \"{0}\"\n",
                    s);
    for (const std::string& list : lists)
        text += fmt::format(
            "[[object_list]]\nname = \"{0}.{1}\"\ncluster = \"{0}\"\nsun = \"world\"\nframe = \"{2}\"\n", s,
            list, list == "bridge" || list == "hull" ? "body" : "waterline");
    const auto plane = [&](const char* name, const char* normal, double distance, const char* frame,
                           const std::string& front, const std::string& back) {
        text +=
            fmt::format("[[cluster_plane]]\ncluster = \"{}\"\nname = \"{}\"\nnormal = {}\ndistance_m = {}\n"
                        "frame = \"{}\"\nfront = \"{}\"\nback = {}\n",
                        s, name, normal, distance, frame, front, back);
    };
    plane("deck", "[0, 0, 1]", 6.0, "body", s + ".bridge", "\"port\"");
    plane("port", "[0, 1, 0]", 7.5, "waterline", s + ".wake_port", "\"starboard\"");
    plane("starboard", "[0, -1, 0]", 7.5, "waterline", s + ".wake_starboard",
          fmt::format("[\"{0}.box\", \"{0}.hull\"]", s));
    text += fmt::format(R"([[object]]
name = "{0} hull"
list = "{0}.hull"
colour = "grey"
[[object.prism]]
base_m = [[-30, -5], [20, -5], [30, 0], [20, 5], [-30, 5]]
bottom_m = -4
top_m = 6
[[object]]
name = "{0} bridge"
list = "{0}.bridge"
colour = "foam"
[[object.box]]
from_m = [-20, -3, 6]
to_m = [-8, 3, 14]
omit = ["bottom"]
[[object]]
name = "{0} box"
list = "{0}.box"
colour = "sea"
[[object.box]]
from_m = [-32, -7, -3]
to_m = [32, 7, 0]
omit = ["top", "bottom"]
)",
                        s);
    for (const int side : {1, -1})
        text += fmt::format(R"([[object]]
name = "{0} wake {1}"
list = "{0}.wake_{1}"
colour = "foam"
two_sided = true
vertices_m = {{ a = [26, {2}, 0], b = [5, {2}, 0], c = [5, {3}, 2.5], d = [26, {3}, 2.5] }}
[[object.face]]
corners = ["a", "b", "c", "d"]
)",
                            s, side > 0 ? "port" : "starboard", 8 * side, 9 * side);
    return text;
}

/// A pier with a shed on it, and a mole beyond its end.
constexpr const char* harbour = R"([[cluster]]
name = "pier"
priority = 10
[[cluster]]
name = "mole"
priority = 10
[[group_plane]]
priority = 10
name = "the pier's end"
normal = [1, 0, 0]
distance_m = 90
front = "mole"
back = "pier"
[[object_list]]
name = "pier"
cluster = "pier"
sun = "world"
[[object_list]]
name = "mole"
cluster = "mole"
sun = "world"
[[object]]
name = "pier"
list = "pier"
colour = "grey"
[[object.box]]
from_m = [-80, -44, -2]
to_m = [80, -34, 3]
[[object.box]]
from_m = [-30, -42, 3]
to_m = [10, -36, 10]
omit = ["bottom"]
[[object]]
name = "mole"
list = "mole"
colour = "grey"
[[object.box]]
from_m = [100, -60, -2]
to_m = [110, 40, 4]
)";

MovingObject ship_at(double x, double y, double heading_deg, double pitch_deg, double roll_deg,
                     double heave_m) {
    MovingObject object;
    object.waterline_position_m = {x, y, 0};
    object.waterline_heading_rad = radians(heading_deg);
    object.position_m = {x, y, heave_m};
    object.attitude = {radians(heading_deg), radians(pitch_deg), radians(roll_deg)};
    return object;
}

/// Looks at the middle of the scene from an azimuth and an elevation.
ChannelView look(double azimuth_deg, double elevation_deg, double distance_m) {
    const Vec3d aim(0, -15, 3);
    ChannelView channel;
    channel.eye_m = aim + distance_m * direction(radians(azimuth_deg), radians(elevation_deg));
    channel.attitude = {radians(azimuth_deg + 180.0), radians(-elevation_deg), 0.0};
    channel.left_tangent = channel.bottom_tangent = -0.6;
    channel.right_tangent = channel.top_tangent = 0.6;
    return channel;
}

CheckView pass(int step, double azimuth_deg, double elevation_deg, double distance_m) {
    CheckView view;
    view.number = static_cast<std::uint64_t>(step);
    const double along = -70.0 + 20.0 * step; // they meet in step 3 or 4, B between A and the pier
    view.packet.suns = {{0, 0, 1}};
    view.packet.moving_objects = {ship_at(along, 6, 0.0, 3.0 - step, 6.0 - 2.0 * step, 1.0),
                                  ship_at(-along, -20, 178.0, step - 4.0, 2.0 * step - 7.0, -1.0)};
    view.packet.channels = {look(azimuth_deg, elevation_deg, distance_m)};
    return view;
}

TEST(PassingShips, EverySideShowsWhatIsNearest) {
    const database::CompileResult compiled =
        database::compile_text(std::string(head) + ship("a") + ship("b") + harbour);
    ASSERT_TRUE(compiled.database) << compiled.diagnostics.text();
    const database::ScratchFolder folder;
    CheckRequest request;
    request.raster = {160, 160, ig::Scan::horizontal};
    request.exceptions = read_exceptions(
        folder.write("check.toml",
                     "[[exception]]\nfront = [\"a\", \"b\", \"pier\", \"mole\"]\nbehind = [\"sea\"]\n"
                     "reason = \"hulls, boxes and foundations reach below the water\"\n"),
        *compiled.database);
    CheckResult result;
    for (int step = 0; step < 8; ++step)
        for (int azimuth = 5; azimuth < 360; azimuth += 24)
            for (const double elevation : {3.0, 20.0, 60.0})
                check_packet_view(*compiled.database, request,
                                  pass(step, azimuth, elevation, step % 2 == 0 ? 150.0 : 320.0), result);
    EXPECT_EQ(result.views, 8U * 15 * 3);
    EXPECT_GT(result.interior, 360U * 160 * 160 / 2);
    EXPECT_EQ(result.ambiguous, 0U);
    for (const Finding& finding : result.findings)
        ADD_FAILURE() << finding.pixels << " pixels show " << finding.shown.object << " instead of "
                      << finding.nearest.object << ", first in step " << finding.view;
}

TEST(PassingShips, ThePierWithoutAPlaneIsATie) {
    std::string text = std::string(head) + ship("a") + harbour;
    const std::size_t plane = text.find("[[group_plane]]");
    text.erase(plane, text.find("[[object_list]]", plane) - plane);
    const database::CompileResult compiled = database::compile_text(text);
    EXPECT_FALSE(compiled.database);
    EXPECT_NE(compiled.diagnostics.text().find("tie: no plane orders the static cluster \"pier\""),
              std::string::npos)
        << compiled.diagnostics.text();
}

} // namespace
} // namespace linkdig::tools
