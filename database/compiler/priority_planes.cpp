#include "database/compiler/priority_planes.h"

#include "database/compiler/ordering.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace linkdig::database {

namespace {

/// A plane as written: the names of its sides are not resolved yet.
struct AuthoredPlane {
    std::string name;
    PlaneNode node;
    std::array<std::vector<std::string>, 3> sides; ///< front, on, back; several names: front to back
    Place at;
};

constexpr std::array<const char*, 3> side_keys{"front", "on", "back"};

/// A name, or an array of names.
std::vector<std::string> read_names(TableReader& reader, const char* key) {
    reader.describe(key, "name, or array of names, front to back", "nothing");
    const toml::node* node = reader.node(key);
    if (node != nullptr && node->as_array() != nullptr) return reader.texts(key);
    if (node == nullptr) return {};
    return {reader.text(key)};
}

AuthoredPlane read_plane(TableReader& reader, Place at) {
    AuthoredPlane plane;
    plane.at = at;
    plane.name = reader.text("name");
    const Vec3d normal = reader.vector("normal");
    const double length = glm::length(normal);
    if (reader.has("normal") && length < 1e-9)
        reader.error_at("normal", "the plane's normal has no length; expected a vector");
    plane.node.normal = length < 1e-9 ? Vec3f(0, 0, 1) : Vec3f(normal / length);
    plane.node.distance = static_cast<float>(reader.length_m("distance", {}, {-1e7, 1e7}));
    for (std::size_t side = 0; side < 3; ++side)
        plane.sides[side] = read_names(reader, side_keys[side]);
    return plane;
}

/// The planes of one cluster or group become a tree over its leaves.
class TreeBuilder {
public:
    TreeBuilder(std::string owner, const char* leaf_kind, const std::vector<AuthoredPlane>& planes,
                std::map<std::string, std::uint32_t> leaves, const Reading& reading,
                std::vector<PlaneNode>& nodes)
        : owner_(std::move(owner)), leaf_kind_(leaf_kind), planes_(planes), leaves_(std::move(leaves)),
          reading_(reading), nodes_(nodes), used_(planes.size(), false) {}

    /// The first plane is the root.
    std::int32_t build() {
        if (planes_.empty()) return none;
        std::map<std::string, Place> names;
        for (const AuthoredPlane& plane : planes_) {
            const auto [first, is_new] = names.emplace(plane.name, plane.at);
            if (!is_new && !plane.name.empty())
                reading_.error(
                    plane.at,
                    fmt::format("the plane \"{}\" of {} stands already in line {}; expected another name",
                                plane.name, owner_, first->second.line));
        }
        used_[0] = true;
        const std::int32_t root = node(0);
        for (std::size_t i = 1; i < planes_.size(); ++i)
            if (!used_[i])
                reading_.error(planes_[i].at,
                               fmt::format("no plane of {} leads to the plane \"{}\"; expected its name as "
                                           "front, on or back of another",
                                           owner_, planes_[i].name));
        return root;
    }

    const std::set<std::uint32_t>& decided() const { return decided_; }

private:
    std::int32_t node(std::size_t index) {
        const AuthoredPlane& plane = planes_[index];
        PlaneNode result = plane.node;
        std::array<std::int32_t, 3> sides{};
        for (std::size_t side = 0; side < 3; ++side) {
            std::vector<std::int32_t> references;
            for (const std::string& name : plane.sides[side])
                references.push_back(reference(name, plane, side_keys[side]));
            std::erase(references, none);
            sides[side] = fixed_order(references, nodes_);
        }
        result.front = sides[0];
        result.on = sides[1];
        result.back = sides[2];
        nodes_.push_back(result);
        return static_cast<std::int32_t>(nodes_.size()) - 1;
    }

