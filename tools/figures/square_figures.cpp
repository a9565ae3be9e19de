/// Squares of the sea pattern: Figures 8 to 11, and which way swell and the
/// random pattern run.

#include "tools/figures/figures.h"
#include "tools/figures/measures.h"
#include "tools/figures/stage.h"

#include "database/model/mathematics.h"
#include "database/model/rotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

namespace linkdig::tools {
namespace {

using host::Signal;
using host::SignalValues;

constexpr double swell_wavelength_m = 64.0; // seas/swell.toml
constexpr double swell_speed_m_s =
    swell_wavelength_m / (360.0 / 40.0); // one wavelength a turn, report/swell.toml

struct Square {
    std::int64_t i = 0;
    std::int64_t j = 0;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 that <=> is compared with for a pointer
    auto operator<=>(const Square&) const = default;
};

/// The square of side `side_m` on z = 0 that a place of the picture shows.
Square square_at(const ChannelView& channel, const Mat3d& world_from_eye, double across, double down,
                 double side_m) {
    const Vec3d ray = ray_through(channel, world_from_eye, across, down);
    const Vec3d point = channel.eye_m - ray * (channel.eye_m.z / ray.z);
    return {static_cast<std::int64_t>(std::floor(point.x / side_m)),
            static_cast<std::int64_t>(std::floor(point.y / side_m))};
}

/// The same for a pixel, unless its square's border is within a pixel.
std::optional<Square> square_of(const ChannelView& channel, const Mat3d& world_from_eye,
                                const ig::VideoFrame& picture, std::size_t x, std::size_t y, double side_m) {
    const auto at = [&](double dx, double dy) {
        return square_at(channel, world_from_eye, (static_cast<double>(x) + 0.5 + dx) / picture.width,
                         (static_cast<double>(y) + 0.5 + dy) / picture.height, side_m);
    };
    const Square middle = at(0, 0);
    for (const double dx : {-1.0, 1.0})
        for (const double dy : {-1.0, 1.0})
            if (at(dx, dy) != middle) return std::nullopt;
    return middle;
}

/// The level that a square has under a sun, from the pattern alone.
int analytic_level(const VisualDatabase& database, const RepeatedTile& tile, const Square& square,
                   const Vec3f& sun) {
    const ObjectList& list = database.lists[tile.list];
    const auto mask = static_cast<std::int64_t>(tile.period) - 1;
    const auto index = static_cast<std::size_t>((square.j & mask) * static_cast<std::int64_t>(tile.period) +
                                                (square.i & mask));
    const Vec3d normal(database.tile_normals[tile.first_face_normal + index]);
    const double lit = std::max(0.0, glm::dot(normal, Vec3d(sun)));
    const double intensity =
        std::clamp(static_cast<double>(list.ambient) + static_cast<double>(list.diffuse) * lit, 0.0, 1.0);
    return static_cast<int>(std::floor(database.colours[tile.colour].green * intensity + 0.5));
}

int worst_square(Stage& stage, const FramePacket& packet, const ig::VideoFrame& picture,
                 std::size_t& compared) {
    const RepeatedTile& tile = stage.database().tiles.front();
    const ChannelView& channel = packet.channels[0];
    const Mat3d world_from_eye = world_from_body(channel.attitude);
    int worst = 0;
    for (std::size_t y = 0; y < picture.height; ++y) {
        for (std::size_t x = 0; x < picture.width; ++x) {
            const auto square = square_of(channel, world_from_eye, picture, x, y, tile.cell_m);
            if (!square) continue;
            const int expected =
                analytic_level(stage.database(), tile, *square, packet.suns[stage.sea_sun()]);
            worst = std::max(worst, std::abs(level(picture.pixels[y * picture.width + x]) - expected));
            ++compared;
        }
    }
    return worst;
}

void cut_edges(Findings& findings) {
    Stage stage("report/confused.toml");
    FramePacket packet = stage.packet(0);
    look(packet, {1, 1, 10}, {1.001, 1, 0}, 60.0);
    ig::VideoFrame picture = stage.draw(packet);
    const RepeatedTile& tile = stage.database().tiles.front();
    const double finest_m = tile.cell_m / static_cast<double>(1U << tile.fine_levels);
    const ChannelView& channel = packet.channels[0];
    const Mat3d world_from_eye = world_from_body(channel.attitude);
    std::map<Square, std::set<std::int32_t>> triangles;
    for (std::size_t y = 0; y < picture.height; ++y)
        for (std::size_t x = 0; x < picture.width; ++x)
            if (const auto square = square_of(channel, world_from_eye, picture, x, y, finest_m))
                triangles[*square].insert(picture.rank[y * picture.width + x]);
    std::size_t cut_in_two = 0;
    for (const auto& [square, ranks] : triangles)
        cut_in_two += ranks.size() <= 2 ? 1 : 0; // at the picture's border one of the two may be outside
    findings.at_most("11", "squares that are not cut into two triangles",
                     static_cast<double>(triangles.size() - cut_in_two), 0.0);
    const std::size_t whole = static_cast<std::size_t>(
        std::ranges::count_if(triangles, [](const auto& each) { return each.second.size() == 2; }));
    findings.at_least("11", "squares seen cut into two triangles", static_cast<double>(whole), 12.0);
    for (std::size_t i = 0; i + picture.width + 1 < picture.pixels.size(); ++i)
        if (picture.rank[i] != picture.rank[i + 1] || picture.rank[i] != picture.rank[i + picture.width])
            picture.pixels[i] = 0xFFFFFFFFU;
    findings.picture("figure_11", picture);
}

} // namespace

void squares(Findings& findings) {
    Stage stage("report/confused.toml");
    SignalValues flat;
    flat.set(Signal::smooth_shading, 0.0);
    flat.set(Signal::sea_state, 3.0);
    for (const auto& [figure, frame] : {std::pair{"8", 10ULL}, std::pair{"9", 48ULL}}) {
        FramePacket packet = stage.packet(frame, flat);
        findings.picture(fmt::format("figure_{:0>2}", figure), stage.draw(packet));
        look(packet, {3, 5, 60}, {3.001, 5, 0}, 60.0);
        std::size_t compared = 0;
        const int worst = worst_square(stage, packet, stage.draw(packet), compared);
        findings.at_most(figure, "greatest error of a square's level", worst, 1.0);
        findings.at_least(figure, "pixels compared", static_cast<double>(compared), 100000.0);
    }
    SignalValues smooth = flat;
    smooth.set(Signal::smooth_shading, 1.0);
    findings.picture("figure_10", stage.draw(stage.packet(48, smooth)));
    cut_edges(findings);
}

void directions(Findings& findings) {
    const std::uint64_t frames = findings.quick() ? 12 : 60;
    const auto from_above = [](Stage& stage, std::uint64_t frame) {
        FramePacket packet = stage.packet(frame);
        look(packet, {0, 0, 200}, {0.001, 0, 0}, 56.0);
        return packet;
    };
    Stage swell("report/swell.toml");
    findings.picture("swell", swell.draw(swell.packet(0)));
    const FramePacket begin = from_above(swell, 0);
    const std::vector<double> first = row_means(swell.draw(begin));
    const double metres_a_row =
        2.0 * 200.0 * begin.channels[0].top_tangent / static_cast<double>(first.size());
    // Within half a wavelength: beyond it the next band fits as well.
    const int most = static_cast<int>(swell_wavelength_m / metres_a_row / 2.0) - 1;
    std::vector<double> shifts;
    for (std::uint64_t frame = 1; frame <= frames; ++frame)
        shifts.push_back(shift(first, row_means(swell.draw(from_above(swell, frame))), most));
    const double a_frame = shifts.back() / static_cast<double>(frames);
    double off = 0.0;
    for (std::size_t k = 0; k < shifts.size(); ++k)
        off = std::max(off, std::fabs(shifts[k] - a_frame * static_cast<double>(k + 1)));
    findings.between("swell", "speed of the bands, m/s", std::fabs(a_frame) * metres_a_row * 30.0,
                     0.97 * swell_speed_m_s, 1.03 * swell_speed_m_s);
    findings.at_most("swell", "departure from one velocity in 60 frames (quick: 12), m", off * metres_a_row,
                     1.0);

    Stage mirrored("report/mirrored.toml");
    findings.picture("mirrored", mirrored.draw(mirrored.packet(0)));

    Stage random("report/confused.toml");
    double anisotropy = 0.0;
    double right = 0.0;
    double down = 0.0;
    ig::VideoFrame before = random.draw(from_above(random, 0));
    for (std::uint64_t frame = 1; frame <= frames; ++frame) {
        const ig::VideoFrame now = random.draw(from_above(random, frame));
        const Flow found = flow(before, now);
        anisotropy += found.anisotropy() / static_cast<double>(frames);
        right += found.right / static_cast<double>(frames);
        down += found.down / static_cast<double>(frames);
        before = now;
    }
    findings.at_most("random", "anisotropy of the pattern", anisotropy, 1.3);
    findings.at_most("random", "its one motion, m/s",
                     std::sqrt(right * right + down * down) * metres_a_row * 30.0, 0.5);
}

} // namespace linkdig::tools
