// Trees of separating planes: each plane, cluster, list, leaf, run and face stands in at most one place, so
// that walking the trees ends, and visits nothing twice.

#include "database/format/validate.h"
#include "database/format/validate_parts.h"

namespace linkdig::database {

namespace {

/// Marks things as met; false the second time.
class Once {
public:
    explicit Once(std::size_t count) : met_(count, 0) {}
    bool first_time(std::size_t i) { return met_[i]++ == 0; }
    /// First thing never met, or the count of things.
    std::size_t missing() const {
        std::size_t i = 0;
        while (i < met_.size() && met_[i] != 0)
            ++i;
        return i;
    }
    std::size_t size() const { return met_.size(); }

private:
    std::vector<std::uint8_t> met_; // at most 2: the check ends there
};

class TreeCheck {
public:
    explicit TreeCheck(const VisualDatabase& database)
        : d_(database), planes_(database.planes.size()), clusters_(database.clusters.size()),
          lists_(database.lists.size()), leaves_(database.run_leaves.size()), runs_(database.runs.size()),
          faces_(database.faces.size()), lights_(database.lights.size()) {}

    std::string run() {
        for (std::size_t i = 0; i < d_.groups.size() && reason_.empty(); ++i)
            walk("groups", i, d_.groups[i].root, false, [&](std::size_t leaf) { cluster_leaf(i, leaf); });
        for (std::size_t i = 0; i < d_.clusters.size() && reason_.empty(); ++i)
            walk("clusters", i, d_.clusters[i].root, true, [&](std::size_t leaf) { list_leaf(i, leaf); });
        for (std::size_t i = 0; i < d_.lists.size() && reason_.empty(); ++i)
            walk("lists", i, d_.lists[i].root, false, [&](std::size_t leaf) { run_leaf(i, leaf); });
        must_all_be_met(planes_, "planes", "no tree");
        must_all_be_met(leaves_, "run_leaves", "no list's tree");
        must_all_be_met(runs_, "runs", "no leaf");
        must_all_be_met(faces_, "faces", "no run");
        must_all_be_met(lights_, "lights", "no run");
        return reason_;
    }

private:
    struct Step {
        std::int32_t reference;
        std::uint32_t depth;
    };

    template <typename Leaf>
    void walk(std::string_view owners, std::size_t owner, std::int32_t root, bool may_float, Leaf&& leaf) {
        steps_.assign(1, {root, 1});
        while (!steps_.empty() && reason_.empty()) {
            const Step step = steps_.back();
            steps_.pop_back();
            if (is_leaf(step.reference)) {
                leaf(leaf_index(step.reference));
            } else if (step.reference != none) {
                node(static_cast<std::size_t>(step.reference), step.depth, may_float);
            }
        }
        if (!reason_.empty()) reason_ = fmt::format("{} (in the tree of {}[{}])", reason_, owners, owner);
    }

    void node(std::size_t index, std::uint32_t depth, bool may_float) {
        if (index >= planes_.size())
            return refuse(
                fmt::format("a reference to plane {}, but there are {} planes", index, planes_.size()));
        if (!planes_.first_time(index)) return refuse(fmt::format("planes[{}] is referred to twice", index));
        if (depth > max_tree_depth)
            return refuse(fmt::format("the tree is more than {} planes deep", max_tree_depth));
        const PlaneNode& plane = d_.planes[index];
        if (plane.waterline != 0 && !may_float)
            return refuse(
                fmt::format("planes[{}].waterline is set, but only a cluster's planes can float", index));
        for (const std::int32_t child : {plane.front, plane.on, plane.back})
            steps_.push_back({child, depth + 1});
    }

    void cluster_leaf(std::size_t group, std::size_t leaf) {
        if (leaf >= clusters_.size())
            return refuse(
                fmt::format("a reference to cluster {}, but there are {} clusters", leaf, clusters_.size()));
        if (!clusters_.first_time(leaf))
            return refuse(fmt::format("clusters[{}] is referred to twice", leaf));
        if (d_.clusters[leaf].group != group)
            return refuse(fmt::format("clusters[{}] belongs to groups[{}]", leaf, d_.clusters[leaf].group));
        if (d_.clusters[leaf].moving_object != none)
            return refuse(fmt::format("clusters[{}] moves; expected a static one", leaf));
    }

