// Pictures that are made to take all time or all memory.

#include <gtest/gtest.h>

#include "bmp_maker.h"
#include "image/foreign_headers.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "image/texture_file.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::idsOf;

struct Hostile : testing::InFolder {
    /// A TIFF picture of one pixel with so many numbers that say what its sample means: 0 is white.
    [[nodiscard]] static std::vector<std::byte> tiffOfMeanings(std::uint32_t count) {
        constexpr std::uint32_t kShort = 3, kLong = 4, kEntries = 9, kData = 8 + 2 + 12 * kEntries + 4;
        std::vector<std::byte> file = testing::bytesOf({'I', 'I', 42, 0, 8, 0, 0, 0});
        testing::putLittle(file, kEntries, 2);
        const auto put = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t number,
                             std::uint32_t value) {
            testing::putLittle(file, tag, 2);
            testing::putLittle(file, type, 2);
            testing::putLittle(file, number, 4);
            testing::putLittle(file, value, 4);
        };
        put(256, kShort, 1, 1);
        put(257, kShort, 1, 1);
        put(258, kShort, 1, 8);
        put(259, kShort, 1, 1);
        put(262, kShort, count, count > 2 ? kData : 0);
        put(273, kLong, 1, kData);
        put(277, kShort, 1, 1);
        put(278, kShort, 1, 1);
        put(279, kLong, 1, 1);
        file.resize(kData + 16);
        return file;
    }
    /// The header of a Photoshop file and nothing else.
    [[nodiscard]] static std::vector<std::byte> photoshop(std::uint32_t side, std::uint32_t channels) {
        std::vector<std::byte> file = testing::bytesOf({'8', 'B', 'P', 'S', 0, 1, 0, 0, 0, 0, 0, 0});
        testing::putBig(file, channels, 2);
        testing::putBig(file, side, 4);
        testing::putBig(file, side, 4);
        testing::putBig(file, 32, 2);
        testing::putBig(file, 3, 2);
        file.resize(70);
        return file;
    }
};

TEST_F(Hostile, ATiffPictureWithSeveralMeaningsIsRefused) {
    const FileLabel label{"a.tif", {}};
    EXPECT_TRUE(readTiffHeader(tiffOfMeanings(1), label));
    for (const std::uint32_t count : {2U, 3U}) {
        const auto header = readTiffHeader(tiffOfMeanings(count), label);
        ASSERT_FALSE(header) << count;
        EXPECT_NE(header.message().find("of an unknown kind"), std::string::npos) << header.message();
    }
}

TEST_F(Hostile, AJpegPictureWithoutAHeaderSaysSo) {
    const std::pair<std::vector<int>, const char*> files[] = {
        {{0xff, 0xd8, 0xff, 0xe0, 0, 4, 0, 0}, "the file ends before its pixels do"},
        {{0xff, 0xd8, 0xff, 0xe0, 0, 4, 0, 0, 0xff, 0xd9}, "its JPEG header is missing or damaged"},
    };
    for (const auto& [bytes, message] : files) {
        const auto read = decodeImage(testing::bytesOf(bytes), "a.jpg");
        ASSERT_FALSE(read);
        EXPECT_NE(read.message().find(message), std::string::npos) << read.message();
    }
}

