// The smallest pictures and scenes (NM27): empty scenes, one pixel, one row, one column, and tiles of every
// size.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace glibra::stress {
namespace {

TEST(EmptyScenes, AreTheBackgroundInEverySpelling) {
    for (const char* text :
         {"", "\n\n\n", "# nothing", "#", "\\", "Background 1 .5 .25", "Clear", "Clear\nClear",
          "PushMatrix\nPopMatrix", "Sphere 0", "Box 0 0 0", "Perspective 50", "Verbose",
          "Color 1 0 0\nLineWidth 3", "Noise3D 32", "Timer 1", "MessageBox hello", "RenderToTexture",
          "Texture2D 6 16 16\nRenderToTexture 6\nClear\nRenderToTexture"}) {
        const FloatPicture picture = draw(std::string("WindowSize 5 4\n") + text + "\n");
        ASSERT_EQ(picture.width, 5) << text;
        const auto first = picture.at(0, 0);
        EXPECT_EQ(picture.count([&](const auto& rgb) { return rgb == first; }), 20U) << text;
        const bool own = std::string(text).starts_with("Background");
        EXPECT_NEAR(first[0], own ? 1 : 18 / 255., 1e-7) << text;
    }
}

TEST(EmptyScenes, OfNoBytesAreLegal) {
    const FloatPicture picture = draw("");
    EXPECT_EQ(picture.width, 600);
    EXPECT_EQ(picture.height, 600);
}

TEST(SmallPictures, OfOnePixelShowTheMiddle) {
    RenderOptions one;
    one.width = one.height = 1;
    const std::string scene = "Background 0\nPerspective 40\nLookAt 0 0 3 0 0 0 0 1 0\n" +
                              std::string(kProgram) + "Sphere 1 60 30\n";
    const FloatPicture picture = draw(scene, shaded("normalize(vN)"), one);
    ASSERT_EQ(picture.values.size(), 3U);
    EXPECT_NEAR(picture.at(0, 0)[2], 1, 1e-5);
    RenderOptions odd;
    odd.width = odd.height = 301;
    const FloatPicture large = draw(scene, shaded("normalize(vN)"), odd);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(picture.at(0, 0)[i], large.at(150, 150)[i], 1e-5);
}

TEST(SmallPictures, OfOneRowOrColumnAreThoseOfALargeOne) {
    // Ortho shows the whole box: one row of 2^14 pixels covers a box of width 2^14 and height 1.
    const Files files = shaded("vMC.xyz");
    for (const int length : {1, 7, 4096, 16384}) {
        const std::string row = fmt::format(
            "WindowSize {0} 1\nBackground 0\nOrtho 0 {0} 0 1\nLookAt 0 0 5 0 0 0 0 1 0\n{1}QuadXY 0 20000\n",
            length, kProgram);
        const std::string column = fmt::format(
            "WindowSize 1 {0}\nBackground 0\nOrtho 0 1 0 {0}\nLookAt 0 0 5 0 0 0 0 1 0\n{1}QuadXY 0 20000\n",
            length, kProgram);
        const FloatPicture across = draw(row, files);
        const FloatPicture down = draw(column, files);
        ASSERT_EQ(across.width, length);
        ASSERT_EQ(down.height, length);
        double worst = 0;
        for (int i = 0; i < length; ++i) {
            worst = std::max(worst, std::abs(static_cast<double>(across.at(i, 0)[0]) - (i + .5)));
            worst = std::max(worst, std::abs(static_cast<double>(down.at(0, length - 1 - i)[1]) - (i + .5)));
        }
        // The position of a pixel is interpolated in float over 40,000 units.
        EXPECT_LT(worst, 40'000 * 2.4e-7) << length;
    }
}

TEST(Tiles, OfAnySizeJoinToTheSamePicture) {
    // Includes the smallest size, and sizes whose last tile has one pixel. Rounding may move edges.
    const std::string scene =
        "WindowSize 97 65\nBackground 0\nPerspective 40\nLookAt 1 2 3 0 0 0 0 1 0\n" + std::string(kProgram) +
        "Torus 1 .4 24 48\nLineWidth 1\nWireSphere 1.2 12 7\nPointSize 5\nPointCloud 4 4 4\n";
    const Files files = shaded("vec3(vEC.xy, gl_FragCoord.x)");
    const FloatPicture whole = draw(scene, files);
    for (const int tile : {16, 32, 48, 64, 96}) {
        RenderOptions options;
        options.tileSize = tile;
        const FloatPicture joined = draw(scene, files, options);
        ASSERT_EQ(joined.values.size(), whole.values.size());
        std::size_t differing = 0;
        for (std::size_t i = 0; i < whole.values.size(); i += 3) {
            bool same = true;
            for (std::size_t k = i; k < i + 3; ++k)
                same = same && std::abs(joined.values[k] - whole.values[k]) < 1e-3F;
            differing += same ? 0 : 1;
        }
        EXPECT_LE(differing, whole.values.size() / 3 / 100) << tile;
    }
}

}  // namespace
}  // namespace glibra::stress
