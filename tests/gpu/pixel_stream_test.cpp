// Pixels that are read while the device draws on.

#include "gpu/object/readback.h"

#include <tuple>

#include "fixture.h"

namespace glibra::gpu {
namespace {

/// Whether buffers stay mapped; the components and the type of a pixel.
class PixelStreamTest : public test::GpuTest,
                        public testing::WithParamInterface<std::tuple<bool, int, TexelType>> {
  protected:
    PixelStreamTest() : capabilities(driver()) {
        capabilities.persistentMaps = std::get<0>(GetParam()) && driver().persistentMaps;
    }
    /// A picture whose pixels all differ, other ones for each number.
    void draw(int number) const {
        const float shift = static_cast<float>(number) / 128;
        window.bind();
        glEnable(GL_SCISSOR_TEST);
        for (int y = 0; y < window.height(); ++y)
            for (int x = 0; x < window.width(); ++x) {
                glScissor(x, y, 1, 1);
                const std::array<float, 4> color{static_cast<float>(x) / 16 + shift,
                                                 static_cast<float>(y) / 16 + shift, shift,
                                                 static_cast<float>(x + y) / 32};
                glClearBufferfv(GL_COLOR, 0, color.data());
            }
        glDisable(GL_SCISSOR_TEST);
    }
    [[nodiscard]] std::vector<std::byte> readNow(const PixelRectangle& rectangle) const {
        auto pixels = readPixels(driver(), window.readable(), 0, rectangle, layout);
        EXPECT_TRUE(pixels);
        return std::move(*pixels);
    }
    [[nodiscard]] std::vector<std::byte> taken(PixelStream& stream, const PixelRectangle& rectangle) const {
        std::vector<std::byte> pixels(byteCount(rectangle, layout), std::byte{0xcd});
        const Diagnostics problems = stream.take(pixels);
        EXPECT_TRUE(problems.empty()) << test::text(problems);
        return pixels;
    }

    Capabilities capabilities;
    PixelLayout layout{std::get<1>(GetParam()), std::get<2>(GetParam())};
    Target window = std::move(*Target::window(driver(), 7, 5, TexelFormat::rgba32f, 1));
};

TEST_P(PixelStreamTest, GivesWhatIsReadAtOnce) {
    PixelStream stream(capabilities);
    const PixelRectangle all{0, 0, 7, 5}, part{2, 1, 3, 3};
    std::vector<std::vector<std::byte>> wanted;
    for (const PixelRectangle& rectangle : {all, all, part, all}) {
        wanted.clear();
        for (int number = 0; number < 2; ++number) {
            draw(number);
            wanted.push_back(readNow(rectangle));
            EXPECT_TRUE(stream.begin(window.readable(), 0, rectangle, layout).empty());
        }
        EXPECT_NE(wanted[0], wanted[1]);
        draw(5);  // does not change what was begun
        EXPECT_EQ(stream.underWay(), 2U);
        EXPECT_EQ(taken(stream, rectangle), wanted[0]);
        EXPECT_EQ(taken(stream, rectangle), wanted[1]);
        EXPECT_EQ(stream.underWay(), 0U);
    }
}

TEST_P(PixelStreamTest, KeepsOrderWhileOneIsUnderWay) {
    PixelStream stream(capabilities);
    const PixelRectangle all{0, 0, 7, 5};
    std::vector<std::byte> before;
    for (int number = 0; number < 8; ++number) {
        draw(number);
        EXPECT_TRUE(stream.begin(window.readable(), 0, all, layout).empty());
        const std::vector<std::byte> now = readNow(all);
        if (number > 0) {
            EXPECT_EQ(taken(stream, all), before) << number;
        }
        before = now;
    }
}

INSTANTIATE_TEST_SUITE_P(Layouts, PixelStreamTest,
                         testing::Combine(testing::Bool(), testing::Values(1, 2, 3, 4),
                                          testing::Values(TexelType::u8, TexelType::u16, TexelType::f32)),
                         [](const auto& each) {
                             return std::string(std::get<0>(each.param) ? "Mapped" : "Copied") +
                                    std::to_string(std::get<1>(each.param)) + "of" +
                                    std::to_string(8 * bytesOf(std::get<2>(each.param)));
                         });

using PixelStreamLimits = test::GpuTest;

TEST_F(PixelStreamLimits, RefusesWhatItCannotGive) {
    const Target window = std::move(*Target::window(driver(), 4, 4, TexelFormat::rgba8, 1));
    window.bind();
    window.clearColor(0, {1, 0, 0, 1});
    PixelStream stream(driver());
    std::vector<std::byte> pixels(4 * 4 * 3);
    EXPECT_EQ(stream.take(pixels).front().id, "gpu-E03") << "nothing is under way";
    const PixelRectangle all{0, 0, 4, 4};
    const PixelLayout rgb{3, TexelType::u8};
    EXPECT_FALSE(stream.begin(window.readable(), 1, all, rgb).empty()) << "there is no such colour";
    EXPECT_FALSE(stream.begin(window.readable(), 0, {0, 0, 0, 4}, rgb).empty());
    EXPECT_TRUE(stream.begin(window.readable(), 0, all, rgb).empty());
    EXPECT_TRUE(stream.begin(window.readable(), 0, all, rgb).empty());
    EXPECT_EQ(stream.begin(window.readable(), 0, all, rgb).front().id, "gpu-E03") << "too many";
    std::vector<std::byte> tooSmall(3);
    EXPECT_EQ(stream.take(tooSmall).front().id, "gpu-E03");
    EXPECT_TRUE(stream.take(pixels).empty());
    EXPECT_EQ(pixels[0], std::byte{255});
    EXPECT_EQ(pixels[1], std::byte{0});
}

}  // namespace
}  // namespace glibra::gpu
