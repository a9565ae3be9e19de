#include "database/water/sea_pattern.h"

#include "database/model/mathematics.h"
#include "database/model/random.h"

namespace linkdig::database {

Vec3f table_normal(std::uint32_t azimuth_index, double vertical_angle_rad) {
    const SineCosine phi = sine_cosine(two_pi * azimuth_index / normal_azimuths);
    const SineCosine a = sine_cosine(vertical_angle_rad);
    return {static_cast<float>(phi.cosine * a.cosine), static_cast<float>(phi.sine * a.cosine),
            static_cast<float>(a.sine)};
}

std::vector<Vec3f> random_normals(std::uint64_t seed, NormalStream stream, std::size_t count,
                                  double vertical_angle_rad) {
    std::vector<Vec3f> table;
    for (std::uint32_t i = 0; i < normal_azimuths; ++i)
        table.push_back(table_normal(i, vertical_angle_rad));
    // Seeds of the streams: two outputs of the generator itself, so that neighbouring seeds share nothing.
    const std::uint64_t stream_seed = random_bits(seed, static_cast<std::uint64_t>(stream));
    std::vector<Vec3f> normals;
    normals.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        normals.push_back(table[random_bits(stream_seed, i) % normal_azimuths]);
    return normals;
}

} // namespace linkdig::database
