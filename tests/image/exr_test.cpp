// EXR: windows, kinds of channels, parts, tiles; files made by hand.

#include <gtest/gtest.h>

#include <tuple>

#include "exr_maker.h"
#include "image/foreign_headers.h"
#include "image/read.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::ExrMaker;
using testing::idsOf;
using Type = ExrMaker::Type;

std::vector<float> floatsAt(const Image& image, int x, int y) {
    std::vector<float> values(4);
    std::memcpy(values.data(), image.row(y).data() + 16 * static_cast<std::size_t>(x), 16);
    return values;
}

class Exr : public testing::InFolder {
  protected:
    [[nodiscard]] Result<Image> read(std::span<const std::byte> file) const {
        return readImage(put("a.exr", file), {}, testing::withModule());
    }
    /// The picture shows the display window, with what the data window has of it.
    void expectShows(const ExrMaker& maker, const std::string& what) const {
        const auto image = read(maker.file());
        ASSERT_TRUE(image) << what << ": " << image.diagnostics[0].text;
        ASSERT_EQ(image->width, maker.display.width()) << what;
        ASSERT_EQ(image->height, maker.display.height()) << what;
        EXPECT_EQ(image->type, Component::f32);
        for (int y = 0; y < image->height; ++y)
            for (int x = 0; x < image->width; ++x) {
                const int column = maker.display.left + x, row = maker.display.top + y;
                const bool inside = column >= maker.data.left && column <= maker.data.right &&
                                    row >= maker.data.top && row <= maker.data.bottom;
                std::vector<float> expected{0, 0, 0, 1};
                if (inside)
                    for (const std::size_t c : {0U, 1U, 2U})
                        expected[c] = static_cast<float>(maker.value(std::string(1, "RGB"[c]), column, row));
                ASSERT_EQ(floatsAt(*image, x, y), expected) << what << " at " << x << " " << y;
            }
    }
};

TEST_F(Exr, ThePictureIsTheDisplayWindowWhereverTheDataLie) {
    GLIBRA_NEED_MODULE();
    const std::vector<ExrMaker::Window> windows{{0, 0, 3, 2},    {1, 1, 2, 1}, {-2, -1, 5, 4},
                                                {-2, 1, 1, 6},   {3, 2, 9, 9}, {10, 10, 11, 11},
                                                {-5, -4, -3, -3}};
    for (const auto& data : windows)
        for (const ExrMaker::Window& display : {ExrMaker::Window{0, 0, 3, 2}, {-3, -2, 1, 0}, {2, 1, 4, 5}})
            for (const int tile : {0, 2, 16})
                for (const bool decreasing : {false, true}) {
                    ExrMaker maker{.data = data, .display = display, .tile = tile, .decreasing = decreasing};
                    maker.channels[1].type = Type::half;
                    maker.value = [](const std::string& channel, int x, int y) {
                        return channel[0] + 100. * (x + 6) + 10 * (y + 6);
                    };
                    expectShows(maker, std::to_string(data.left) + " " + std::to_string(display.left) + " " +
                                           std::to_string(tile));
                }
}

TEST_F(Exr, WholeNumbersKeepTheirValue) {
    GLIBRA_NEED_MODULE();
    ExrMaker maker;
    for (auto& each : maker.channels) each.type = Type::whole;
    expectShows(maker, "small");
    maker.value = [](const std::string&, int x, int y) { return 4e9 + x + y; };
    expectShows(maker, "large");
}

TEST_F(Exr, ChannelsAreChosenByTheirNames) {
    GLIBRA_NEED_MODULE();
    struct Case {
        std::vector<ExrMaker::Channel> channels;
        std::string shown;  ///< the last letter of the channel of each component; 0 and 1: none
    };
    for (const auto& [channels, shown] :
         {Case{{{"A"}, {"B"}, {"G"}, {"R"}}, "RGBA"}, Case{{{"A"}, {"Y"}}, "YYYA"}, Case{{{"Z"}}, "ZZZ1"},
          Case{{{"G"}, {"R"}}, "RG01"}, Case{{{"R"}}, "RRR1"},
          Case{{{"B"}, {"G"}, {"R"}, {"depth.Z"}, {"diffuse.B"}}, "RGB1"},
          Case{{{"diffuse.B"}, {"diffuse.G"}, {"diffuse.R"}, {"x.Z"}}, "RGB1"},
          Case{{{"b"}, {"g"}, {"r"}}, "rgb1"}}) {
        ExrMaker maker;
        maker.channels = channels;
        const auto image = read(maker.file());
        ASSERT_TRUE(image) << image.diagnostics[0].text;
        std::vector<float> expected;
        for (const char each : shown)
            expected.push_back(each == '0' || each == '1'
                                   ? static_cast<float>(each - '0')
                                   : static_cast<float>(maker.value(std::string(1, each), 1, 0)));
        EXPECT_EQ(floatsAt(*image, 1, 0), expected) << channels[0].name;
    }
}

