#include "ig/machine/machine.h"

#include "host/packet/check_packet.h"
#include "ig/active/activate.h"
#include "ig/active/shedding.h"
#include "ig/edges/edges.h"
#include "ig/geometry/parts.h"
#include "ig/geometry/project.h"
#include "ig/lights/splat.h"
#include "ig/machine/fork_join.h"
#include "ig/machine/load.h"
#include "ig/priority/prioritise.h"
#include "ig/scanline/bands.h"
#include "ig/scanline/scanline.h"
#include "ig/video/video.h"
#include "ig/water/make_wakes.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

namespace linkdig::ig {

namespace {

/// What one thread needs to draw a band.
struct BandWorker {
    BandScratch scratch;
    BandSegments segments;
    VideoScratch video;
    double scanline_s = 0.0; ///< of the frame at hand, if stages are measured
    double video_s = 0.0;
};

/// What a band reports; summed in band order, so that counts do not depend on threads.
struct BandCounts {
    std::uint64_t segments = 0;
    std::uint64_t most_on_a_line = 0;
    std::uint64_t light_pixels = 0;
};

/// Faces that make it worth while to share a channel's geometry among threads.
constexpr std::uint64_t faces_worth_sharing = 512;
/// And of a part to join faces and edges at the same time.
constexpr std::size_t faces_worth_joining = 2048;

/// What one thread needs to project a part of a channel's faces; the first part goes where the whole will stand.
struct GeometryPart {
    GeometryScratch scratch;
    ProjectedFaces projected;
    FaceEdges edges;
};

/// One channel's stages, in order, and what passes between them.
struct Channel {
    Vec3d eye_m{0};
    PriorityScratch priority_scratch;
    PriorityOrder order;
    std::vector<OrderPart> cut;
    std::vector<GeometryPart> parts;
    ProjectedFaces projected;
    FaceEdges edges;
    Splats splats;
    Bands bands;
    Air air;
    std::vector<FaceAir> face_air;
    std::vector<BandCounts> counts;
    std::vector<std::int64_t> on_line;
    VideoFrame picture;
};

std::uint32_t threads_of(const Configuration& configuration) {
    return configuration.threads != 0 ? configuration.threads
                                      : std::max(1U, std::thread::hardware_concurrency());
}

void check(const Configuration& configuration) {
    const Raster& raster = configuration.raster;
    if (raster.width < 1 || raster.height < 1 || raster.width > max_raster_side ||
        raster.height > max_raster_side) {
        throw std::invalid_argument("raster is " + std::to_string(raster.width) + " x " +
                                    std::to_string(raster.height) +
                                    " pixels; expected 1 to 4096 on each side");
    }
    if (configuration.threads > 256) {
        throw std::invalid_argument("threads is " + std::to_string(configuration.threads) +
                                    "; expected 0 to 256");
    }
}

/// Vertex normals can be sent for lists that repeat a tile, as many as the tile has. Empty: they fit.
std::string check_normal_updates(const VisualDatabase& database, const FramePacket& packet) {
    for (std::size_t k = 0; k < packet.normal_updates.size(); ++k) {
        const VertexNormalUpdate& update = packet.normal_updates[k];
        const std::string field = "normal_updates[" + std::to_string(k) + "]";
        const std::int32_t tile = database.lists[update.list].tile;
        if (tile == none) return field + ".list has no repeated tile; expected a list that has one";
        const std::size_t period = database.tiles[static_cast<std::size_t>(tile)].period;
        if (update.first + update.normals.size() > period * period) {
            return field + " ends at normal " + std::to_string(update.first + update.normals.size()) +
                   "; expected at most " + std::to_string(period * period);
        }
    }
    return {};
}

/// The faces of a wake are those of a list that has none. Empty: all is well.
std::string check_wakes(const VisualDatabase& database, const FramePacket& packet) {
    for (std::size_t k = 0; k < packet.wakes.size(); ++k) {
        const ObjectList& list = database.lists[packet.wakes[k].list];
        if (list.root != none || list.tile != none)
            return "wakes[" + std::to_string(k) + "].list has faces of its own; expected a list without";
    }
    return {};
}

Colour background_of(const FramePacket& packet) {
    const auto level = [](float value) {
        return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F));
    };
    return {level(packet.sky.x), level(packet.sky.y), level(packet.sky.z)};
}

BandCounts count(const BandSegments& band) {
    return {.segments = band.segments.size(), .most_on_a_line = *std::ranges::max_element(band.on_line)};
}

} // namespace

