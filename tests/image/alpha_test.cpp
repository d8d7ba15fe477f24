// Alpha and orientation: what a file says about them reaches the pixels, and what a format cannot keep is
// reported.

#include <gtest/gtest.h>

#include "bmp_maker.h"
#include "image/compare/compare.h"
#include "image/image.h"
#include "image/read.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::idsOf;
using testing::Rgba;

struct Alpha : testing::InFolder {
    /// A TIFF file of RGBA bytes without compression.
    [[nodiscard]] static std::vector<std::byte> tiff(int width, int height, int orientation, int extraSample,
                                                     const std::vector<int>& values) {
        struct Entry {
            std::uint32_t tag, type, count, value;
        };
        constexpr std::uint32_t kEntries = 11, kBitsAt = 8 + 2 + 12 * kEntries + 4, kPixelsAt = kBitsAt + 8;
        const auto unsignedOf = [](int value) { return static_cast<std::uint32_t>(value); };
        std::vector<std::byte> file = testing::bytesOf({'I', 'I', 42, 0, 8, 0, 0, 0});
        testing::putLittle(file, kEntries, 2);
        for (const Entry& each : {Entry{256, 3, 1, unsignedOf(width)},
                                  {257, 3, 1, unsignedOf(height)},
                                  {258, 3, 4, kBitsAt},
                                  {259, 3, 1, 1},
                                  {262, 3, 1, 2},
                                  {273, 4, 1, kPixelsAt},
                                  {274, 3, 1, unsignedOf(orientation)},
                                  {277, 3, 1, 4},
                                  {278, 3, 1, unsignedOf(height)},
                                  {279, 4, 1, static_cast<std::uint32_t>(values.size())},
                                  {338, 3, 1, unsignedOf(extraSample)}}) {
            testing::putLittle(file, each.tag, 2);
            testing::putLittle(file, each.type, 2);
            testing::putLittle(file, each.count, 4);
            testing::putLittle(file, each.value, 4);
        }
        testing::putLittle(file, 0, 4);
        for (int i = 0; i < 4; ++i) testing::putLittle(file, 8, 2);
        for (const std::byte each : testing::bytesOf(values)) file.push_back(each);
        return file;
    }
};

TEST_F(Alpha, IsDividedOutWithRounding) {
    Image image{3, 1, 4, Component::u8, testing::bytesOf({10, 20, 64, 128, 9, 9, 9, 0, 200, 1, 2, 100})};
    unassociateAlpha(image);
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{20, 40, 128, 128}));
    EXPECT_EQ(testing::pixelAt(image, 1, 0), (Rgba{9, 9, 9, 0}));
    EXPECT_EQ(testing::pixelAt(image, 2, 0), (Rgba{255, 3, 5, 100}));
    Image floats = testing::floatImage(1, 1, 4, {1, 2, 3, .5F});
    unassociateAlpha(floats);
    EXPECT_EQ(floats.data, testing::floatImage(1, 1, 4, {2, 4, 6, .5F}).data);
}

TEST_F(Alpha, ThatATiffHasMultipliedInIsDividedOut) {
    GLIBRA_NEED_MODULE();
    const std::vector<int> values{10, 20, 64, 128, 9, 9, 9, 0};
    const auto associated = readImage(put("a.tif", tiff(2, 1, 1, 1, values)), {}, testing::withModule());
    const auto straight = readImage(put("b.tif", tiff(2, 1, 1, 2, values)), {}, testing::withModule());
    ASSERT_TRUE(associated && straight) << idsOf(associated.diagnostics);
    EXPECT_EQ(testing::pixelAt(*associated, 0, 0), (Rgba{20, 40, 128, 128}));
    EXPECT_EQ(testing::pixelAt(*straight, 0, 0), (Rgba{10, 20, 64, 128}));
    EXPECT_EQ(testing::pixelAt(*straight, 1, 0), (Rgba{9, 9, 9, 0}));
}

