// Pictures that are made to take all time or all memory.

#include <gtest/gtest.h>

#include "bmp_maker.h"
#include "image/png/png_writer.h"
#include "image/texture_file.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::idsOf;

struct Hostile : testing::InFolder {
    static void putBig(std::vector<std::byte>& to, std::uint32_t value, int bytes) {
        for (int i = bytes - 1; i >= 0; --i) to.push_back(static_cast<std::byte>(value >> (8 * i)));
    }
    /// The header of a Photoshop file and nothing else.
    [[nodiscard]] static std::vector<std::byte> photoshop(std::uint32_t side, std::uint32_t channels) {
        std::vector<std::byte> file = testing::bytesOf({'8', 'B', 'P', 'S', 0, 1, 0, 0, 0, 0, 0, 0});
        putBig(file, channels, 2);
        putBig(file, side, 4);
        putBig(file, side, 4);
        putBig(file, 32, 2);
        putBig(file, 3, 2);
        file.resize(70);
        return file;
    }
};

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
