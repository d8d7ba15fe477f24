// Files as texels: raw textures, pictures as textures, cube maps (language, 3.4 and 8.3).

#include "image/texture_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;
using testing::idsOf;

const Place kTexturePlace{"scene.glib", 9, 2};

std::vector<std::byte> rawFile(const std::vector<std::uint32_t>& sizes, std::size_t length) {
    std::vector<std::byte> file;
    for (const std::uint32_t size : sizes) testing::putLittle(file, size, 4);
    while (file.size() < length)
        file.push_back(static_cast<std::byte>(testing::hash(static_cast<std::uint32_t>(file.size())) >> 24));
    return file;
}

const FileLabel kRawLabel{"a.tex", kTexturePlace};

TEST(RawTexture, ReadsBytesOfEveryDimension) {
    const struct {
        std::vector<std::uint32_t> sizes;
        int width, height, depth;
    } cases[] = {{{7}, 7, 1, 1}, {{3, 5}, 3, 5, 1}, {{4, 3, 2}, 4, 3, 2}};
    for (const auto& each : cases) {
        const std::size_t header = 4 * each.sizes.size();
        const auto file =
            rawFile(each.sizes, header + static_cast<std::size_t>(4 * each.width * each.height * each.depth));
        for (const int asked : {0, static_cast<int>(each.sizes.size())}) {
            const auto read = decodeRawTexture(file, asked, kRawLabel);
            ASSERT_TRUE(read);
            EXPECT_EQ(read->dimensions, static_cast<int>(each.sizes.size()));
            EXPECT_EQ(read->width, each.width);
            EXPECT_EQ(read->height, each.height);
            EXPECT_EQ(read->depth, each.depth);
            EXPECT_EQ(read->type, Component::u8);
            EXPECT_EQ(read->data,
                      std::vector<std::byte>(file.begin() + static_cast<std::ptrdiff_t>(header), file.end()));
        }
    }
}

TEST(RawTexture, KeepsFloatsBitForBitIncludingNan) {
    std::vector<std::byte> file;
    for (const std::uint32_t word :
         {2U, 1U, 0x3f800000U, 0x7fc01234U, 0xff800000U, 0x80000000U, 0x42f6e979U, 1U, 0U, 0xc0490fdbU})
        testing::putLittle(file, word, 4);
    const auto read = decodeRawTexture(file, 2, kRawLabel);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->type, Component::f32);
    std::array<std::uint32_t, 8> words{};
    ASSERT_EQ(read->data.size(), sizeof words);
    std::memcpy(words.data(), read->data.data(), sizeof words);
    EXPECT_EQ(words[0], 0x3f800000U);
    EXPECT_EQ(words[1], 0x7fc01234U);
    EXPECT_EQ(words[7], 0xc0490fdbU);
}

TEST(RawTexture, SeveralReadingsAreReportedAndTheFirstTaken) {
    // 36 bytes: 1D with 2 float texels, and 3D with 2 x 1 x 3 byte texels.
    const auto read = decodeRawTexture(rawFile({2, 1, 3}, 36), 0, kRawLabel);
    ASSERT_TRUE(read);
    ASSERT_EQ(idsOf(read.diagnostics), "file-W07");
    EXPECT_EQ(read.diagnostics[0].text,
              "36 bytes match 2 float texels (1D) and 2 x 1 x 3 byte texels (3D); read as 1D");
    EXPECT_EQ(read->dimensions, 1);
    EXPECT_EQ(read->type, Component::f32);
    const auto asked = decodeRawTexture(rawFile({2, 1, 3}, 36), 3, kRawLabel);
    ASSERT_TRUE(asked);
    EXPECT_TRUE(asked.diagnostics.empty());
    EXPECT_EQ(asked->depth, 3);
}

TEST(RawTexture, OnlyTheLengthsOfTheReferenceAreAmbiguous) {
    for (std::uint32_t s = 1; s <= 12; ++s)
        for (std::uint32_t t = 1; t <= 12; ++t)
            for (std::uint32_t p = 1; p <= 12; ++p)
                for (std::size_t length = 8; length <= 80; length += 4)
                    if (rawShapes(rawFile({s, t, p}, length), 0).size() > 1) {
                        EXPECT_TRUE(length == 20 || length == 24 || length == 36) << length;
                    }
}

TEST(RawTexture, AWrongLengthNamesTheRightOnes) {
    const auto two = decodeRawTexture(rawFile({4, 4}, 17), 2, kRawLabel);
    ASSERT_EQ(idsOf(two.diagnostics), "file-E05");
    EXPECT_EQ(two.diagnostics[0].text,
              "'a.tex': 17 bytes match no raw 2D texture; 4 x 4 would need 72 or 264");
    EXPECT_EQ(two.diagnostics[0].place, kTexturePlace);
    const auto any = decodeRawTexture(rawFile({4, 4}, 17), 0, kRawLabel);
    ASSERT_EQ(idsOf(any.diagnostics), "file-E05");
    EXPECT_NE(any.diagnostics[0].text.find("4 (1D) would need 20 or 68, 4 x 4 would need 72 or 264"),
              std::string::npos);
    EXPECT_EQ(idsOf(decodeRawTexture(rawFile({}, 3), 0, kRawLabel).diagnostics), "file-E05");
}

