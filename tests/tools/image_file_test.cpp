#include "ig/sink/image_file.h"
#include "ig/sink/png_sink.h"
#include "tests/tools/pictures.h"

#include <OpenImageIO/imagebuf.h>
#include <gmock/gmock.h>

#include <chrono>
#include <thread>

namespace linkdig::tools {
namespace {

TEST(ImageFile, PngHoldsEveryPixelInThreeChannels) {
    const TemporaryFolder folder;
    const ig::VideoFrame picture = test_picture(33, 17, 5);
    ig::PngSink sink(folder.text());
    sink.put(7, picture);
    const OIIO::ImageBuf read(folder.file("frame_000007.png"));
    ASSERT_EQ(read.spec().width, 33);
    ASSERT_EQ(read.spec().height, 17);
    ASSERT_EQ(read.nchannels(), 3);
    for (int y = 0; y < 17; ++y) {
        for (int x = 0; x < 33; ++x) {
            const std::uint32_t pixel =
                picture.pixels[static_cast<std::size_t>(y) * 33 + static_cast<std::size_t>(x)];
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(std::lround(read.getchannel(x, y, 0, c) * 255), pixel >> (8 * c) & 0xFF)
                    << x << ' ' << y;
        }
    }
}

TEST(ImageFile, FilesCarryNoTimeOfWriting) {
    const TemporaryFolder folder;
    const ig::VideoFrame picture = test_picture(40, 30);
    const std::vector<float> values(1200, 0.25F);
    ig::write_png(folder.file("a.png"), picture);
    ig::write_exr(folder.file("a.exr"), 40, 30, values);
    // Time stamps in pictures count whole seconds.
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    ig::write_png(folder.file("b.png"), picture);
    ig::write_exr(folder.file("b.exr"), 40, 30, values);
    EXPECT_EQ(bytes_of(folder.file("a.png")), bytes_of(folder.file("b.png")));
    EXPECT_EQ(bytes_of(folder.file("a.exr")), bytes_of(folder.file("b.exr")));
}

TEST(ImageFile, NumbersOf32BitsSurvive) {
    const TemporaryFolder folder;
    const std::vector<std::uint32_t> values{0, 1, 16777217, 0x80000001U, 0xFFFFFFFEU, 0xFFFFFFFFU};
    ig::write_exr(folder.file("object.exr"), "object", 3, 2, values);
    const auto input = OIIO::ImageInput::open(folder.file("object.exr"));
    ASSERT_TRUE(input);
    EXPECT_THAT(input->spec().channelnames, testing::ElementsAre("object"));
    std::vector<std::uint32_t> read(6);
    ASSERT_TRUE(input->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT32, read.data()));
    EXPECT_EQ(read, values);
}

TEST(ImageFile, AFolderThatIsNotThereIsNamed) {
    try {
        ig::write_png("/nowhere/at/all/x.png", test_picture(2, 2));
        FAIL() << "written into nowhere";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("/nowhere/at/all/x.png: cannot be written"));
    }
}

} // namespace
} // namespace linkdig::tools