TEST_F(Exr, OutsideOfItsDataAPictureWithAlphaIsTransparent) {
    GLIBRA_NEED_MODULE();
    const ExrMaker maker{.data = {1, 0, 1, 0}, .channels = {{"A"}, {"B"}, {"G"}, {"R"}}};
    const auto image = read(maker.file());
    ASSERT_TRUE(image);
    EXPECT_EQ(floatsAt(*image, 0, 0), (std::vector<float>{0, 0, 0, 0}));
    EXPECT_EQ(floatsAt(*image, 1, 0)[3], static_cast<float>('A' + 100));
}

TEST_F(Exr, OfSeveralPartsTheFirstIsRead) {
    GLIBRA_NEED_MODULE();
    ExrMaker first, second;
    second.value = [](const std::string&, int, int) { return 7.; };
    auto image = read(ExrMaker::fileOf({first, second}));
    ASSERT_TRUE(image) << image.diagnostics[0].text;
    EXPECT_EQ(floatsAt(*image, 1, 1)[0], static_cast<float>(first.value("R", 1, 1)));
    second.tile = 2;
    image = read(ExrMaker::fileOf({second, first}));
    ASSERT_TRUE(image) << image.diagnostics[0].text;
    EXPECT_EQ(floatsAt(*image, 1, 1)[0], 7.F);
    first.partType = "deepscanline";
    EXPECT_EQ(read(ExrMaker::fileOf({first})).diagnostics[0].text, "'a.exr': it is a deep picture");
}

TEST_F(Exr, SizesAreJudgedBeforeTheLibrarySeesTheFile) {
    const ReadOptions none = testing::withoutModule();  // the module would be named if it was asked
    // The header alone, since the file would be huge.
    const auto idOf = [&](const ExrMaker::Window& data, const ExrMaker::Window& display, int tile) {
        std::vector<std::byte> header = testing::bytesOf({0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0});
        const auto putText = [&](const std::string& text) {
            for (const char each : text) header.push_back(static_cast<std::byte>(each));
            header.push_back({});
        };
        const auto putBox = [&](const char* name, const ExrMaker::Window& box) {
            putText(name);
            putText("box2i");
            testing::putLittle(header, 16, 4);
            for (const int each : {box.left, box.top, box.right, box.bottom})
                testing::putLittle(header, static_cast<std::uint32_t>(each), 4);
        };
        putText("channels");
        putText("chlist");
        testing::putLittle(header, 19, 4);
        putText("R");
        for (const std::uint32_t each : {2U, 0U, 1U, 1U}) testing::putLittle(header, each, 4);
        header.push_back({});
        putBox("dataWindow", data);
        putBox("displayWindow", display);
        if (tile > 0) {
            putText("tiles");
            putText("tiledesc");
            testing::putLittle(header, 9, 4);
            testing::putLittle(header, static_cast<std::uint32_t>(tile), 4);
            testing::putLittle(header, static_cast<std::uint32_t>(tile), 4);
            header.push_back({});
        }
        header.push_back({});
        return idsOf(readImage(put("a.exr", header), {}, none).diagnostics);
    };
    constexpr ExrMaker::Window kSmall{0, 0, 3, 3};
    EXPECT_EQ(idOf(kSmall, kSmall, 0), "file-E03") << "the module is missing, nothing else";
    EXPECT_EQ(idOf({0, 0, 20000, 0}, kSmall, 0), "file-E09");
    EXPECT_EQ(idOf(kSmall, {0, 0, 20000, 0}, 0), "file-E09");
    EXPECT_EQ(idOf({INT32_MIN, 0, INT32_MAX, 0}, kSmall, 0), "file-E09");
    EXPECT_EQ(idOf({1, 0, 0, 0}, kSmall, 0), "file-E04");
    EXPECT_EQ(idOf(kSmall, kSmall, 1 << 30), "file-E09");
}

TEST_F(Exr, ACutFileIsAnErrorAtEveryLength) {
    GLIBRA_NEED_MODULE();
    const auto whole = ExrMaker{}.file();
    for (std::size_t length = 8; length < whole.size(); length += 7) {
        const auto image = read(std::span(whole).first(length));
        EXPECT_EQ(idsOf(image.diagnostics), "file-E04") << length;
    }
}

TEST_F(Exr, WhatTwoFilesHaveDifferentIsDescribed) {
    ExrMaker maker{.display = {2, 3, 4, 5}};
    maker.channels[1].type = Type::half;
    maker.channels[2].type = Type::whole;
    const auto part = readExrHeader(maker.file(), {"a", {}});
    ASSERT_TRUE(part);
    EXPECT_EQ(describeExr(*part),
              "display window at 2 3, data window 2 x 2 at 0 0, channels B (float) G (half) R (uint)");
}

}  // namespace
}  // namespace glibra::image