TEST_F(Alpha, StaysWithItsColoursInEveryFormatThatHasIt) {
    GLIBRA_NEED_MODULE();
    const Image image = testing::noisyImage(23, 17, 4, Component::u8);  // with every alpha, also 0
    for (const char* suffix : {".png", ".tif", ".tga", ".webp", ".sgi"}) {
        const auto path = folder / (std::string("a") + suffix);
        const Diagnostics written = writeImage(image, path, {{}, testing::moduleFolders()});
        EXPECT_TRUE(written.empty()) << suffix << ": " << idsOf(written);
        const auto read = readImage(path, {}, testing::withModule());
        ASSERT_TRUE(read) << suffix;
        EXPECT_EQ(read->data, image.data) << suffix;
    }
    const Image floats = testing::noisyImage(23, 17, 4, Component::f32);
    ASSERT_TRUE(writeImage(floats, folder / "a.exr", {{}, testing::moduleFolders()}).empty());
    const auto read = readImage(folder / "a.exr", {}, testing::withModule());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->data, floats.data);
}

TEST_F(Alpha, ThatAFormatLacksIsReportedWhenItIsLost) {
    GLIBRA_NEED_MODULE();
    Image opaque = testing::noisyImage(9, 7, 4, Component::u8);
    for (std::size_t i = 3; i < opaque.data.size(); i += 4) opaque.data[i] = std::byte{255};
    Image clear = opaque;
    clear.data[4 * 30 + 3] = std::byte{254};
    for (const char* suffix : {".bmp", ".jpg", ".hdr", ".ppm", ".pfm", ".gif"}) {
        const auto path = folder / (std::string("a") + suffix);
        EXPECT_TRUE(writeImage(opaque, path, {{}, testing::moduleFolders()}).empty()) << suffix;
        const Diagnostics lost = writeImage(clear, path, {{}, testing::moduleFolders()});
        ASSERT_EQ(idsOf(lost), "file-W14") << suffix;
        EXPECT_NE(lost[0].text.find(path.string()), std::string::npos);
        const auto read = readImage(path, {}, testing::withModule());
        ASSERT_TRUE(read) << suffix;
        EXPECT_FALSE(isTransparent(*read)) << suffix;
        if (std::string_view(suffix) == ".bmp") {
            EXPECT_EQ(read->data, opaque.data);
        }
    }
}

TEST_F(Alpha, OrientationsPutTheFirstRowAndColumnWhereTheySay) {
    // The pixels of a 3 x 2 file, and where TIFF 6.0 (Orientation) puts them.
    const Image file{3, 2, 1, Component::u8, testing::bytesOf({1, 2, 3, 4, 5, 6})};
    const std::vector<std::vector<int>> expected{{1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1},
                                                 {4, 5, 6, 1, 2, 3}, {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3},
                                                 {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
    for (unsigned orientation = 1; orientation <= 8; ++orientation) {
        const Image turned = upright(file, orientation);
        EXPECT_EQ(turned.width, orientation < 5 ? 3 : 2) << orientation;
        EXPECT_EQ(turned.data, testing::bytesOf(expected[orientation - 1])) << orientation;
    }
}

TEST_F(Alpha, ATiffIsReadUpright) {
    GLIBRA_NEED_MODULE();
    const std::vector<int> values{1, 1, 1, 255, 2, 2, 2, 255, 3, 3, 3, 255,
                                  4, 4, 4, 255, 5, 5, 5, 255, 6, 6, 6, 255};
    const auto read = readImage(put("a.tif", tiff(3, 2, 6, 2, values)), {}, testing::withModule());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->width, 2);
    EXPECT_EQ(read->height, 3);
    EXPECT_EQ(testing::pixelAt(*read, 0, 0)[0], 4);
    EXPECT_EQ(testing::pixelAt(*read, 1, 2)[0], 3);
}

TEST_F(Alpha, ColoursThatAPaletteLacksAreReported) {
    testing::BmpMaker maker{.width = 8, .height = 1, .bits = 4, .palette = {{9, 8, 7}, {6, 5, 4}}};
    maker.pixels = {0x01, 0x25, 0x10, 0x00};
    const auto read = readImage(put("a.bmp", maker.file()));
    ASSERT_TRUE(read) << idsOf(read.diagnostics);
    ASSERT_EQ(idsOf(read.diagnostics), "file-W16");
    EXPECT_EQ(read.diagnostics[0].text,
              "'a.bmp': 2 pixels have colours that the palette lacks; they are black");
    EXPECT_EQ(testing::pixelAt(*read, 2, 0), (Rgba{0, 0, 0, 255}));
}

}  // namespace
}  // namespace glibra::image
