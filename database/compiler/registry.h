#pragma once
/// Pass 2: everything that other tables refer to by name.

#include "database/compiler/sources.h"
#include "database/model/visual_database.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::database {

/// Names of one kind, numbered in the order of their appearance.
class NameTable {
public:
    explicit NameTable(const char* kind) : kind_(kind) {}
    /// Reports a name that stands already. An empty name (one that was reported as missing) is numbered, not
    /// found.
    void add(std::string name, Place at, const Sources& sources, Diagnostics& diagnostics);
    std::optional<std::uint32_t> find(std::string_view name) const;
    /// "no colour is named ..." with the closest spelling.
    std::string unknown(std::string_view name) const;
    const std::vector<std::string>& names() const { return names_; }
    /// "name of a [[colour]]"
    std::string reference() const;
    std::uint32_t size() const { return static_cast<std::uint32_t>(names_.size()); }

private:
    std::string table() const;
    const char* kind_;
    std::vector<std::string> names_;
    std::vector<Place> places_;
    std::map<std::string, std::uint32_t, std::less<>> index_;
};

struct AuthoredCluster {
    std::int32_t group_number = 0;
    std::int32_t moving_object = none;
    std::optional<Vec3d> reference_m;
    std::optional<Vec3d> half_extent_m;
    Place at;
};

struct AuthoredList {
    ObjectList list;               ///< without its tree
    bool in_cluster = false;       ///< its cluster is known
    bool resolved = false;         ///< its cluster and sun are known
    std::uint32_t edge_budget = 0; ///< 0: none
    std::string added_to;          ///< name of the list that it is added to, or empty
    SourceLocation added_to_at;
    Place at;
};

struct AuthoredDetail {
    Detail detail;
    std::vector<float> to_m; ///< of its levels; empty if there is a mistake
    bool resolved = false;   ///< its cluster is known
    Place at;
};

struct Registry {
    std::string name;
    std::uint32_t edge_budget = 0; ///< of the whole database; 0: none
    Place edge_budget_at;
    NameTable colour_names{"colour"}, suns{"sun"}, moving_objects{"moving object"}, slots{"slot"},
        cluster_names{"cluster"}, list_names{"object list"}, details{"detail"};
    std::vector<Colour> colours;
    std::vector<std::uint32_t> alternatives;  ///< parallel to slots
    std::vector<std::uint32_t> first_objects; ///< parallel to slots: 1 where alternative 0 is nothing, else 0
    std::vector<Place> slot_places;
    std::vector<AuthoredCluster> clusters;
    std::vector<AuthoredList> lists;
    std::vector<AuthoredDetail> authored_details; ///< parallel to details
};

Registry read_registry(const AuthoredTables& tables, const Sources& sources, Diagnostics& diagnostics);

/// Levels of detail, into `registry`, which knows the clusters.
void read_details(const AuthoredTables& tables, const Sources& sources, Diagnostics& diagnostics,
                  Registry& registry);

/// The number of the thing that the key's value names; an unknown one is reported. Nothing if the key is
/// absent.
std::optional<std::uint32_t> named(TableReader& reader, std::string_view key, const NameTable& names,
                                   bool required);

/// Three whole numbers 0 to 255.
Vec3d read_rgb(TableReader& reader, std::string_view key);

/// Most alternatives of a slot.
inline constexpr std::int64_t most_alternatives = 4096;

} // namespace linkdig::database