struct Machine::State {
    State(const VisualDatabase& visual_database, const Configuration& built_as)
        : database(visual_database), configuration(built_as), limits(packet_limits(visual_database)),
          parallelism(tbb::global_control::max_allowed_parallelism,
                      std::max(threads_of(built_as), threads_of({}))),
          arena(static_cast<int>(threads_of(built_as))), workers(threads_of(built_as)) {
        if (configuration.capacity.limited()) active.object_worth = object_worths(database);
    }

    const VisualDatabase& database;
    Configuration configuration;
    PacketLimits limits;
    tbb::global_control parallelism; ///< lets an arena have more threads than the machine has cores
    tbb::task_arena arena;
    std::vector<BandWorker> workers; ///< one per thread of the arena
    History history;
    std::vector<Colour> colours; ///< of the packet at hand
    Colour background;
    ActiveDatabase active;
    std::vector<Channel> channels;
    WakeMakers wake_makers;
    LoadCounts load;
    FrameReport report;
    bool intensity_plane = false;
    bool rank_plane = false;
    bool measuring = false;
    StageTimes times;

    /// Runs a stage; its time goes to `share` if stages are measured.
    template <typename Stage>
    void run(double StageTimes::*share, Stage stage) {
        const StageClock clock(measuring ? &(times.*share) : nullptr);
        stage();
    }

    /// Else the report says why not.
    bool accepts(const FramePacket& packet) {
        report.frame = packet.frame;
        report.errors.clear();
        std::string refusal = check_packet(packet, limits);
        if (refusal.empty()) refusal = check_normal_updates(database, packet);
        if (refusal.empty()) refusal = check_wakes(database, packet);
        if (!refusal.empty()) report.errors.push_back(std::move(refusal));
        return report.errors.empty();
    }

    /// The block diagram.
    void draw(const FramePacket& packet) {
        times = {};
        const std::vector<Colour>& codes = packet.colours.empty() ? database.colours : packet.colours;
        colours.assign(codes.begin(), codes.end());
        background = background_of(packet);
        run(&StageTimes::active_s, [&] { activate(database, packet, configuration, history, active); });
        make_the_water(packet);
        channels.resize(packet.channels.size());
        report.channels.assign(packet.channels.size(), {});
        clear_load();
        for (std::size_t c = 0; c < packet.channels.size(); ++c) {
            if (packet.channels[c].on) draw(packet, packet.channels[c], channels[c], report.channels[c]);
        }
        if (configuration.capacity.limited())
            report.overload = settle_load(database, packet, configuration.capacity, active, load, history);
        gather_times();
    }

    void draw(const FramePacket& packet, const ChannelView& view, Channel& channel, ChannelReport& counts) {
        const Raster& raster = configuration.raster;
        channel.eye_m = view.eye_m;
        run(&StageTimes::priority_s,
            [&] { prioritise(active, view, channel.priority_scratch, channel.order); });
        run(&StageTimes::geometry_s, [&] {
            cut(channel);
            for_parts(channel, [&](std::size_t p, GeometryPart& part) {
                project(active, channel.order, channel.cut[p], view, raster,
                        {.depth = packet.visibility_m > 0.0F, .low_faces = configuration.edge_smoothing},
                        part.scratch, p == 0 ? channel.projected : part.projected);
            });
            channel.air.prepare(channel.projected.scale, raster, static_cast<double>(packet.visibility_m),
                                background);
        });
        run(&StageTimes::edges_s, [&] {
            for_parts(channel, [&](std::size_t p, GeometryPart& part) {
                make_edges(p == 0 ? channel.projected : part.projected, raster, configuration.edge_smoothing,
                           p == 0 ? channel.edges : part.edges);
            });
            join_parts(channel);
        });
        run(&StageTimes::lights_s,
            [&] { make_splats(channel.projected.lights, raster, band_lines, channel.splats); });
        run(&StageTimes::bands_s, [&] { sort_into_bands(channel.edges, raster.lines(), channel.bands); });
        open_frame(raster, intensity_plane, rank_plane, channel.picture);
        run(&StageTimes::video_s,
            [&] { judge_air(channel.projected, channel.edges, channel.air, channel.face_air); });
        draw_bands(channel);
        tell(channel, counts);
        count_wake_edges(channel);
        counts.most_crossings_on_a_line = most_crossings(channel.edges, raster.lines(), channel.on_line);
        if (configuration.capacity.limited()) add_load(channel, counts);
    }

