// Passes with reversed depth: the same pictures as without it, but for what only they tell apart.

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "scene_text.h"
#include "script_problems.h"

namespace glibra::test {
namespace {

constexpr const char* kView =
    "WindowSize 96 64\nCamera eye LookAt 3 2 6  0 0 0  0 1 0  Perspective 50 .1 100\n";

/// `scene` with REVERSED in its passes, or without it.
std::string withDepth(std::string scene, bool isReversed) {
    for (std::size_t at = 0; (at = scene.find("REVERSED")) != std::string::npos;)
        scene.replace(at, 8, isReversed ? "reversed" : "");
    return kView + scene;
}

int differingPixels(const Picture& a, const Picture& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) count += pixel(a, x, y) != pixel(b, x, y) ? 1 : 0;
    return count;
}

/// Each draws surfaces that hide one another, and leaves both a hidden and a visible part.
const std::vector<std::pair<const char*, std::string>> kScenes{
    {"Plain",
     "Pass window REVERSED\nColor 1 0 0\nSphere 1\nColor 0 1 0\nBox 1.6\nColor 0 0 1\n"
     "Torus .4 1.6\nEndPass\n"},
    {"Compare",
     "Pass window REVERSED clear {0 0 0} depth 0\nState depth greater\nColor 1 0 0\nSphere 1\n"
     "Color 0 1 0\nBox 1.6\nState depth lequal\nColor 0 0 1\nTorus .4 1.6\nEndPass\n"},
    {"ClearDepth",
     "Pass window REVERSED clear {0 0 0} depth .984\nColor 1 0 0\nSphere 1\nBox 1.6\nEndPass\n"},
    {"ClearAgain",
     "Pass window REVERSED\nColor 1 0 0\nBox 1.6\nClear depth\nColor 0 1 0\nSphere .9\nEndPass\n"},
    {"DepthRange",
     "Pass window REVERSED\nState depthrange .5 1\nColor 1 0 0\nBox 1.6\nState depthrange 0 .5\n"
     "Color 0 1 0\nSphere .4\nState depthrange 1 .9\nColor 0 0 1\nTorus .4 1.6\nEndPass\n"},
    {"Offset",
     "Pass window REVERSED\nState offset 3 0\nColor 1 0 0\nBox 1.6\nState offset 6 0\nColor 0 1 0\nBox 1.6\n"
     "State offset 0 0\nColor 0 0 1\nSphere .9\nEndPass\n"},
    {"Stencil",
     "Pass window REVERSED\nColor 1 0 0\nBox 1.6\nState mark 1\nColor 0 1 0\nSphere 1\nState default\n"
     "State where 1  depth always\nColor 0 0 1\nTorus .4 1.6\nEndPass\n"},
    {"Passes",
     "Pass window REVERSED\nColor 1 0 0\nBox 1.6\nEndPass\nPass window REVERSED keep\nColor 0 1 0\n"
     "Sphere 1\nEndPass\nPass window REVERSED keep color\nColor 0 0 1\nSphere .3\nEndPass\n"},
    {"LinesAndPoints",
     "Pass window REVERSED\nColor 1 0 0\nBox 1.6\nColor 0 1 0\nPointSize 5\nglBegin points\n"
     "glVertex 1.2 1.2 1.2\nglVertex 0 0 0\nglEnd\nState polygon line\nTorus .4 1.6\nEndPass\n"},
    {"Sky", "Pass window REVERSED\nColor 1 0 0\nBox 1.6\nColor 0 1 0\nSkyBox\nEndPass\n"},
    {"Clamped",
     "Pass window REVERSED\nState depthclamp on\nColor 1 0 0\nBox 1.6\nColor 0 1 0\nTranslate 0 0 -200\n"
     "Sphere 60\nEndPass\n"},
    {"FullScreen",
     "Pass window REVERSED\nColor 1 0 0\nState depthrange .2 .4\nBox 1.6\nState depthrange .6 .8\n"
     "Sphere 1.3\nEndPass\nFragment inline\n#version 330\nout vec4 c;\nvoid main() { c = vec4(1., 1., 0., "
     "1.); }\nEndFragment\nProgram Cover\nPass window REVERSED keep\nFullScreen\nEndPass\n"},
    {"Texture",
     "Texture2D color 96 64 rgba8\nPass color REVERSED\nColor 1 0 0\nBox 1.6\nColor 0 1 0\nSphere "
     "1\nEndPass\n"
     "Fragment inline\n#version 330\nin vec2 vST;\nout vec4 c;\nuniform sampler2D color;\n"
     "void main() { c = texture(color, vST); }\nEndFragment\nProgram Show color color\n"
     "Fill window with Show\n"},
    {"Once",
     "Texture2D color 96 64 rgba8\nOnce\nPass color REVERSED\nColor 1 0 0\nBox 1.6\nColor 0 1 0\nSphere 1\n"
     "EndPass\nEndOnce\nFragment inline\n#version 330\nin vec2 vST;\nout vec4 c;\nuniform sampler2D color;\n"
     "void main() { c = texture(color, vST); }\nEndFragment\nProgram Show color color\n"
     "Fill window with Show\n"},
    {"Samples",
     "Texture2D color 96 64 rgba8 samples 4\nTexture2D depth 96 64 depth32f samples 4\n"
     "Pass color depth REVERSED\nColor 1 0 0\nBox 1.6\nColor 0 1 0\nSphere 1\nEndPass\n"
     "Fragment inline\n#version 330\nin vec2 vST;\nout vec4 c;\nuniform sampler2D color;\n"
     "void main() { c = texture(color, vST); }\nEndFragment\nProgram Show color color\n"
     "Fill window with Show\n"},
};

class ReversedDepth : public testing::TestWithParam<std::size_t> {};

/// A driver may round depths otherwise where surfaces meet.
constexpr int kMostPixels = 12;

TEST_P(ReversedDepth, DrawsTheSamePicture) {
    const std::string& scene = kScenes[GetParam()].second;
    const Picture usual = picture(withDepth(scene, false));
    EXPECT_GT(countPixels(usual, pixel(usual, 48, 32)), 20);
    EXPECT_LE(differingPixels(usual, picture(withDepth(scene, true))), kMostPixels);
    RenderOptions tiled;
    tiled.tileSize = 32;
    EXPECT_LE(differingPixels(usual, picture(withDepth(scene, true), {}, tiled)), kMostPixels) << "in tiles";
    RenderOptions whole;
    whole.skip = false;
    EXPECT_LE(differingPixels(usual, picture(withDepth(scene, true), {}, whole)), kMostPixels)
        << "skips nothing";
    RenderOptions smooth;
    smooth.samples = 4;
    EXPECT_LE(differingPixels(picture(withDepth(scene, false), {}, smooth),
                              picture(withDepth(scene, true), {}, smooth)),
              2 * kMostPixels);
}

TEST_P(ReversedDepth, HasAxesThatTheSceneHides) {
    const std::string& scene = kScenes[GetParam()].second;
    RenderOptions axes;
    axes.axes = true;
    EXPECT_LE(differingPixels(picture(withDepth(scene, false), {}, axes),
                              picture(withDepth(scene, true), {}, axes)),
              kMostPixels);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReversedDepth, testing::Range(std::size_t{0}, kScenes.size()),
                         [](const testing::TestParamInfo<std::size_t>& index) {
                             return kScenes[index.param].first;
                         });

/// A green square a thousandth of the distance in front of a red one, which is drawn after it.
std::string farAway(const std::string& words) {
    return "WindowSize 32 32\nCamera eye LookAt 0 0 0  0 0 -1  0 1 0  Perspective 50 .01 1e6\nPass window " +
           words +
           "\nColor 0 1 0\nGroup\nTranslate 0 0 -99900\nScale 1e5 1e5 1\nQuadXY 0 1\nEndGroup\n"
           "Color 1 0 0\nTranslate 0 0 -100000\nScale 1e5 1e5 1\nQuadXY 0 1\nEndPass\n";
}

constexpr std::array<int, 3> kGreen{0, 255, 0};

TEST(FarAway, SurfacesAreToldApartByReversedDepthAlone) {
    EXPECT_LT(countPixels(picture(farAway("")), kGreen), 32 * 32);
    EXPECT_EQ(countPixels(picture(farAway("reversed")), kGreen), 32 * 32);
    EXPECT_NE(problemsOf(farAway("")).find("draw-W19"), std::string::npos);
    EXPECT_EQ(problemsOf(farAway("reversed")).find("draw-W"), std::string::npos);
}

TEST(FarAway, MatricesByNameAreMirrored) {
    const std::string program =
        "Vertex inline\n#version 330\nin vec3 vertPos;\nuniform mat4 mv_matrix, proj_matrix;\nvoid main() { "
        "gl_Position = proj_matrix * (mv_matrix * vec4(vertPos, 1.)); }\nEndVertex\nFragment "
        "inline\n#version "
        "330\nout vec4 c;\nuniform vec4 tone;\nvoid main() { c = tone; }\nEndFragment\nProgram P\n";
    std::string scene = farAway("reversed");
    const auto set = [&](const std::string& from, const std::string& to) {
        scene.replace(scene.find(from), from.size(), to);
    };
    set("Color 0 1 0", "Set tone [0 1 0 1]");
    set("Color 1 0 0", "Set tone [1 0 0 1]");
    set("Pass window", program + "Pass window");
    EXPECT_EQ(countPixels(picture(scene), kGreen), 32 * 32);
}

/// The depth of a square half way between the planes of a box, in a texture.
std::string depthAt(const std::string& words, const std::string& check) {
    return "WindowSize 8 8\nCamera eye LookAt 0 0 0  0 0 -1  0 1 0  Ortho -1 1 -1 1 0 4\n"
           "Texture2D depth 8 8 depth32f nearest\nPass depth " +
           words + "\nTranslate 0 0 -1\nQuadXY 0 1\nEndPass\n" + check;
}

TEST(ReversedDepthTexture, HoldsOneMinusTheDepth) {
    EXPECT_EQ(problemsOf(depthAt("", "Expect range depth .2499 .2501\n")), "");
    EXPECT_EQ(problemsOf(depthAt("reversed", "Expect range depth .7499 .7501\n")), "");
}

/// A wall in the shadow of a square, by a map with this depth and comparison.
std::string shadowed(const std::string& words, const std::string& compare) {
    return "WindowSize 32 32\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 50 .1 100\n"
           "Camera light LookAt 0 0 4  0 0 0  0 1 0  Perspective 60 .1 50 aspect 1\n"
           "Texture2D map 256 256 depth32f compare " +
           compare + " nearest clamp\nPass map from light " + words +
           "\nTranslate 0 0 1\nQuadXY 0 .5\nEndPass\n"
           "Vertex inline\n#version 330\nin vec4 vertPos;\nuniform mat4 mvp, uLight;\nout vec4 at;\nvoid "
           "main() { at = uLight * vertPos; gl_Position = mvp * vertPos; }\nEndVertex\nFragment inline\n"
           "#version 330\nin vec4 at;\nuniform sampler2DShadow map;\nuniform float uMirrored;\nout vec4 c;\n"
           "void main() { vec3 p = at.xyz / at.w;\np.z = uMirrored > 0. ? 1. - p.z + .002 : p.z - .002;\n"
           "c = vec4(vec3(texture(map, p)), 1.); }\nEndFragment\n"
           "Program Lit map map  uLight (light.shadow)  uMirrored " +
           (words.empty() ? "0" : "1") + "\nPass window\nQuadXY 0 2\nEndPass\n";
}

TEST(ReversedDepthTexture, IsAShadowMapThatComparesGreater) {
    const Picture usual = picture(shadowed("", "lequal"));
    EXPECT_GT(countPixels(usual, {0, 0, 0}), 20);
    EXPECT_GT(countPixels(usual, kWhite), 20);
    EXPECT_LE(differingPixels(usual, picture(shadowed("reversed", "greater"))), 4);
}

}  // namespace
}  // namespace glibra::test
