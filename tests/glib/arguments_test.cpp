// Arguments (language, 1.7) and the numbers of each command (language, 3).

#include <gtest/gtest.h>

#include "scene.h"

namespace glibra::glib::test {
namespace {

TEST(Arguments, SuffixWithDefaultsMayBeLeftOutInSilence) {
    EXPECT_EQ(numbersOf("QuadXY .2 2."), (Numbers{.2, 2, 4, 4}));
    EXPECT_TRUE(idsOf("QuadXY .2 2.").empty());
    EXPECT_EQ(read("QuadXY .2 2.").commands.at(0).givenNumbers, 2U);
}

TEST(Arguments, MissingOneWithoutDefaultIsRefused) {
    EXPECT_EQ(idsOf("LookAt 0 0 5 0 0 0"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("glNormal 0 0"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("LineWidth"), Ids{"glib-E04"});
    EXPECT_TRUE(read("LookAt 0 0 5").commands.empty());
}

TEST(Arguments, SurplusIsIgnored) {
    EXPECT_EQ(idsOf("Color 1 1 1 1 1"), Ids{"glib-W07"});
    EXPECT_EQ(idsOf("Teapot 5 5"), Ids{"glib-W07"});
    EXPECT_EQ(idsOf("Obj cow.obj x y"), Ids{"glib-W07"});
    EXPECT_EQ(idsOf("glBegin points points"), Ids{"glib-W07"});
    EXPECT_EQ(idsOf("PopMatrix 1"), Ids{"glib-W07"});
    EXPECT_EQ(idsOf("Let v <0 1 1 1 1 1 5>"), Ids{"glib-E37"});
    EXPECT_EQ(placeOf("Color 1 1 1 1 1", "glib-W07"), "1:15");
}

TEST(Arguments, NegativeSizeCountsAsItsAbsoluteValue) {
    EXPECT_EQ(numbersOf("Sphere -2"), (Numbers{2, 60, 60}));
    EXPECT_EQ(idsOf("Sphere -2"), Ids{"glib-W28"});
    EXPECT_EQ(numbersOf("Box 1 -2 3"), (Numbers{1, 2, 3}));
    EXPECT_EQ(numbersOf("Cylinder 1 -3"), (Numbers{1, 3, 60, 20}));
}

TEST(Arguments, ZeroSizeIsKeptWithAWarning) {
    EXPECT_EQ(numbersOf("Sphere 0"), (Numbers{0, 60, 60}));
    EXPECT_EQ(idsOf("Sphere 0"), Ids{"glib-W42"});
}

TEST(Arguments, CoordinateIsNoSize) {
    EXPECT_TRUE(idsOf("QuadXY -5. 5.\nDiskXY 0 1").empty());
}

TEST(Arguments, SubdivisionIsRaisedToItsMinimum) {
    const auto raised = [](std::string_view text, const Numbers& numbers, std::size_t warnings) {
        EXPECT_EQ(numbersOf(text), numbers) << text;
        EXPECT_EQ(idsOf(text), Ids(warnings, "glib-W28")) << text;
    };
    raised("Sphere 1 2 1", {1, 3, 2}, 2);
    raised("Sphere 1 3 2", {1, 3, 2}, 0);
    raised("WireSphere 1 0 0", {1, 3, 2}, 2);
    raised("Cylinder 1 1 1 0", {1, 1, 3, 1}, 2);
    raised("Cone 1 1 -60 1", {1, 1, 3, 1}, 1);
    raised("Torus 1 .5 2 2", {1, .5, 3, 3}, 2);
    raised("DiskXY 0 1 2 0", {0, 1, 3, 1}, 2);
    raised("QuadXZ 0 1 0 0", {0, 1, 1, 1}, 2);
    raised("QuadBox 0", {1}, 1);
    raised("Xarrow 1", {2}, 1);
    raised("PointCloud 0 1 1", {1, 1, 1}, 1);
}

TEST(Arguments, SubdivisionBeyondTheLimitIsRefused) {
    for (const char* text : {"Sphere 1 65537", "Sphere 1 3 65537", "Torus 1 .5 3 1e9", "QuadXY 0 1 65537",
                             "Xarrow 1e30", "PointCloud 65537 1 1", "QuadBox 2097153"})
        EXPECT_EQ(idsOf(text), Ids{"glib-E15"}) << text;
    EXPECT_TRUE(idsOf("Sphere 1 65536 3").empty());
}

TEST(Defaults, AreThoseOfTheLanguage) {
    const auto check = [](std::string_view text, const Numbers& numbers) {
        EXPECT_EQ(numbersOf(text), numbers) << text;
        EXPECT_TRUE(idsOf(text).empty()) << text;
    };
    check("WindowSize", {600, 600});
    check("WindowSize 800", {800, 600});
    check("Perspective", {50, .1, 1000});
    check("Persp 70", {70, .1, 1000});
    check("Ortho", {-3, 3, -3, 3, -1000, 1000});
    check("Ortho -1 1 -2 2", {-1, 1, -2, 2, -1000, 1000});
    check("Background", {18 / 255., 27 / 255., 33 / 255., 1});
    check("Box", {2, 2, 2});
    check("Cube 1 2", {1, 2, 2});
    check("Sphere", {1, 60, 60});
    check("Cylinder", {1, 1, 60, 20});
    check("Cone", {1, 1, 60, 20});
    check("Torus", {1, .5, 20, 40});
    check("Teapot", {16});
    check("Soccerball", {1});
    check("DiskXY", {0, 1, 60, 10});
    check("QuadXY", {0, 1, 4, 4});
    check("QuadXZ", {0, 1, 4, 4});
    check("QuadYZ", {0, 1, 4, 4});
    check("QuadBox", {10});
    check("Xarrow", {100});
    check("PointCloud", {10, 10, 10});
    check("JitterCloud", {10, 10, 10, 0});
    check("WireSphere", {1, 20, 20});
    check("WireTorus", {1, .5, 20, 40});
    check("WireCylinder", {1, 1, 20, 5});
    check("WireCone", {1, 1, 20, 5});
    check("WireCube", {1});
    check("WireBox", {2, 2, 2});
    check("PointSizeMode", {1});
    check("Noise2D", {64});
    check("Noise3D", {64});
    check("Timer", {10});
    check("Clamp", {1});
    check("RenderToTexture", {});
    check("GeometryVerticesOut", {});
    check("glColor 1 0 0", {1, 0, 0, 1});
    check("glTexCoord .5", {.5, 0, 0, 1});
}

TEST(WindowSize, MustLieInItsRange) {
    EXPECT_EQ(idsOf("WindowSize 0 600"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("WindowSize 600 16385"), Ids{"glib-E05"});
    EXPECT_TRUE(idsOf("WindowSize 1 16384").empty());
}

TEST(Perspective, AngleNearAndFarMustFit) {
    EXPECT_EQ(idsOf("Perspective 0"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("Perspective 180"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("Perspective 50 0 10"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("Perspective 50 10 10"), Ids{"glib-E29"});
    EXPECT_EQ(idsOf("Perspective 50 2000"), Ids{"glib-E29"});
    EXPECT_TRUE(idsOf("Perspective 179.9 .001 1e6").empty());
}

TEST(Ortho, IncompleteListsAreFilledWithAWarning) {
    EXPECT_EQ(numbersOf("Ortho -1"), (Numbers{-1, 3, -3, 3, -1000, 1000}));
    for (const char* text : {"Ortho -1", "Ortho -1 1", "Ortho -1 1 -1", "Ortho -1 1 -1 1 -5"})
        EXPECT_EQ(idsOf(text), Ids{"glib-W06"}) << text;
}

TEST(Ortho, EqualLimitsBecomeOne) {
    EXPECT_EQ(numbersOf("Ortho 0 0 0 0"), (Numbers{-1, 1, -1, 1, -1000, 1000}));
    EXPECT_EQ(idsOf("Ortho 0 0 0 0"), (Ids{"glib-W29", "glib-W29"}));
    EXPECT_TRUE(idsOf("Ortho 3 -3 3 -3").empty());
}

TEST(Ortho, EqualNearAndFarAreRefused) {
    EXPECT_EQ(idsOf("Ortho -1 1 -1 1 5 5"), Ids{"glib-E29"});
}

TEST(Color, OneNumberIsGreyTwoLackBlue) {
    EXPECT_EQ(numbersOf("Color .5"), (Numbers{.5, .5, .5, 1}));
    EXPECT_EQ(idsOf("Color .5"), Ids{"glib-W06"});
    EXPECT_EQ(numbersOf("Colour .5 1"), (Numbers{.5, 1, 0, 1}));
    EXPECT_EQ(idsOf("Color .5 1"), Ids{"glib-W06"});
    EXPECT_EQ(idsOf("Color"), Ids{"glib-E04"});
    EXPECT_EQ(numbersOf("Color 1 .5 0 .25"), (Numbers{1, .5, 0, .25}));
}

TEST(Color, ComponentsOutsideTheRangeAreKept) {
    EXPECT_EQ(numbersOf("Color -1 2 0"), (Numbers{-1, 2, 0, 1}));
    EXPECT_EQ(idsOf("Color -1 2 0"), (Ids{"glib-W26", "glib-W26"}));
}

TEST(Background, OneNumberIsGreyInSilence) {
    EXPECT_EQ(numbersOf("Background 1"), (Numbers{1, 1, 1, 1}));
    EXPECT_TRUE(idsOf("Background 1").empty());
    EXPECT_EQ(numbersOf("Background 1 .5"), (Numbers{1, .5, 0, 1}));
    EXPECT_EQ(idsOf("Background 1 .5"), Ids{"glib-W06"});
    EXPECT_EQ(idsOf("Background 0 0 2"), Ids{"glib-W26"});
}

TEST(Translate, MissingNumbersAreZero) {
    EXPECT_EQ(numbersOf("Translate 1 2"), (Numbers{1, 2, 0}));
    EXPECT_EQ(idsOf("Translate 1 2"), Ids{"glib-W06"});
    EXPECT_EQ(numbersOf("Translate"), (Numbers{0, 0, 0}));
    EXPECT_EQ(idsOf("Translate"), Ids{"glib-W06"});
}

TEST(Rotate, NeedsAnAngleAndWarnsOfAZeroAxis) {
    EXPECT_EQ(idsOf("Rotate"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("Rotate 90 1"), Ids{"glib-W06"});
    EXPECT_EQ(numbersOf("Rotate 90 1"), (Numbers{90, 1, 0, 0}));
    EXPECT_EQ(idsOf("Rotate 90 0 0 0"), Ids{"glib-W42"});
    EXPECT_EQ(numbersOf("Rotate 90 0 0 0").size(), 4U);
}

TEST(Scale, TakesOneOrThreeFactors) {
    EXPECT_EQ(numbersOf("Scale 2"), (Numbers{2, 2, 2}));
    EXPECT_TRUE(idsOf("Scale 2").empty());
    EXPECT_EQ(numbersOf("Scale 2 3"), (Numbers{2, 3, 1}));
    EXPECT_EQ(idsOf("Scale 2 3"), Ids{"glib-W06"});
    EXPECT_EQ(numbersOf("Scale 1 0 -1"), (Numbers{1, 0, -1}));
    EXPECT_EQ(idsOf("Scale 1 0 -1"), Ids{"glib-W42"});
    EXPECT_EQ(idsOf("Scale"), Ids{"glib-E04"});
}

TEST(Box, OneNumberIsUsedForAllSides) {
    EXPECT_EQ(numbersOf("Box 3"), (Numbers{3, 3, 3}));
    EXPECT_TRUE(idsOf("Box 3").empty());
}

TEST(GlVertex, HasThreeOrFourNumbers) {
    EXPECT_EQ(numbersOf("glVertex 1 2 3"), (Numbers{1, 2, 3}));
    EXPECT_EQ(numbersOf("glVertex 1 2 3 4"), (Numbers{1, 2, 3, 4}));
    EXPECT_EQ(numbersOf("glVertex 1 2"), (Numbers{1, 2, 0}));
    EXPECT_EQ(idsOf("glVertex 1 2"), Ids{"glib-W06"});
    EXPECT_EQ(idsOf("glVertex 1"), Ids{"glib-E04"});
}

TEST(Pixels, MustBePositive) {
    EXPECT_EQ(idsOf("LineWidth 0"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("PointSize -1"), Ids{"glib-E05"});
    EXPECT_TRUE(idsOf("LineWidth 300\nPointSize .5").empty());
}

TEST(PointSizeMode, TakesAnyInteger) {
    EXPECT_EQ(numbersOf("PointSizeMode 0"), Numbers{0});
    EXPECT_EQ(numbersOf("PointSizeMode -3"), Numbers{-3});
    EXPECT_EQ(idsOf("PointSizeMode 1e12"), Ids{"glib-E05"});
}

TEST(NumPatchVertices, MustLieInItsRange) {
    EXPECT_EQ(idsOf("NumPatchVertices 0"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("NumPatchVertices 33"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("NumPatchVertices"), Ids{"glib-E04"});
    EXPECT_EQ(numbersOf("NumPatchVertices 16"), Numbers{16});
}

TEST(Noise, SizesMustLieInTheirRanges) {
    EXPECT_TRUE(idsOf("Noise2D 4\nNoise2D 4096\nNoise3D 4\nNoise3D 400").empty());
    for (const char* text : {"Noise2D 3", "Noise2D 4097", "Noise3D 3", "Noise3D 401"})
        EXPECT_EQ(idsOf(text), Ids{"glib-E05"}) << text;
}

TEST(Timer, MustBePositiveAndWithinItsLimits) {
    EXPECT_EQ(idsOf("Timer 0"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("Timer -5"), Ids{"glib-E05"});
    EXPECT_EQ(idsOf("Timer 1e7"), Ids{"glib-E15"});
    EXPECT_EQ(idsOf("Timer 1e-4"), Ids{"glib-E15"});
    EXPECT_TRUE(idsOf("Timer 1e-3\nTimer 1e6").empty());
}

TEST(GeometryVerticesOut, MustBeAtLeastOne) {
    EXPECT_EQ(numbersOf("GeometryVerticesOut 32"), Numbers{32});
    EXPECT_EQ(idsOf("GeometryVerticesOut 0"), Ids{"glib-E05"});
}

TEST(JitterCloud, SeedIsAnyUnsignedOrSignedInteger) {
    EXPECT_EQ(numbersOf("JitterCloud 2 2 2 4294967295"), (Numbers{2, 2, 2, 4294967295.}));
    EXPECT_EQ(idsOf("JitterCloud 2 2 2 4294967296"), Ids{"glib-E05"});
}

TEST(Messages, TextIsRaw) {
    EXPECT_EQ(textOf("MessageBox Move the Scene Back # not a comment"),
              "Move the Scene Back # not a comment");
    EXPECT_EQ(textOf("messagebox"), "");
    EXPECT_EQ(read("MessageBox  hello").commands.at(0).textPosition().column, 13);
}

TEST(Commands, WithoutEffectAreAccepted) {
    EXPECT_TRUE(idsOf("GSTAP\ngstap.h\nVerbose\nFlat\nSmooth\nClear").empty());
    EXPECT_EQ(read("gstap.h").commands.at(0).id, CommandId::gstap);
}

}  // namespace
}  // namespace glibra::glib::test
