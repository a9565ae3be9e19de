/// Intensity at vertices against the formula of the report (3.1.4 and Appendix I), through the whole machine:
/// with a normal of azimuth phi and vertical angle a, and a sun of azimuth w and elevation e,
///   I = ambient + diffuse max(0, sin a sin e + cos a cos e cos(phi - w)).

#include "database/model/random.h"
#include "ig/machine/machine.h"
#include "tests/ig/small_database.h"
#include "tests/support/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace linkdig::ig {
namespace {

constexpr std::uint32_t side_px = 256;
constexpr double eye_height_m = side_px / 2.0; // straight down with tangents of 1: a pixel is a metre
constexpr std::int32_t spacing_px = 16;
constexpr double vertical_angle_deg = 68.0;
constexpr int frames = 60;
constexpr int period_frames = 24;
constexpr double start_azimuth_rad = 0.3;

/// A pixel whose centre a vertex falls on, and the azimuth of that vertex's normal.
struct Probe {
    std::int32_t row = 0;
    std::int32_t column = 0;
    double phi_rad = 0;
};

/// Looks down, x up the screen and y to the left of it: from above the origin the world's (x, y) is row 128 -
/// x, column 128 - y.
ChannelView looking_down(const Vec3d& eye_m) {
    ChannelView channel = channel_at(eye_m, 0.0, -90.0);
    channel.left_tangent = channel.bottom_tangent = -1.0;
    channel.right_tangent = channel.top_tangent = 1.0;
    return channel;
}

/// World position of the centre of a pixel, seen from above the origin.
Vec4f position_of(std::int32_t row, std::int32_t column) {
    return {128.0F - (static_cast<float>(row) + 0.5F), 128.0F - (static_cast<float>(column) + 0.5F), 0.0F,
            1.0F};
}

struct GridOptions {
    std::uint32_t sun = 0;
    std::int32_t first_column = 0;
    float ambient = 0.35F;
    float diffuse = 0.65F;
};

void add_list(VisualDatabase& database, const GridOptions& options) {
    const auto index = static_cast<std::uint32_t>(database.lists.size());
    database.groups.push_back({.number = static_cast<std::int32_t>(index), .root = none});
    Cluster cluster;
    cluster.name = "grid " + std::to_string(index);
    cluster.group = index;
    cluster.half_extent_m = {128, 128, 1};
    cluster.root = leaf_reference(index);
    database.clusters.push_back(cluster);
    ObjectList list;
    list.name = cluster.name;
    list.cluster = index;
    list.sun = options.sun;
    list.ambient = options.ambient;
    list.diffuse = options.diffuse;
    list.root = leaf_reference(index);
    database.lists.push_back(list);
    Object object;
    object.name = cluster.name;
    object.list = index;
    database.objects.push_back(object);
    database.run_leaves.push_back({.first_run = index, .run_count = 1});
    FaceRun run;
    run.first_face = static_cast<std::uint32_t>(database.faces.size());
    run.radius = -1;
    database.runs.push_back(run);
}

/// A list with a flat grid of 7 by 9 smooth-shaded squares, whose vertices fall on pixel centres and carry
/// normals of a table of 256 at a fixed vertical angle. Returns the inner vertices: those at the border share
/// their pixel with nothing.
std::vector<Probe> add_grid(VisualDatabase& database, const GridOptions& options) {
    constexpr std::int32_t columns = 7;
    constexpr std::int32_t rows = 9;
    add_list(database, options);
    std::vector<Probe> probes;
    const auto first_vertex = static_cast<std::uint32_t>(database.vertices.size());
    for (std::int32_t j = 0; j <= rows; ++j) {
        for (std::int32_t i = 0; i <= columns; ++i) {
            const std::uint64_t entry =
                random_bits(1979 + options.sun, static_cast<std::uint64_t>(j * 10 + i)) % 256;
            const Probe probe{8 + j * spacing_px, options.first_column + i * spacing_px,
                              two_pi * static_cast<double>(entry) / 256.0};
            database.vertices.push_back(
                {.position = position_of(probe.row, probe.column),
                 .normal = Vec3f(direction(probe.phi_rad, radians(vertical_angle_deg)))});
            if (i > 0 && i < columns && j > 0 && j < rows) probes.push_back(probe);
        }
    }
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            Face face;
            face.first_corner = static_cast<std::uint32_t>(database.corners.size());
            face.corner_count = 4;
            face.object = static_cast<std::uint32_t>(database.objects.size() - 1);
            face.shading = Shading::vertex;
            const std::uint32_t corner = first_vertex + j * (columns + 1) + i;
            // Counter-clockwise as seen from above, that is on the picture: down, right, up.
            for (const std::uint32_t c : {corner, corner + columns + 1, corner + columns + 2, corner + 1})
                database.corners.push_back(c);
            database.faces.push_back(face);
            ++database.runs.back().face_count;
        }
    }
    return probes;
}

