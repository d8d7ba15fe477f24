// BMP in every form of language, 8.2: bytes made by hand, and OpenImageIO as a second reader if it knows the
// form.

#include <gtest/gtest.h>

#include <algorithm>

#include "bmp_maker.h"
#include "image/compare/compare.h"
#include "image/formats/readers.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::BmpMaker;
using testing::Rgba;

const FileLabel kBmpLabel{"a.bmp", {"scene.glib", 4, 1}};

Image decoded(const BmpMaker& maker) {
    auto result = decodeBmp(maker.file(), kBmpLabel);
    EXPECT_TRUE(result) << (result ? "" : result.diagnostics[0].text);
    return result ? *std::move(result.value) : Image{0, 0, 4, Component::u8, {}};
}

std::string idFor(const BmpMaker& maker) {
    return testing::idsOf(decodeBmp(maker.file(), kBmpLabel).diagnostics);
}

void expectSameElsewhere(const BmpMaker& maker) {
    if (!testing::hasModule()) return;
    const auto other = testing::decodeElsewhere(Format::bmp, maker.file());
    ASSERT_TRUE(other) << other.diagnostics[0].text;
    EXPECT_TRUE(compare(decoded(maker), *other).identical);
}

std::vector<int> noisyValues(std::uint32_t count, std::uint32_t seed = 0) {
    std::vector<int> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = static_cast<int>(testing::hash(seed + static_cast<std::uint32_t>(i)) >> 24);
    return values;
}

std::vector<std::array<int, 3>> noisyPalette(std::size_t count) {
    std::vector<std::array<int, 3>> palette(count);
    for (std::size_t i = 0; i < count; ++i)
        palette[i] = {static_cast<int>(i * 7 % 256), static_cast<int>(255 - i),
                      static_cast<int>(i * 31 % 256)};
    return palette;
}

TEST(Bmp, Reads24BitsBottomRowFirstWithPaddedRows) {
    const Image image = decoded({.width = 1, .height = 2, .pixels = {1, 2, 3, 99, 4, 5, 6, 99}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{6, 5, 4, 255}));
    EXPECT_EQ(testing::pixelAt(image, 0, 1), (Rgba{3, 2, 1, 255}));
}

TEST(Bmp, NegativeHeightIsTopRowFirst) {
    const Image image = decoded({.width = 1, .height = -2, .pixels = {1, 2, 3, 99, 4, 5, 6, 99}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{3, 2, 1, 255}));
    EXPECT_EQ(testing::pixelAt(image, 0, 1), (Rgba{6, 5, 4, 255}));
}

TEST(Bmp, AgreesWithAnotherReaderFor24Bits) {
    expectSameElsewhere({.width = 5, .height = 7, .pixels = noisyValues(16 * 7)});
    expectSameElsewhere({.width = 6, .height = -4, .pixels = noisyValues(20 * 4)});
}

TEST(Bmp, ReadsPalettesOf1And4And8Bits) {
    for (const std::uint32_t bits : {1U, 4U, 8U}) {
        BmpMaker maker{.width = 13,
                       .height = 3,
                       .bits = bits,
                       .palette = noisyPalette(1U << bits),
                       .pixels = noisyValues((13 * bits + 31) / 32 * 4 * 3)};
        const Image image = decoded(maker);
        // Pixel x of the bottom row, computed from the whole row as one string of bits.
        for (std::size_t x = 0; x < 13; ++x) {
            const std::size_t bit = x * bits;
            const auto index =
                static_cast<std::size_t>(maker.pixels[bit / 8]) >> (8 - bits - bit % 8) & ((1U << bits) - 1);
            const auto& color = maker.palette[index];
            EXPECT_EQ(testing::pixelAt(image, static_cast<int>(x), 2),
                      (Rgba{color[0], color[1], color[2], 255}))
                << bits << " " << x;
        }
        expectSameElsewhere(maker);
    }
}

TEST(Bmp, ReadsTheOldHeaderWithItsThreeBytePalette) {
    const BmpMaker maker{.headerSize = 12,
                         .width = 2,
                         .height = 1,
                         .bits = 8,
                         .palette = noisyPalette(256),
                         .pixels = {3, 200, 0, 0}};
    const Image image = decoded(maker);
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{21, 252, 93, 255}));
    EXPECT_EQ(testing::pixelAt(image, 1, 0), (Rgba{200 * 7 % 256, 55, 200 * 31 % 256, 255}));
}

