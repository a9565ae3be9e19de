// What a frame costs is told of frames that were drawn.

#include "tools/bench/live.h"
#include "tools/bench/measure.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

namespace linkdig::bench {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Bench, AFrameThatIsRefusedIsNotMeasured) {
    const Scene scene = make_scene("sea");
    const MeasureOptions refused{
        .size = 16, .visibility_m = std::numeric_limits<double>::quiet_NaN(), .frames = 1};
    const auto told = ThrowsMessage<std::runtime_error>(HasSubstr("bench: frame 0 was refused: "));
    EXPECT_THAT([&] { measure(scene, refused); }, told);
    EXPECT_THAT([&] { measure_live(scene, refused, 1000.0); }, told);
}

} // namespace
} // namespace linkdig::bench