TEST(RawTexture, EveryCutGivesOneMessage) {
    const auto file = rawFile({3, 5, 2}, 12 + 4 * 30);
    for (std::size_t length = 0; length < file.size(); ++length)
        EXPECT_EQ(idsOf(decodeRawTexture(std::span(file).first(length), 3, kRawLabel).diagnostics),
                  "file-E05")
            << length;
}

TEST(RawTexture, WrongSizesAreRejected) {
    EXPECT_EQ(idsOf(decodeRawTexture(rawFile({0, 4}, 8), 2, kRawLabel).diagnostics), "file-E05");
    EXPECT_EQ(idsOf(decodeRawTexture(rawFile({0x80000000U, 0x80000000U, 4}, 12), 3, kRawLabel).diagnostics),
              "file-E05");  // product 2^64
    EXPECT_EQ(
        idsOf(
            decodeRawTexture(rawFile({0xffffffffU, 0xffffffffU, 0xffffffffU}, 40), 0, kRawLabel).diagnostics),
        "file-E05");
    EXPECT_EQ(idsOf(decodeRawTexture(rawFile({20000, 1}, 8 + 80000), 2, kRawLabel).diagnostics), "file-E09");
    EXPECT_EQ(idsOf(decodeRawTexture(rawFile({3000, 1, 1}, 12 + 12000), 3, kRawLabel).diagnostics),
              "file-E09");
}

class TextureFile : public testing::InFolder {
  protected:
    /// A 2 x 3 picture; red is 10 * row (from the top) + column.
    fs::path picture(const std::string& name) {
        Image image{2, 3, 4, Component::u8, {}};
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 2; ++x)
                for (const int c : {10 * y + x, 0, 0, 255}) image.data.push_back(static_cast<std::byte>(c));
        return put(name, encodePng(image));
    }
    static std::vector<int> reds(const TexelBlock& block) {
        std::vector<int> values;
        for (std::size_t at = 0; at < block.data.size(); at += 4)
            values.push_back(std::to_integer<int>(block.data[at]));
        return values;
    }
};

TEST_F(TextureFile, APictureHasItsBottomRowFirst) {
    for (const int dimensions : {0, 2}) {
        const auto read = readTexture(picture("a.png"), dimensions, kTexturePlace);
        ASSERT_TRUE(read);
        EXPECT_TRUE(read.diagnostics.empty());
        EXPECT_EQ(read->dimensions, 2);
        EXPECT_EQ(read->width, 2);
        EXPECT_EQ(read->height, 3);
        EXPECT_EQ(reds(*read), (std::vector<int>{20, 21, 10, 11, 0, 1}));
    }
}

TEST_F(TextureFile, A1DTextureIsThePicturesBottomRow) {
    const auto read = readTexture(picture("a.png"), 1, kTexturePlace);
    ASSERT_TRUE(read);
    ASSERT_EQ(idsOf(read.diagnostics), "file-W08");
    EXPECT_EQ(read.diagnostics[0].text, "'a.png' is 2 x 3; 1D textures use the bottom row of a picture");
    EXPECT_EQ(read->dimensions, 1);
    EXPECT_EQ(read->height, 1);
    EXPECT_EQ(reds(*read), (std::vector<int>{20, 21}));
    const auto flat =
        readTexture(put("b.png", encodePng(testing::noisyImage(5, 1, 3, Component::u8))), 1, kTexturePlace);
    ASSERT_TRUE(flat);
    EXPECT_TRUE(flat.diagnostics.empty());
}

TEST_F(TextureFile, A3DTextureIsNeverAPicture) {
    EXPECT_EQ(idsOf(readTexture(picture("a.png"), 3, kTexturePlace).diagnostics), "file-E03");
}

TEST_F(TextureFile, ARawFileKeepsItsOrder) {
    const auto file = rawFile({3, 5}, 8 + 60);
    const auto read = readTexture(put("a.tex", file), 0, kTexturePlace);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read.diagnostics.empty());
    EXPECT_EQ(read->data, std::vector<std::byte>(file.begin() + 8, file.end()));
}

TEST_F(TextureFile, TheContentDecidesNotTheSuffix) {
    const auto picturePath = picture("a.tex");
    const auto read = readTexture(picturePath, 2, kTexturePlace);
    ASSERT_TRUE(read);
    ASSERT_EQ(idsOf(read.diagnostics), "file-W03");
    EXPECT_EQ(read.diagnostics[0].text, "'a.tex' is a PNG picture");
    const auto raw = readTexture(put("b.bmp", rawFile({3, 5}, 68)), 2, kTexturePlace);
    ASSERT_TRUE(raw);
    ASSERT_EQ(idsOf(raw.diagnostics), "file-W03");
    EXPECT_EQ(raw.diagnostics[0].text, "'b.bmp' is a raw texture");
}