TEST(Bmp, ReadsEveryHeaderLength) {
    for (const std::uint32_t size : {12U, 40U, 52U, 56U, 64U, 108U, 124U}) {
        const Image image =
            decoded({.headerSize = size, .width = 2, .height = 1, .pixels = {1, 2, 3, 4, 5, 6, 0, 0}});
        ASSERT_EQ(image.width, 2) << size;
        EXPECT_EQ(testing::pixelAt(image, 1, 0), (Rgba{6, 5, 4, 255})) << size;
    }
    for (const std::uint32_t size : {0U, 16U, 41U, 128U, 0xffffffffU})
        EXPECT_EQ(idFor({.headerSize = std::min(size, 4000U), .pixels = {1, 2, 3, 0}}), "file-E04") << size;
}

TEST(Bmp, HonoursTheDataOffset) {
    const Image image = decoded({.pixels = {7, 8, 9, 0}, .gap = 37});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{9, 8, 7, 255}));
}

TEST(Bmp, AShortPaletteLeavesTheOtherColorsBlack) {
    const Image image = decoded({.width = 3,
                                 .height = 1,
                                 .bits = 8,
                                 .colorsUsed = 2,
                                 .palette = noisyPalette(2),
                                 .pixels = {1, 2, 255, 0}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{7, 254, 31, 255}));
    EXPECT_EQ(testing::pixelAt(image, 1, 0), (Rgba{0, 0, 0, 255}));
    EXPECT_EQ(testing::pixelAt(image, 2, 0), (Rgba{0, 0, 0, 255}));
}

TEST(Bmp, AHugePaletteCountIsLimited) {
    const Image image = decoded({.width = 1,
                                 .height = 1,
                                 .bits = 1,
                                 .colorsUsed = 0xffffffff,
                                 .palette = noisyPalette(2),
                                 .pixels = {0x80, 0, 0, 0}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{7, 254, 31, 255}));
}

TEST(Bmp, Reads16BitsAs555) {
    // 0 11111 00000 10000, little-endian; 16/31 of 255 is 131.6.
    const Image image = decoded({.width = 1, .height = 1, .bits = 16, .pixels = {0x10, 0x7c, 0, 0}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{255, 0, 132, 255}));
}

TEST(Bmp, Reads16BitsAs565ByMasks) {
    const Image image = decoded({.width = 2,
                                 .height = 1,
                                 .bits = 16,
                                 .compression = 3,
                                 .masks = {0xf800, 0x07e0, 0x001f},
                                 .pixels = {0xe0, 0x07, 0x01, 0x84}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{0, 255, 0, 255}));
    EXPECT_EQ(testing::pixelAt(image, 1, 0), (Rgba{132, 130, 8, 255}));  // 16/31, 32/63, 1/31
}

TEST(Bmp, TheFourthByteOfPlain32BitsIsIgnored) {
    const BmpMaker maker{.width = 1, .height = 1, .bits = 32, .pixels = {1, 2, 3, 77}};
    EXPECT_EQ(testing::pixelAt(decoded(maker), 0, 0), (Rgba{3, 2, 1, 255}));
    BmpMaker longer = maker;
    longer.headerSize = 124;
    longer.masks = {0xff0000, 0xff00, 0xff,
                    0xff000000};  // in the header, but nothing says that the pixels use them
    EXPECT_EQ(testing::pixelAt(decoded(longer), 0, 0), (Rgba{3, 2, 1, 255}));
}

TEST(Bmp, AnAlphaMaskOf32BitsGivesAlpha) {
    for (const std::uint32_t size : {56U, 108U, 124U}) {
        const Image image = decoded({.headerSize = size,
                                     .width = 1,
                                     .height = 1,
                                     .bits = 32,
                                     .compression = 3,
                                     .masks = {0xff0000, 0xff00, 0xff, 0xff000000},
                                     .pixels = {1, 2, 3, 77}});
        EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{3, 2, 1, 77})) << size;
    }
    // ALPHABITFIELDS: four masks after the 40-byte header.
    const Image image = decoded({.width = 1,
                                 .height = 1,
                                 .bits = 32,
                                 .compression = 6,
                                 .masks = {0xff, 0xff00, 0xff0000, 0xff000000},
                                 .pixels = {1, 2, 3, 77}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{1, 2, 3, 77}));
}

