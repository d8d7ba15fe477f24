// A PNG file that browsers may show as another picture than the one that is decoded.

#include "image/png/png_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/bytes.h"
#include "image/image.h"
#include "image/png/png_writer.h"

namespace glibra::image {
namespace {

using Bytes = std::vector<std::byte>;

Image red() {
    Image image{4, 4, 3, Component::u8, Bytes(48)};
    for (std::size_t i = 0; i < 48; i += 3) image.data[i] = std::byte{255};
    return image;
}

Bytes numbers(const std::vector<std::uint32_t>& values) {
    Bytes content;
    for (const std::uint32_t each : values) putBig32(content, each);
    return content;
}

/// The picture with a chunk before its pixels, or after them.
Bytes with(std::string_view type, const Bytes& content, bool isAfter = false, int times = 1,
           const Image& picture = red()) {
    constexpr std::size_t kHead = 8 + 25, kEnd = 12;
    const Bytes plain = encodePng(picture);
    Bytes file(plain.begin(), isAfter ? plain.end() - kEnd : plain.begin() + kHead);
    for (int i = 0; i < times; ++i) putPngChunk(file, type, content);
    file.insert(file.end(), isAfter ? plain.end() - kEnd : plain.begin() + kHead, plain.end());
    return file;
}

TEST(PngAppearance, WhatIsWrittenIsShownAsItIs) {
    EXPECT_EQ(shownOtherwise(encodePng(red())), "");
    EXPECT_EQ(shownOtherwise(encodePng(red(), {.text = {{"Software", "glibra"}, {"Scene", "K\xc3\xb6nig"}}})),
              "");
    const Image wide{2, 2, 4, Component::u16, Bytes(32)};
    EXPECT_EQ(shownOtherwise(encodePng(wide)), "");
}

TEST(PngAppearance, ChunksThatChangeNothingPass) {
    Bytes square = numbers({2835, 2835});
    square.push_back(std::byte{1});
    const std::pair<const char*, Bytes> harmless[] = {
        {"tEXt", Bytes(5, std::byte{'a'})},
        {"tIME", Bytes(7)},
        {"sRGB", Bytes(1)},
        {"gAMA", numbers({45455})},
        {"cHRM", numbers({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000})},
        {"sBIT", Bytes(3, std::byte{8})},
        {"pHYs", square},
        {"bKGD", Bytes(6)},  // of opaque pixels
    };
    for (const auto& [type, content] : harmless) EXPECT_EQ(shownOtherwise(with(type, content)), "") << type;
    EXPECT_EQ(shownOtherwise(with("tEXt", Bytes(5, std::byte{'a'}), true)), "") << "also after the pixels";
}

TEST(PngAppearance, WhateverElseThereIsIsNamed) {
    Bytes tall = numbers({1000, 3000});
    tall.push_back(std::byte{0});
    const std::pair<const char*, Bytes> harmful[] = {
        {"acTL", Bytes(8)},  {"fcTL", Bytes(26)},
        {"fdAT", Bytes(9)},  {"iCCP", Bytes(9, std::byte{'a'})},
        {"cICP", Bytes(4)},  {"gAMA", numbers({100000})},
        {"gAMA", {}},        {"cHRM", numbers({31270, 32900, 30000, 60000, 64000, 33000, 15000, 6000})},
        {"mDCv", Bytes(24)}, {"cLLi", Bytes(8)},
        {"eXIf", Bytes(8)},  {"pHYs", tall},
        {"pHYs", Bytes(1)},  {"hiDe", Bytes(1)},
    };
    for (const auto& [type, content] : harmful)
        for (const bool isAfter : {false, true})
            EXPECT_NE(shownOtherwise(with(type, content, isAfter)).find(type), std::string::npos) << type;
}

TEST(PngAppearance, ABackgroundShowsBehindTransparentPixelsAlone) {
    const Image clear{2, 2, 4, Component::u8, Bytes(16)};
    EXPECT_NE(shownOtherwise(with("bKGD", Bytes(6), false, 1, clear)).find("bKGD"), std::string::npos);
    EXPECT_NE(shownOtherwise(with("bKGD", Bytes(6), false, 2)).find("bKGD"), std::string::npos) << "twice";
    EXPECT_NE(shownOtherwise(with("bKGD", Bytes(6), true)).find("bKGD"), std::string::npos) << "too late";
}

TEST(PngAppearance, AnimationsAreNamedAsSuch) {
    AnimatedPng film(10);
    film.add(red());
    Image blue = red();
    blue.data[2] = std::byte{255};
    film.add(blue);
    EXPECT_NE(shownOtherwise(film.finish()).find("animation"), std::string::npos);
}

TEST(PngAppearance, FilesThatAreNotOneWholePictureAreNone) {
    const Bytes plain = encodePng(red());
    Bytes followed = plain;
    followed.insert(followed.end(), plain.begin(), plain.end());
    Bytes flipped = plain;
    flipped[20] ^= std::byte{1};
    const Bytes cut(plain.begin(), plain.end() - 12);
    for (const Bytes& each : {followed, flipped, cut, Bytes()})
        EXPECT_NE(shownOtherwise(each).find("whole"), std::string::npos);
    EXPECT_NE(shownOtherwise(with("tRNS", Bytes(6), false, 2)), "")
        << "programs differ in which of two counts";
    EXPECT_NE(shownOtherwise(with("tRNS", Bytes(6), true)), "")
        << "and in whether one counts that comes too late";
}

}  // namespace
}  // namespace glibra::image
