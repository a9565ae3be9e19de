#pragma once
/// Why a pixel looks as it does: what the stages decided about it, in their own numbers.

#include "database/model/visual_database.h"
#include "ig/active/face_block.h"
#include "ig/edges/edge.h"
#include "ig/geometry/projected_face.h"
#include "ig/machine/make_up.h"
#include "ig/priority/ranked_run.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::ig {

/// A separating plane on the way to a face, and the side that was taken to get there.
struct PlaneTaken {
    enum class Tree : std::uint8_t { group, cluster, list };
    enum class Side : std::uint8_t { front, on, back };
    Tree tree = Tree::list;
    Vec3f normal{0}; ///< null: no plane, a fixed order
    float distance_m = 0;
    double eye_distance_m = 0; ///< of the eye from the plane, positive in front
    bool eye_in_front = false;
    Side side = Side::front; ///< where the face stands
};

/// One face that covers the pixel's centre, or has a share in the pixel.
struct Layer {
    std::uint32_t rank = 0;
    bool covers_centre = true;
    std::uint32_t list = 0;
    std::uint32_t object = 0;
    std::uint32_t cluster = 0;
    std::int32_t group_number = 0;
    std::int32_t list_number = 0;
    std::uint16_t colour = 0;         ///< colour code
    std::uint16_t file = 0;           ///< into VisualDatabase::source_files
    std::uint32_t line = 0;           ///< 0: no author wrote it, the machine made it this frame
    std::vector<PlaneTaken> planes{}; ///< group's, then cluster's, then list's, each from its root
    Shading shading = Shading::face;
    bool smooth = false; ///< intensity varies over the face
    Vec3f normal{0};     ///< of the face
    Vec3f sun{0};        ///< in the list's frame
    float ambient = 0;
    float diffuse = 0;
    std::int32_t corner_intensity[3] = {0, 0, 0}; ///< of the triangle, if smooth; 1.0 = 2^22
    std::int32_t intensity = 0;                   ///< at the pixel
    bool coloured = false;             ///< its corners have colours: `tint` instead of code x intensity
    std::int32_t tint[3] = {0, 0, 0};  ///< red, green, blue at the pixel; 255 is 1.0 = 2^22
    std::int32_t level = none;         ///< of detail: into VisualDatabase::detail_levels
    std::uint16_t level_opacity = 256; ///< of 256: what is seen of that level
};

/// A channel's stage outputs of the last frame.
struct StageOutputs {
    const ActiveDatabase* active = nullptr;
    const PriorityOrder* order = nullptr;
    const ProjectedFaces* projected = nullptr;
    const FaceEdges* edges = nullptr;
    Vec3d eye_m{0};
};

/// Every face whose area holds the pixel's centre, and every face that has a share in the pixel, front to back.
std::vector<Layer> explain_pixel(const StageOutputs& outputs, const PixelMakeUp& made, std::uint32_t line,
                                 std::uint32_t element);

/// Why a pixel is what it is.
struct PixelReasons {
    PixelMakeUp make_up;
    std::vector<Layer> layers{}; ///< front to back
};

} // namespace linkdig::ig
