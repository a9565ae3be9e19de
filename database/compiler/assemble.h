#pragma once
/// Pass 7: everything in its vector of the visual database, everything by index.

#include "database/compiler/compile.h"
#include "database/compiler/order_lists.h"
#include "database/compiler/priority_planes.h"
#include "database/compiler/read_tiles.h"

namespace linkdig::database {

struct Assembly {
    const Sources& sources;
    const Registry& registry;
    const std::vector<ModelObject>& objects;
    const std::vector<OrderedList>& lists;
    const PriorityPlanes& planes;
    const Tiles& tiles;
};

VisualDatabase assemble(const Assembly& parts, CompileStatistics& statistics);

/// Box of the points of a cluster's lists, for its reference point and half extent; nothing if it has none.
struct Box {
    Vec3d low{0};
    Vec3d high{0};
    bool any = false;
    void add(const Vec3d& point);
};

} // namespace linkdig::database
