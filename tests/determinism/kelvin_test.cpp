// Fields of Kelvin wakes, as floats.

#include "database/compiler/wake_spec.h"
#include "tests/determinism/hashes.h"

#include <gtest/gtest.h>

namespace linkdig::determinism {

TEST(Kelvin, FieldsKeepTheirBytes) {
    for (const char* figure : {"figure09b", "figure12", "figure20", "figure22"}) {
        database::Diagnostics diagnostics;
        auto spec = database::read_wake_spec(
            std::string(LINKDIG_SOURCE_DIR "/database/scenes/wakes/kelvin/") + figure + ".toml", diagnostics);
        ASSERT_TRUE(spec) << diagnostics.text();
        spec->wakes.psi_per_unit *= 0.25;
        spec->wakes.size /= 4;
        Hasher hasher;
        for (const float height : database::wake_field(*spec).kelvin.field.heights)
            hasher.value(height);
        expect_hash(std::string("kelvin/") + figure, hasher.hash());
    }
}

} // namespace linkdig::determinism
