#include "tests/database/compiler/solids.h"

#include "database/model/mathematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace linkdig::database {

Solid box(const Vec3d& low, const Vec3d& high) {
    Solid solid{{}, {}, low, high};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d normal(0.0);
        normal[axis] = 1;
        solid.bounds.push_back({normal, high[axis]});
        solid.bounds.push_back({-normal, -low[axis]});
    }
    solid.text = fmt::format("[[object.box]]\nfrom_m = [{}, {}, {}]\nto_m = [{}, {}, {}]\n", low.x, low.y,
                             low.z, high.x, high.y, high.z);
    return solid;
}

Solid prism(const Vec3d& centre, double radius, double half_height, int sides, double turn) {
    Solid solid;
    std::string base;
    std::vector<Vec2d> points;
    for (int i = 0; i < sides; ++i) {
        const SineCosine a = sine_cosine(turn + two_pi * i / sides);
        points.emplace_back(centre.x + radius * a.cosine, centre.y + radius * a.sine);
        base += fmt::format("[{}, {}], ", points.back().x, points.back().y);
    }
    for (int i = 0; i < sides; ++i) {
        const Vec2d a = points[static_cast<std::size_t>(i)];
        const Vec2d edge = points[static_cast<std::size_t>((i + 1) % sides)] - a;
        const Vec3d normal = glm::normalize(Vec3d(edge.y, -edge.x, 0));
        solid.bounds.push_back({normal, normal.x * a.x + normal.y * a.y});
    }
    solid.bounds.push_back({{0, 0, 1}, centre.z + half_height});
    solid.bounds.push_back({{0, 0, -1}, -(centre.z - half_height)});
    solid.low = centre - Vec3d(radius, radius, half_height);
    solid.high = centre + Vec3d(radius, radius, half_height);
    solid.text = fmt::format("[[object.prism]]\nbase_m = [{}]\nbottom_m = {}\ntop_m = {}\n", base,
                             centre.z - half_height, centre.z + half_height);
    return solid;
}

namespace {

/// Where the ray enters the solid, or infinity; and how far from an edge or a miss that is decided, metres.
struct Entry {
    double distance = 1e300;
    double margin = 1e300;
};

Entry enter(const Solid& solid, const Ray& ray) {
    double in = -1e300, out = 1e300;
    for (const Solid::HalfSpace& bound : solid.bounds) {
        const double speed = glm::dot(bound.normal, ray.along);
        const double gap = bound.distance - glm::dot(bound.normal, ray.from);
        if (std::fabs(speed) < 1e-12) {
            if (gap < 0) return {};
        } else if (speed < 0) {
            in = std::max(in, gap / speed);
        } else {
            out = std::min(out, gap / speed);
        }
    }
    const double margin = std::fabs(out - in);
    if (in > out || in <= 0) return {1e300, margin};
    return {in, margin};
}

std::string authored(const std::vector<Solid>& solids) {
    std::string text;
    for (std::size_t i = 0; i < solids.size(); ++i)
        text += fmt::format("[[object]]\nname = \"s{}\"\nlist = \"list\"\ncolour = \"grey\"\n{}", i,
                            solids[i].text);
    return scene(text);
}

bool apart(const Solid& a, const Solid& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.low[axis] > b.high[axis] + 0.05 || b.low[axis] > a.high[axis] + 0.05) return true;
    return false;
}

} // namespace

CompileResult compiled(const std::vector<Solid>& solids) {
    CompileResult result = compile_text(authored(solids));
    EXPECT_TRUE(result.database) << messages(result);
    return result;
}

std::vector<Solid> random_solids(Random& random, int wanted) {
    std::vector<Solid> solids;
    for (int tries = 0; tries < 2000 && static_cast<int>(solids.size()) < wanted; ++tries) {
        const Vec3d centre = random.point({-10, -10, -10}, {10, 10, 10});
        Solid solid;
        if (random.between(0, 1) < 0.5) {
            const Vec3d half = random.point({0.3, 0.3, 0.3}, {6, 3, 3});
            solid = box(centre - half, centre + half);
        } else {
            const double radius = random.between(0.5, 3), half_height = random.between(0.3, 6);
            const int sides = 3 + static_cast<int>(random.between(0, 5));
            solid = prism(centre, radius, half_height, sides, random.between(0, 6));
        }
        if (std::all_of(solids.begin(), solids.end(),
                        [&](const Solid& other) { return apart(solid, other); }))
            solids.push_back(solid);
    }
    return solids;
}

