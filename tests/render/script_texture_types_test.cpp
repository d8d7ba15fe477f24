// Arrays of 1D textures, rectangles and arrays of multisampled textures (language, 12.4).

#include <gtest/gtest.h>

#include <string>

#include "modern_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

/// A program of that name with this fragment stage, whose coordinates are `vST`.
std::string programOf(const std::string& name, const std::string& declarations, const std::string& value) {
    return "Fragment inline\n#version 410 core\nin vec2 vST;\nout vec4 c;\n" + declarations +
           "\nvoid main() { c = " + value + "; }\nEndFragment\nProgram " + name + "\n";
}
/// Shows this value in a window of 8 x 4 pixels.
std::string shown(const std::string& declarations, const std::string& value) {
    return programOf("Show", declarations, value) + "Fill window with Show\n";
}
const std::string kEightByFour = "WindowSize 8 4\n";

/// The messages of a scene that is refused must have this text.
void expectRefusal(const std::string& scene, const std::string& message) {
    const std::string refused = refusalOf(kEightByFour + scene + "\n");
    EXPECT_NE(refused.find(message), std::string::npos) << scene << "\n" << refused;
}

// ---- Arrays of 1D textures.

TEST(Script1DArrays, EachLayerIsDrawnAndReadAlone) {
    EXPECT_EQ(problemsOf(kEightByFour + "Texture1DArray ramps 8 3 rgba8 nearest clamp\n" +
                         programOf("Ramp", "uniform float uBlue;", "vec4(vST.x, 1. - vST.x, uBlue, 1)") + R"(
Repeat 3 as n
    Fill ramps.layer(n) with Ramp uBlue (n/2)
EndRepeat
)" + shown("uniform sampler1DArray ramps;", "texture(ramps, vec2(vST.x, 2. * vST.y))") +
                         R"(
Expect pixel 0 0 [.0625 .9375 0] within .003
Expect pixel 7 0 [.9375 .0625 0] within .003
Expect pixel 3 1 [.4375 .5625 .5] within .003
Expect pixel 3 3 [.4375 .5625 1] within .003
Expect mean 0 0 8 1 [.5 .5 .5] of ramps.layer(1) within .003
Expect sum ramps [12 12 12 24] within .1
Expect (ramps.size == vec2(8, 3))
)"),
              "");
}

TEST(Script1DArrays, TheGeometryStageChoosesTheLayer) {
    EXPECT_EQ(problemsOf(kEightByFour + "Texture1DArray ramps 8 4 rgba8\n" +
                         coveringLayers(4, "vec4(vLayer / 3., gl_FragCoord.x / 8., 0, 1)") + R"(
Pass ramps
    Use Layers
    Vertices points 1
EndPass
Expect pixel 0 0 [0 .0625] of ramps within .003
Expect mean 0 0 8 1 [.3333 .5] of ramps.layer(1) within .003
Expect mean 0 0 8 1 [1 .5] of ramps.layer(3) within .003
)"),
              "");
}

TEST(Script1DArrays, HaveLevelsHistoryAndDepth) {
    EXPECT_EQ(problemsOf(kEightByFour + R"(Texture1DArray ramps 8 2 rgba8 mipmap generate
Pass ramps.layer(1) clear {1 .5 0 1}
EndPass
)" + shown("uniform sampler1DArray ramps;", "textureLod(ramps, vec2(.5, vST.y), 3.)") +
                         "Expect pixel 0 0 [0 0 0]\nExpect pixel 0 3 [1 .5 0] within .003\n"
                         "Expect pixel 0 0 [1 .5 0] of ramps.layer(1).level(3) within .003\n"),
              "");
    EXPECT_EQ(problemsOf(kEightByFour + "Texture1DArray count 4 2 r32f history\n" +
                         programOf("More", "uniform sampler1DArray uOld;",
                                   "vec4(texelFetch(uOld, ivec2(0, 1), 0).r + 1.)") +
                         R"(
Step 1
    Fill count.layer(1) with More uOld count.prev
EndStep
Expect mean 0 0 4 1 [3] of count.layer(1) at 3
)"),
              "");
    EXPECT_EQ(problemsOf(kEightByFour + R"(Texture1DArray far 4 2 depth32f
Pass far.layer(1) clear depth .5
EndPass
)" + shown("uniform sampler1DArrayShadow far;", "vec4(texture(far, vec3(.5, 1, vST.x)))") +
                         "Expect pixel 1 1 [1]\nExpect pixel 6 1 [0]\n"),
              "");
}

