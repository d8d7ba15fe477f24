// --axes: where the axes end, how thick they are, and what of them is before the eye.

#include <cmath>
#include <numbers>

#include "render/draw/axes.h"
#include "scene_text.h"

namespace glibra::test {
namespace {

constexpr int kAxesSide = 400;

Picture withAxes(const std::string& scene, RenderOptions options = {}) {
    options.axes = true;
    return picture("WindowSize 400 400\n" + scene + "Color 0 0 .5\nTranslate -.9 -.9 0\nQuadXY 0 .01\n", {},
                   options);
}

bool isWhite(const Picture& picture, int x, int y) {
    return pixel(picture, x, y) == std::array{255, 255, 255};
}

/// The length of the white line from the middle of the picture in a direction, in pixels.
int lengthOfLine(const Picture& picture, int stepX, int stepY) {
    int length = 0;
    const int middle = picture.width / 2;
    while (middle + length < picture.width &&
           isWhite(picture, middle + stepX * length, middle + stepY * length))
        ++length;
    return length;
}

/// The number of white pixels in the column above and below the x axis.
int thickness(const Picture& picture) {
    int count = 0;
    for (int y = picture.height / 2 - 20; y < picture.height / 2 + 20; ++y)
        count += isWhite(picture, picture.width * 5 / 8, y) ? 1 : 0;
    return count;
}

int whitePixels(const Picture& picture) {
    return countPixels(picture, {255, 255, 255});
}

const std::string kFlatView = "Ortho -2 2 -2 2 -5 5\n";

TEST(AxesOfThePicture, AreOneAndAHalfUnitsLongInABox) {
    const Picture flat = withAxes(kFlatView);
    const double unit = kAxesSide / 4.0;
    EXPECT_NEAR(lengthOfLine(flat, 1, 0), render::kAxisLength * unit, 3);
    EXPECT_NEAR(lengthOfLine(flat, 0, -1), render::kAxisLength * unit, 3);
    EXPECT_LE(lengthOfLine(flat, -1, 0), 3);
    // The letter X crosses in its middle, Y stands on its foot; both are a tenth of the axis wide.
    EXPECT_TRUE(isWhite(flat, 200 + 172, 200));
    EXPECT_TRUE(isWhite(flat, 200, 200 - 167));
    EXPECT_FALSE(isWhite(flat, 200 + 158, 200)) << "between the axis and its letter";
}

TEST(AxesOfThePicture, AreOneAndAHalfUnitsLongInPerspective) {
    const Picture deep = withAxes("Perspective 50 .1 100\nLookAt 0 0 5  0 0 0  0 1 0\n");
    const double unit = kAxesSide / 2.0 / (5 * std::tan(25 * std::numbers::pi / 180));
    EXPECT_NEAR(lengthOfLine(deep, 1, 0), render::kAxisLength * unit, 3);
    EXPECT_NEAR(lengthOfLine(deep, 0, -1), render::kAxisLength * unit, 3);
}

TEST(AxesOfThePicture, AreAsThickInAPictureOfAnySize) {
    EXPECT_EQ(thickness(withAxes(kFlatView)), 2);
    RenderOptions large;
    large.width = large.height = 1200;
    EXPECT_EQ(thickness(withAxes(kFlatView, large)), 6);
    RenderOptions small;
    small.width = small.height = 80;
    const int least = thickness(withAxes(kFlatView, small));
    EXPECT_TRUE(least == 1 || least == 2) << least;
}

TEST(AxesOfThePicture, AreTheSameInTiles) {
    RenderOptions tiled;
    tiled.tileSize = 96;
    const Picture whole = withAxes(kFlatView), tiles = withAxes(kFlatView, tiled);
    int different = 0;
    for (int y = 0; y < kAxesSide; ++y)
        for (int x = 0; x < kAxesSide; ++x) different += pixel(whole, x, y) != pixel(tiles, x, y) ? 1 : 0;
    EXPECT_LE(different, 4) << "rounding at the ends of slanted lines";
}

TEST(AxesOfThePicture, ThatPassTheEyeEndBeforeIt) {
    // The z axis goes from below the middle past the eye.
    const Picture near = withAxes("Perspective 50 .1 100\nLookAt 0 .1 1  0 0 0  0 1 0\n");
    EXPECT_GT(whitePixels(near), 300);
    EXPECT_LT(whitePixels(near), kAxesSide * kAxesSide / 40);
    for (int y = 230; y < kAxesSide; ++y) EXPECT_TRUE(isWhite(near, 200, y)) << y;
    // Nothing of the axes is before an eye that looks away.
    EXPECT_EQ(whitePixels(withAxes("Perspective 50 .1 100\nLookAt 0 0 5  0 0 9  0 1 0\n")), 0);
}

TEST(AxesOfThePicture, AreHiddenByWhatIsNearer) {
    const Picture hidden = withAxes(kFlatView + "Color .2 .4 .2\nQuadXY 2 .5\n");
    EXPECT_FALSE(isWhite(hidden, 220, 200));
    EXPECT_TRUE(isWhite(hidden, 300, 200));
}

}  // namespace
}  // namespace glibra::test
