#include "ig/sink/hash_sink.h"
#include "tests/tools/pictures.h"

#include <gtest/gtest.h>

#include <vector>

namespace linkdig::tools {
namespace {

TEST(HashSink, EqualPicturesHaveEqualHashes) {
    EXPECT_EQ(ig::picture_hash(test_picture(8, 6, 3)), ig::picture_hash(test_picture(8, 6, 3)));
}

TEST(HashSink, EveryBitOfAPixelCounts) {
    const ig::VideoFrame picture = test_picture(8, 6);
    const std::uint64_t hash = ig::picture_hash(picture);
    for (std::size_t pixel = 0; pixel < picture.pixels.size(); ++pixel) {
        for (std::uint32_t bit = 0; bit < 32; ++bit) {
            ig::VideoFrame changed = picture;
            changed.pixels[pixel] ^= 1U << bit;
            ASSERT_NE(ig::picture_hash(changed), hash);
        }
    }
}

TEST(HashSink, TheShapeCounts) {
    ig::VideoFrame wide{
        .width = 8, .height = 2, .pixels = std::vector<std::uint32_t>(16, 7), .intensity = {}, .rank = {}};
    ig::VideoFrame square{
        .width = 4, .height = 4, .pixels = std::vector<std::uint32_t>(16, 7), .intensity = {}, .rank = {}};
    EXPECT_NE(ig::picture_hash(wide), ig::picture_hash(square));
}

TEST(HashSink, RemembersByFrame) {
    ig::HashSink sink;
    sink.put(5, test_picture(3, 3, 5));
    sink.put(2, test_picture(3, 3, 2));
    ASSERT_EQ(sink.hashes().size(), 2U);
    EXPECT_EQ(sink.hashes().at(2), ig::picture_hash(test_picture(3, 3, 2)));
    EXPECT_EQ(sink.hashes().at(5), ig::picture_hash(test_picture(3, 3, 5)));
}

} // namespace
} // namespace linkdig::tools