TEST(Script1DArrays, HoldIntegersAndAreImages) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs compute stages";
    EXPECT_EQ(
        problemsOf(
            kEightByFour + R"(Texture1DArray codes 8 3 r32ui
Texture1DArray plain 8 2 rgba8
Compute inline
#version 430
layout(local_size_x = 8) in;
layout(r32ui) uniform uimage1DArray uCodes;
layout(rgba8) uniform image1D uRow;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(uCodes, at, uvec4(10 * at.y + at.x));
    imageStore(uRow, at.x, vec4(float(at.x) / 7.));
}
EndCompute
Program Number uCodes codes uRow plain.layer(1)
Dispatch Number over codes
)" +
            programOf("Show", "uniform usampler1DArray codes;\nuniform sampler1D row;",
                      "vec4(float(texture(codes, vec2(vST.x, 2)).r) / 27., texture(row, vST.x).r, 0, 1)") +
            R"(
Fill window with Show row plain.layer(1)
Expect sum codes 324
Expect pixel 7 0 [1 1]
Expect sum plain [4 4 4 4] within .02
)"),
        "");
}

TEST(Script1DArrays, ArePicturesByTheirBottomRows) {
    const std::map<std::string, std::string> files{{"red.bmp", bmp(5, 1, std::string("\0\0\377", 3))},
                                                   {"green.bmp", bmp(5, 1, std::string("\0\377\0", 3))},
                                                   {"high.bmp", bmp(5, 3, std::string("\377\0\0", 3))},
                                                   {"wide.bmp", bmp(6, 1, std::string("\377\0\0", 3))}};
    const std::string show = shown("uniform sampler1DArray rows;", "texture(rows, vec2(vST.x, 2. * vST.y))");
    EXPECT_EQ(problemsOf(kEightByFour + "Texture1DArray rows red.bmp green.bmp nearest\n" + show +
                             "Expect pixel 1 0 [1 0 0]\nExpect pixel 1 3 [0 1 0]\n"
                             "Expect (rows.size == vec2(5, 2))\n",
                         files),
              "");
    const std::string warned = problemsOf(
        kEightByFour + "Texture1DArray rows red.bmp high.bmp\n" + show + "Expect pixel 1 3 [0 0 1]\n", files);
    EXPECT_NE(warned.find("'high.bmp' is 5 x 3; 1D textures use the bottom row of a picture [file-W08]"),
              std::string::npos)
        << warned;
    EXPECT_EQ(warned.find("error"), std::string::npos) << warned;
    EXPECT_NE(
        problemsOf(kEightByFour + "Texture1DArray rows red.bmp wide.bmp\n" + show, files).find("file-E06"),
        std::string::npos);
}

TEST(Script1DArrays, AreReadByTheirOwnTypes) {
    const std::string scene = "Texture1DArray ramps 8 3 rgba8\n";
    expectRefusal(scene + shown("uniform sampler2D ramps;", "texture(ramps, vST)"),
                  "which is a 1D array of rgba8; write sampler1DArray");
    expectRefusal(scene + programOf("Show", "uniform sampler2D row;", "texture(row, vST)") +
                      "Fill window with Show row ramps.layer(1)",
                  "which is a layer of a 1D array of rgba8; write sampler1D");
    expectRefusal(scene + "Pass ramps.layer(3)\nEndPass", "ramps.layer: 3 is not between 0 and 2");
    expectRefusal("Texture1DArray ramps 8 3000 rgba8", "the size 3000 is not between 1 and 2,048");
    expectRefusal("Texture1DArray ramps 8 3 rgba8 samples 4",
                  "only 2D textures and their arrays have several samples");
    expectRefusal("Texture1DArray ramps 8 3 rgba8 clamp border", "is one wrap mode too many");
}

// ---- Rectangles.

const std::string kPlaces = "vec4(gl_FragCoord.xy / vec2(8, 4), .5, 1)";

TEST(ScriptRectangles, AreReadByTexelCoordinates) {
    EXPECT_EQ(problemsOf(kEightByFour + "TextureRect grid 8 4 rgba8\n" + programOf("Grid", "", kPlaces) +
                         "Fill grid with Grid\n" +
                         shown("uniform sampler2DRect grid;", "texture(grid, gl_FragCoord.xy + vec2(1, 0))") +
                         R"(
Expect pixel 0 0 [.1875 .125 .5] within .003
Expect pixel 5 2 [.8125 .625 .5] within .003
Expect pixel 7 3 [.9375 .875 .5] within .003
Expect mean 0 0 8 4 [.5 .5 .5] of grid within .003
Expect (grid.size == vec2(8, 4))
)"),
              "");
}