    /// A part for each thread, if there are faces enough.
    void cut(Channel& channel) const {
        const std::uint64_t faces = count_faces(active, channel.order);
        cut_order(active, channel.order, faces, faces < faces_worth_sharing ? 1 : workers.size(),
                  channel.cut);
        if (channel.parts.size() < channel.cut.size()) channel.parts.resize(channel.cut.size());
    }

    /// work(number, part) for each part of a channel's faces, shared among the threads.
    template <typename Work>
    void for_parts(Channel& channel, const Work& work) {
        if (channel.cut.size() == 1) {
            work(0, channel.parts[0]);
            return;
        }
        fork_join(arena, static_cast<std::uint32_t>(channel.cut.size()),
                  [&](std::uint32_t p, std::uint32_t /*thread*/) { work(p, channel.parts[p]); });
    }

    /// Faces and edges of all parts behind the first ones': each of the two on a thread of its own, if there are many.
    void join_parts(Channel& channel) {
        const auto join_faces = [&] {
            for (std::size_t p = 1; p < channel.cut.size(); ++p)
                append(channel.parts[p].projected, channel.projected);
        };
        const auto join_edges = [&] {
            for (std::size_t p = 1; p < channel.cut.size(); ++p)
                append(channel.parts[p].edges, channel.edges);
        };
        if (channel.cut.size() > 1 && channel.projected.faces.size() > faces_worth_joining) {
            fork_join(arena, 2, [&](std::uint32_t piece, std::uint32_t /*thread*/) {
                piece == 0 ? join_faces() : join_edges();
            });
        } else {
            join_faces();
            join_edges();
        }
    }

    void make_the_water(const FramePacket& packet) {
        report.wakes.clear();
        report.wakes_s = 0.0;
        if (packet.wakes.empty() && history.trails.empty() && history.particle_wakes.empty()) return;
        {
            const StageClock clock(&report.wakes_s);
            arena.execute([&] {
                follow_wakes(database, packet, wake_makers, history);
                make_wake_faces(packet, history, wake_makers, active, report.wakes);
            });
        }
        times.water_s = measuring ? report.wakes_s : 0.0;
    }

    /// The edges of the made faces of one channel.
    void count_wake_edges(const Channel& channel) {
        if (report.wakes.empty()) return;
        for (std::size_t rank = 0; rank < channel.projected.faces.size(); ++rank) {
            const auto same =
                std::ranges::find(report.wakes, channel.projected.faces[rank].list, &WakeReport::list);
            if (same == report.wakes.end()) continue;
            const EdgeFace& made = channel.edges.faces[rank];
            same->edges += std::uint64_t{made.leading} + made.trailing;
        }
    }

    void clear_load() {
        load.edges = load.crossings = load.channels = 0;
        load.lights_at_step = {};
        load.lights_left_out = 0;
        std::fill(load.object_edges.begin(), load.object_edges.end(), 0);
    }

    void add_load(const Channel& channel, const ChannelReport& counts) {
        count_edges(active, channel.projected, channel.edges, load);
        load.edges += counts.edges;
        load.crossings = std::max(load.crossings, counts.most_crossings_on_a_line);
        for (std::size_t step = 0; step < load.lights_at_step.size(); ++step)
            load.lights_at_step[step] += channel.projected.lights_at_step[step];
        load.lights_left_out += channel.projected.lights_left_out;
        ++load.channels;
    }

    VideoInput video_input(const Channel& channel) const {
        return {&channel.projected, &channel.edges,   colours,         background,
                &channel.air,       database.colours, channel.face_air};
    }

    void draw_bands(Channel& channel) {
        const Raster& raster = configuration.raster;
        const VideoInput input = video_input(channel);
        const std::uint32_t bands = band_count(raster.lines());
        channel.counts.assign(bands, {});
        const auto draw_one = [&](std::uint32_t band, BandWorker& worker) {
            worker.segments.first_line = band * band_lines;
            worker.segments.end_line = std::min((band + 1) * band_lines, raster.lines());
            {
                const StageClock clock(measuring ? &worker.scanline_s : nullptr);
                resolve_band(channel.edges, channel.bands.of(band), channel.splats.of(band),
                             channel.splats.pixels, raster.elements(), configuration.edge_smoothing,
                             worker.scratch, worker.segments);
            }
            const StageClock clock(measuring ? &worker.video_s : nullptr);
            draw_band(input, raster, worker.segments, worker.video, channel.picture);
            channel.counts[band] = count(worker.segments);
            channel.counts[band].light_pixels = worker.video.light_pixels;
        };
        if (workers.size() == 1) {
            for (std::uint32_t band = 0; band < bands; ++band)
                draw_one(band, workers[0]);
            return;
        }
        fork_join(arena, bands,
                  [&](std::uint32_t band, std::uint32_t thread) { draw_one(band, workers[thread]); });
    }

