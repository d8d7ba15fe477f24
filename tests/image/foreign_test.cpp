// What the image module is trusted with: every variant of the formats that libraries decode gives the pixels
// that it holds, or a message.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>

#include "image/file.h"
#include "image/read.h"
#include "image/write.h"
#include "support.h"
#include "variant_maker.h"

namespace glibra::image {
namespace {

using testing::componentAt;
using testing::Variant;

/// Half a step of the type, and a little for conversions that cut.
double toleranceOf(const Image& image, double value) {
    return image.type == Component::u8    ? 1.01 / 255
           : image.type == Component::u16 ? 1.01 / 65535
                                          : 1e-6 * std::abs(value) + 1e-7;
}

/// Empty, or the first pixel that is not what the file holds.
std::string wrongPixel(const Image& image, const Variant& variant) {
    if (image.width != variant.width || image.height != variant.height || image.components != 4)
        return "size";
    for (std::size_t i = 0; i < variant.pixels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const double expected = variant.pixels[i].at(c), found = componentAt(image, 4 * i + c);
            if (std::abs(found - expected) > toleranceOf(image, expected))
                return "pixel " + std::to_string(i) + ", component " + std::to_string(c) + ": " +
                       std::to_string(found) + " for " + std::to_string(expected);
        }
    return {};
}

using Maker = std::vector<Variant> (*)();

class Foreign : public testing::InFolder {};

TEST_F(Foreign, VariantsGiveTheirPixelsOrAMessage) {
    GLIBRA_NEED_MODULE();
    std::map<std::string, int> right;  // by the kind before the first number
    for (const Maker make :
         {testing::tiffVariants, testing::photoshopVariants, testing::iconVariants, testing::gifVariants})
        for (const Variant& each : make()) {
            const auto read = readImage(put(each.name, each.file), {}, testing::withModule());
            if (!read) {
                EXPECT_EQ(testing::idsOf(read.diagnostics), "file-E04") << each.name;
                EXPECT_EQ(read.diagnostics[0].text.find("Read error"), std::string::npos) << each.name;
                continue;
            }
            EXPECT_EQ(wrongPixel(*read, each), "") << each.name;
            ++right[each.name.substr(0, each.name.find_first_of("0123456789"))];
        }
    for (const char* kind : {"tiff-white-u", "tiff-black-u", "tiff-black-i", "tiff-black-f", "tiff-rgb-u",
                             "tiff-rgb-i", "tiff-rgb-f", "tiff-inks-u", "tiff-palette-u", "psd-", "ico-"})
        EXPECT_GE(right[kind], 6) << kind;
    EXPECT_EQ(right["gif-"], static_cast<int>(testing::gifVariants().size())) << "none is refused";
}

TEST_F(Foreign, CutGifFilesAreErrors) {
    GLIBRA_NEED_MODULE();
    int number = 0;
    for (const Variant& each : testing::gifVariants()) {
        if (number++ % 7 != 0) continue;
        for (std::size_t length = 6; length + 20 < each.file.size(); length += 1 + length / 4) {
            const auto read =
                decodeImage(std::span(each.file).first(length), each.name, {}, testing::withModule());
            ASSERT_EQ(testing::idsOf(read.diagnostics), "file-E04") << each.name << " " << length;
            EXPECT_EQ(read.message().find("picture."), std::string::npos) << read.message();
        }
    }
}

/// Some formats are read by OpenImageIO from files only, and this one has no name on the disk.
TEST_F(Foreign, PicturesWithoutAFileAreReadFromMemory) {
    GLIBRA_NEED_MODULE();
    const Image image = testing::noisyImage(19, 11, 3, Component::u8);
    for (const char* suffix : {".tif", ".sgi", ".gif", ".ico"}) {
        const std::filesystem::path path = folder / (std::string("a") + suffix);
        const bool isIcon = std::string_view(suffix) == ".ico";
        const Image written = isIcon ? testing::noisyImage(16, 16, 4, Component::u8) : image;
        ASSERT_TRUE(writeImage(written, path, {{}, testing::moduleFolders()}).empty()) << suffix;
        const auto onDisk = readImage(path, {}, testing::withModule());
        const auto bytes = readFile(path, {"a", {}});
        ASSERT_TRUE(onDisk && bytes) << suffix;
        std::filesystem::remove(path);
        const auto content =
            std::make_shared<const std::string>(reinterpret_cast<const char*>(bytes->data()), bytes->size());
        const auto inMemory = readImage({path, content}, {}, testing::withModule());
        ASSERT_TRUE(inMemory) << suffix << ": " << inMemory.diagnostics[0].text;
        EXPECT_EQ(inMemory->data, onDisk->data) << suffix;
    }
}

/// A DDS file with one block of BC4S or BC4U.
std::vector<std::byte> oneBlock(bool isSigned, const std::array<int, 8>& block) {
    for (auto [name, file] : testing::blockFiles()) {
        if (name != (isSigned ? "blocks-81.dds" : "blocks-79.dds")) continue;
        file[12] = file[16] = std::byte{4};
        file.resize(128 + 20);
        for (const int each : block) file.push_back(static_cast<std::byte>(each));
        return file;
    }
    return {};
}

TEST(DdsBlocks, HaveSixOrFourStepsBetweenTheirEnds) {
    // Texels 0 to 7 have the indices 0 to 7 (three bits, the lowest first), and so have texels 8 to 15.
    constexpr std::array kIndices{0x88, 0xc6, 0xfa, 0x88, 0xc6, 0xfa};
    struct Row {
        bool isSigned;
        int first, second;
        std::array<double, 8> wanted;
    };
    const std::array<Row, 4> rows{{
        {false, 210, 0, {210, 0, 180, 150, 120, 90, 60, 30}},
        {false, 50, 100, {50, 100, 60, 70, 80, 90, 0, 255}},
        {true, 126, 0x100 - 126, {126, -126, 90, 54, 18, -18, -54, -90}},
        {true, 0x100 - 128, 123, {-127, 123, -77, -27, 23, 73, -127, 127}},
    }};
    for (const Row& row : rows) {
        std::array<int, 8> block{row.first, row.second};
        std::copy(kIndices.begin(), kIndices.end(), block.begin() + 2);
        const auto read = decodeImage(oneBlock(row.isSigned, block), "a.dds", {}, testing::withoutModule());
        ASSERT_TRUE(read) << read.diagnostics[0].text;
        ASSERT_EQ(read->width, 4);
        for (std::size_t i = 0; i < 16; ++i)
            EXPECT_NEAR(componentAt(*read, 4 * i), row.wanted.at(i % 8) / (row.isSigned ? 127 : 255), 1e-6)
                << row.first << ", texel " << i;
    }
}

TEST(DdsBlocks, OfOneComponentAreGreyAndOfTwoAreRedAndGreen) {
    for (const auto& [name, file] : testing::blockFiles()) {
        const bool isOne = name.find("BC4") != std::string::npos || name.find("ATI1") != std::string::npos ||
                           (name >= "blocks-79" && name < "blocks-82");
        const bool isTwo = name.find("BC5") != std::string::npos || name.find("ATI2") != std::string::npos ||
                           (name >= "blocks-82" && name < "blocks-85");
        if (!isOne && !isTwo) continue;
        const auto read = decodeImage(file, name, {}, testing::withoutModule());
        ASSERT_TRUE(read) << name;
        const bool isSigned = testing::isSignedBlocks(name);
        EXPECT_EQ(read->type, isSigned ? Component::f32 : Component::u8) << name;
        double least = 1;
        for (std::size_t i = 0; i < read->data.size() / bytesOf(read->type); i += 4) {
            const double red = componentAt(*read, i), green = componentAt(*read, i + 1),
                         blue = componentAt(*read, i + 2);
            least = std::min(least, red);
            if (isOne) {
                ASSERT_EQ(green, red) << name;
                ASSERT_EQ(blue, red) << name;
            } else {
                ASSERT_EQ(blue, 0) << name;
            }
            ASSERT_EQ(componentAt(*read, i + 3), 1) << name;
        }
        EXPECT_EQ(least < 0, isSigned) << name;
    }
}

}  // namespace
}  // namespace glibra::image