    std::int32_t reference(const std::string& name, const AuthoredPlane& from, const char* side) {
        if (name.empty()) return none;
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            if (planes_[i].name != name) continue;
            if (!used_[i]) {
                used_[i] = true;
                return node(i);
            }
            reading_.error(
                from.at,
                fmt::format("the {} of plane \"{}\" leads to the plane \"{}\" a second time; expected "
                            "a tree",
                            side, from.name, name));
            return none;
        }
        const auto leaf = leaves_.find(name);
        if (leaf == leaves_.end()) {
            unknown(name, from, side);
            return none;
        }
        if (decided_.insert(leaf->second).second) return leaf_reference(leaf->second);
        reading_.error(
            from.at,
            fmt::format("the {} of plane \"{}\" names the {} \"{}\" a second time; expected each once", side,
                        from.name, leaf_kind_, name));
        return none;
    }

    void unknown(const std::string& name, const AuthoredPlane& from, const char* side) const {
        std::vector<std::string> known;
        for (const AuthoredPlane& plane : planes_)
            known.push_back(plane.name);
        for (const auto& [leaf, index] : leaves_)
            known.push_back(leaf);
        const std::string closest = suggestion(name, known);
        reading_.error(from.at,
                       fmt::format("the {} of plane \"{}\" names \"{}\", which is no plane or {} of {}; {}",
                                   side, from.name, name, leaf_kind_, owner_,
                                   closest.empty() ? "expected one of those"
                                                   : fmt::format("did you mean {}?", closest)));
    }

    std::string owner_;
    const char* leaf_kind_;
    const std::vector<AuthoredPlane>& planes_;
    std::map<std::string, std::uint32_t> leaves_;
    const Reading& reading_;
    std::vector<PlaneNode>& nodes_;
    std::vector<bool> used_;
    std::set<std::uint32_t> decided_;
};

class PriorityReader {
public:
    PriorityReader(const AuthoredTables& tables, const Reading& reading)
        : reading_(reading), registry_(*reading.registry), planes_of_cluster_(registry_.clusters.size()) {
        for (const AuthoredTable each : tables.cluster_planes)
            read_cluster_plane(each);
        for (const AuthoredTable each : tables.group_planes)
            read_group_plane(each);
        number_groups();
    }

    PriorityPlanes build() {
        for (std::uint32_t c = 0; c < registry_.clusters.size(); ++c)
            result_.cluster_roots.push_back(cluster_root(c));
        for (PriorityGroup& group : result_.groups)
            group.root = group_root(group.number);
        return std::move(result_);
    }

private:
    void read_cluster_plane(AuthoredTable table) {
        TableReader reader = reader_of(table, *reading_.sources, "cluster_plane", *reading_.diagnostics);
        const auto cluster = named(reader, "cluster", registry_.cluster_names, true);
        AuthoredPlane plane = read_plane(reader, place_of(*table.table, table.file));
        const bool moving = cluster && registry_.clusters[*cluster].moving_object != none;
        reader.describe("frame", R"("body" or "waterline" or "world")",
                        R"("body" in a moving cluster, else "world")");
        const std::size_t frame = reader.choice("frame", moving ? 0 : 2, {"body", "waterline", "world"});
        plane.node.waterline = frame == 1 ? 1 : 0;
        if (cluster && moving == (frame == 2))
            reader.error_at(
                "frame", moving
                             ? "a plane of a moving cluster moves with it; expected \"body\" or \"waterline\""
                             : "a plane of a static cluster stands in the world; expected \"world\"");
        reader.finish();
        if (cluster) planes_of_cluster_[*cluster].push_back(std::move(plane));
    }

    void read_group_plane(AuthoredTable table) {
        TableReader reader = reader_of(table, *reading_.sources, "group_plane", *reading_.diagnostics);
        const auto number = static_cast<std::int32_t>(reader.integer("priority", -1000000, 1000000));
        planes_of_group_[number].push_back(read_plane(reader, place_of(*table.table, table.file)));
        reader.finish();
    }

