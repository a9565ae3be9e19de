#include "host/loop/turned_normals.h"

#include "database/model/mathematics.h"

namespace linkdig::host {

void turn_normals(const std::vector<Vec3f>& normals, double turned_rad, VertexNormalUpdate& update) {
    const SineCosine turn = sine_cosine(turned_rad);
    update.normals.resize(normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vec3d n(normals[i]);
        update.normals[i] = Vec3f(static_cast<float>(n.x * turn.cosine - n.y * turn.sine),
                                  static_cast<float>(n.x * turn.sine + n.y * turn.cosine), normals[i].z);
    }
}

} // namespace linkdig::host
