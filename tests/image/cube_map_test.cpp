// One picture as the faces of a cube map.

#include "image/texture_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>

#include "image/image.h"
#include "image/write.h"

namespace glibra::image {
namespace {

/// Writes a picture of bytes whose pixels `color` gives, and reads it as a cube map.
template <class ColorAt>
Result<TexelBlock> cubeOf(int width, int height, const ColorAt& color) {
    Image picture{width, height, 4, Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int each : color(x, y)) picture.data.push_back(static_cast<std::byte>(each));
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("glibra-cube-" + std::to_string(::getpid()) + ".png");
    EXPECT_TRUE(writeImage(picture, path).empty());
    Result<TexelBlock> cube = readCubePicture(path);
    std::filesystem::remove(path);
    return cube;
}

std::array<int, 4> texel(const TexelBlock& cube, int face, int x, int y) {
    const auto side = static_cast<std::size_t>(cube.width);
    const std::size_t at = ((static_cast<std::size_t>(face) * side + static_cast<std::size_t>(y)) * side +
                            static_cast<std::size_t>(x)) *
                           4;
    std::array<int, 4> value{};
    for (std::size_t i = 0; i < 4; ++i) value[i] = std::to_integer<int>(cube.data.at(at + i));
    return value;
}

TEST(CubePicture, OfACrossIsCopied) {
    const auto cube = cubeOf(8, 6, [](int x, int y) { return std::array{x * 10, y * 10, 7, 255}; });
    ASSERT_TRUE(cube);
    EXPECT_EQ(cube->faces, 6);
    EXPECT_EQ(cube->width, 2);
    // Columns and rows of the upper left texels of +x -x +y -y +z -z.
    const std::array<std::array<int, 2>, 6> corners{{{4, 2}, {0, 2}, {2, 0}, {2, 4}, {2, 2}, {6, 2}}};
    for (int face = 0; face < 6; ++face) {
        const auto& [column, row] = corners.at(static_cast<std::size_t>(face));
        EXPECT_EQ(texel(*cube, face, 1, 0), (std::array{(column + 1) * 10, row * 10, 7, 255})) << face;
    }
}

TEST(CubePicture, OfAPanoramaLooksInTheDirectionOfEachTexel) {
    // The colour is the direction of the pixel, so every texel must have the colour of its own direction.
    constexpr int kWidth = 256, kHeight = 128;
    const auto asByte = [](double value) { return static_cast<int>(std::lround((value + 1) * 127.5)); };
    const auto cube = cubeOf(kWidth, kHeight, [&](int x, int y) {
        const double longitude = ((x + .5) / kWidth - .5) * 2 * std::numbers::pi;
        const double latitude = (.5 - (y + .5) / kHeight) * std::numbers::pi;
        return std::array{asByte(std::cos(latitude) * std::sin(longitude)), asByte(std::sin(latitude)),
                          asByte(-std::cos(latitude) * std::cos(longitude)), 255};
    });
    ASSERT_TRUE(cube);
    ASSERT_EQ(cube->width, kWidth / 4);
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < cube->height; y += 7)
            for (int x = 0; x < cube->width; x += 7) {
                const auto [dx, dy, dz] =
                    cubeDirection(face, (x + .5) / cube->width, (y + .5) / cube->height);
                const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
                const std::array<int, 4> found = texel(*cube, face, x, y);
                EXPECT_NEAR(found[0], asByte(dx / length), 3) << face << ' ' << x << ' ' << y;
                EXPECT_NEAR(found[1], asByte(dy / length), 3) << face << ' ' << x << ' ' << y;
                EXPECT_NEAR(found[2], asByte(dz / length), 3) << face << ' ' << x << ' ' << y;
            }
}

TEST(CubePicture, OfAnotherShapeIsAnError) {
    const auto cube = cubeOf(5, 4, [](int, int) { return std::array{0, 0, 0, 255}; });
    ASSERT_FALSE(cube);
    EXPECT_EQ(cube.diagnostics.at(0).id, "file-E06");
}

TEST(TexelBlocks, AreFlippedSliceBySlice) {
    TexelBlock block;
    block.width = 1;
    block.height = 2;
    block.depth = 2;
    block.components = 1;
    block.data = {std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}};
    flipRows(block);
    EXPECT_EQ(block.data, (std::vector{std::byte{2}, std::byte{1}, std::byte{4}, std::byte{3}}));
}

TEST(TexelBlocks, AreDecodedFromSrgb) {
    TexelBlock block;
    block.type = Component::u16;
    block.data.resize(8);
    const std::array<std::uint16_t, 4> encoded{32768, 65535, 1000, 32768};
    std::memcpy(block.data.data(), encoded.data(), sizeof encoded);
    decodeSrgb(block);
    std::array<float, 4> linear{};
    ASSERT_EQ(block.data.size(), sizeof linear);
    std::memcpy(linear.data(), block.data.data(), sizeof linear);
    EXPECT_NEAR(static_cast<double>(linear[0]), .2140482, 1e-6);  // (.5000076 + .055) / 1.055 to the 2.4
    EXPECT_EQ(linear[1], 1);
    EXPECT_NEAR(static_cast<double>(linear[2]), 1000. / 65535 / 12.92, 1e-7);
    EXPECT_NEAR(static_cast<double>(linear[3]), .5000076, 1e-6) << "alpha stays";
}

}  // namespace
}  // namespace glibra::image