VisualDatabase empty_database() {
    VisualDatabase database;
    database.name = "light";
    database.colours = {{200, 200, 200, 0}};
    database.colour_names = {"grey"};
    database.source_files = {"made in code"};
    database.suns = {"turning", "fixed"};
    return database;
}

double azimuth_at(int frame) { return start_azimuth_rad + two_pi * frame / period_frames; }

FramePacket packet_at(int frame, double elevation_rad, const Vec3d& eye_m, std::size_t suns) {
    FramePacket packet;
    packet.frame = static_cast<std::uint64_t>(frame);
    packet.channels = {looking_down(eye_m)};
    packet.suns = {Vec3f(direction(azimuth_at(frame), elevation_rad)), Vec3f(direction(1.0, 0.7))};
    packet.suns.resize(suns);
    return packet;
}

double expected_intensity(const ObjectList& list, double phi_rad, double azimuth_rad, double elevation_rad) {
    const double a = radians(vertical_angle_deg);
    const double cosine_of_angle = std::sin(a) * std::sin(elevation_rad) +
                                   std::cos(a) * std::cos(elevation_rad) * std::cos(phi_rad - azimuth_rad);
    return list.ambient + list.diffuse * std::max(0.0, cosine_of_angle);
}

double seen_intensity(const VideoFrame& picture, const Probe& probe) {
    const auto at =
        static_cast<std::size_t>(probe.row) * picture.width + static_cast<std::size_t>(probe.column);
    return static_cast<double>(picture.intensity.at(at)) / intensity_one;
}

Configuration configuration_of(Scan scan) {
    Configuration configuration;
    configuration.raster = {side_px, side_px, scan};
    configuration.threads = 1;
    return configuration;
}

/// The intensities of each frame at the probes, one row per frame.
using Record = std::vector<std::vector<double>>;

Record record(Machine& machine, const std::vector<Probe>& probes, double elevation_rad, const Vec3d& eye_m,
              std::size_t suns) {
    Record rows;
    machine.draw_planes(true, true);
    for (int frame = 0; frame < frames; ++frame) {
        const FrameReport& report = machine.frame(packet_at(frame, elevation_rad, eye_m, suns));
        EXPECT_TRUE(report.errors.empty()) << report.errors.front();
        std::vector<double> row;
        for (const Probe& probe : probes)
            row.push_back(seen_intensity(machine.picture(0), probe));
        rows.push_back(row);
    }
    return rows;
}

/// Far below a level of 1/255: what remains is the normals' single precision and the plane's rounding.
constexpr double tolerance = 5e-5;

void expect_formula(const Record& rows, const std::vector<Probe>& probes, const ObjectList& list,
                    double elevation_rad) {
    double worst = 0;
    for (std::size_t frame = 0; frame < rows.size(); ++frame)
        for (std::size_t p = 0; p < probes.size(); ++p)
            worst = std::max(
                worst, std::fabs(rows[frame][p] - expected_intensity(list, probes[p].phi_rad,
                                                                     azimuth_at(static_cast<int>(frame)),
                                                                     elevation_rad)));
    EXPECT_LT(worst, tolerance);
    ::testing::Test::RecordProperty("worst_difference", std::to_string(worst));
}

/// Mean difference between frames `lag` apart.
double mean_change(const Record& rows, std::size_t lag) {
    double sum = 0;
    for (std::size_t frame = 0; frame + lag < rows.size(); ++frame)
        for (std::size_t p = 0; p < rows[frame].size(); ++p)
            sum += std::fabs(rows[frame][p] - rows[frame + lag][p]);
    return sum / static_cast<double>((rows.size() - lag) * rows.front().size());
}

/// The sun's increment predicts the period, and no shorter one exists.
void expect_period(const Record& rows) {
    EXPECT_LT(mean_change(rows, period_frames), tolerance);
    for (std::size_t lag = 1; lag < period_frames; ++lag)
        EXPECT_GT(mean_change(rows, lag), 0.01) << "lag " << lag;
}