TEST(ScriptRectangles, AreClampedByEverySampler) {
    EXPECT_EQ(problemsOf(kEightByFour + R"(TextureRect grid 8 4 rgba8 nearest
Sampler around repeat mipmap
Sampler framed border {0 0 1 1} nearest
)" + programOf("Grid", "", kPlaces) +
                         "Fill grid with Grid\n" +
                         programOf("Show", "uniform sampler2DRect uA, uB;",
                                   "vec4(texture(uA, vec2(20, .5)).r, texture(uB, vec2(20, .5)).rb, 1)") +
                         R"(
Fill window with Show uA grid.around uB grid.framed
Expect pixel 0 0 [.9375 0 1] within .003
)"),
              "");
}

TEST(ScriptRectangles, ArePicturesDepthIntegersAndImages) {
    EXPECT_EQ(problemsOf(kEightByFour + "TextureRect map red.bmp\n" +
                             shown("uniform sampler2DRect map;",
                                   "vec4(texture(map, vec2(4.5, 2.5)).rg, textureSize(map) / 8.)") +
                             "Expect pixel 0 0 [1 0 .625 .375] within .003\n"
                             "Expect (map.size == vec2(5, 3))\n",
                         {{"red.bmp", bmp(5, 3, std::string("\0\0\377", 3))}}),
              "");
    EXPECT_EQ(problemsOf(kEightByFour + R"(TextureRect far 4 4 depth32f
Pass far clear depth .5
EndPass
)" + shown("uniform sampler2DRectShadow far;", "vec4(texture(far, vec3(2, 2, vST.x)))") +
                         "Expect pixel 1 1 [1]\nExpect pixel 6 1 [0]\n"),
              "");
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "images need GL 4.2";
    EXPECT_EQ(problemsOf(kEightByFour + R"(TextureRect codes 8 4 r32i
Compute inline
#version 430
layout(local_size_x = 8) in;
layout(r32i) uniform iimage2DRect uCodes;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(uCodes, at, ivec4(-10 * at.y - at.x));
}
EndCompute
Program Number uCodes codes
Dispatch Number over codes
)" +
                         shown("uniform isampler2DRect codes;",
                               "vec4(float(texelFetch(codes, ivec2(gl_FragCoord.xy)).r) / -37., 0, 0, 1)") +
                         "Expect sum codes -592\nExpect pixel 7 3 [1]\n"),
              "");
}

TEST(ScriptRectangles, HaveHistory) {
    EXPECT_EQ(problemsOf(kEightByFour + "TextureRect count 4 4 r32f history\n" +
                         programOf("More", "uniform sampler2DRect uOld;", "texture(uOld, vec2(1)) + 1.") + R"(
Step 1
    Fill count with More uOld count.prev
EndStep
Expect mean 0 0 4 4 [3] of count at 3
)"),
              "");
}

TEST(ScriptRectangles, HaveOneLevelAndDoNotRepeat) {
    const auto expect = [](const std::string& options, const std::string& message) {
        expectRefusal("TextureRect grid 8 4 rgba8 " + options, message + " [glib-E32]");
    };
    expect("repeat", "'repeat': a rectangle does not repeat; write 'clamp' or 'border'");
    expect("clamp mirror", "'mirror': a rectangle does not repeat; write 'clamp' or 'border'");
    expect("mipmap", "a rectangle has no mipmaps; write 'nearest' or 'linear'");
    expect("generate", "'generate': a rectangle has no mipmaps; write Texture2D");
    expect("levels 2", "'levels': a rectangle has no mipmaps; write Texture2D");
    expect("samples 4", "only 2D textures and their arrays have several samples");
    const std::string scene = "TextureRect grid 8 4 rgba8\n";
    expectRefusal(scene + shown("uniform sampler2D grid;", "texture(grid, vST)"),
                  "which is a rectangle of rgba8; write sampler2DRect");
    expectRefusal(
        "Texture2D plane 8 4 rgba8\n" + shown("uniform sampler2DRect plane;", "texture(plane, vST)"),
        "which is a 2D texture of rgba8; write sampler2D");
    expectRefusal(scene + "Pass grid.layer(0)\nEndPass", "'grid' has no part 'layer'");
    expectRefusal(scene + "Pass grid.level(1)\nEndPass", "is not between 0 and 0");
}

// ---- Arrays of multisampled textures.

