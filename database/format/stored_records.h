#pragma once
/// Each record's two conversions, side by side: database/model to what visual_database.fbs stores, and back.

#include "database/format/visual_database_generated.h"
#include "database/model/visual_database.h"

namespace linkdig::database {

inline stored::Vec3 to_stored(const Vec3f& v) { return {v.x, v.y, v.z}; }
inline Vec3f from_stored(const stored::Vec3& v) { return {v.x(), v.y(), v.z()}; }

inline stored::Vec3Double to_stored(const Vec3d& v) { return {v.x, v.y, v.z}; }
inline Vec3d from_stored(const stored::Vec3Double& v) { return {v.x(), v.y(), v.z()}; }

inline stored::Colour to_stored(const Colour& c) { return {c.red, c.green, c.blue}; }
inline Colour from_stored(const stored::Colour& c) { return {c.red(), c.green(), c.blue(), 0}; }

inline stored::Vertex to_stored(const Vertex& v) {
    return {v.position.x, v.position.y, v.position.z, v.position.w, to_stored(v.normal)};
}
inline Vertex from_stored(const stored::Vertex& v) {
    return {{v.x(), v.y(), v.z(), v.w()}, from_stored(v.normal())};
}

inline stored::Face to_stored(const Face& f) {
    return {f.first_corner,
            f.object,
            f.line,
            to_stored(f.normal),
            f.corner_count,
            f.colour,
            f.file,
            f.opacity,
            static_cast<std::uint8_t>(f.shading),
            f.two_sided,
            static_cast<std::uint8_t>(f.coloured < 255 ? f.coloured : 255)};
}
inline Face from_stored(const stored::Face& f) {
    return {.first_corner = f.first_corner(),
            .corner_count = f.corner_count(),
            .colour = f.colour(),
            .object = f.object(),
            .normal = from_stored(f.normal()),
            .shading = static_cast<Shading>(f.shading()),
            .two_sided = f.two_sided(),
            .file = f.file(),
            .line = f.line(),
            .opacity = f.opacity(),
            .coloured = f.coloured()};
}

inline stored::FaceRun to_stored(const FaceRun& r) {
    return {r.first_face,        r.face_count, r.slot,        r.alternative, r.level,
            to_stored(r.centre), r.radius,     r.first_light, r.light_count};
}
inline FaceRun from_stored(const stored::FaceRun& r) {
    return {.first_face = r.first_face(),
            .face_count = r.face_count(),
            .slot = r.slot(),
            .alternative = r.alternative(),
            .level = r.level(),
            .centre = from_stored(r.centre()),
            .radius = r.radius(),
            .first_light = r.first_light(),
            .light_count = r.light_count()};
}

inline stored::LightPoint to_stored(const LightPoint& l) {
    return {to_stored(l.position),
            to_stored(l.direction),
            to_stored(l.side),
            l.place,
            l.across,
            l.upward,
            l.intensity,
            l.size_m,
            l.full_to_m,
            l.flash_hz,
            l.duty,
            l.phase,
            l.object,
            l.line,
            l.file,
            l.colour,
            l.back_colour,
            static_cast<std::uint8_t>(l.beam),
            static_cast<std::uint8_t>(l.fall_off)};
}
inline LightPoint from_stored(const stored::LightPoint& l) {
    return {.position = from_stored(l.position()),
            .place = l.place(),
            .direction = from_stored(l.direction()),
            .across = l.across(),
            .side = from_stored(l.side()),
            .upward = l.upward(),
            .intensity = l.intensity(),
            .size_m = l.size_m(),
            .full_to_m = l.full_to_m(),
            .flash_hz = l.flash_hz(),
            .duty = l.duty(),
            .phase = l.phase(),
            .object = l.object(),
            .line = l.line(),
            .file = l.file(),
            .colour = l.colour(),
            .back_colour = l.back_colour(),
            .beam = static_cast<LightBeam>(l.beam()),
            .fall_off = static_cast<FallOff>(l.fall_off())};
}

inline stored::PlaneNode to_stored(const PlaneNode& n) {
    return {to_stored(n.normal), n.distance, n.front, n.on, n.back, n.waterline};
}
/// A `waterline` that is no byte becomes 255, which validation refuses.
inline PlaneNode from_stored(const stored::PlaneNode& n) {
    return {.normal = from_stored(n.normal()),
            .distance = n.distance(),
            .front = n.front(),
            .on = n.on(),
            .back = n.back(),
            .waterline = static_cast<std::uint8_t>(n.waterline() < 255 ? n.waterline() : 255)};
}

inline stored::RunLeaf to_stored(const RunLeaf& l) { return {l.first_run, l.run_count}; }
inline RunLeaf from_stored(const stored::RunLeaf& l) { return {l.first_run(), l.run_count()}; }

inline stored::PriorityGroup to_stored(const PriorityGroup& g) { return {g.number, g.root}; }
inline PriorityGroup from_stored(const stored::PriorityGroup& g) { return {g.number(), g.root()}; }

inline stored::Object to_stored(const Object& o) { return {o.list, o.slot, o.alternative, o.level}; }
/// An alternative beyond 65535 becomes 65535, which is beyond every slot that validation accepts.
inline Object from_stored(const stored::Object& o) {
    return {.name = {},
            .list = o.list(),
            .slot = o.slot(),
            .alternative = static_cast<std::uint16_t>(o.alternative() < 65535 ? o.alternative() : 65535),
            .level = o.level()};
}

inline stored::ObjectList to_stored(const ObjectList& l) {
    return {to_stored(l.origin_m),
            l.cluster,
            l.number,
            static_cast<std::uint32_t>(l.attachment),
            l.sun,
            l.ambient,
            l.diffuse,
            l.root,
            l.tile,
            l.added_to};
}
inline ObjectList from_stored(const stored::ObjectList& l) {
    return {.name = {},
            .cluster = l.cluster(),
            .number = l.number(),
            .attachment = static_cast<Attachment>(l.attachment() < 255 ? l.attachment() : 255),
            .sun = l.sun(),
            .ambient = l.ambient(),
            .diffuse = l.diffuse(),
            .origin_m = from_stored(l.origin_m()),
            .root = l.root(),
            .tile = l.tile(),
            .added_to = l.added_to()};
}

inline stored::Cluster to_stored(const Cluster& c) {
    return {to_stored(c.reference_point_m), to_stored(c.half_extent_m), c.group, c.moving_object, c.root};
}
inline Cluster from_stored(const stored::Cluster& c) {
    return {.name = {},
            .group = c.group(),
            .moving_object = c.moving_object(),
            .reference_point_m = from_stored(c.reference_point_m()),
            .half_extent_m = from_stored(c.half_extent_m()),
            .root = c.root()};
}

inline stored::Detail to_stored(const Detail& d) {
    return {to_stored(d.reference_m), d.cluster, d.hysteresis_m, d.blend_m, d.added, d.first_level, d.levels};
}
/// An `added` that is no byte becomes 255, which validation refuses.
inline Detail from_stored(const stored::Detail& d) {
    return {.name = {},
            .cluster = d.cluster(),
            .reference_m = from_stored(d.reference_m()),
            .hysteresis_m = d.hysteresis_m(),
            .blend_m = d.blend_m(),
            .added = static_cast<std::uint8_t>(d.added() < 255 ? d.added() : 255),
            .first_level = d.first_level(),
            .levels = d.levels()};
}

inline stored::DetailLevel to_stored(const DetailLevel& l) { return {l.detail, l.to_m}; }
inline DetailLevel from_stored(const stored::DetailLevel& l) { return {l.detail(), l.to_m()}; }

inline stored::RepeatedTile to_stored(const RepeatedTile& t) {
    return {t.cell_m,
            t.list,
            t.period,
            t.rings,
            t.fine_levels,
            t.half_width,
            t.vertical_angle_rad,
            t.line,
            t.first_normal,
            t.first_face_normal,
            t.colour,
            t.file};
}
inline RepeatedTile from_stored(const stored::RepeatedTile& t) {
    return {.list = t.list(),
            .period = t.period(),
            .cell_m = t.cell_m(),
            .rings = t.rings(),
            .fine_levels = t.fine_levels(),
            .half_width = t.half_width(),
            .vertical_angle_rad = t.vertical_angle_rad(),
            .colour = t.colour(),
            .file = t.file(),
            .line = t.line(),
            .first_normal = t.first_normal(),
            .first_face_normal = t.first_face_normal()};
}

} // namespace linkdig::database
