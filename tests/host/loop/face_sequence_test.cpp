#include "host/loop/face_sequence.h"

#include <gtest/gtest.h>

#include <array>

namespace linkdig::host {
namespace {

TEST(FaceSequence, RunsThroughAll28FacesAndWraps) {
    const FaceSequence sequence = FaceSequence::of(28, 0.1, 0.0, 30.0);
    for (std::uint64_t frame = 0; frame < 3 * 28 * 3; ++frame)
        EXPECT_EQ(sequence.index(frame), frame / 3 % 28) << frame;
}

TEST(FaceSequence, EachFaceStaysItsNumberOfFramesAtOtherRates) {
    const FaceSequence sequence = FaceSequence::of(28, 0.1, 0.0, 60.0);
    for (std::uint64_t frame = 0; frame < 1000; ++frame)
        EXPECT_EQ(sequence.index(frame), frame / 6 % 28) << frame;
}

/// 0.05 s at 30 Hz is a frame and a half: faces stay one and two frames in turn, so the rate is kept.
TEST(FaceSequence, ABrokenNumberOfFramesKeepsTheRate) {
    const FaceSequence sequence = FaceSequence::of(28, 0.05, 0.0, 30.0);
    std::array<int, 28> stays{};
    for (std::uint64_t frame = 0; frame < 42; ++frame)
        ++stays[sequence.index(frame)];
    for (std::size_t face = 0; face < stays.size(); ++face)
        EXPECT_EQ(stays[face], face % 2 == 0 ? 2 : 1) << face;
    EXPECT_EQ(sequence.index(42), 0U);
}

TEST(FaceSequence, SameFaceAtTheSameTimeAtThirtyAndSixtyHertz) {
    for (const double dwell : {0.1, 0.07, 1.0 / 3.0, 0.0333333, 0.004}) {
        const FaceSequence at_30 = FaceSequence::of(28, dwell, 0.25, 30.0);
        const FaceSequence at_60 = FaceSequence::of(28, dwell, 0.25, 60.0);
        for (std::uint64_t frame = 0; frame < 36000; ++frame)
            ASSERT_EQ(at_30.index(frame), at_60.index(2 * frame)) << dwell << " " << frame;
    }
}

TEST(FaceSequence, DoesNotSlipInHours) {
    const FaceSequence sequence = FaceSequence::of(28, 0.1, 0.0, 30.0);
    const std::uint64_t ten_hours = 30ULL * 36000;
    for (std::uint64_t frame = ten_hours; frame < ten_hours + 200; ++frame)
        EXPECT_EQ(sequence.index(frame), frame / 3 % 28) << frame;
}

TEST(FaceSequence, BeginsAtItsPhase) {
    EXPECT_EQ(FaceSequence::of(28, 0.1, 0.5, 30.0).index(0), 14U);
    EXPECT_EQ(FaceSequence::of(28, 0.1, 1.0, 30.0).index(0), 0U);
    EXPECT_EQ(FaceSequence::of(1, 0.1, 0.0, 30.0).index(77), 0U);
}

} // namespace
} // namespace linkdig::host
