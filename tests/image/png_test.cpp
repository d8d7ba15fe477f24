// PNG files written here and read by two decoders, and files written by libspng and read here.

#include <gtest/gtest.h>
#include <libdeflate.h>
#include <spng.h>

#include <algorithm>
#include <memory>

#include "image/bytes.h"
#include "image/compare/compare.h"
#include "image/png/png_reader.h"
#include "image/png/png_writer.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::Rgba;

/// Builds any PNG file, including invalid ones.
class PngMaker {
  public:
    PngMaker() { file_ = testing::bytesOf({0x89, 'P', 'N', 'G', 13, 10, 26, 10}); }

    PngMaker& chunk(const std::string& type, const std::vector<std::byte>& content) {
        putBig32(file_, static_cast<std::uint32_t>(content.size()));
        const std::size_t begin = file_.size();
        for (const char each : type) file_.push_back(static_cast<std::byte>(each));
        file_.insert(file_.end(), content.begin(), content.end());
        putBig32(file_, libdeflate_crc32(0, file_.data() + begin, file_.size() - begin));
        return *this;
    }
    PngMaker& header(std::uint32_t width, std::uint32_t height, int depth, int colorType, int interlace = 0) {
        std::vector<std::byte> content;
        putBig32(content, width);
        putBig32(content, height);
        for (const int each : {depth, colorType, 0, 0, interlace})
            content.push_back(static_cast<std::byte>(each));
        return chunk("IHDR", content);
    }
    /// `rows` include the filter byte of each row.
    PngMaker& pixels(const std::vector<int>& rows) {
        const auto raw = testing::bytesOf(rows);
        const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
            libdeflate_alloc_compressor(6), libdeflate_free_compressor);
        std::vector<std::byte> packed(libdeflate_zlib_compress_bound(compressor.get(), raw.size()));
        packed.resize(
            libdeflate_zlib_compress(compressor.get(), raw.data(), raw.size(), packed.data(), packed.size()));
        return chunk("IDAT", packed);
    }
    std::vector<std::byte> end() { return chunk("IEND", {}).file_; }

  private:
    std::vector<std::byte> file_;
};

const FileLabel kPngLabel{"a.png", {"scene.glib", 7, 3}};

struct Shape {
    int width, height, components;
    Component type;
};

class PngRoundTrip : public ::testing::TestWithParam<Shape> {};

TEST_P(PngRoundTrip, KeepsEveryPixelForLibspng) {
    const auto [width, height, components, type] = GetParam();
    const Image image = testing::noisyImage(width, height, components, type);
    const auto read = decodePng(encodePng(image), kPngLabel);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->components, 4);
    EXPECT_EQ(read->type, type);
    EXPECT_TRUE(compare(image, *read).identical);
}

TEST_P(PngRoundTrip, KeepsEveryPixelForLibpng) {
    GLIBRA_NEED_MODULE();
    const auto [width, height, components, type] = GetParam();
    const Image image = testing::noisyImage(width, height, components, type, 99);
    const auto read = testing::decodeElsewhere(Format::png, encodePng(image));
    ASSERT_TRUE(read) << read.diagnostics[0].text;
    EXPECT_EQ(read->type, type);
    EXPECT_TRUE(compare(image, *read).identical);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PngRoundTrip,
                         ::testing::Values(Shape{1, 1, 4, Component::u8}, Shape{1, 1, 1, Component::u16},
                                           Shape{37, 23, 1, Component::u8}, Shape{37, 23, 2, Component::u8},
                                           Shape{37, 23, 3, Component::u8}, Shape{37, 23, 4, Component::u8},
                                           Shape{37, 23, 1, Component::u16}, Shape{37, 23, 2, Component::u16},
                                           Shape{37, 23, 3, Component::u16}, Shape{37, 23, 4, Component::u16},
                                           Shape{1, 300, 3, Component::u8}, Shape{300, 1, 3, Component::u8},
                                           Shape{513, 257, 4, Component::u8},
                                           Shape{1, 5000, 3, Component::u8},
                                           Shape{16384, 9, 4, Component::u16},
                                           Shape{9000, 40, 1, Component::u8}));

TEST(PngWriter, EveryLevelGivesTheSamePixels) {
    const Image image = testing::smoothImage(64, 48);
    for (const int level : {-3, 0, 1, 6, 12, 99}) {
        const auto read = decodePng(encodePng(image, {.level = level, .text = {}}), kPngLabel);
        ASSERT_TRUE(read) << level;
        EXPECT_TRUE(compare(image, *read).identical) << level;
    }
}

TEST(PngWriter, LargePicturesReachEveryReaderWhole) {
    for (const int components : {1, 3, 4})
        for (const Component type : {Component::u8, Component::u16})
            for (const int level : {0, 1, 4}) {
                // Several stripes; the last one is shorter.
                const Image image = components == 3 ? testing::smoothImage(1111, 977)
                                                    : testing::noisyImage(1111, 977, components, type);
                const auto png = encodePng(image, {.level = level, .text = {}});
                const auto read = decodePng(png, kPngLabel);
                ASSERT_TRUE(read) << components << ' ' << level;
                EXPECT_TRUE(compare(image, *read).identical) << components << ' ' << level;
                if (!testing::hasModule()) continue;
                const auto other = testing::decodeElsewhere(Format::png, png);
                ASSERT_TRUE(other) << other.diagnostics[0].text;
                EXPECT_TRUE(compare(image, *other).identical) << components << ' ' << level;
            }
}

