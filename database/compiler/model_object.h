#pragma once
/// Pass 3: objects as polygons over named or generated vertices, before they are checked and ordered.

#include "database/compiler/compile.h"
#include "database/compiler/polygon.h"
#include "database/compiler/registry.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::database {

/// A point (w = 1), or a direction (w = 0, unit): a vertex at infinity. Coordinates are those that a float
/// holds, so that the checks see what the machine will draw.
struct ModelVertex {
    Vec4d position{0, 0, 0, 1};
    std::optional<Vec3d> normal; ///< given by the author, or averaged by average_normals
    std::string name;            ///< empty: generated
    Place at;
    std::optional<Vec3d> colour{}; ///< its own, 0 to 255
};

/// What a face takes from its object unless it says otherwise.
struct FaceStyle {
    std::optional<std::uint16_t> colour;
    Shading shading = Shading::face;
    bool two_sided = false;
    std::int32_t layer = 0;
    std::uint16_t opacity = 256; ///< of 256
};

struct ModelFace {
    std::vector<std::uint32_t> corners; ///< into ModelObject::vertices; the fan starts at the first
    FaceStyle style;
    Place at;
    Vec3d light_normal{0}; ///< unit: what lights it instead of its plane's (churned water); zero: its plane's
    // Set by check_faces:
    Plane plane;
    double deviation_m = 0;   ///< of the corners from the plane
    bool at_infinity = false; ///< all its corners are directions; plane.normal points at the eye
};

struct ModelLight {
    LightPoint point; ///< `place` and `object` are not known yet
    Place at;
};

struct ModelObject {
    std::string name;
    std::uint32_t list = 0;
    std::int32_t slot = none;
    std::uint32_t alternative = 0;
    std::int32_t detail = none; ///< into the registry's details
    std::uint32_t level = 0;    ///< in that detail, which may have fewer (check_levels)
    bool resolved = false;      ///< everything that it names is known
    bool of_mesh = false;       ///< read from a mesh file
    std::vector<ModelVertex> vertices;
    std::vector<ModelFace> faces;
    std::vector<ModelLight> lights;
    Place at;
};

/// What the reading passes share.
struct Reading {
    const Sources* sources = nullptr;
    const Registry* registry = nullptr;
    Diagnostics* diagnostics = nullptr;
    void error(Place at, std::string message) const {
        diagnostics->error(sources->location(at), std::move(message));
    }
};

/// What reading [[mesh]] tables leaves beside objects.
struct MeshFiles {
    std::vector<std::string> tried; ///< paths as opened
    std::vector<MeshStatistics> statistics;
};

/// Objects in the order of their files: [[object]]s, then [[mesh]]es, then [[sequence]]s, then
/// [[churn]]s, [[mounds]], [[patchwork]]s and [[wake_field]]s.
std::vector<ModelObject> read_objects(const AuthoredTables& tables, const Reading& reading,
                                      MeshFiles& meshes);
/// One object per alternative of the slot, its shape between the key shapes before and after (report, 3.2.2).
void read_sequence(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects);
/// Churned water: a strip of smooth squares on z = 0 with random normals that shrink towards its rims (report,
/// 3.2.3).
void read_churn(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects);

/// A field of irregular low pyramids as one object (report, 3.1.1).
void read_mounds(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects);
/// A patchwork of fields on flat ground as one object.
void read_patchwork(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects);
/// Flat water with the wakes of a specification, as one object of smooth squares. Paths that were to be read go to `tried`.
void read_wake_field(AuthoredTable table, const Reading& reading, std::vector<ModelObject>& objects,
                     std::vector<std::string>& tried);
/// Most faces of a field, without outlines.
inline constexpr std::uint32_t most_mound_faces = 100000;

/// colour, shading, two_sided, layer and opacity of a table, falling back on `inherited`.
FaceStyle read_style(TableReader& reader, const Reading& reading, const FaceStyle& inherited);
/// list, slot, detail and level; `slot_required`: of a sequence. Sets `resolved`.
void read_membership(TableReader& reader, const Reading& reading, bool slot_required, ModelObject& object);
/// slot and alternative of an object.
void read_alternative(TableReader& reader, ModelObject& object);
/// What every table that makes one object begins with: name, place, list, slot and alternative, detail and level.
ModelObject begin_object(TableReader& reader, const AuthoredTable& table, const Reading& reading);
/// mirror = "y".
bool read_mirror(TableReader& reader);
/// Mirrors vertices and faces in the plane y = 0. Vertices on it are shared, so that normals average across
/// it.
void add_mirror_image(ModelObject& object);

} // namespace linkdig::database
