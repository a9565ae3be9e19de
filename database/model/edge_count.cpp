#include "database/model/edge_count.h"

#include "database/model/most_at_once.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace linkdig {

namespace {

std::array<float, 4> place_of(const Vertex& vertex) {
    const Vec4f& p = vertex.position;
    return {p.x, p.y, p.z, p.w};
}

/// For each vertex the lowest vertex at the same place.
std::vector<std::uint32_t> number_places(const VisualDatabase& database) {
    const std::vector<Vertex>& vertices = database.vertices;
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto first = place_of(vertices[a]), second = place_of(vertices[b]);
        return first != second ? first < second : a < b;
    });
    std::vector<std::uint32_t> places(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && place_of(vertices[order[i]]) == place_of(vertices[order[i - 1]]);
        places[order[i]] = same ? places[order[i - 1]] : order[i];
    }
    return places;
}

struct OwnedEdge {
    std::uint32_t owner;
    std::uint32_t low, high;
    bool operator==(const OwnedEdge&) const = default;
    bool operator<(const OwnedEdge& other) const {
        return std::tie(owner, low, high) < std::tie(other.owner, other.low, other.high);
    }
};

/// How many different edges each owner has.
std::vector<std::uint32_t> count_by_owner(std::vector<OwnedEdge>& edges, std::size_t owners) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::uint32_t> counts(owners, 0);
    for (const OwnedEdge& edge : edges)
        ++counts[edge.owner];
    return counts;
}

/// Of each list: the objects that may be there together, each with its edges, and no more than the list has at all.
std::vector<std::uint32_t> count_at_most(const VisualDatabase& database,
                                         const std::vector<std::uint32_t>& objects,
                                         const std::vector<std::uint32_t>& lists) {
    std::vector<MostAtOnce> present(database.lists.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const Object& object = database.objects[i];
        present[object.list].add(object.slot, object.alternative, object.level, objects[i]);
    }
    std::vector<std::uint32_t> most;
    for (std::size_t i = 0; i < lists.size(); ++i)
        most.push_back(std::min(lists[i], static_cast<std::uint32_t>(present[i].most(database))));
    return most;
}

} // namespace

EdgeCounts count_edges(const VisualDatabase& database) {
    const std::vector<std::uint32_t> places = number_places(database);
    std::vector<OwnedEdge> edges;
    edges.reserve(database.corners.size());
    for (const Face& face : database.faces)
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const std::uint32_t next = i + 1 == face.corner_count ? 0 : i + 1;
            const auto [low, high] = std::minmax(places[database.corners[face.first_corner + i]],
                                                 places[database.corners[face.first_corner + next]]);
            edges.push_back({face.object, low, high});
        }
    EdgeCounts counts;
    counts.objects = count_by_owner(edges, database.objects.size());
    for (OwnedEdge& edge : edges)
        edge.owner = database.objects[edge.owner].list;
    counts.lists = count_by_owner(edges, database.lists.size());
    counts.lists_at_most = count_at_most(database, counts.objects, counts.lists);
    return counts;
}

} // namespace linkdig