TEST(PngWriter, WritesTheSameBytesByAnyNumberOfThreads) {
    const Image image = testing::smoothImage(1500, 1000);
    const auto alone = encodePng(image, {.text = {}, .threads = 1});
    for (const unsigned threads : {0U, 2U, 3U, 64U})
        EXPECT_EQ(encodePng(image, {.text = {}, .threads = threads}), alone) << threads;
}

TEST(PngWriter, TextReachesAnotherReader) {
    const auto png = encodePng(testing::smoothImage(4, 4), {.text = {{"Scene", "ripples.glib"},
                                                                     {"Autor", "J\xc3\xb6rg"},
                                                                     {"", "none"},
                                                                     {std::string(80, 'k'), "long"}}});
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), spng_ctx_free);
    spng_set_png_buffer(context.get(), png.data(), png.size());
    std::uint32_t count = 0;
    ASSERT_EQ(spng_get_text(context.get(), nullptr, &count), 0);
    ASSERT_EQ(count, 2U);
    std::vector<spng_text> texts(count);
    ASSERT_EQ(spng_get_text(context.get(), texts.data(), &count), 0);
    EXPECT_STREQ(texts[0].keyword, "Scene");
    EXPECT_STREQ(texts[0].text, "ripples.glib");
    EXPECT_EQ(texts[0].type, SPNG_TEXT);
    EXPECT_STREQ(texts[1].keyword, "Autor");
    EXPECT_STREQ(texts[1].text, "J\xc3\xb6rg");
    EXPECT_EQ(texts[1].type, SPNG_ITXT);
}

TEST(PngWriter, RejectsImagesThatPngCannotHold) {
    EXPECT_TRUE(encodePng(testing::noisyImage(3, 3, 4, Component::f32)).empty());
    EXPECT_TRUE(encodePng({}).empty());
    EXPECT_TRUE(encodePng({4, 4, 5, Component::u8, std::vector<std::byte>(80)}).empty());
    EXPECT_TRUE(encodePng({4, 4, 4, Component::u8, std::vector<std::byte>(63)}).empty());
}

TEST(PngReader, ReadsGreyOfEveryDepth) {
    const auto one =
        decodePng(PngMaker().header(5, 2, 1, 0).pixels({0, 0b10110000, 0, 0b01001000}).end(), kPngLabel);
    ASSERT_TRUE(one);
    EXPECT_EQ(testing::pixelAt(*one, 0, 0), (Rgba{255, 255, 255, 255}));
    EXPECT_EQ(testing::pixelAt(*one, 1, 0), (Rgba{0, 0, 0, 255}));
    EXPECT_EQ(testing::pixelAt(*one, 4, 1), (Rgba{255, 255, 255, 255}));
    const auto two = decodePng(PngMaker().header(4, 1, 2, 0).pixels({0, 0b00011011}).end(), kPngLabel);
    ASSERT_TRUE(two);
    EXPECT_EQ(testing::pixelAt(*two, 1, 0)[0], 85);
    EXPECT_EQ(testing::pixelAt(*two, 2, 0)[2], 170);
    const auto four = decodePng(PngMaker().header(2, 1, 4, 0).pixels({0, 0x3f}).end(), kPngLabel);
    ASSERT_TRUE(four);
    EXPECT_EQ(testing::pixelAt(*four, 0, 0)[1], 51);
    const auto sixteen = decodePng(PngMaker().header(1, 1, 16, 0).pixels({0, 0x12, 0x34}).end(), kPngLabel);
    ASSERT_TRUE(sixteen);
    EXPECT_EQ(testing::pixelAt(*sixteen, 0, 0), (Rgba{0x1234, 0x1234, 0x1234, 65535}));
}

TEST(PngReader, ReadsPalettesWithTransparency) {
    const auto read = decodePng(PngMaker()
                                    .header(3, 1, 8, 3)
                                    .chunk("PLTE", testing::bytesOf({10, 20, 30, 40, 50, 60, 70, 80, 90}))
                                    .chunk("tRNS", testing::bytesOf({128, 0}))
                                    .pixels({0, 0, 1, 2})
                                    .end(),
                                kPngLabel);
    ASSERT_TRUE(read);
    EXPECT_EQ(testing::pixelAt(*read, 0, 0), (Rgba{10, 20, 30, 128}));
    EXPECT_EQ(testing::pixelAt(*read, 1, 0), (Rgba{40, 50, 60, 0}));
    EXPECT_EQ(testing::pixelAt(*read, 2, 0), (Rgba{70, 80, 90, 255}));
}

