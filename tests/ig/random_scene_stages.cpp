#include "tests/ig/random_scene_stages.h"

#include "ig/edges/edges.h"
#include "ig/geometry/project.h"
#include "ig/scanline/bands.h"
#include "ig/scanline/scanline.h"
#include "ig/video/video.h"
#include "tests/support/active_edge_loop.h"
#include "tests/support/painter.h"
#include "tests/support/picture_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace linkdig::ig {

Projected project_packet(const VisualDatabase& database, const FramePacket& packet, const Raster& raster) {
    Configuration configuration;
    configuration.raster = raster;
    Projected made;
    History history;
    activate(database, packet, configuration, history, made.active);
    PriorityScratch priority_scratch;
    prioritise(made.active, packet.channels[0], priority_scratch, made.order);
    GeometryScratch geometry_scratch;
    made.scene.raster = raster;
    made.scene.colours = database.colours;
    project(made.active, made.order, whole_of(made.order), packet.channels[0], raster, {.low_faces = true},
            geometry_scratch, made.scene.projected);
    return made;
}

Drawn draw(const Scene& scene, std::uint32_t threads) {
    Drawn drawn;
    make_edges(scene.projected, scene.raster, false, drawn.edges);
    Bands bands;
    const std::uint32_t lines = scene.raster.lines();
    sort_into_bands(drawn.edges, lines, bands);
    open_frame(scene.raster, true, true, drawn.picture);
    drawn.bands.resize(band_count(lines));
    const Air clear;
    const VideoInput input{&scene.projected, &drawn.edges, scene.colours, scene.background, &clear};
    const auto draw_bands_from = [&](std::uint32_t first) {
        BandScratch scratch;
        VideoScratch video_scratch;
        for (std::uint32_t band = first; band < drawn.bands.size(); band += threads) {
            BandSegments& segments = drawn.bands[band];
            segments.first_line = band * band_lines;
            segments.end_line = std::min((band + 1) * band_lines, lines);
            resolve_band(drawn.edges, bands.of(band), scene.raster.elements(), false, scratch, segments);
            draw_band(input, scene.raster, segments, video_scratch, drawn.picture);
        }
    };
    std::vector<std::thread> others;
    for (std::uint32_t first = 1; first < threads; ++first)
        others.emplace_back(draw_bands_from, first);
    draw_bands_from(0);
    for (std::thread& other : others)
        other.join();
    return drawn;
}

VideoFrame painted(const Scene& scene) {
    return support::paint(scene.projected, scene.raster, scene.colours, scene.packed_background());
}

VideoFrame looped(const Scene& scene, const FaceEdges& edges) {
    return support::active_edge_loop(scene.projected, edges, scene.raster, scene.colours,
                                     scene.packed_background());
}

void expect_agreement(const Scene& scene) {
    const Drawn drawn = draw(scene);
    const support::PictureDifference slow = support::compare(painted(scene), drawn.picture);
    EXPECT_EQ(slow.ranks, 0U) << "painter: " << slow.explanation;
    EXPECT_LE(slow.worst_level, 1U) << "painter: " << slow.explanation;
    const VideoFrame loop = looped(scene, drawn.edges);
    EXPECT_TRUE(loop.pixels == drawn.picture.pixels)
        << "active edge loop: " << support::compare(loop, drawn.picture).explanation;
    EXPECT_TRUE(loop.rank == drawn.picture.rank);
    EXPECT_TRUE(loop.intensity == drawn.picture.intensity);
}

} // namespace linkdig::ig
