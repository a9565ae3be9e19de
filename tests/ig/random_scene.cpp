#include "tests/ig/random_scene.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace linkdig::ig {

namespace {

constexpr std::int32_t guard = greatest_coordinate;

std::int32_t snapped(double coordinate) { return static_cast<std::int32_t>(std::floor(coordinate + 0.5)); }

/// A point somewhere about the raster; one in five exactly on a pixel centre, where ties are decided.
RasterPoint random_point(RandomStream& random, const Raster& raster, double margin_px) {
    const double lines = raster.lines() + margin_px;
    const double elements = raster.elements() + margin_px;
    RasterPoint point{snapped(256.0 * random.between(-margin_px, lines)),
                      snapped(256.0 * random.between(-margin_px, elements))};
    if (random.one_in(5)) point = {(point.line & ~255) | 128, (point.element & ~255) | 128};
    return point;
}

/// Corners of an ellipse, snapped: convex but for the snapping, and still rising and falling once along the
/// lines.
std::vector<RasterPoint> random_polygon(RandomStream& random, RasterPoint centre, double radius_px) {
    const auto corners = static_cast<std::size_t>(random.integer(3, 12));
    const double flatness = random.one_in(3) ? 0.001 : random.between(0.1, 1.0);
    const SineCosine turn = sine_cosine(random.between(0.0, two_pi));
    std::vector<double> angles(corners);
    for (double& angle : angles)
        angle = random.between(0.0, two_pi);
    std::sort(angles.begin(), angles.end());
    std::vector<RasterPoint> points;
    for (const double angle : angles) {
        const SineCosine at = sine_cosine(angle);
        const double x = 256.0 * radius_px * at.cosine;
        const double y = 256.0 * radius_px * flatness * at.sine;
        points.push_back({snapped(centre.line + x * turn.sine + y * turn.cosine),
                          snapped(centre.element + x * turn.cosine - y * turn.sine)});
    }
    return points;
}

void add_polygon(Scene& scene, RandomStream& random) {
    const double radius = random.one_in(4) ? random.between(0.01, 2.0) : random.between(2.0, 60.0);
    add_face(scene, random, random_polygon(random, random_point(random, scene.raster, 20.0), radius));
}

void add_triangle(Scene& scene, RandomStream& random, double radius_px) {
    const RasterPoint first = random_point(random, scene.raster, 20.0);
    const auto reach = static_cast<std::int32_t>(256.0 * radius_px);
    const auto near_first = [&] {
        return RasterPoint{std::clamp(first.line + random.integer(-reach, reach), -guard, guard),
                           std::clamp(first.element + random.integer(-reach, reach), -guard, guard)};
    };
    add_face(scene, random, {first, near_first(), near_first()}, random_intensities(random));
}

/// A long triangle whose third corner lies within a few 1/256 pixel of the first.
void add_sliver(Scene& scene, RandomStream& random) {
    const RasterPoint first = random_point(random, scene.raster, 20.0);
    const RasterPoint second = random_point(random, scene.raster, random.one_in(2) ? 20.0 : 5000.0);
    const RasterPoint third{first.line + random.integer(-3, 3), first.element + random.integer(-3, 3)};
    add_face(scene, random, {first, second, third}, random_intensities(random));
}

/// Points on one straight line, or all in one place.
void add_without_area(Scene& scene, RandomStream& random) {
    const RasterPoint first = random_point(random, scene.raster, 20.0);
    const RasterPoint step{random.integer(-500, 500), random.integer(-500, 500)};
    const std::int32_t k = random.one_in(3) ? 0 : random.integer(1, 9);
    add_face(scene, random,
             {first,
              {first.line + k * step.line, first.element + k * step.element},
              {first.line + 3 * k * step.line, first.element + 3 * k * step.element}},
             random_intensities(random));
}

/// Whole or half pixels: edges that run through centres. Small ones, and some that reach beyond the raster's
/// borders.
void add_rectangle(Scene& scene, RandomStream& random) {
    const std::int32_t reach = random.one_in(6) ? 1000 : 30;
    const auto corner = [&](std::uint32_t size) {
        return random.integer(-6, 2 * static_cast<std::int32_t>(size) + 6);
    };
    const std::int32_t l0 = corner(scene.raster.lines());
    const std::int32_t e0 = corner(scene.raster.elements());
    const std::int32_t l1 = l0 + random.integer(-reach, reach);
    const std::int32_t e1 = e0 + random.integer(-reach, reach);
    add_face(scene, random,
             {{128 * l0, 128 * e0}, {128 * l0, 128 * e1}, {128 * l1, 128 * e1}, {128 * l1, 128 * e0}});
}

/// Corners anywhere in the guard band, its border included.
void add_huge(Scene& scene, RandomStream& random) {
    const auto coordinate = [&] {
        return random.one_in(4) ? (random.one_in(2) ? guard : -guard) : random.integer(-guard, guard);
    };
    std::vector<RasterPoint> points;
    for (int i = 0; i < 3; ++i)
        points.push_back({coordinate(), coordinate()});
    const bool flat = random.one_in(2);
    const std::array<std::int32_t, 3> intensities = random_intensities(random);
    add_face(scene, random, points, flat ? std::span<const std::int32_t>{} : intensities);
}

/// What remains of a triangle after clipping: a piece of few corners inside a triangle that reaches further,
/// whose corners are not snapped.
void add_piece(Scene& scene, RandomStream& random) {
    const double reach = random.one_in(3) ? 1e6 : random.between(100.0, 3000.0);
    IntensityTriangle triangle;
    for (double& line : triangle.line)
        line = 256.0 * random.between(-reach, reach);
    for (double& element : triangle.element)
        element = 256.0 * random.between(-reach, reach);
    const std::array<std::int32_t, 3> intensities = random_intensities(random);
    std::copy(intensities.begin(), intensities.end(), triangle.intensity);
    // Move it so that its centroid, about which the piece lies, is on the raster.
    const RasterPoint at = random_point(random, scene.raster, 0.0);
    const double off_line = at.line - (triangle.line[0] + triangle.line[1] + triangle.line[2]) / 3.0;
    const double off_element =
        at.element - (triangle.element[0] + triangle.element[1] + triangle.element[2]) / 3.0;
    for (double& line : triangle.line)
        line += off_line;
    for (double& element : triangle.element)
        element += off_element;
    std::vector<RasterPoint> points;
    const double scale = std::min(0.9, 80.0 / reach);
    for (int i = 0; i < 3; ++i)
        points.push_back({snapped(at.line + scale * (triangle.line[i] - at.line)),
                          snapped(at.element + scale * (triangle.element[i] - at.element))});
    add_face(scene, random, points);
    scene.projected.faces.back().triangle = static_cast<std::int32_t>(scene.projected.triangles.size());
    scene.projected.triangles.push_back(triangle);
}

/// The inverse of a modulo m, or 0 if there is none (extended Euclid). 0 < a < m.
std::int64_t inverse(std::int64_t a, std::int64_t m) {
    std::int64_t r0 = m, r1 = a, s0 = 0, s1 = 1;
    while (r1 != 0) {
        const std::int64_t q = r0 / r1;
        r0 = std::exchange(r1, r0 - q * r1);
        s0 = std::exchange(s1, s0 - q * s1);
    }
    return r0 == 1 ? (s0 + m) % m : 0;
}

/// An edge of height h that crosses line centre c, `down` below its upper end, at upper.element + down *
/// width / h. With down * width = miss (mod h) it passes the pixel centre in question at miss / h of 1/256
/// pixel.
bool add_near_miss(Scene& scene, RandomStream& random) {
    const auto lines = static_cast<std::int32_t>(scene.raster.lines());
    const std::int32_t height = random.integer(guard / 2, 2 * guard);
    const std::int32_t upper = random.integer(-guard, guard - height);
    const std::int64_t centre = support::centre_of(lines - 1 - random.integer(0, std::min(lines - 1, 40)));
    const std::int64_t down = centre - upper;
    if (down <= 0 || down >= height) return false;
    const std::int64_t unit_width = inverse(down, height);
    if (unit_width == 0) return false;
    const std::int64_t miss = random.integer(-1, 1);
    const std::int64_t width = unit_width * miss + (random.one_in(2) ? 0 : -height * miss);
    const std::int64_t whole = (down * width - miss) / height; // exact, by the choice of the width
    const std::int64_t from = support::centre_of(random.integer(2, 60)) - whole;
    if (std::abs(from) > guard || std::abs(from + width) > guard) return false;
    const RasterPoint start{upper, static_cast<std::int32_t>(from)};
    const RasterPoint end{upper + height, static_cast<std::int32_t>(from + width)};
    const std::int32_t side = random.one_in(2) ? guard : -guard; // the rest of the face, left or right of it
    add_face(scene, random, {start, end, {random.one_in(2) ? start.line : end.line, side}});
    return true;
}

} // namespace

