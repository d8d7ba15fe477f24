// GIF files that are written: their frames as the reader of single pictures gives them, their times, and how
// near their colours are.

#include "image/video/video_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "image/bytes.h"
#include "support.h"

namespace glibra::image::test {
namespace {

using Pixels = std::vector<std::byte>;

/// A picture with a colour for each pixel.
template <class Colour>
Image drawn(int width, int height, const Colour& colour) {
    Image image{width, height, 3, Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int each : colour(x, y)) image.data.push_back(static_cast<std::byte>(each));
    return image;
}

Image evenly(int width, int height, int value) {
    return drawn(width, height, [&](int, int) { return std::array{value, value, 255 - value}; });
}

struct GifFilm {
    std::vector<Image> frames;
    std::vector<std::uint32_t> hundredths;
    bool repeats = false;
};

/// The end of the blocks that begin at a byte.
std::size_t pastBlocks(ByteSpan file, std::size_t at) {
    while (octetAt(file, at) != 0) at += 1 + std::size_t{octetAt(file, at)};
    return at + 1;
}

/// Plays a film: each frame is made a file of its own, which the reader of pictures decodes.
GifFilm playedGif(const std::vector<std::byte>& bytes) {
    const ByteSpan file(bytes);
    GifFilm film;
    std::size_t at = 13;
    std::size_t control = 0;
    while (at < file.size() && octetAt(file, at) != 0x3b) {
        const std::size_t begin = at;
        if (octetAt(file, at) == 0x21) {
            if (octetAt(file, at + 1) == 0xf9) {
                control = at;
                film.hundredths.push_back(little16(file, at + 4));
            } else {
                film.repeats = true;
            }
            at = pastBlocks(file, at + 2);
            continue;
        }
        const unsigned flags = octetAt(file, at + 9);
        at = pastBlocks(file, at + 10 + (std::size_t{3} << ((flags & 7U) + 1)) + 1);
        std::vector<std::byte> one(file.begin(), file.begin() + 13);
        one.insert(one.end(), file.begin() + static_cast<std::ptrdiff_t>(control),
                   file.begin() + static_cast<std::ptrdiff_t>(at));
        EXPECT_EQ(begin, control + 8);
        one.push_back(std::byte{0x3b});
        const Result<Image> read = testing::decodeElsewhere(Format::gif, one);
        EXPECT_TRUE(read) << (read ? "" : read.diagnostics.front().text);
        if (!read) return film;
        Image canvas = film.frames.empty() ? evenly(read->width, read->height, 0) : film.frames.back();
        for (std::size_t i = 0; i < canvas.data.size() / 3; ++i)
            if (read->data[4 * i + 3] != std::byte{0})
                std::copy_n(read->data.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                            canvas.data.begin() + static_cast<std::ptrdiff_t>(3 * i));
        film.frames.push_back(std::move(canvas));
    }
    EXPECT_EQ(at + 1, file.size());
    return film;
}

/// The root of the mean squared difference, of 255.
double apart(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
        sum += std::pow(std::to_integer<int>(a.data[i]) - std::to_integer<int>(b.data[i]), 2);
    return std::sqrt(sum / static_cast<double>(a.data.size()));
}

TEST(AnimatedGif, PlaysTheFramesThatWereAdded) {
    GLIBRA_NEED_MODULE();
    std::vector<Image> frames(4, evenly(7, 5, 10));
    frames[1].data[0] = std::byte{200};
    frames[2].data.back() = std::byte{90};
    frames[3] = evenly(7, 5, 250);
    AnimatedGif film(8);
    for (const Image& each : frames) film.add(each);
    const GifFilm result = playedGif(film.finish());
    ASSERT_EQ(result.frames.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_EQ(result.frames[i].data, frames[i].data) << i;
    EXPECT_TRUE(result.repeats);
}

TEST(AnimatedGif, ManyColoursAndLongRunsOfCodesAreExactUpTo256) {
    GLIBRA_NEED_MODULE();
    for (const int colours : {1, 2, 3, 17, 255, 256}) {
        // Unlike any period, so that the table of codes fills several times.
        unsigned random = 12345;
        const Image noise = drawn(301, 97, [&](int, int) {
            random = random * 1664525U + 1013904223U;
            const int value = static_cast<int>((random >> 16U) % static_cast<unsigned>(colours));
            return std::array{value, 255 - value, value / 2};
        });
        const GifFilm result = playedGif(encodeGif(noise));
        ASSERT_EQ(result.frames.size(), 1U);
        EXPECT_EQ(result.frames[0].data, noise.data) << colours;
        EXPECT_FALSE(result.repeats);
    }
}

TEST(AnimatedGif, EveryLengthOfARunIsExact) {
    GLIBRA_NEED_MODULE();
    for (int width = 1; width < 700; ++width) {
        const Image rows = drawn(width, 3, [](int x, int y) { return std::array{x % 5 + 5 * y, 0, 0}; });
        const GifFilm result = playedGif(encodeGif(rows));
        ASSERT_EQ(result.frames.size(), 1U);
        ASSERT_EQ(result.frames[0].data, rows.data) << width;
    }
}

TEST(AnimatedGif, MoreColoursAreNearInEachPixelAndNearerInTheMean) {
    GLIBRA_NEED_MODULE();
    const auto smooth = [](int x, int y) { return std::array{x, y, 128 + (x - y) / 2}; };
    const Image picture = drawn(256, 256, smooth);
    const GifFilm result = playedGif(encodeGif(picture));
    ASSERT_EQ(result.frames.size(), 1U);
    EXPECT_LT(apart(result.frames[0], picture), 14);
    // Means of 8 x 8 pixels, as the eye sees them from afar.
    const auto means = [](const Image& of) {
        return drawn(32, 32, [&](int x, int y) {
            std::array<int, 3> sum{};
            for (int i = 0; i < 64; ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += std::to_integer<int>(
                        of.row(8 * y + i / 8)[static_cast<std::size_t>(8 * x + i % 8) * 3 + c]);
            for (int& each : sum) each = (each + 32) / 64;
            return sum;
        });
    };
    EXPECT_LT(apart(means(result.frames[0]), means(picture)), 3);
}

TEST(AnimatedGif, LastsAsLongAsTheFramesDo) {
    GLIBRA_NEED_MODULE();
    struct Case {
        double rate;
        std::vector<std::uint32_t> hundredths;
    };
    for (const Case& each :
         {Case{30, {3, 4, 3, 3, 4, 3}}, Case{10, {10, 10, 10, 10, 10, 10}}, Case{50, {2, 2, 2, 2, 2, 2}},
          Case{100, {2, 2, 2}}, Case{.001, {65535, 65535, 65535, 65535, 65535, 65535}}}) {
        AnimatedGif film(each.rate);
        for (int i = 0; i < 6; ++i) film.add(evenly(2, 2, i));
        EXPECT_EQ(playedGif(film.finish()).hundredths, each.hundredths) << each.rate;
    }
    AnimatedGif still(10);
    for (int i = 0; i < 4; ++i) still.add(evenly(3, 2, i < 3 ? 5 : 6));
    EXPECT_EQ(playedGif(still.finish()).hundredths, (std::vector<std::uint32_t>{30, 10}));
}

TEST(AnimatedGif, TakesAnyPixels) {
    GLIBRA_NEED_MODULE();
    EXPECT_TRUE(AnimatedGif(10).finish().empty());
    AnimatedGif film(10);
    film.add({2, 1, 4, Component::f32, std::vector<std::byte>(32)});
    film.add({2, 1, 1, Component::u16, std::vector<std::byte>(4, std::byte{255})});
    const GifFilm result = playedGif(film.finish());
    ASSERT_EQ(result.frames.size(), 2U);
    EXPECT_EQ(result.frames[1].data, Pixels(6, std::byte{255}));
}

}  // namespace
}  // namespace glibra::image::test
