#pragma once
/// Puts a visual database together list by list, each list with one run of faces in fixed order.

#include "database/model/visual_database.h"

#include <span>
#include <string>

namespace linkdig::bench {

class SceneBuilder {
public:
    SceneBuilder(VisualDatabase& database, const std::string& name);

    std::uint16_t colour(const std::string& name, Colour code);

    /// Begins a static cluster with one list: lower numbers win, and must be asked for in ascending order.
    void begin_list(const std::string& name, std::uint32_t sun, Attachment attachment = Attachment::world);

    std::uint32_t vertex(const Vec4f& position, const Vec3f& normal = {0, 0, 1});
    std::uint32_t vertex(const Vec3f& position, const Vec3f& normal = {0, 0, 1}) {
        return vertex(Vec4f(position, 1.0F), normal);
    }

    /// Appends a face behind those that the list has. Its normal is that of its first three corners.
    void face(std::span<const std::uint32_t> corners, std::uint16_t colour, Shading shading);

    /// A box's five upper faces, in an order that holds from outside.
    void box(const Vec3f& from, const Vec3f& to, std::uint16_t colour);

    /// A level rectangle that faces up.
    void rectangle(const Vec2f& from, const Vec2f& to, float height, std::uint16_t colour);

private:
    VisualDatabase& database_;
};

} // namespace linkdig::bench
