#include "ig/machine/load.h"

#include "ig/active/detail_levels.h"
#include "ig/active/shedding.h"

#include <algorithm>
#include <span>

namespace linkdig::ig {

namespace {

/// What the frame at hand would have been at another step.
class Forecast {
public:
    Forecast(const VisualDatabase& database, const FramePacket& packet, const ActiveDatabase& active,
             const History& history, LoadCounts& counts)
        : database_(database), packet_(packet), active_(active), history_(history), counts_(counts) {
        measure();
    }

    /// Edges at a step. What is there now counts as it was counted; what would appear counts in the measure of its detail's
    /// present levels, or (`at_most`) with all its faces on every channel.
    std::uint64_t edges_at(std::uint32_t step, bool at_most) {
        open(step, counts_.opacity);
        std::uint64_t edges = 0;
        for (std::size_t o = 0; o < database_.objects.size(); ++o) {
            const Object& object = database_.objects[o];
            if (!slot_there(object) || active_.object_px[o] < least_size_px(step)) continue;
            if (object.level != none && counts_.opacity[static_cast<std::size_t>(object.level)] == 0)
                continue;
            if (there_now(o) || active_.object_px[o] == 0.0) {
                edges += counts_.object_edges[o];
            } else {
                edges += at_most ? active_.object_worth[o].edges * counts_.channels : in_measure(o);
            }
        }
        return edges;
    }

    /// Details that show a coarser level at a step than at none.
    std::uint64_t coarser_at(std::uint32_t step) {
        open(0, counts_.opacity);
        open(step, counts_.opacity_at_step);
        std::uint64_t coarser = 0;
        for (const Detail& detail : database_.details)
            coarser += finest(detail, counts_.opacity_at_step) > finest(detail, counts_.opacity) ? 1 : 0;
        return coarser;
    }

private:
    /// Opacities of all levels at a step.
    void open(std::uint32_t step, std::vector<std::uint16_t>& opacity) const {
        opacity.resize(database_.detail_levels.size());
        const double bias = static_cast<double>(packet_.lod_bias) + bias_at_step(step);
        for (std::size_t d = 0; d < database_.details.size(); ++d) {
            const Detail& detail = database_.details[d];
            const double range_m = biased_range_m(active_.detail_range_m[d], bias);
            level_opacities(database_, detail, range_m,
                            level_at(database_, detail, range_m, history_.held_level[d]),
                            std::span(opacity).subspan(detail.first_level, detail.levels));
        }
    }

    static std::uint32_t finest(const Detail& detail, const std::vector<std::uint16_t>& opacity) {
        std::uint32_t level = 0;
        while (level < detail.levels && opacity[detail.first_level + level] == 0)
            ++level;
        return level;
    }

    bool slot_there(const Object& object) const {
        return object.slot == none ||
               active_.slot_index[static_cast<std::size_t>(object.slot)] == object.alternative;
    }

    bool there_now(std::size_t o) const {
        const Object& object = database_.objects[o];
        return slot_there(object) && active_.object_shed[o] == 0 && level_opacity(active_, object.level) != 0;
    }

    std::size_t detail_of(const Object& object) const {
        return database_.detail_levels[static_cast<std::size_t>(object.level)].detail;
    }

    /// How many of the edges of its present levels each detail brought to the raster.
    void measure() {
        counts_.seen_of_detail.assign(database_.details.size(), 0);
        counts_.worth_of_detail.assign(database_.details.size(), 0);
        for (std::size_t o = 0; o < database_.objects.size(); ++o) {
            const Object& object = database_.objects[o];
            if (object.level == none || !there_now(o)) continue;
            counts_.seen_of_detail[detail_of(object)] += counts_.object_edges[o];
            counts_.worth_of_detail[detail_of(object)] += active_.object_worth[o].edges;
        }
    }

    std::uint64_t in_measure(std::size_t o) const {
        const Object& object = database_.objects[o];
        const std::uint64_t edges = active_.object_worth[o].edges;
        if (object.level == none) return edges;
        const std::size_t d = detail_of(object);
        return counts_.worth_of_detail[d] == 0
                   ? edges
                   : edges * counts_.seen_of_detail[d] / counts_.worth_of_detail[d];
    }