TEST_F(TextureFile, AFileOfAnotherKindIsNotATexture) {
    const std::string text = "Sphere 1 20 20\nTeapot\n";
    const auto bytes = std::as_bytes(std::span(text));
    EXPECT_EQ(idsOf(readTexture(put("a.glib", bytes), 2, kTexturePlace).diagnostics), "file-E03");
    EXPECT_EQ(idsOf(readTexture(put("report.tex", bytes), 2, kTexturePlace).diagnostics),
              "file-E05");  // LaTeX
    EXPECT_EQ(idsOf(readTexture(folder / "none.png", 2, kTexturePlace).diagnostics), "file-E01");
    EXPECT_EQ(idsOf(readTexture(folder, 2, kTexturePlace).diagnostics), "file-E14");
}

TEST_F(TextureFile, SixteenBitsStaySixteen) {
    const Image image = testing::noisyImage(4, 4, 4, Component::u16);
    const auto read = readTexture(put("a.png", encodePng(image)), 2, kTexturePlace);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->type, Component::u16);
    EXPECT_TRUE(std::equal(read->data.begin(), read->data.begin() + 32, image.row(3).begin()));
}

class CubeMapFiles : public testing::InFolder {
  protected:
    std::vector<base::FileSource> faces(int width = 4, int height = 4) {
        std::vector<base::FileSource> paths;
        for (std::uint32_t i = 0; i < 6; ++i) {
            images.push_back(testing::noisyImage(width, height, 4, Component::u8, 1000 * i));
            paths.push_back(put("face" + std::to_string(i) + ".png", encodePng(images.back())));
        }
        return paths;
    }
    std::vector<Image> images;
};

TEST_F(CubeMapFiles, HoldSixFacesTopRowFirst) {
    const auto cube = readCubeMap(faces(), kTexturePlace);
    ASSERT_TRUE(cube);
    EXPECT_TRUE(cube.diagnostics.empty());
    EXPECT_EQ(cube->faces, 6);
    EXPECT_EQ(cube->width, 4);
    EXPECT_EQ(cube->height, 4);
    std::vector<std::byte> expected;
    for (const Image& each : images) expected.insert(expected.end(), each.data.begin(), each.data.end());
    EXPECT_EQ(cube->data, expected);
}

TEST_F(CubeMapFiles, UseTheLastRowOfARawFileAsTheTopRow) {
    auto paths = faces(2, 2);
    const auto raw = rawFile({2, 2}, 8 + 16);
    paths[2] = put("raw.tex", raw);
    const auto cube = readCubeMap(paths, kTexturePlace);
    ASSERT_TRUE(cube);
    EXPECT_TRUE(std::equal(raw.begin() + 16, raw.end(), cube->data.begin() + 32));
    EXPECT_TRUE(std::equal(raw.begin() + 8, raw.begin() + 16, cube->data.begin() + 40));
}

TEST_F(CubeMapFiles, HaveTheWidestTypeOfTheirFaces) {
    auto paths = faces();
    paths[5] = put("wide.png", encodePng(testing::noisyImage(4, 4, 4, Component::u16)));
    const auto cube = readCubeMap(paths, kTexturePlace);
    ASSERT_TRUE(cube);
    EXPECT_EQ(cube->type, Component::u16);
    ASSERT_EQ(cube->data.size(), 6U * 16 * 8);
    for (std::size_t i = 0; i < 64; ++i) {  // byte b becomes 257 b: both halves are b
        EXPECT_EQ(cube->data[2 * i], images[0].data[i]);
        EXPECT_EQ(cube->data[2 * i + 1], images[0].data[i]);
    }
}

TEST_F(CubeMapFiles, MustBeSquareAndEqual) {
    auto paths = faces();
    paths[3] = put("negy.png", encodePng(testing::noisyImage(5, 4, 4, Component::u8)));
    const auto oblong = readCubeMap(paths, kTexturePlace);
    ASSERT_EQ(idsOf(oblong.diagnostics), "file-E06");
    EXPECT_EQ(oblong.diagnostics[0].text,
              "CubeMap: 'negy.png' is 5 x 4, all faces must be squares of equal size");
    paths[3] = put("negy.png", encodePng(testing::noisyImage(5, 5, 4, Component::u8)));
    EXPECT_EQ(idsOf(readCubeMap(paths, kTexturePlace).diagnostics), "file-E06");
    paths.pop_back();
    EXPECT_EQ(idsOf(readCubeMap(paths, kTexturePlace).diagnostics), "file-E06");
}

TEST_F(CubeMapFiles, ReportAllMissingFacesAtOnce) {
    auto paths = faces();
    paths[1] = folder / "none.png";
    paths[4] = folder / "neither.png";
    EXPECT_EQ(idsOf(readCubeMap(paths, kTexturePlace).diagnostics), "file-E01 file-E01");
}

}  // namespace
}  // namespace glibra::image
