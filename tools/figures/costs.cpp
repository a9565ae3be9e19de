/// What each effect costs (report, 3.1.4 and 4.0).

#include "tools/figures/figures.h"
#include "tools/figures/stage.h"
#include "tools/fly/effects.h"

#include <fmt/format.h>

namespace linkdig::tools {

void costs(Findings& findings) {
    Stage stage("report/methods.toml", {.width = 1024, .height = 768, .edge_smoothing = true, .threads = 1});
    Flight& flight = stage.flight();
    flight.machine().draw_planes(false, false);
    constexpr std::uint64_t frame = 60;
    for (int i = 0; i < 3; ++i) // warm
        flight.draw(frame, {});
    const FrameReport& report = flight.draw(frame, {});
    Table table{"Cost of each effect: a frame of 1024 x 768 with it, less the "
                "same frame without it (one thread; times of one machine)",
                {"effect", "edges", "host ms", "image generator ms"},
                {}};
    table.rows.push_back({"the whole frame", fmt::format("{}", report.channels[0].edges),
                          fmt::format("{:.3f}", 1000.0 * flight.costs().last_host_s),
                          fmt::format("{:.2f}", 1000.0 * flight.costs().last_machine_s)});
    std::int64_t churned = 0;
    std::int64_t cam = 0;
    std::int64_t faces = 0;
    for (std::size_t i = 0; i < effect_count; ++i) {
        const auto effect = static_cast<Effect>(i);
        if (!is_possible(effect, flight.loop())) continue;
        const Price price = price_of(effect, flight, frame, {});
        if (effect == Effect::churned) churned = price.edges;
        if (effect == Effect::cam) cam = price.edges;
        if (effect == Effect::face_substitution) faces = price.edges;
        table.rows.push_back({effect_name(effect), fmt::format("{:+}", price.edges),
                              fmt::format("{:+.3f}", price.host_ms), fmt::format("{:+.2f}", price.ig_ms)});
    }
    findings.table(std::move(table));
    findings.between("4.0", "edges of the 28 faces' method (two faces at a time)", static_cast<double>(faces),
                     1.0, 20.0);
    findings.at_least("3.2.2", "edges of the cams over those of the 28 faces",
                      static_cast<double>(cam) / static_cast<double>(faces > 0 ? faces : 1), 2.0);
    findings.at_least("3.2.3", "edges of the churned water", static_cast<double>(churned), 1.0);
}

} // namespace linkdig::tools
