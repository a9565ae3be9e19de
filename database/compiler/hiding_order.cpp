/// Strongly connected parts of "can hide" (Tarjan, Depth-first search and linear graph algorithms, 1972), in
/// a topological order that keeps to the authored one.

#include "database/compiler/ordering.h"

#include <algorithm>
#include <queue>

namespace linkdig::database {

namespace {

using Graph = std::vector<std::vector<std::uint32_t>>; ///< for each face those that it can hide

Graph hiding_graph(std::span<const OrderFace> faces,
                   const std::function<void(const OrderFace&, const OrderFace&)>& tied) {
    Graph graph(faces.size());
    for (std::uint32_t i = 0; i < faces.size(); ++i)
        for (std::uint32_t j = i + 1; j < faces.size(); ++j) {
            const Relation found = relation(faces[i], faces[j]);
            if (found == Relation::tie) tied(faces[i], faces[j]);
            if (found == Relation::first_hides || found == Relation::both_hide) graph[i].push_back(j);
            if (found == Relation::second_hides || found == Relation::both_hide) graph[j].push_back(i);
        }
    return graph;
}

/// Tarjan's search, with a stack of its own instead of recursion.
class Components {
public:
    explicit Components(const Graph& graph)
        : component(graph.size(), unseen), graph_(&graph), number_(graph.size(), unseen),
          low_(graph.size(), 0) {
        for (std::uint32_t i = 0; i < graph.size(); ++i)
            if (number_[i] == unseen) search(i);
    }

    std::vector<std::uint32_t> component; ///< of each face
    std::uint32_t count = 0;

private:
    static constexpr std::uint32_t unseen = 0xffffffffU;
    struct Visit {
        std::uint32_t face;
        std::size_t next;
    };

    void enter(std::uint32_t face) {
        number_[face] = low_[face] = counter_++;
        open_.push_back(face);
        visits_.push_back({face, 0});
    }

    void search(std::uint32_t root) {
        enter(root);
        while (!visits_.empty()) {
            const std::uint32_t face = visits_.back().face;
            const std::vector<std::uint32_t>& hidden = (*graph_)[face];
            if (visits_.back().next < hidden.size()) {
                const std::uint32_t other = hidden[visits_.back().next++];
                if (number_[other] == unseen)
                    enter(other);
                else if (component[other] == unseen)
                    low_[face] = std::min(low_[face], number_[other]);
                continue;
            }
            visits_.pop_back();
            if (!visits_.empty()) low_[visits_.back().face] = std::min(low_[visits_.back().face], low_[face]);
            if (low_[face] == number_[face]) close(face);
        }
    }

    void close(std::uint32_t root) {
        for (bool last = false; !last;) {
            const std::uint32_t face = open_.back();
            open_.pop_back();
            component[face] = count;
            last = face == root;
        }
        ++count;
    }

    const Graph* graph_;
    std::vector<std::uint32_t> number_, low_, open_;
    std::vector<Visit> visits_;
    std::uint32_t counter_ = 0;
};

} // namespace

std::vector<std::vector<std::uint32_t>>
hiding_order(std::span<const OrderFace> faces,
             const std::function<void(const OrderFace&, const OrderFace&)>& tied) {
    const Graph graph = hiding_graph(faces, tied);
    const Components parts(graph);
    std::vector<std::vector<std::uint32_t>> members(parts.count);
    for (std::uint32_t i = 0; i < faces.size(); ++i)
        members[parts.component[i]].push_back(i);
    std::vector<std::uint32_t> hidden_by(parts.count, 0);
    for (std::uint32_t i = 0; i < faces.size(); ++i)
        for (const std::uint32_t j : graph[i])
            if (parts.component[i] != parts.component[j]) ++hidden_by[parts.component[j]];
    using Free = std::pair<std::uint32_t, std::uint32_t>; // lowest member, component
    std::priority_queue<Free, std::vector<Free>, std::greater<>> free;
    for (std::uint32_t c = 0; c < parts.count; ++c)
        if (hidden_by[c] == 0) free.emplace(members[c].front(), c);
    std::vector<std::vector<std::uint32_t>> order;
    while (!free.empty()) {
        const std::uint32_t c = free.top().second;
        free.pop();
        for (const std::uint32_t i : members[c])
            for (const std::uint32_t j : graph[i]) {
                const std::uint32_t other = parts.component[j];
                if (other != c && --hidden_by[other] == 0) free.emplace(members[other].front(), other);
            }
        order.push_back(std::move(members[c]));
    }
    return order;
}

} // namespace linkdig::database