TEST(Bmp, ThreeMasksMeanNoAlpha) {
    for (const std::uint32_t size : {40U, 52U}) {
        const Image image = decoded({.headerSize = size,
                                     .width = 1,
                                     .height = 1,
                                     .bits = 32,
                                     .compression = 3,
                                     .masks = {0xff000000, 0xff0000, 0xff00},
                                     .pixels = {77, 3, 2, 1}});
        EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{1, 2, 3, 255})) << size;
    }
}

TEST(Bmp, WideAndNarrowMasksAreScaledToBytes) {
    // 10 bits of red, 1 bit of green, no blue.
    const Image image = decoded({.width = 1,
                                 .height = 1,
                                 .bits = 32,
                                 .compression = 3,
                                 .masks = {0x3ff, 0x400, 0},
                                 .pixels = {0x00, 0x06, 0, 0}});
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{128, 255, 0, 255}));  // 512 / 1023 of 255 = 127.6
}

TEST(Bmp, DecodesRunsAndLiteralsOfRle8) {
    // Rows from the bottom: 3 x colour 1; then 3 literals padded to 4 bytes.
    const BmpMaker maker{.width = 6,
                         .height = 2,
                         .bits = 8,
                         .compression = 1,
                         .palette = noisyPalette(256),
                         .pixels = {3, 1, 0, 3, 5, 6, 7, 0, 0, 0, 6, 9, 0, 1}};
    const Image image = decoded(maker);
    EXPECT_EQ(testing::pixelAt(image, 2, 1), (Rgba{7, 254, 31, 255}));
    EXPECT_EQ(testing::pixelAt(image, 3, 1), (Rgba{35, 250, 155, 255}));
    EXPECT_EQ(testing::pixelAt(image, 5, 1), (Rgba{49, 248, 217, 255}));
    EXPECT_EQ(testing::pixelAt(image, 0, 0), (Rgba{63, 246, 9 * 31 % 256, 255}));
}

TEST(Bmp, DecodesRunsAndLiteralsOfRle4) {
    // A run alternates between its two colours; 5 literals take 3 bytes and one byte of padding.
    const BmpMaker maker{.width = 10,
                         .height = 1,
                         .bits = 4,
                         .compression = 2,
                         .palette = noisyPalette(16),
                         .pixels = {5, 0x12, 0, 5, 0x34, 0x56, 0x70, 0, 0, 1}};
    const Image image = decoded(maker);
    const int expected[10] = {1, 2, 1, 2, 1, 3, 4, 5, 6, 7};
    for (int x = 0; x < 10; ++x) EXPECT_EQ(testing::pixelAt(image, x, 0)[1], 255 - expected[x]) << x;
}

TEST(Bmp, GapsOfRunLengthsAreTheFirstColor) {
    // One pixel, then 2 to the right and 1 up, one pixel, end of picture.
    const BmpMaker maker{.width = 4,
                         .height = 3,
                         .bits = 8,
                         .compression = 1,
                         .palette = noisyPalette(256),
                         .pixels = {1, 1, 0, 2, 2, 1, 1, 2, 0, 1}};
    const Image image = decoded(maker);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) {
            const int index = x == 0 && y == 2 ? 1 : x == 3 && y == 1 ? 2 : 0;
            EXPECT_EQ(testing::pixelAt(image, x, y)[1], 255 - index) << x << " " << y;
        }
}

TEST(Bmp, RunsBeyondTheRowAreDropped) {
    const BmpMaker maker{.width = 2,
                         .height = 2,
                         .bits = 8,
                         .compression = 1,
                         .palette = noisyPalette(256),
                         .pixels = {200, 1, 0, 0, 2, 3, 0, 2, 255, 255, 9, 9, 0, 1}};
    const Image image = decoded(maker);
    EXPECT_EQ(testing::pixelAt(image, 1, 1)[1], 254);
    EXPECT_EQ(testing::pixelAt(image, 1, 0)[1], 252);
}

