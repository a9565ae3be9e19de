#include "tools/check/check.h"

#include "tools/check/comparison.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace linkdig::tools {
namespace {

constexpr std::uint32_t wrong_pixel = 0xff0000ffU; ///< red, as no wrong pixel is missed

FacePlace place_of(const VisualDatabase& database, const CastScene& scene, std::int32_t index) {
    if (index < 0) return {};
    const CastFace& face = scene.faces[static_cast<std::size_t>(index)];
    FacePlace place;
    place.list = database.lists[face.list].name;
    place.object = database.objects[face.object].name;
    if (face.face != none) {
        const Face& authored = database.faces[static_cast<std::size_t>(face.face)];
        place.file = database.source_files[authored.file];
        place.line = authored.line;
    } else {
        const RepeatedTile& tile = database.tiles[static_cast<std::size_t>(database.lists[face.list].tile)];
        place.file = database.source_files[tile.file];
        place.line = tile.line;
    }
    return place;
}

void add_finding(CheckResult& result, Finding finding) {
    const auto same = std::ranges::find_if(result.findings, [&](const Finding& each) {
        return each.shown == finding.shown && each.nearest == finding.nearest && each.gone == finding.gone;
    });
    if (same == result.findings.end()) {
        result.findings.push_back(std::move(finding));
        return;
    }
    same->pixels += finding.pixels;
    same->nearer_by_m = std::max(same->nearer_by_m, finding.nearer_by_m);
}

void add_comparison(const VisualDatabase& database, const CastScene& scene, const CheckView& view,
                    const Comparison& comparison, CheckResult& result) {
    ++result.views;
    result.interior += comparison.interior;
    result.as_near += comparison.as_near;
    result.wrong += comparison.wrong.size();
    result.excepted.resize(comparison.excepted.size(), 0);
    for (std::size_t i = 0; i < comparison.excepted.size(); ++i)
        result.excepted[i] += comparison.excepted[i];
    for (const WrongPixel& pixel : comparison.wrong)
        add_finding(result, {.shown = place_of(database, scene, pixel.shown),
                             .nearest = place_of(database, scene, pixel.nearest),
                             .pixels = 1,
                             .nearer_by_m = pixel.nearer_by_m,
                             .gone = pixel.shown == absent,
                             .view = view.number,
                             .column = pixel.column,
                             .row = pixel.row});
}

void sort_findings(CheckResult& result) {
    std::ranges::stable_sort(result.findings, std::greater<>{}, &Finding::pixels);
}

/// The machine and the database that it shares with the caster.
class Checker {
public:
    Checker(const VisualDatabase& database, const CheckRequest& request)
        : database_(without_transparent(database)), request_(request),
          machine_(database_, {.name = "check", .raster = request.raster}) {
        machine_.draw_planes(false, true);
    }

    void check(const CheckView& view, CheckResult& result,
               const std::function<void(const CheckedView&)>& each) {
        const FrameReport& report = machine_.frame(view.packet);
        if (!report.errors.empty()) throw std::logic_error("check: " + report.errors.front());
        const ChannelView& channel = view.packet.channels[0];
        const CastScene scene = cast_scene(database_, view.packet, channel.eye_m);
        const Caster caster(scene);
        const Comparison comparison = compare_faces(faces_shown(database_, machine_, scene), request_.raster,
                                                    channel, scene, caster, request_.exceptions);
        result.ambiguous += report.channels[0].ambiguous_priorities;
        add_comparison(database_, scene, view, comparison, result);
        if (!each) return;
        ig::VideoFrame picture = machine_.picture(0);
        for (const WrongPixel& pixel : comparison.wrong)
            picture.pixels[std::size_t{pixel.row} * picture.width + pixel.column] = wrong_pixel;
        each({view, picture, comparison.wrong.size()});
    }

    const VisualDatabase& database() const { return database_; }

private:
    VisualDatabase database_;
    const CheckRequest& request_;
    ig::Machine machine_;
};

} // namespace

CheckResult check_database(const VisualDatabase& database, const CheckRequest& request,
                           const std::function<void(const CheckedView&)>& each) {
    CheckResult result;
    Checker checker(database, request);
    const double aspect = static_cast<double>(request.raster.width) / request.raster.height;
    for (std::uint64_t number = request.first_view; number < request.first_view + request.views; ++number)
        checker.check(check_view(checker.database(), request.seed, number, aspect), result, each);
    if (result.interior == 0) // a share of nothing would pass every bound
        throw BadInput(fmt::format(
            "linkdig: error: nothing was checked: no pixel of {} views of {} x {} is more than one "
            "from every edge; expected more views, or larger ones",
            result.views, request.raster.width, request.raster.height));
    sort_findings(result);
    return result;
}

void check_packet_view(const VisualDatabase& database, const CheckRequest& request, const CheckView& view,
                       CheckResult& result, const std::function<void(const CheckedView&)>& each) {
    Checker(database, request).check(view, result, each);
    sort_findings(result);
}

} // namespace linkdig::tools