std::int64_t doubled_area(std::span<const RasterPoint> points) {
    std::int64_t area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const RasterPoint& a = points[i];
        const RasterPoint& b = points[(i + 1) % points.size()];
        area += std::int64_t{a.element} * b.line - std::int64_t{b.element} * a.line;
    }
    return area;
}

double RandomStream::unit() { return random_unit(seed_, index_++); }

double RandomStream::between(double least, double greatest) { return least + unit() * (greatest - least); }

std::int32_t RandomStream::integer(std::int32_t least, std::int32_t greatest) {
    const auto range = static_cast<std::uint64_t>(std::int64_t{greatest} - least) + 1;
    return static_cast<std::int32_t>(least + static_cast<std::int64_t>(random_bits(seed_, index_++) % range));
}

Scene empty_scene(RandomStream& random, const Raster& raster) {
    Scene scene;
    scene.raster = raster;
    for (int i = 0; i < 16; ++i) {
        const auto component = [&] { return static_cast<std::uint8_t>(random.integer(0, 255)); };
        scene.colours.push_back({component(), component(), component()});
    }
    return scene;
}

void add_face(Scene& scene, RandomStream& random, std::vector<RasterPoint> points,
              std::span<const std::int32_t> intensities) {
    if (doubled_area(points) < 0) std::reverse(points.begin(), points.end());
    ProjectedFace face;
    face.first_point = static_cast<std::uint32_t>(scene.projected.points.size());
    face.point_count = static_cast<std::uint16_t>(points.size());
    face.colour =
        static_cast<std::uint16_t>(random.integer(0, static_cast<std::int32_t>(scene.colours.size()) - 1));
    face.intensity = random.integer(0, intensity_one);
    if (intensities.size() == 3) {
        face.triangle = static_cast<std::int32_t>(scene.projected.triangles.size());
        IntensityTriangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle.line[i] = points[i].line;
            triangle.element[i] = points[i].element;
            triangle.intensity[i] = intensities[i];
        }
        scene.projected.triangles.push_back(triangle);
    }
    scene.projected.points.insert(scene.projected.points.end(), points.begin(), points.end());
    scene.projected.faces.push_back(face);
}