TEST(Light, vertices_follow_the_formula_as_the_sun_turns) {
    VisualDatabase database = empty_database();
    const std::vector<Probe> probes = add_grid(database, {.sun = 0, .first_column = 8});
    add_grid(database, {.sun = 1, .first_column = 136});
    ASSERT_GE(probes.size(), 20U);
    const double elevation = radians(45.0); // a + e >= 90 degrees: nothing is clamped
    for (const Scan scan : {Scan::horizontal, Scan::vertical}) {
        Machine machine(database, configuration_of(scan));
        const Record rows = record(machine, probes, elevation, {0, 0, eye_height_m}, 2);
        expect_formula(rows, probes, database.lists[0], elevation);
        expect_period(rows);
    }
}

TEST(Light, faces_turned_away_keep_the_ambient_light) {
    VisualDatabase database = empty_database();
    const std::vector<Probe> probes = add_grid(database, {.first_column = 8});
    const double elevation =
        radians(5.0); // a + e < 90 degrees: vertices opposite the sun get no direct light
    Machine machine(database, configuration_of(Scan::horizontal));
    const Record rows = record(machine, probes, elevation, {0, 0, eye_height_m}, 2);
    expect_formula(rows, probes, database.lists[0], elevation);
    std::size_t dark = 0;
    for (const std::vector<double>& row : rows)
        dark += static_cast<std::size_t>(
            std::count_if(row.begin(), row.end(), [](double i) { return i < 0.35 + 1e-6; }));
    EXPECT_GT(dark, 100U);
}

TEST(Light, no_other_list_moves_with_the_sun) {
    VisualDatabase database = empty_database();
    add_grid(database, {.sun = 0, .first_column = 8});
    const std::vector<Probe> fixed = add_grid(database, {.sun = 1, .first_column = 136});
    Machine machine(database, configuration_of(Scan::horizontal));
    machine.draw_planes(true, true);
    std::vector<std::int32_t> first_intensity;
    std::vector<std::uint32_t> list_of;
    std::uint64_t moved = 0;
    for (int frame = 0; frame < frames; ++frame) {
        machine.frame(packet_at(frame, radians(45.0), {0, 0, eye_height_m}, 2));
        const VideoFrame& picture = machine.picture(0);
        if (frame == 0) first_intensity = picture.intensity;
        std::uint64_t pixels_of_fixed = 0;
        for (std::size_t at = 0; at < picture.intensity.size(); ++at) {
            if (picture.rank[at] == none) continue;
            if (machine.source(0, picture.rank[at]).list == 0) {
                moved += picture.intensity[at] != first_intensity[at] ? 1 : 0;
                continue;
            }
            ++pixels_of_fixed;
            ASSERT_EQ(picture.intensity[at], first_intensity[at]) << "frame " << frame << " pixel " << at;
        }
        ASSERT_EQ(pixels_of_fixed, 7U * spacing_px * 9U * spacing_px);
    }
    EXPECT_GT(moved, 500'000U); // of 59 frames of 16128 pixels
    for (const Probe& probe : fixed) {
        const double a = radians(vertical_angle_deg);
        const double n_dot_s =
            std::sin(a) * std::sin(0.7) + std::cos(a) * std::cos(0.7) * std::cos(probe.phi_rad - 1.0);
        EXPECT_NEAR(seen_intensity(machine.picture(0), probe), 0.35 + 0.65 * n_dot_s, tolerance);
    }
}

/// Azimuth of a tile's normal at a multiple of its cell.
double tile_azimuth(const VisualDatabase& database, std::int32_t x, std::int32_t y) {
    const RepeatedTile& tile = database.tiles.front();
    const auto wrap = [&](std::int32_t k) { return static_cast<std::uint32_t>(k) & (tile.period - 1); };
    const Vec3f normal = database.tile_normals.at(tile.first_normal + wrap(y) * tile.period + wrap(x));
    return std::atan2(normal.y, normal.x);
}

TEST(Light, vertices_of_the_repeated_sea_follow_the_formula) {
    const SeaOptions options{.cell_m = spacing_px, .vertical_angle_deg = vertical_angle_deg};
    const VisualDatabase database = sea_database(options);
    // Half a pixel off, so that the sea's vertices, at multiples of 16 m, fall on pixel centres.
    const Vec3d eye(1600.5, -799.5, eye_height_m);
    std::vector<Probe> probes;
    for (std::int32_t i = -5; i <= 5; ++i)
        for (std::int32_t j = -5; j <= 5; ++j)
            probes.push_back(
                {128 - i * spacing_px, 128 - j * spacing_px, tile_azimuth(database, 100 + i, -50 + j)});
    Machine machine(database, configuration_of(Scan::horizontal));
    const double elevation = radians(45.0);
    const Record rows = record(machine, probes, elevation, eye, 1);
    expect_formula(rows, probes, database.lists[0], elevation);
    expect_period(rows);
}

} // namespace
} // namespace linkdig::ig
