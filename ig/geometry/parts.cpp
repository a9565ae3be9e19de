#include "ig/geometry/parts.h"

namespace linkdig::ig {

namespace {

std::uint32_t faces_of(const ActiveDatabase& active, const RankedRun& ranked) {
    return active.blocks[ranked.block].runs[ranked.run].face_count;
}

template <typename Value>
void add_to(const std::vector<Value>& more, std::vector<Value>& all) {
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

OrderPart whole_of(const PriorityOrder& order) { return {{}, {order.runs.size(), 0}}; }

std::uint64_t count_faces(const ActiveDatabase& active, const PriorityOrder& order) {
    std::uint64_t faces = 0;
    for (const RankedRun& ranked : order.runs)
        faces += faces_of(active, ranked);
    return faces;
}

void cut_order(const ActiveDatabase& active, const PriorityOrder& order, std::uint64_t faces,
               std::size_t parts, std::vector<OrderPart>& cut) {
    cut.clear();
    FacePlace from;
    std::uint64_t before = 0; // faces before run `at`
    std::size_t at = 0;
    for (std::size_t part = 1; part < parts; ++part) {
        const std::uint64_t wanted = faces * part / parts;
        for (; at < order.runs.size() && before + faces_of(active, order.runs[at]) <= wanted; ++at)
            before += faces_of(active, order.runs[at]);
        const FacePlace to{at, static_cast<std::uint32_t>(wanted - before)};
        cut.push_back({from, to});
        from = to;
    }
    cut.push_back({from, {order.runs.size(), 0}});
}

void append(const ProjectedFaces& part, ProjectedFaces& all) {
    const auto first_point = static_cast<std::uint32_t>(all.points.size());
    const auto first_triangle = static_cast<std::int32_t>(all.triangles.size());
    const auto first_depth = static_cast<std::int32_t>(all.depths.size());
    const auto first_rank = static_cast<std::uint32_t>(all.faces.size());
    all.faces.reserve(all.faces.size() + part.faces.size());
    for (const ProjectedFace& face : part.faces) {
        ProjectedFace& added = all.faces.emplace_back(face);
        added.first_point += first_point;
        if (added.triangle >= 0) added.triangle += first_triangle;
        if (added.depth >= 0) added.depth += first_depth;
    }
    add_to(part.points, all.points);
    add_to(part.triangles, all.triangles);
    add_to(part.depths, all.depths);
    for (const ProjectedLight& light : part.lights)
        all.lights.emplace_back(light).rank += first_rank;
    all.offered += part.offered;
    all.lights_offered += part.lights_offered;
    all.lights_left_out += part.lights_left_out;
    for (std::size_t step = 0; step < all.lights_at_step.size(); ++step)
        all.lights_at_step[step] += part.lights_at_step[step];
}

} // namespace linkdig::ig