TEST(Bmp, RunLengthsMayEndWithoutTheEndMark) {
    EXPECT_EQ(decoded({.width = 2,
                       .height = 2,
                       .bits = 8,
                       .compression = 1,
                       .palette = noisyPalette(256),
                       .pixels = {2, 1, 0, 0, 2, 3}})
                  .width,
              2);
}

TEST(Bmp, RunLengthsThatEndEarlyAreShort) {
    const auto result = decodeBmp(BmpMaker{.width = 2,
                                           .height = 3,
                                           .bits = 8,
                                           .compression = 1,
                                           .palette = noisyPalette(256),
                                           .pixels = {2, 1, 0, 0}}
                                      .file(),
                                  kBmpLabel);
    ASSERT_EQ(testing::idsOf(result.diagnostics), "file-E04");
    EXPECT_EQ(result.diagnostics[0].text, "'a.bmp': pixel data end after row 1 of 3");
    EXPECT_EQ(idFor({.width = 9,
                     .height = 2,
                     .bits = 8,
                     .compression = 1,
                     .palette = noisyPalette(256),
                     .pixels = {0, 9, 1, 2}}),
              "file-E04");
    EXPECT_EQ(idFor({.width = 9,
                     .height = 2,
                     .bits = 8,
                     .compression = 1,
                     .palette = noisyPalette(256),
                     .pixels = {0, 2, 1}}),
              "file-E04");
}

TEST(Bmp, AgreesWithAnotherReaderForRle8) {
    BmpMaker maker{.width = 40, .height = 9, .bits = 8, .compression = 1, .palette = noisyPalette(256)};
    for (int y = 0; y < 9; ++y) {
        for (const int each : {10 + y, y, 0, 20 - y}) maker.pixels.push_back(each);
        for (int i = 0; i < 20 - y + y % 2; ++i) maker.pixels.push_back(i * 3 % 256);
        for (const int each : {10, 100 + y, 0, 0}) maker.pixels.push_back(each);
    }
    maker.pixels.back() = 1;  // the end of the last row is the end of the picture
    expectSameElsewhere(maker);
}

TEST(Bmp, CutPixelsReportTheNumberOfCompleteRows) {
    const BmpMaker maker{.width = 3, .height = 5, .pixels = noisyValues(12 * 5)};
    const auto file = maker.file();
    const auto cut = decodeBmp(std::span(file).first(file.size() - 30), kBmpLabel);
    ASSERT_EQ(testing::idsOf(cut.diagnostics), "file-E04");
    EXPECT_EQ(cut.diagnostics[0].text, "'a.bmp': pixel data end after row 2 of 5");
    EXPECT_EQ(cut.diagnostics[0].place, kBmpLabel.place);
    // The padding of the last row may be missing, but not a pixel.
    EXPECT_TRUE(decodeBmp(std::span(file).first(file.size() - 3), kBmpLabel));
    EXPECT_FALSE(decodeBmp(std::span(file).first(file.size() - 4), kBmpLabel));
}

TEST(Bmp, EveryCutOfEveryFormGivesOneMessage) {
    const BmpMaker forms[] = {
        {.width = 3, .height = 5, .pixels = noisyValues(60)},
        {.headerSize = 12,
         .width = 9,
         .height = 3,
         .bits = 4,
         .palette = noisyPalette(16),
         .pixels = noisyValues(24)},
        {.headerSize = 124,
         .width = 3,
         .height = 3,
         .bits = 32,
         .compression = 3,
         .masks = {255, 0xff00, 0xff0000, 0},
         .pixels = noisyValues(36)},
        {.width = 3,
         .height = 3,
         .bits = 16,
         .compression = 3,
         .masks = {0xf800, 0x7e0, 0x1f},
         .pixels = noisyValues(24)},
        {.width = 6,
         .height = 2,
         .bits = 8,
         .compression = 1,
         .palette = noisyPalette(256),
         .pixels = {3, 1, 0, 3, 5, 6, 7, 0, 0, 0, 6, 9}},
    };
    for (const BmpMaker& form : forms) {
        const auto file = form.file();
        ASSERT_TRUE(decodeBmp(file, kBmpLabel));
        for (std::size_t length = 0; length + 4 <= file.size(); ++length) {
            const auto result = decodeBmp(std::span(file).first(length), kBmpLabel);
            if (result) {
                EXPECT_GT(length + 5, file.size());
            } else {
                EXPECT_EQ(testing::idsOf(result.diagnostics), "file-E04") << length;
            }
        }
    }
}