    void list_leaf(std::size_t cluster, std::size_t leaf) {
        if (leaf >= lists_.size())
            return refuse(fmt::format("a reference to list {}, but there are {} lists", leaf, lists_.size()));
        if (!lists_.first_time(leaf)) return refuse(fmt::format("lists[{}] is referred to twice", leaf));
        if (d_.lists[leaf].cluster != cluster)
            return refuse(fmt::format("lists[{}] belongs to clusters[{}]", leaf, d_.lists[leaf].cluster));
    }

    void run_leaf(std::size_t list, std::size_t leaf) {
        if (leaf >= leaves_.size())
            return refuse(
                fmt::format("a reference to leaf {}, but there are {} run_leaves", leaf, leaves_.size()));
        if (!leaves_.first_time(leaf))
            return refuse(fmt::format("run_leaves[{}] is referred to twice", leaf));
        const RunLeaf& runs = d_.run_leaves[leaf];
        if (!span_fits(runs.first_run, runs.run_count, runs_.size()))
            return refuse(
                out_of_range("run_leaves", leaf, "first_run", runs.first_run, runs_.size(), "runs"));
        for (std::size_t i = 0; i < runs.run_count && reason_.empty(); ++i)
            face_run(list, runs.first_run + i);
    }

    void face_run(std::size_t list, std::size_t index) {
        if (!runs_.first_time(index)) return refuse(fmt::format("runs[{}] stands in two leaves", index));
        const FaceRun& run = d_.runs[index];
        for (std::size_t i = 0; i < run.face_count && reason_.empty(); ++i)
            face(list, index, std::size_t{run.first_face} + i);
        std::uint32_t before = 0;
        for (std::size_t i = 0; i < run.light_count && reason_.empty(); ++i)
            light(list, index, std::size_t{run.first_light} + i, before);
    }

    void light(std::size_t list, std::size_t run_index, std::size_t index, std::uint32_t& before) {
        if (!lights_.first_time(index)) return refuse(fmt::format("lights[{}] stands in two runs", index));
        const FaceRun& run = d_.runs[run_index];
        const LightPoint& light = d_.lights[index];
        if (light.place > run.face_count || light.place < before)
            return refuse(fmt::format("lights[{}].place is {}; expected {} to {}, in ascending order", index,
                                      light.place, before, run.face_count));
        before = light.place;
        check_owner("lights", index, light.object, list, run_index);
    }

    void check_owner(std::string_view things, std::size_t index, std::uint32_t object_index, std::size_t list,
                     std::size_t run_index) {
        const FaceRun& run = d_.runs[run_index];
        const Object& object = d_.objects[object_index];
        if (object.list != list)
            return refuse(fmt::format("{}[{}] belongs to lists[{}]", things, index, object.list));
        if (object.slot != run.slot || (run.slot != none && object.alternative != run.alternative))
            return refuse(fmt::format("runs[{}] has another slot or alternative than the object of {}[{}]",
                                      run_index, things, index));
        if (object.level != run.level)
            return refuse(fmt::format("runs[{}] has another level of detail than the object of {}[{}]",
                                      run_index, things, index));
    }

    void face(std::size_t list, std::size_t run_index, std::size_t index) {
        if (!faces_.first_time(index)) return refuse(fmt::format("faces[{}] stands in two runs", index));
        check_owner("faces", index, d_.faces[index].object, list, run_index);
    }

    void must_all_be_met(const Once& things, std::string_view what, std::string_view where) {
        if (reason_.empty() && things.missing() < things.size())
            reason_ = fmt::format("{}[{}] stands in {}", what, things.missing(), where);
    }

    void refuse(std::string why) { reason_ = std::move(why); }

    const VisualDatabase& d_;
    Once planes_, clusters_, lists_, leaves_, runs_, faces_, lights_;
    std::vector<Step> steps_;
    std::string reason_;
};

} // namespace

std::string check_trees(const VisualDatabase& database) { return TreeCheck(database).run(); }

} // namespace linkdig::database