TEST(PngReader, ReadsATransparentColor) {
    const auto read = decodePng(PngMaker()
                                    .header(2, 1, 8, 2)
                                    .chunk("tRNS", testing::bytesOf({0, 1, 0, 2, 0, 3}))
                                    .pixels({0, 1, 2, 3, 1, 2, 4})
                                    .end(),
                                kPngLabel);
    ASSERT_TRUE(read);
    EXPECT_EQ(testing::pixelAt(*read, 0, 0), (Rgba{1, 2, 3, 0}));
    EXPECT_EQ(testing::pixelAt(*read, 1, 0), (Rgba{1, 2, 4, 255}));
}

TEST(PngReader, IgnoresGammaAndSignificantBits) {
    const auto read = decodePng(PngMaker()
                                    .header(1, 1, 8, 2)
                                    .chunk("gAMA", testing::bytesOf({0, 1, 0x86, 0xa0}))
                                    .chunk("sBIT", testing::bytesOf({3, 3, 3}))
                                    .pixels({0, 77, 88, 99})
                                    .end(),
                                kPngLabel);
    ASSERT_TRUE(read);
    EXPECT_EQ(testing::pixelAt(*read, 0, 0), (Rgba{77, 88, 99, 255}));
}

TEST(PngReader, ReadsInterlacedPictures) {
    // Adam7 of a 3 x 2 picture: pass 1 holds pixel (0, 0), pass 6 (1, 0), pass 5 (2, 0) among others, and
    // pass 7 row 1.
    const auto read = decodePng(
        PngMaker().header(3, 2, 8, 0, 1).pixels({0, 11, 0, 13, 0, 12, 0, 21, 22, 23}).end(), kPngLabel);
    ASSERT_TRUE(read);
    const int expected[2][3] = {{11, 12, 13}, {21, 22, 23}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            EXPECT_EQ(testing::pixelAt(*read, x, y)[0], expected[y][x]) << x << " " << y;
}

TEST(PngReader, EveryCutGivesOneMessage) {
    const auto png = encodePng(testing::noisyImage(20, 20, 4, Component::u8));
    const std::size_t pixelsEnd = png.size() - 12 - 4;  // IEND and the checksum of the pixels
    for (std::size_t length = 0; length < pixelsEnd; length += 7) {
        const auto read = decodePng(std::span(png).first(length), kPngLabel);
        EXPECT_FALSE(read) << length;
        ASSERT_EQ(testing::idsOf(read.diagnostics), "file-E04") << length;
        EXPECT_EQ(read.diagnostics[0].place, kPngLabel.place);
    }
}

TEST(PngReader, AChangedByteInThePixelsIsDetected) {
    auto png = encodePng(testing::noisyImage(20, 20, 4, Component::u8));
    png[png.size() / 2] ^= std::byte{0x10};
    EXPECT_EQ(testing::idsOf(decodePng(png, kPngLabel).diagnostics), "file-E04");
}

TEST(PngReader, AHeaderWithAWrongSizeIsDetected) {
    EXPECT_EQ(testing::idsOf(
                  decodePng(PngMaker().header(16384, 16385, 8, 0).pixels({0}).end(), kPngLabel).diagnostics),
              "file-E09");
    EXPECT_EQ(testing::idsOf(
                  decodePng(PngMaker().header(16384, 16384, 16, 6).pixels({0}).end(), kPngLabel).diagnostics),
              "file-E09");
    // Within the limits, but far more than these few bytes can hold.
    EXPECT_EQ(testing::idsOf(
                  decodePng(PngMaker().header(16000, 16000, 8, 6).pixels({0}).end(), kPngLabel).diagnostics),
              "file-E04");
    EXPECT_EQ(
        testing::idsOf(
            decodePng(PngMaker().header(4, 4, 8, 0).pixels({0, 1, 2, 3, 4, 0}).end(), kPngLabel).diagnostics),
        "file-E04");
    EXPECT_EQ(
        testing::idsOf(decodePng(PngMaker().header(0, 4, 8, 0).pixels({0}).end(), kPngLabel).diagnostics),
        "file-E04");
    EXPECT_EQ(
        testing::idsOf(decodePng(PngMaker().header(4, 4, 3, 0).pixels({0}).end(), kPngLabel).diagnostics),
        "file-E04");
    EXPECT_EQ(
        testing::idsOf(decodePng(PngMaker().header(4, 4, 8, 1).pixels({0}).end(), kPngLabel).diagnostics),
        "file-E04");
}

TEST(PngReader, APaletteIndexWithoutAnEntryIsDetected) {
    const auto read = decodePng(
        PngMaker().header(1, 1, 8, 3).chunk("PLTE", testing::bytesOf({1, 2, 3})).pixels({0, 200}).end(),
        kPngLabel);
    if (read) {
        EXPECT_EQ(testing::pixelAt(*read, 0, 0), (Rgba{0, 0, 0, 255}));
    } else {
        EXPECT_EQ(testing::idsOf(read.diagnostics), "file-E04");
    }
}

}  // namespace
}  // namespace glibra::image