/// Fills `soft.layer(1)` with a number per sample, 0, 1, 2 ...
const std::string kNumberedSamples = kEightByFour + "Texture2DArray soft 4 4 3 rgba32f samples 4\n" +
                                     programOf("Number", "", "vec4(float(gl_SampleID), 0, 0, 1)") +
                                     "Fill soft.layer(1) with Number\n";

TEST(ScriptMultisampledArrays, AreReadByMeanAndBySample) {
    EXPECT_EQ(problemsOf(kNumberedSamples +
                         programOf("Show", "uniform sampler2DArray uMean;\nuniform sampler2DMSArray uEach;",
                                   "vec4(texture(uMean, vec3(vST, 1)).r / 3.,\n"
                                   "    texelFetch(uEach, ivec3(2, 2, 1), 3).r / 3.,\n"
                                   "    texelFetch(uEach, ivec3(2, 2, 1), 1).r / 3.,\n"
                                   "    texture(uMean, vec3(vST, 0)).r)") +
                         "Fill window with Show uMean soft uEach soft\n"
                         "Expect pixel 5 2 [.5 1 .3333 0] within .003\n"),
              "");
}

TEST(ScriptMultisampledArrays, LayersAreReadAsMultisampledTextures) {
    if (!sharedContext().capabilities().atLeast(4, 3)) GTEST_SKIP() << "layers alone need GL 4.3";
    EXPECT_EQ(problemsOf(
                  kNumberedSamples +
                  programOf("Show", "uniform sampler2D uMean;\nuniform sampler2DMS uEach;",
                            "vec4(texture(uMean, vST).r / 3., texelFetch(uEach, ivec2(2), 3).r / 3., 0, 1)") +
                  "Fill window with Show uMean soft.layer(1) uEach soft.layer(1)\n"
                  "Expect pixel 5 2 [.5 1] within .003\n"),
              "");
}

TEST(ScriptMultisampledArrays, TheGeometryStageChoosesTheLayer) {
    EXPECT_EQ(problemsOf(kEightByFour + "Texture2DArray soft 4 4 3 rgba8 samples 4\n" +
                         coveringLayers(3, "vec4(vLayer / 2., float(gl_SampleID) / 3., 0, 1)") + R"(
Pass soft
    Use Layers
    Vertices points 1
EndPass
)" + programOf("Show", "uniform sampler2DArray soft;", "texture(soft, vec3(vST, floor(3. * vST.x)))") +
                         R"(
Fill window with Show
Expect pixel 1 2 [0 .5] within .003
Expect pixel 4 2 [.5 .5] within .003
Expect pixel 7 2 [1 .5] within .003
)"),
              "");
}

TEST(ScriptMultisampledArrays, HoldIntegersAndDepth) {
    EXPECT_EQ(problemsOf(kEightByFour + R"(Texture2DArray codes 4 4 2 r32ui samples 4
Texture2DArray far 4 4 2 depth32f samples 4
Pass codes.layer(1) far.layer(0) clear {7} depth .5
EndPass
)" +
                         shown("uniform usampler2DMSArray codes;\nuniform sampler2DMSArray far;",
                               "vec4(float(texelFetch(codes, ivec3(1, 1, 1), 2).r) / 7., texelFetch(far, "
                               "ivec3(1, 1, 0), 2).r, 0, 1)") +
                         "Expect pixel 5 2 [1 .5] within .003\n"),
              "");
}

TEST(ScriptMultisampledArrays, AreReadByTheirOwnTypesWithoutFilters) {
    const std::string soft = "Texture2DArray soft 4 4 3 ";
    expectRefusal(soft + "rgba8 samples 4\n" + shown("uniform sampler2D soft;", "texture(soft, vST)"),
                  "which is a 2D array of rgba8 with 4 samples; write sampler2DArray");
    expectRefusal(
        soft + "rgba8 samples 4\n" + shown("uniform sampler2DMS soft;", "texelFetch(soft, ivec2(0), 0)"),
        "with 4 samples; write sampler2DMSArray");
    expectRefusal(
        soft + "depth24 samples 4\n" + shown("uniform sampler2DArray soft;", "texture(soft, vec3(vST, 0))"),
        "with 4 samples; write sampler2DMSArray");
    expectRefusal(soft + "rgba8 samples 4 linear", "has no levels and is read without a filter");
    expectRefusal(soft + "rgba8 samples 4 levels 2", "has no levels and is read without a filter");
    expectRefusal("CubeMap sky 4 rgba8 layers 2 samples 4",
                  "only 2D textures and their arrays have several samples");
}

}  // namespace
}  // namespace glibra::test