TEST(Bmp, WrongHeadersAreRejected) {
    EXPECT_EQ(idFor({.width = 0, .pixels = {0}}), "file-E04");
    EXPECT_EQ(idFor({.width = -5, .pixels = {0}}), "file-E04");
    EXPECT_EQ(idFor({.height = 0, .pixels = {0}}), "file-E04");
    EXPECT_EQ(idFor({.width = 16385, .pixels = {0}}), "file-E09");
    EXPECT_EQ(idFor({.width = 0x7fffffff, .height = 0x7fffffff, .bits = 32, .pixels = {0}}), "file-E09");
    EXPECT_EQ(idFor({.height = std::numeric_limits<std::int32_t>::min(), .pixels = {0}}), "file-E09");
    EXPECT_EQ(idFor({.width = 16000, .height = 16000, .pixels = {0}}), "file-E04");
    EXPECT_EQ(idFor({.bits = 7, .pixels = {0, 0, 0, 0}}), "file-E04");
    EXPECT_EQ(idFor({.bits = 24, .compression = 1, .pixels = {0, 0, 0, 0}}), "file-E04");
    EXPECT_EQ(idFor({.compression = 99, .pixels = {0, 0, 0, 0}}), "file-E04");
    EXPECT_EQ(idFor({.pixels = {1, 2, 3, 0}, .dataOffset = 20}), "file-E04");
    EXPECT_EQ(idFor({.pixels = {1, 2, 3, 0}, .dataOffset = 58}), "file-E04");
    EXPECT_EQ(idFor({.pixels = {1, 2, 3, 0}, .dataOffset = 0xffffffff}), "file-E04");
    EXPECT_EQ(idFor({.headerSize = 64, .bits = 24, .compression = 4, .pixels = {1, 2, 3, 0}}),
              "file-E04");  // OS/2's RLE24
}

TEST(Bmp, AWrappedPngIsRead) {
    const Image inner = testing::noisyImage(5, 4, 4, Component::u8);
    BmpMaker maker{.width = 5, .height = 4, .bits = 0, .compression = 5};
    for (const std::byte each : encodePng(inner)) maker.pixels.push_back(std::to_integer<int>(each));
    const auto read = decodeImage(maker.file(), "wrapped.bmp", {}, testing::withoutModule());
    ASSERT_TRUE(read);
    EXPECT_TRUE(read.diagnostics.empty());
    EXPECT_TRUE(compare(*read, inner).identical);
}

TEST(Bmp, AWrapperAroundSomethingElseIsRejected) {
    // Nested BMP files could continue without end.
    BmpMaker maker{.width = 1, .height = 1, .bits = 0, .compression = 5};
    for (const std::byte each : BmpMaker{.pixels = {1, 2, 3, 0}}.file())
        maker.pixels.push_back(std::to_integer<int>(each));
    EXPECT_EQ(testing::idsOf(decodeImage(maker.file(), "a.bmp").diagnostics), "file-E04");
    EXPECT_EQ(idFor(maker), "file-E04");
}

TEST(Bmp, AWrappedJpegIsRead) {
    GLIBRA_NEED_MODULE();
    const auto path =
        std::filesystem::temp_directory_path() / ("glibra-wrapped-" + std::to_string(::getpid()) + ".jpg");
    const Image inner = testing::smoothImage(32, 16);
    ASSERT_TRUE(writeImage(inner, path, {{}, testing::moduleFolders()}).empty());
    std::ifstream stream(path, std::ios::binary);
    const std::string jpeg((std::istreambuf_iterator<char>(stream)), {});
    std::filesystem::remove(path);
    BmpMaker maker{.width = 32, .height = 16, .bits = 0, .compression = 4};
    for (const char each : jpeg) maker.pixels.push_back(static_cast<unsigned char>(each));
    const auto read = decodeImage(maker.file(), "wrapped.bmp", {}, testing::withModule());
    ASSERT_TRUE(read) << read.diagnostics[0].text;
    EXPECT_LT(compare(*read, inner).largest, .04);
}

}  // namespace
}  // namespace glibra::image
