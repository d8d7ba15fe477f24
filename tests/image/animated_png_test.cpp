// Animated PNG files: their chunks, and the pictures that a reader puts together from the parts.

#include "image/png/png_writer.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <cstdint>
#include <string>
#include <vector>

#include "image/bytes.h"
#include "image/png/png_reader.h"

namespace glibra::image::test {
namespace {

Image filledWith(int width, int height, int value) {
    Image image{width, height, 3, Component::u8, {}};
    image.data.assign(image.rowBytes() * static_cast<std::size_t>(height), static_cast<std::byte>(value));
    return image;
}

void put(Image& image, int x, int y, int value) {
    const std::size_t at = static_cast<std::size_t>(y) * image.rowBytes() + static_cast<std::size_t>(x) * 3;
    for (std::size_t c = 0; c < 3; ++c) image.data[at + c] = static_cast<std::byte>(value);
}

struct Played {
    std::vector<Image> frames;  ///< whole ones
    std::vector<std::uint32_t> milliseconds;
};

/// Plays the file as the specification says: each part replaces what is in its rectangle. The parts are
/// decoded as PNG files of their own.
Played played(std::span<const std::byte> file) {
    Played result;
    std::uint32_t sequence = 0, width = 0, height = 0, left = 0, top = 0, announced = 0;
    Image canvas;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t length = big32(file, at);
        const std::string type(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
        EXPECT_EQ(libdeflate_crc32(0, file.data() + at + 4, length + 4), big32(file, at + 8 + length))
            << type;
        const std::span<const std::byte> content = file.subspan(at + 8, length);
        at += length + 12;
        if (type == "acTL") announced = big32(content, 0);
        if (type == "fcTL") {
            EXPECT_EQ(big32(content, 0), sequence++);
            width = big32(content, 4);
            height = big32(content, 8);
            left = big32(content, 12);
            top = big32(content, 16);
            result.milliseconds.push_back(1000 * big16(content, 20) / big16(content, 22));
        }
        if (type != "IDAT" && type != "fdAT") continue;
        if (type == "fdAT") {
            EXPECT_EQ(big32(content, 0), sequence++);
        }
        const Image part{static_cast<int>(width), static_cast<int>(height), 3, Component::u8, {}};
        std::vector<std::byte> png;
        putPngHeader(png, part);
        putPngChunk(png, "IDAT", content.subspan(type == "fdAT" ? 4 : 0));
        putPngChunk(png, "IEND", {});
        const Result<Image> read = decodePng(png, {});
        EXPECT_TRUE(read);
        if (!read) return result;
        if (result.frames.empty()) canvas = filledWith(part.width, part.height, 0);
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
                put(canvas, static_cast<int>(left + x), static_cast<int>(top + y),
                    std::to_integer<int>(read->row(static_cast<int>(y))[x * 4]));
        result.frames.push_back(canvas);
    }
    EXPECT_EQ(announced, result.frames.size());
    return result;
}

TEST(AnimatedPng, PlaysTheFramesThatWereAdded) {
    std::vector<Image> frames(5, filledWith(7, 5, 10));
    put(frames[1], 0, 0, 200);
    put(frames[2], 6, 4, 90);
    put(frames[2], 3, 1, 91);
    frames[4] = filledWith(7, 5, 250);
    AnimatedPng film(8);
    for (const Image& each : frames) film.add(each);
    const Played result = played(film.finish());
    ASSERT_EQ(result.frames.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(result.frames[i].data, frames[i].data) << i;
    EXPECT_EQ(result.milliseconds, std::vector<std::uint32_t>(5, 125));
}

TEST(AnimatedPng, EqualFramesAreOneThatLastsLonger) {
    AnimatedPng film(10);
    for (int i = 0; i < 4; ++i) film.add(filledWith(3, 2, i < 3 ? 5 : 6));
    EXPECT_EQ(film.differing(), 2U);
    const Played result = played(film.finish());
    EXPECT_EQ(result.milliseconds, (std::vector<std::uint32_t>{300, 100}));
}

TEST(AnimatedPng, IsAPngPictureOfItsFirstFrame) {
    AnimatedPng film(10);
    film.add(filledWith(4, 4, 77));
    film.add(filledWith(4, 4, 78));
    const Result<Image> read = decodePng(film.finish(), {});
    ASSERT_TRUE(read);
    EXPECT_EQ(std::to_integer<int>(read->data[0]), 77);
    EXPECT_EQ(read->width, 4);
}

TEST(AnimatedPng, TakesAnyPixelsAndAnySpeed) {
    EXPECT_TRUE(AnimatedPng(10).finish().empty());
    for (const double rate : {1e-3, 1e6, 29.97}) {
        AnimatedPng film(rate);
        film.add({2, 1, 4, Component::f32, std::vector<std::byte>(32)});
        film.add({2, 1, 1, Component::u16, std::vector<std::byte>(4, std::byte{255})});
        const Played result = played(film.finish());
        ASSERT_EQ(result.frames.size(), 2U);
        EXPECT_GE(result.milliseconds[0], 1U);
        EXPECT_LE(result.milliseconds[0], 65'535U);
    }
}

}  // namespace
}  // namespace glibra::image::test