/// OpenImageIO divides by what the header says, and libpng writes to standard error.
TEST_F(Hostile, APngPictureInAnIconIsReadAsOneInAFile) {
    const Image picture = testing::noisyImage(16, 16, 4, Component::u8);
    const std::vector<std::byte> png = encodePng(picture);
    std::vector<std::byte> icon = testing::bytesOf({0, 0, 1, 0, 1, 0, 16, 16, 0, 0, 1, 0, 32, 0});
    testing::putLittle(icon, static_cast<std::uint32_t>(png.size()), 4);
    testing::putLittle(icon, 22, 4);
    icon.insert(icon.end(), png.begin(), png.end());
    const Result<Image> read = decodeImage(icon, "a.ico");
    ASSERT_TRUE(read) << read.message();
    EXPECT_EQ(read->data, picture.data);
    ::testing::internal::CaptureStderr();
    for (std::size_t at = 30; at < 55; ++at) {  // the length, the name, the content and the checksum of IHDR
        std::vector<std::byte> damagedIcon = icon;
        damagedIcon[at] ^= std::byte{0x85};
        const std::string ids = idsOf(decodeImage(damagedIcon, "a.ico").diagnostics);
        EXPECT_TRUE(ids == "file-E04" || ids == "file-E09") << at << " " << ids;
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(Hostile, ADecoderThatTakesTooLongIsEnded) {
    GLIBRA_NEED_MODULE();
    const Image large = testing::smoothImage(6000, 4000);
    ASSERT_TRUE(writeImage(large, folder / "a.webp", {{}, testing::moduleFolders()}).empty());
    ReadOptions options = testing::withModule();
    EXPECT_EQ(options.decoder.seconds, 20);
    options.decoder.seconds = .005;
    const auto read = readImage(folder / "a.webp", {}, options);
    EXPECT_FALSE(read);
    EXPECT_EQ(idsOf(read.diagnostics), "file-E11");
    EXPECT_EQ(read.diagnostics.front().text, "'a.webp': not decoded within 0.005 seconds");
}

TEST_F(Hostile, ADecoderHasALimitOfMemory) {
    GLIBRA_NEED_MODULE();
    const Image large = testing::smoothImage(6000, 4000);
    ASSERT_TRUE(writeImage(large, folder / "a.webp", {{}, testing::moduleFolders()}).empty());
    ReadOptions options = testing::withModule();
    ASSERT_TRUE(readImage(folder / "a.webp", {}, options));
    options.decoder.memory = std::uint64_t{16} << 20;
    const auto read = readImage(folder / "a.webp", {}, options);
    EXPECT_FALSE(read) << "16 MiB do not hold 24 million pixels";
    EXPECT_EQ(read.diagnostics.size(), 1U);
}

TEST_F(Hostile, ALargePhotoshopHeaderIsRefusedBeforeMemoryIsReserved) {
    GLIBRA_NEED_MODULE();
    const ReadOptions options = testing::withModule();
    for (const auto& [side, channels, ids] :
         {std::tuple{16384U, 56U, "file-E09"}, {30000U, 4U, "file-E09"}, {16384U, 1U, "file-E04"}}) {
        const auto read = readImage(put("a.psd", photoshop(side, channels)), {}, options);
        EXPECT_EQ(idsOf(read.diagnostics), ids) << side << " " << channels;
    }
}

TEST_F(Hostile, RunLengthsThatSkipAllPixelsMakeNoLargePicture) {
    const testing::BmpMaker bmp{.width = 16384,
                                .height = 16384,
                                .bits = 8,
                                .compression = 1,
                                .palette = {{1, 2, 3}},
                                .pixels = {0, 1}};
    const auto read = readImage(put("a.bmp", bmp.file()));
    EXPECT_EQ(idsOf(read.diagnostics), "file-E04");
    EXPECT_NE(read.diagnostics.front().text.find("cannot hold 16384 x 16384 pixels"), std::string::npos);
    const testing::BmpMaker small{
        .width = 64, .height = 64, .bits = 8, .compression = 1, .palette = {{1, 2, 3}}, .pixels = {0, 1}};
    EXPECT_TRUE(readImage(put("b.bmp", small.file())));
}

TEST_F(Hostile, TexturesBeyondWhatTheSceneMayHaveAreRefusedBeforeDecoding) {
    const auto png = encodePng(testing::smoothImage(32, 32));
    const auto path = put("a.png", png);
    ReadOptions options;
    options.limits.sceneBytesLeft = 32 * 32 * 4;
    EXPECT_TRUE(readTexture(path, 2, {}, options));
    const std::vector<base::FileSource> six(6, path);
    EXPECT_EQ(idsOf(readCubeMap(six, {}, options).diagnostics),
              "draw-E08 draw-E08 draw-E08 draw-E08 draw-E08");
    options.limits.sceneBytesLeft *= 6;
    EXPECT_TRUE(readCubeMap(six, {}, options));
    options.limits.sceneBytesLeft = 32 * 32 * 4 - 1;
    const auto read = readTexture(path, 2, {"scene.glib", 7, 1}, options);
    ASSERT_EQ(idsOf(read.diagnostics), "draw-E08");
    EXPECT_EQ(read.diagnostics.front().place.line, 7);
    EXPECT_EQ(read.diagnostics.front().text,
              "'a.png' needs 4096 bytes, but the textures of a scene may have 2 GiB together, and 4095 bytes "
              "are left");
}

}  // namespace
}  // namespace glibra::image
