#include "tools/reasons/parts.h"
#include "tools/reasons/reasons.h"

namespace linkdig::tools {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* shading_names[] = {"unshaded", "face", "vertex"};

Json numbers(const Vec3f& v) { return Json::array({v.x, v.y, v.z}); }
Json numbers(Colour code) { return Json::array({code.red, code.green, code.blue}); }
Json numbers(const Levels& levels) { return Json::array({levels.red, levels.green, levels.blue}); }

Json plane_json(const ig::PlaneTaken& plane) {
    return {{"tree", tree_name(plane.tree)},
            {"normal", numbers(plane.normal)},
            {"distance_m", plane.distance_m},
            {"eye_distance_m", plane.eye_distance_m},
            {"eye", plane.eye_in_front ? "front" : "back"},
            {"face", side_name(plane.side)}};
}

Json layer_json(const VisualDatabase& database, const ig::Layer& layer) {
    const bool made = layer.line == 0;
    Json json{{"rank", layer.rank},
              {"covers_centre", layer.covers_centre},
              {"list", database.lists[layer.list].name},
              {"object", database.objects[layer.object].name},
              {"cluster", database.clusters[layer.cluster].name},
              {"group_number", layer.group_number},
              {"list_number", layer.list_number},
              {"file", made ? Json() : Json(database.source_files[layer.file])},
              {"line", made ? Json() : Json(layer.line)},
              {"colour", database.colour_names[layer.colour]},
              {"shading", shading_names[static_cast<int>(layer.shading)]},
              {"intensity", unit(layer.intensity)},
              {"ambient", layer.ambient},
              {"diffuse", layer.diffuse},
              {"sun", numbers(layer.sun)},
              {"normal", numbers(layer.normal)}};
    if (layer.smooth) {
        json["corner_intensities"] =
            Json::array({unit(layer.corner_intensity[0]), unit(layer.corner_intensity[1]),
                         unit(layer.corner_intensity[2])});
    }
    if (layer.coloured)
        json["tint"] = Json::array({unit(layer.tint[0]), unit(layer.tint[1]), unit(layer.tint[2])});
    if (layer.level != none) {
        const DetailLevel& level = database.detail_levels[static_cast<std::size_t>(layer.level)];
        const Detail& detail = database.details[level.detail];
        json["detail"] = detail.name;
        json["level"] = static_cast<std::uint32_t>(layer.level) - detail.first_level;
        json["level_opacity"] = layer.level_opacity / 256.0;
    }
    json["planes"] = Json::array();
    for (const ig::PlaneTaken& plane : layer.planes)
        json["planes"].push_back(plane_json(plane));
    return json;
}

Json share_json(const VisualDatabase& database, const ig::PixelReasons& reasons,
                const ig::PixelShare& share) {
    const ig::Layer* const layer = layer_of(reasons, share.rank);
    Json json{{"rank", layer == nullptr ? Json() : Json(share.rank)},
              {"list", layer == nullptr ? Json() : Json(database.lists[layer->list].name)},
              {"part", part(share)},
              {"levels", numbers(levels_of(share))}};
    if (layer == nullptr || !layer->coloured) json["code"] = numbers(share.code);
    if (share.seen.transmission >= 0) json["transmission"] = transmission(share);
    if (share.added_to >= 0) {
        json["added_to"] = database.lists[static_cast<std::size_t>(share.added_to)].name;
        json["lost"] = share.falls_on_none;
    }
    return json;
}

} // namespace

Json reasons_json(const VisualDatabase& database, const ig::PixelReasons& reasons, std::uint32_t pixel) {
    const ig::Layer* const seen = seen_layer(reasons);
    Json json{{"pixel", Json::array({pixel & 0xffU, pixel >> 8U & 0xffU, pixel >> 16U & 0xffU})},
              {"seen", seen == nullptr ? Json() : Json(seen->rank)},
              {"horizon", numbers(reasons.make_up.horizon)},
              {"made_of", Json::array()},
              {"lights", Json::array()},
              {"layers", Json::array()}};
    for (const ig::PixelShare& share : reasons.make_up.shares)
        json["made_of"].push_back(share_json(database, reasons, share));
    for (const ig::PixelLight& light : reasons.make_up.lights)
        json["lights"].push_back(
            {{"code", numbers(light.code)},
             {"levels", Json::array({light.levels[0], light.levels[1], light.levels[2]})}});
    for (const ig::Layer& layer : reasons.layers)
        json["layers"].push_back(layer_json(database, layer));
    return json;
}

} // namespace linkdig::tools
