#include "tools/reasons/reasons.h"

#include "tools/reasons/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace linkdig::tools {

const ig::Layer* layer_of(const ig::PixelReasons& reasons, std::uint32_t rank) {
    const auto found = std::ranges::find(reasons.layers, rank, &ig::Layer::rank);
    return found == reasons.layers.end() ? nullptr : &*found;
}

const ig::Layer* seen_layer(const ig::PixelReasons& reasons) {
    const ig::PixelShare* greatest = nullptr;
    for (const ig::PixelShare& share : reasons.make_up.shares)
        if (share.added_to < 0 && (greatest == nullptr || share.weight > greatest->weight)) greatest = &share;
    return greatest == nullptr ? nullptr : layer_of(reasons, greatest->rank);
}

std::string place_text(const VisualDatabase& database, const ig::Layer& layer) {
    const std::string where = layer.line == 0
                                  ? std::string("made by the machine")
                                  : fmt::format("{}:{}", database.source_files[layer.file], layer.line);
    return fmt::format("{}, object \"{}\" ({})", database.lists[layer.list].name,
                       database.objects[layer.object].name, where);
}

namespace {

using Out = std::back_insert_iterator<std::string>;

void put_priority(const VisualDatabase& database, const ig::Layer& layer, Out out) {
    fmt::format_to(out, "priority  group {}, cluster {}, number {} in it, rank {}\n", layer.group_number,
                   database.clusters[layer.cluster].name, layer.list_number, layer.rank);
    for (const ig::PlaneTaken& plane : layer.planes) {
        if (plane.normal == Vec3f(0)) {
            fmt::format_to(out, "          {} tree: fixed order, the face stands {}\n", tree_name(plane.tree),
                           plane.side == ig::PlaneTaken::Side::front ? "first" : "later");
            continue;
        }
        fmt::format_to(
            out,
            "          {} tree: plane ({:.3f} {:.3f} {:.3f}) at {:.3f} m; the eye is {:.2f} m {} it, "
            "the face {}\n",
            tree_name(plane.tree), plane.normal.x, plane.normal.y, plane.normal.z, plane.distance_m,
            std::fabs(plane.eye_distance_m), plane.eye_in_front ? "in front of" : "behind",
            side_name(plane.side));
    }
}

void put_level(const VisualDatabase& database, const ig::Layer& layer, Out out) {
    if (layer.level == none) return;
    const DetailLevel& level = database.detail_levels[static_cast<std::size_t>(layer.level)];
    const Detail& detail = database.details[level.detail];
    fmt::format_to(out, "detail    level {} of {}, to {:.6g} m, seen by {:.0f} %\n",
                   static_cast<std::uint32_t>(layer.level) - detail.first_level, detail.name, level.to_m,
                   layer.level_opacity / 2.56);
}

double cosine_of(const ig::Layer& layer) {
    return static_cast<double>(layer.normal.x) * layer.sun.x +
           static_cast<double>(layer.normal.y) * layer.sun.y +
           static_cast<double>(layer.normal.z) * layer.sun.z;
}

void put_intensity(const ig::Layer& layer, Out out) {
    if (layer.coloured) return;
    if (layer.smooth) {
        fmt::format_to(out, "intensity {:.4f}, between corners of {:.4f}, {:.4f} and {:.4f}\n",
                       unit(layer.intensity), unit(layer.corner_intensity[0]),
                       unit(layer.corner_intensity[1]), unit(layer.corner_intensity[2]));
        fmt::format_to(out,
                       "          each corner: {:.3f} + {:.3f} max(0, n.s), s = ({:.3f} {:.3f} {:.3f})\n",
                       layer.ambient, layer.diffuse, layer.sun.x, layer.sun.y, layer.sun.z);
    } else if (layer.shading == Shading::face) {
        fmt::format_to(out,
                       "intensity {:.4f} = {:.3f} + {:.3f} max(0, {:.4f}), n = ({:.3f} {:.3f} {:.3f}), s = "
                       "({:.3f} {:.3f} {:.3f})\n",
                       unit(layer.intensity), layer.ambient, layer.diffuse, cosine_of(layer), layer.normal.x,
                       layer.normal.y, layer.normal.z, layer.sun.x, layer.sun.y, layer.sun.z);
    } else {
        fmt::format_to(out, "intensity {:.4f}, the same at every corner\n", unit(layer.intensity));
    }
}

std::string levels_text(const Levels& levels) {
    return fmt::format("({:.1f} {:.1f} {:.1f})", levels.red, levels.green, levels.blue);
}

std::string code_text(Colour code) { return fmt::format("({} {} {})", code.red, code.green, code.blue); }

/// The face's own colour, and what the air makes of it.
std::string colour_text(const VisualDatabase& database, const ig::PixelReasons& reasons,
                        const ig::PixelShare& share) {
    const ig::Layer* const layer = layer_of(reasons, share.rank);
    if (layer == nullptr) return fmt::format("the background {}", code_text(share.code));
    std::string text;
    if (layer->coloured) {
        text = fmt::format("the colours of its corners x intensity = {}",
                           levels_text(own_levels(*layer, share)));
    } else {
        text = fmt::format("{} {} x {:.4f} = {}", database.colour_names[layer->colour], code_text(share.code),
                           unit(layer->intensity), levels_text(own_levels(*layer, share)));
    }
    if (share.seen.transmission < 0) return text;
    const double through = transmission(share);
    if (share.added_to >= 0)
        return text +
               fmt::format(", {:.4f} of it through the air = {}", through, levels_text(levels_of(share)));
    return text + fmt::format(", {:.4f} of it through the air and {:.4f} of the horizon's {} = {}", through,
                              1.0 - through, code_text(reasons.make_up.horizon),
                              levels_text(levels_of(share)));
}

void put_share(const VisualDatabase& database, const ig::PixelReasons& reasons, const ig::PixelShare& share,
               const char* heading, Out out) {
    const ig::Layer* const layer = layer_of(reasons, share.rank);
    const std::string name = layer == nullptr ? std::string("background") : database.lists[layer->list].name;
    const std::string colour = colour_text(database, reasons, share);
    if (share.added_to < 0) {
        fmt::format_to(out, "{:<9} {:.1f} % {}: {}\n", heading, 100.0 * part(share), name, colour);
        return;
    }
    const std::string& partner = database.lists[static_cast<std::size_t>(share.added_to)].name;
    fmt::format_to(out, "{:<9} {:.1f} % of the light of {}: {}, {}\n", heading, 100.0 * part(share), name,
                   colour,
                   share.falls_on_none ? fmt::format("lost: {} is not the next behind it", partner)
                                       : fmt::format("added to {}", partner));
}

void put_make_up(const VisualDatabase& database, const ig::PixelReasons& reasons, Out out) {
    const char* heading = "made of";
    for (const ig::PixelShare& share : reasons.make_up.shares) {
        put_share(database, reasons, share, heading, out);
        heading = "";
    }
    for (const ig::PixelLight& light : reasons.make_up.lights)
        fmt::format_to(out, "          a light point {}: ({:.1f} {:.1f} {:.1f}) more\n",
                       code_text(light.code), light.levels[0], light.levels[1], light.levels[2]);
}

} // namespace

std::string reasons_text(const VisualDatabase& database, const ig::PixelReasons& reasons,
                         std::uint32_t pixel) {
    std::string text;
    const Out out(text);
    fmt::format_to(out, "pixel     ({} {} {})\n", pixel & 0xffU, pixel >> 8U & 0xffU, pixel >> 16U & 0xffU);
    const ig::Layer* const seen = seen_layer(reasons);
    if (seen == nullptr) {
        fmt::format_to(out, "seen      the background\n");
    } else {
        fmt::format_to(out, "seen      {}\n", place_text(database, *seen));
        put_priority(database, *seen, out);
        put_level(database, *seen, out);
        put_intensity(*seen, out);
    }
    put_make_up(database, reasons, out);
    for (const bool before : {true, false}) {
        const char* heading = before ? "before it" : "behind it";
        for (const ig::Layer& layer : reasons.layers) {
            const bool is_before = seen == nullptr || layer.rank < seen->rank;
            if (&layer == seen || is_before != before) continue;
            fmt::format_to(out, "{:<9} {}\n", heading, place_text(database, layer));
            heading = "";
        }
    }
    return text;
}

} // namespace linkdig::tools