    const VisualDatabase& database_;
    const FramePacket& packet_;
    const ActiveDatabase& active_;
    const History& history_;
    LoadCounts& counts_;
};

bool within(std::uint64_t count, std::uint64_t limit, std::uint64_t eighths) {
    return limit == 0 || count <= limit / 8 * eighths + limit % 8 * eighths / 8;
}

/// Crossings that go with so many edges, in the measure of the frame.
std::uint64_t crossings_with(const LoadCounts& counts, std::uint64_t edges) {
    return counts.edges == 0 ? 0 : counts.crossings * edges / counts.edges;
}

/// The first step beyond the present one that is enough.
std::uint32_t step_up(Forecast& forecast, const Capacity& capacity, const LoadCounts& counts,
                      const LoadState& load) {
    const std::uint64_t eighths = load.over > 3 ? 4 : 8 - load.over; // a forecast that failed is trusted less
    std::uint32_t step = load.step;
    while (step < most_steps) {
        const std::uint64_t edges = forecast.edges_at(++step, false);
        if (within(edges, capacity.edges, eighths) &&
            within(crossings_with(counts, edges), capacity.crossings_on_a_line, eighths))
            break;
    }
    return step;
}

/// Would one step less stay within the limits whatever returns?
bool bears_less(Forecast& forecast, const Capacity& capacity, const LoadCounts& counts,
                const LoadState& load) {
    const std::uint64_t edges = forecast.edges_at(load.step - 1, true);
    const std::uint64_t returning = edges > counts.edges ? edges - counts.edges : 0;
    return within(edges, capacity.edges, 7) &&
           within(counts.crossings + returning, capacity.crossings_on_a_line, 7);
}

std::uint64_t beyond(std::uint64_t count, std::uint64_t limit) {
    return limit != 0 && count > limit ? count - limit : 0;
}

} // namespace

std::uint64_t most_crossings(const FaceEdges& edges, std::uint32_t lines,
                             std::vector<std::int64_t>& on_line) {
    on_line.assign(std::size_t{lines} + 1, 0);
    for (const Edge& edge : edges.edges) {
        ++on_line[static_cast<std::size_t>(edge.first_line)];
        --on_line[static_cast<std::size_t>(edge.end_line)];
    }
    std::int64_t now = 0;
    std::int64_t most = 0;
    for (const std::int64_t change : on_line)
        most = std::max(most, now += change);
    return static_cast<std::uint64_t>(most);
}

void count_edges(const ActiveDatabase& active, const ProjectedFaces& projected, const FaceEdges& edges,
                 LoadCounts& counts) {
    counts.object_edges.resize(active.database->objects.size());
    for (std::size_t rank = 0; rank < projected.faces.size(); ++rank) {
        const ProjectedFace& face = projected.faces[rank];
        const EdgeFace& made = edges.faces[rank];
        counts.object_edges[active.blocks[face.block].faces[face.face].object] +=
            std::uint64_t{made.leading} + made.trailing;
    }
}

namespace {

/// Steps beyond the present one, and the one before it, are known exactly (ProjectedFaces::lights_at_step).
void settle_lights(const LoadCounts& counts, std::uint64_t limit, LoadState& load, Overload& overload) {
    overload.light_step = load.light_step;
    overload.lights_left_out = counts.lights_left_out;
    overload.lights_over = beyond(counts.lights_at_step[load.light_step], limit);
    if (overload.lights_over != 0) {
        load.light_calm = 0;
        while (load.light_step < light_steps && !within(counts.lights_at_step[load.light_step], limit, 7))
            ++load.light_step;
        return;
    }
    const bool bears_more =
        load.light_step > 0 && within(counts.lights_at_step[load.light_step - 1], limit, 7);
    load.light_calm = bears_more ? load.light_calm + 1 : 0;
    if (load.light_calm >= calm_frames) {
        --load.light_step;
        load.light_calm = 0;
    }
}

} // namespace

Overload settle_load(const VisualDatabase& database, const FramePacket& packet, const Capacity& capacity,
                     const ActiveDatabase& active, LoadCounts& counts, History& history) {
    LoadState& load = history.load;
    Overload overload;
    overload.step = load.step;
    overload.edges_over = beyond(counts.edges, capacity.edges);
    overload.crossings_over = beyond(counts.crossings, capacity.crossings_on_a_line);
    settle_lights(counts, capacity.light_points, load, overload);
    if (load.step == 0 && overload.edges_over == 0 && overload.crossings_over == 0) return overload;
    Forecast forecast(database, packet, active, history, counts);
    if (load.step > 0) {
        overload.range_factor = 1.0 / biased_range_m(1.0, bias_at_step(load.step));
        overload.coarser_details = forecast.coarser_at(load.step);
        overload.least_size_px = least_size_px(load.step);
        overload.objects_left_out = static_cast<std::uint64_t>(
            std::count(active.object_shed.begin(), active.object_shed.end(), std::uint8_t{1}));
    }
    if (overload.edges_over != 0 || overload.crossings_over != 0) {
        ++load.over;
        load.calm = 0;
        load.step = step_up(forecast, capacity, counts, load);
        return overload;
    }
    load.over = 0;
    load.calm = load.step > 0 && bears_less(forecast, capacity, counts, load) ? load.calm + 1 : 0;
    if (load.calm >= calm_frames) {
        --load.step;
        load.calm = 0;
    }
    return overload;
}

} // namespace linkdig::ig