std::vector<Solid> interlocked_beams() {
    return {box({-5, -1, 0}, {5, 0, 1}), box({-4, -5, 1}, {-3, 5, 2}), box({-5, 3, 2}, {5, 4, 3}),
            box({3, -5, -1}, {4, 2, 0}), box({3.2, 1, 0.2}, {3.8, 5, 1.5})};
}

void walk(const VisualDatabase& d, std::int32_t reference, const Vec3d& eye,
          std::vector<std::uint32_t>& faces) {
    if (reference == none) return;
    if (is_leaf(reference)) {
        const RunLeaf& leaf = d.run_leaves[leaf_index(reference)];
        for (std::uint32_t r = leaf.first_run; r < leaf.first_run + leaf.run_count; ++r)
            for (std::uint32_t f = 0; f < d.runs[r].face_count; ++f)
                faces.push_back(d.runs[r].first_face + f);
        return;
    }
    const PlaneNode& node = d.planes[static_cast<std::size_t>(reference)];
    const bool front = glm::dot(Vec3d(node.normal), eye) > static_cast<double>(node.distance);
    walk(d, front ? node.front : node.back, eye, faces);
    walk(d, node.on, eye, faces);
    walk(d, front ? node.back : node.front, eye, faces);
}

bool meets(const VisualDatabase& d, const Face& face, const Ray& ray, double& distance, double& margin) {
    const Vec3d normal(face.normal);
    const auto corner = [&](std::uint32_t i) {
        return Vec3d(d.vertices[d.corners[face.first_corner + i % face.corner_count]].position);
    };
    const double speed = glm::dot(normal, ray.along);
    if (speed > -1e-9 && (face.two_sided == 0 || speed < 1e-9)) return false;
    distance = glm::dot(normal, corner(0) - ray.from) / speed;
    if (distance <= 0) return false;
    const Vec3d hit = ray.from + distance * ray.along;
    double inside = 1e300;
    for (std::uint32_t i = 0; i < face.corner_count; ++i) {
        const Vec3d edge = corner(i + 1) - corner(i);
        inside = std::min(inside, glm::dot(glm::cross(normal, edge), hit - corner(i)) / glm::length(edge));
    }
    margin = std::min(margin, std::fabs(inside));
    return inside > 0;
}

Met met_in_order(const VisualDatabase& d, const std::vector<std::uint32_t>& order, const Ray& ray) {
    Met met;
    for (const std::uint32_t f : order) {
        double distance = 0;
        if (!meets(d, d.faces[f], ray, distance, met.margin)) continue;
        if (met.first > 1e299) met.first = distance;
        met.nearest = std::min(met.nearest, distance);
    }
    return met;
}

void check_rays(const VisualDatabase& d, const std::vector<Solid>& solids, Random& random, int eyes,
                Tally& tally) {
    for (int e = 0; e < eyes; ++e) {
        const Vec3d eye = random.point({-40, -40, -40}, {40, 40, 40});
        std::vector<std::uint32_t> order;
        walk(d, d.lists[0].root, eye, order);
        for (int r = 0; r < 60; ++r) {
            const Ray ray{eye, glm::normalize(random.point({-12, -12, -12}, {12, 12, 12}) - eye)};
            double nearest = 1e300, margin = 1e300;
            bool inside = false;
            for (const Solid& solid : solids) {
                const Entry entry = enter(solid, ray);
                nearest = std::min(nearest, entry.distance);
                margin = std::min(margin, entry.margin);
                inside =
                    inside || std::all_of(solid.bounds.begin(), solid.bounds.end(), [&](const auto& bound) {
                        return glm::dot(bound.normal, eye) < bound.distance + 0.01;
                    });
            }
            if (inside) break; // nobody looks from within a solid: its faces are culled
            double first = 1e300;
            for (const std::uint32_t f : order) {
                double distance = 0;
                if (!meets(d, d.faces[f], ray, distance, margin)) continue;
                first = distance;
                break;
            }
            ++tally.rays;
            if (margin < 2e-3) {
                ++tally.grazing; // through an edge: either answer is right
                continue;
            }
            tally.hits += nearest < 1e299 ? 1 : 0;
            if (std::fabs(first - nearest) > 1e-2) ++tally.wrong;
        }
    }
}

} // namespace linkdig::database