std::array<std::int32_t, 3> random_intensities(RandomStream& random) {
    std::array<std::int32_t, 3> intensities{};
    for (std::int32_t& i : intensities)
        i = random.integer(0, intensity_one);
    if (random.one_in(8)) intensities = {0, intensity_one, intensity_one};
    return intensities;
}

void shuffle_ranks(Scene& scene, RandomStream& random) {
    std::vector<ProjectedFace>& faces = scene.projected.faces;
    for (std::size_t i = faces.size(); i > 1; --i)
        std::swap(faces[i - 1],
                  faces[static_cast<std::size_t>(random.integer(0, static_cast<std::int32_t>(i) - 1))]);
}

Scene random_scene(std::uint64_t seed, const Raster& raster, std::uint32_t faces) {
    RandomStream random(seed);
    Scene scene = empty_scene(random, raster);
    while (scene.projected.faces.size() < faces) {
        switch (random.integer(0, 9)) {
        case 0:
            add_huge(scene, random);
            break;
        case 1:
            add_sliver(scene, random);
            break;
        case 2:
            add_without_area(scene, random);
            break;
        case 3:
            add_rectangle(scene, random);
            break;
        case 4:
            add_piece(scene, random);
            break;
        case 5:
            add_triangle(scene, random, 1.5);
            break;
        case 6:
            add_triangle(scene, random, 500.0);
            break;
        case 7:
            add_triangle(scene, random, 40.0);
            break;
        default:
            add_polygon(scene, random);
            break;
        }
    }
    // The huge ones to the back, or they hide all others.
    shuffle_ranks(scene, random);
    std::stable_partition(
        scene.projected.faces.begin(), scene.projected.faces.end(), [&](const ProjectedFace& face) {
            const RasterPoint* points = scene.projected.points.data() + face.first_point;
            return std::all_of(points, points + face.point_count, [](const RasterPoint& point) {
                return std::abs(point.line) < 1'000'000 && std::abs(point.element) < 1'000'000;
            });
        });
    return scene;
}

Scene near_miss_scene(std::uint64_t seed, const Raster& raster, std::uint32_t faces) {
    RandomStream random(seed);
    Scene scene = empty_scene(random, raster);
    while (scene.projected.faces.size() < faces)
        add_near_miss(scene, random);
    return scene;
}

} // namespace linkdig::ig
