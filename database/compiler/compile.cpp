#include "database/compiler/compile.h"

#include "database/compiler/assemble.h"
#include "database/compiler/check_objects.h"
#include "database/compiler/check_solids.h"
#include "database/compiler/edge_budgets.h"

#include <utility>

namespace linkdig::database {

ListStatistics CompileStatistics::total() const {
    ListStatistics sum;
    for (const ListStatistics& list : lists) {
        sum.objects += list.objects;
        sum.faces += list.faces;
        sum.faces_at_once += list.faces_at_once;
        sum.edges += list.edges;
        sum.edges_at_once += list.edges_at_once;
        sum.vertices += list.vertices;
        sum.planes += list.planes;
        sum.splits += list.splits;
        sum.lights += list.lights;
        sum.runs += list.runs;
    }
    return sum;
}

CompileResult compile_file(const std::string& path) {
    CompileResult result;
    const Sources sources = read_sources(path, result.diagnostics);
    result.files = sources.tried;
    const AuthoredTables tables = gather_tables(sources, result.diagnostics);
    const Registry registry = read_registry(tables, sources, result.diagnostics);
    const Reading reading{&sources, &registry, &result.diagnostics};
    MeshFiles meshes;
    std::vector<ModelObject> objects = read_objects(tables, reading, meshes);
    result.statistics.meshes = std::move(meshes.statistics);
    result.files.insert(result.files.end(), meshes.tried.begin(), meshes.tried.end());
    check_faces(objects, reading);
    check_solids(objects, reading);
    check_slots(objects, reading);
    check_levels(objects, reading);
    for (ModelObject& object : objects)
        average_normals(object);
    const std::vector<OrderedList> lists = order_lists(objects, reading);
    const PriorityPlanes planes = read_priority_planes(tables, reading);
    const Tiles tiles = read_tiles(tables, objects, reading);
    if (result.diagnostics.any()) return result;
    result.database = assemble({sources, registry, objects, lists, planes, tiles}, result.statistics);
    check_edge_budgets(*result.database, reading, result.statistics);
    if (result.diagnostics.any()) result.database.reset();
    return result;
}

} // namespace linkdig::database
