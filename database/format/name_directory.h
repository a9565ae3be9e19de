#pragma once
/// What a host may know of a visual database: names and the indices they stand for in a frame packet.

#include "database/model/visual_database.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::database {

struct NameDirectory {
    /// Alternatives of a slot: Substitution::index is 0 to alternatives - 1.
    struct Slot {
        std::string name;
        std::uint32_t alternatives = 0;
        bool operator==(const Slot&) const = default;
    };
    /// A list's light as the database has it: what ListLighting starts from.
    struct List {
        std::string name;
        std::uint32_t sun = 0;
        float ambient = 0;
        float diffuse = 1;
        bool operator==(const List&) const = default;
    };

    /// What a host must know to steer clear of things, and to order them anew.
    struct Cluster {
        std::string name;
        std::int32_t priority = 0;         ///< its group's number
        std::int32_t moving_object = none; ///< it rides on, or none: static
        /// Box of what is rigid in it, in the cluster's frame: of a moving one without what floats around it (wakes). Half sides
        /// of 0: nothing is.
        Vec3d middle_m{0};
        Vec3d half_m{0};
        bool operator==(const Cluster&) const = default;
    };
    /// A repeated tile's vertex normals: what a host that changes them starts from (report, 3.1.4).
    struct Tile {
        std::uint32_t list = 0;
        std::vector<Vec3f> normals; ///< row by row
        bool operator==(const Tile&) const = default;
    };

    std::string database_name;
    std::uint64_t database_id = 0;           ///< FramePacket::database_id
    std::vector<std::string> suns;           ///< rows of FramePacket::suns
    std::vector<std::string> moving_objects; ///< rows of FramePacket::moving_objects
    std::vector<Slot> slots;                 ///< Substitution::slot
    std::vector<List> lists;                 ///< ListLighting::list
    std::vector<std::string> colours;        ///< ListLighting::colour
    std::vector<Colour> colour_codes;        ///< of those names: what FramePacket::colours starts from
    std::vector<Cluster> clusters;           ///< ClusterPriority::cluster
    std::vector<Tile> tiles;
    bool operator==(const NameDirectory&) const = default;

    std::optional<std::uint32_t> find_sun(std::string_view name) const;
    std::optional<std::uint32_t> find_moving_object(std::string_view name) const;
    std::optional<std::uint32_t> find_slot(std::string_view name) const;
    std::optional<std::uint32_t> find_list(std::string_view name) const;
    std::optional<std::uint32_t> find_colour(std::string_view name) const;
    std::optional<std::uint32_t> find_cluster(std::string_view name) const;
};

/// `id`: ReadResult::id, or database_id().
NameDirectory name_directory(const VisualDatabase& database, std::uint64_t id);

} // namespace linkdig::database
