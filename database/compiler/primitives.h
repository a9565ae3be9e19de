#pragma once
/// Primitives of objects: solids, lofts and flat markings as shapes, each a pure function of its table.

#include "database/compiler/model_object.h"

#include <cstdint>
#include <string>
#include <vector>

namespace linkdig::database {

/// Points in metres and polygons over them, corners counter-clockwise seen from the front.
struct Shape {
    struct Polygon {
        std::vector<std::uint32_t> corners;
        std::uint32_t side = 0; ///< into the primitive's side names
    };
    std::vector<Vec3d> points;
    std::vector<Polygon> polygons;

    void add(std::vector<std::uint32_t> corners, std::uint32_t side = 0) {
        polygons.push_back({std::move(corners), side});
    }
    /// A polygon with points of its own.
    void add_points(const std::vector<Vec3d>& corners, std::uint32_t side = 0);
    /// Four corners, or three where neighbours coincide, or nothing; two triangles, cut along the shorter
    /// diagonal, where the four are not planar within the tolerance of faces.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t side = 0);
};

/// Has anything been reported since? What follows from a mistake is no second one.
class Mistakes {
public:
    explicit Mistakes(const TableReader& reader) : diagnostics_(&reader.diagnostics()), before_(count()) {}
    bool any() const { return count() != before_; }

private:
    std::size_t count() const { return diagnostics_->all().size(); }
    const Diagnostics* diagnostics_;
    std::size_t before_;
};

/// Reads what the table says; a mistake is reported, and the shape then may be empty.
Shape box_shape(TableReader& reader);
Shape prism_shape(TableReader& reader);
/// Sections of equal numbers of points. For sections S, S + 1 and points P, P + 1 the face runs
/// (S, P), (S, P+1), (S+1, P+1), (S+1, P): its normal is cross(point direction, section direction).
/// flip = true turns every face round. Points at the same place are one vertex.
Shape loft_shape(TableReader& reader);
Shape rectangle_shape(TableReader& reader);
Shape disc_shape(TableReader& reader);
Shape ring_shape(TableReader& reader);
Shape stripe_shape(TableReader& reader);
/// A band of one width along a line of points, with mitred bends.
Shape path_shape(TableReader& reader);
Shape numeral_shape(TableReader& reader);

/// Names of a box's sides, in the order of Shape::Polygon::side: bow +x, stern -x, port +y, starboard -y,
/// top, bottom.
const std::vector<std::string>& box_sides();
const std::vector<std::string>& prism_sides();

/// Adds all primitives of an [[object]] table, then puts the object's faces in the order of their lines.
void read_primitives(TableReader& object_reader, std::uint16_t file, const Reading& reading,
                     const FaceStyle& inherited, ModelObject& object);

/// Most corners of a face, and most copies of a repeated primitive.
inline constexpr std::size_t most_corners = 65535;
inline constexpr std::int64_t most_copies = 10000;
/// Most faces that one primitive may make, its copies included.
inline constexpr std::size_t most_primitive_faces = 1000000;

} // namespace linkdig::database