    void number_groups() {
        std::map<std::int32_t, std::uint32_t> index;
        for (const AuthoredCluster& cluster : registry_.clusters)
            index.emplace(cluster.group_number, 0);
        for (auto& [number, position] : index) {
            position = static_cast<std::uint32_t>(result_.groups.size());
            result_.groups.push_back({number, none});
        }
        for (const AuthoredCluster& cluster : registry_.clusters)
            result_.cluster_groups.push_back(index[cluster.group_number]);
        for (const auto& [number, planes] : planes_of_group_)
            if (index.find(number) == index.end())
                reading_.error(
                    planes.front().at,
                    fmt::format("no cluster has the priority {}; expected a group that exists", number));
    }

    std::int32_t cluster_root(std::uint32_t cluster) {
        const std::string owner = fmt::format("cluster \"{}\"", registry_.cluster_names.names()[cluster]);
        std::map<std::string, std::uint32_t> lists;
        for (std::uint32_t i = 0; i < registry_.lists.size(); ++i)
            if (registry_.lists[i].in_cluster && registry_.lists[i].list.cluster == cluster)
                lists.emplace(registry_.lists[i].list.name, i);
        TreeBuilder builder(owner, "object list", planes_of_cluster_[cluster], lists, reading_,
                            result_.nodes);
        const std::int32_t root = builder.build();
        std::map<std::int32_t, std::vector<std::uint32_t>> by_number;
        for (const auto& [name, index] : lists)
            by_number[registry_.lists[index].list.number].push_back(index);
        for (auto& [number, equal] : by_number) {
            std::sort(equal.begin(), equal.end());
            tell_list_ties(owner, number, equal, builder.decided());
        }
        return root;
    }

    void tell_list_ties(const std::string& owner, std::int32_t number,
                        const std::vector<std::uint32_t>& equal,
                        const std::set<std::uint32_t>& decided) const {
        for (const std::uint32_t index : equal) {
            if (equal.size() < 2 || decided.count(index) != 0) continue;
            const std::uint32_t other = index == equal[0] ? equal[1] : equal[0];
            reading_.error(
                registry_.lists[index].at,
                fmt::format("tie: object lists \"{}\" and \"{}\" of {} have the same priority {}; expected "
                            "different ones or a [[cluster_plane]] that names both",
                            registry_.lists[index].list.name, registry_.lists[other].list.name, owner,
                            number));
        }
    }

    std::int32_t group_root(std::int32_t number) {
        std::map<std::string, std::uint32_t> clusters;
        std::vector<std::uint32_t> standing;
        for (std::uint32_t c = 0; c < registry_.clusters.size(); ++c) {
            const AuthoredCluster& cluster = registry_.clusters[c];
            if (cluster.group_number != number || cluster.moving_object != none) continue;
            clusters.emplace(registry_.cluster_names.names()[c], c);
            standing.push_back(c);
        }
        TreeBuilder builder(fmt::format("priority group {}", number), "static cluster",
                            planes_of_group_[number], clusters, reading_, result_.nodes);
        const std::int32_t root = builder.build();
        if (root == none && standing.size() == 1) return leaf_reference(standing.front());
        for (const std::uint32_t c : standing)
            if (builder.decided().count(c) == 0)
                reading_.error(
                    registry_.clusters[c].at,
                    fmt::format("tie: no plane orders the static cluster \"{}\" among the {} of priority {}; "
                                "expected another priority or a [[group_plane]] that names it",
                                registry_.cluster_names.names()[c], standing.size(), number));
        return root;
    }

    Reading reading_;
    const Registry& registry_;
    std::vector<std::vector<AuthoredPlane>> planes_of_cluster_;
    std::map<std::int32_t, std::vector<AuthoredPlane>> planes_of_group_;
    PriorityPlanes result_;
};

} // namespace

PriorityPlanes read_priority_planes(const AuthoredTables& tables, const Reading& reading) {
    return PriorityReader(tables, reading).build();
}

} // namespace linkdig::database