    void gather_times() {
        for (BandWorker& worker : workers) {
            times.scanline_s += worker.scanline_s;
            times.video_s += worker.video_s;
            worker.scanline_s = worker.video_s = 0.0;
        }
    }

    static void tell(const Channel& channel, ChannelReport& counts) {
        counts.faces_active = channel.projected.offered;
        counts.faces_projected = channel.projected.faces.size();
        counts.edges = channel.edges.edges.size();
        counts.lights_active = channel.projected.lights_offered;
        counts.lights = channel.projected.lights.size();
        counts.ambiguous_priorities = channel.order.ambiguous;
        for (const BandCounts& band : channel.counts) {
            counts.segments += band.segments;
            counts.light_pixels += band.light_pixels;
            counts.most_segments_on_a_line = std::max(counts.most_segments_on_a_line, band.most_on_a_line);
        }
    }
};

Machine::Machine(const VisualDatabase& database, const Configuration& configuration) {
    check(configuration);
    state_ = std::make_unique<State>(database, configuration);
    for (std::uint32_t field = 0; field < configuration.fields; ++field) {
        const FieldTimes times = field_times(configuration, field);
        state_->report.fields.push_back({times.first_line_s, times.last_line_s});
    }
}

Machine::~Machine() = default;

const FrameReport& Machine::frame(const FramePacket& packet) {
    if (state_->accepts(packet)) state_->draw(packet);
    return state_->report;
}

const FrameReport& Machine::follow(const FramePacket& packet) {
    if (state_->accepts(packet))
        state_->arena.execute(
            [&] { follow_wakes(state_->database, packet, state_->wake_makers, state_->history); });
    return state_->report;
}

const VideoFrame& Machine::picture(std::size_t channel) const {
    static const VideoFrame no_picture;
    return channel < state_->channels.size() ? state_->channels[channel].picture : no_picture;
}

const History& Machine::history() const { return state_->history; }

void Machine::restore(History history) { state_->history = std::move(history); }

void Machine::draw_planes(bool intensity, bool rank) {
    state_->intensity_plane = intensity;
    state_->rank_plane = rank;
}

void Machine::measure_stages(bool on) { state_->measuring = on; }

const StageTimes& Machine::stage_times() const { return state_->times; }

Machine::Source Machine::source(std::size_t channel, std::int32_t rank) const {
    if (channel >= state_->channels.size() || rank < 0) return {};
    const auto& faces = state_->channels[channel].projected.faces;
    if (static_cast<std::size_t>(rank) >= faces.size()) return {};
    const ProjectedFace& projected = faces[static_cast<std::size_t>(rank)];
    const FaceBlock& block = state_->active.blocks[projected.block];
    const Face& face = block.faces[projected.face];
    return {.list = block.list,
            .object = face.object,
            .face = &face,
            .colour = projected.colour,
            .flat_intensity =
                face.shading == Shading::unshaded ? intensity_one : lit_intensity(block, face.normal)};
}

std::optional<PixelReasons> Machine::explain(std::size_t channel, std::uint32_t column,
                                             std::uint32_t row) const {
    if (channel >= state_->channels.size()) return std::nullopt;
    const Channel& drawn = state_->channels[channel];
    if (column >= drawn.picture.width || row >= drawn.picture.height) return std::nullopt;
    const Configuration& configuration = state_->configuration;
    const bool horizontal = configuration.raster.scan == Scan::horizontal;
    const std::uint32_t line = horizontal ? row : column, element = horizontal ? column : row;
    PixelReasons reasons{.make_up = make_up({state_->video_input(drawn), &drawn.bands, &drawn.splats,
                                             configuration.raster, configuration.edge_smoothing},
                                            line, element)};
    const StageOutputs outputs{&state_->active, &drawn.order, &drawn.projected, &drawn.edges, drawn.eye_m};
    reasons.layers = explain_pixel(outputs, reasons.make_up, line, element);
    return reasons;
}

} // namespace linkdig::ig
