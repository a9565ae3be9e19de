#pragma once
/// What the machine says of a pixel (ig/machine/explain.h) in words and as JSON, by the database's names.

#include "database/model/visual_database.h"
#include "ig/machine/explain.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace linkdig::tools {

/// The ordinary face with the greatest share, as the planes of ranks and ids show it; null where that is the background.
const ig::Layer* seen_layer(const ig::PixelReasons& reasons);

/// A list, its object, and where the author wrote it; "made by the machine" of what nobody wrote.
std::string place_text(const VisualDatabase& database, const ig::Layer& layer);

/// Several lines: the pixel, what is seen, by which planes, what the colour is made of, and what else is there.
std::string reasons_text(const VisualDatabase& database, const ig::PixelReasons& reasons,
                         std::uint32_t pixel);

/// "pixel", "seen" (a rank, or null), "made_of", "lights", "layers": see docs/frame-in-detail.md.
nlohmann::ordered_json reasons_json(const VisualDatabase& database, const ig::PixelReasons& reasons,
                                    std::uint32_t pixel);

} // namespace linkdig::tools
