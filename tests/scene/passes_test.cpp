// Render targets and clears (language, 2.3).

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::idsOf;
using tests::run;
using tests::textsOf;

using Colors = std::vector<std::optional<glm::dvec4>>;
const glm::dvec4 kRed{1, 0, 0, 1};
const glm::dvec4 kGreen{0, 1, 0, 1};
const glm::dvec4 kBlue{0, 0, 1, 1};

TEST(Passes, AnEmptySceneIsTheClearedWindow) {
    const Scene scene = run("Background 1 0 0\nBackground 0 1 0\n");
    ASSERT_EQ(scene.frame.passes.size(), 1U);
    EXPECT_TRUE(scene.frame.passes[0].targets.empty());
    EXPECT_TRUE(scene.frame.passes[0].steps.empty());
    EXPECT_EQ(scene.frame.passes[0].clearColors, Colors{kGreen});
    EXPECT_TRUE(scene.frame.passes[0].clearDepth);
}

TEST(Passes, TheWindowIsClearedToTheBackgroundOfItsFirstDraw) {
    const Scene scene = run("Background 1 0 0\nSphere\nBackground 0 1 0\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 1U);
    EXPECT_EQ(scene.frame.passes[0].clearColors, Colors{kRed});
    EXPECT_EQ(scene.frame.passes[0].steps.size(), 2U);
}

TEST(Passes, OneTexturePassAndTheWindow) {
    const Scene scene =
        run("Background 1 0 0\nTexture2D 6 256 128\nRenderToTexture 6\nClear\nSphere\n"
            "RenderToTexture\nBackground 0 1 0\nClear\nQuadXY\n");
    ASSERT_EQ(scene.frame.passes.size(), 2U);
    const Pass& texture = scene.frame.passes[0];
    ASSERT_EQ(texture.targets.size(), 1U);
    EXPECT_EQ(scene.textures[texture.targets[0]].unit, 6);
    EXPECT_EQ(texture.clearColors, Colors{kRed});
    EXPECT_TRUE(texture.clearDepth);
    EXPECT_NE(texture.depthBuffer, 0);
    EXPECT_EQ(texture.place.line, 3);
    EXPECT_EQ(texture.steps.size(), 1U) << "the first Clear only repeats the implicit one";
    const Pass& window = scene.frame.passes[1];
    EXPECT_TRUE(window.targets.empty());
    EXPECT_EQ(window.clearColors, Colors{kGreen});
    EXPECT_EQ(window.depthBuffer, 0);
    EXPECT_TRUE(window.clearDepth);
}

TEST(Passes, BlendingIsForTheWindowOnly) {
    const auto draws = drawsOf(run("Texture2D 6 8 8\nRenderToTexture 6\nSphere\nRenderToTexture\nSphere\n"));
    EXPECT_FALSE(draws.at(0).raster->blend[0].isOn);
    EXPECT_EQ(draws.at(1).raster->blend[0], base::kBlendOver);
}

TEST(Passes, ALaterClearStaysAStepWithItsOwnColour) {
    const Scene scene = run("Background 1 0 0\nSphere\nBackground 0 0 1\nClear\nSphere\nClear\n");
    ASSERT_EQ(scene.frame.passes.size(), 1U);
    ASSERT_EQ(scene.frame.passes[0].steps.size(), 4U);
    EXPECT_EQ(std::get<Clear>(scene.frame.passes[0].steps[1]).color, kBlue);
    EXPECT_EQ(std::get<Clear>(scene.frame.passes[0].steps[1]).place.line, 4);
    EXPECT_EQ(scene.frame.passes[0].clearColors, Colors{kRed});
}

TEST(Passes, ReturningToAListKeepsItsContent) {
    const Scene scene =
        run("Texture2D 6 8 8\nRenderToTexture 6\nSphere\nRenderToTexture\nSphere\n"
            "RenderToTexture 6\nSphere\nRenderToTexture\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 4U);
    for (const std::size_t again : {2U, 3U}) {
        EXPECT_EQ(scene.frame.passes[again].targets, scene.frame.passes[again - 2].targets);
        EXPECT_EQ(scene.frame.passes[again].depthBuffer, scene.frame.passes[again - 2].depthBuffer);
        EXPECT_EQ(scene.frame.passes[again].clearColors, Colors{std::nullopt});
        EXPECT_FALSE(scene.frame.passes[again].clearDepth);
    }
}

TEST(Passes, AClearInAPassThatKeepsItsContentIsAStep) {
    const Scene scene =
        run("Texture2D 6 8 8\nSphere\nRenderToTexture 6\nSphere\nRenderToTexture\nClear\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 3U);
    ASSERT_EQ(scene.frame.passes[2].steps.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<Clear>(scene.frame.passes[2].steps[0]));
}

TEST(Passes, EachTextureIsClearedOnceWhateverListItIsIn) {
    const Scene scene =
        run("Background 1 0 0\nTexture2D 6 8 8\nTexture2D 7 8 8\nRenderToTexture 6\nSphere\n"
            "Background 0 1 0\nRenderToTexture 6 7\nSphere\nRenderToTexture 7\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 4U);
    EXPECT_EQ(scene.frame.passes[1].clearColors, (Colors{std::nullopt, kGreen}));
    EXPECT_TRUE(scene.frame.passes[1].clearDepth) << "a list of units has its own depth buffer";
    EXPECT_EQ(scene.frame.passes[2].clearColors, Colors{std::nullopt});
    EXPECT_TRUE(scene.frame.passes[2].clearDepth);
    EXPECT_NE(scene.frame.passes[0].depthBuffer, scene.frame.passes[1].depthBuffer);
    EXPECT_NE(scene.frame.passes[1].depthBuffer, scene.frame.passes[2].depthBuffer);
}

TEST(Passes, AClearIsAStepIfOnlyOneOfTheTargetsIsFresh) {
    const Scene scene = run(
        "Texture2D 6 8 8\nTexture2D 7 8 8\nRenderToTexture 6\nSphere\nRenderToTexture 6 7\nClear\nSphere\n");
    EXPECT_EQ(scene.frame.passes.at(1).steps.size(), 2U);
}

TEST(Passes, UnitsInAnotherOrderAreAnotherList) {
    const Scene scene =
        run("Texture2D 6 8 8\nTexture2D 7 8 8\nRenderToTexture 6 7\nSphere\nRenderToTexture 7 6\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 3U);
    EXPECT_EQ(scene.frame.passes[1].targets[0], scene.frame.passes[0].targets[1]);
    EXPECT_NE(scene.frame.passes[1].depthBuffer, scene.frame.passes[0].depthBuffer);
}

TEST(Passes, ATargetThatNothingIsDrawnIntoMakesNoPass) {
    const Scene scene = run("Texture2D 6 8 8\nSphere\nRenderToTexture 6\nRenderToTexture\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 1U);
    EXPECT_EQ(scene.frame.passes[0].steps.size(), 2U);
}

TEST(Passes, AClearAloneIsAPass) {
    const Scene scene =
        run("Background 1 0 0\nTexture2D 6 8 8\nRenderToTexture 6\nClear\nRenderToTexture\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 2U);
    EXPECT_EQ(scene.frame.passes[0].clearColors, Colors{kRed});
    EXPECT_TRUE(scene.frame.passes[0].steps.empty());
}

TEST(Passes, TheWindowPassExistsAfterAFileThatEndsInATexture) {
    const Scene scene = run("Texture2D 6 8 8\nRenderToTexture 6\nSphere\nBackground 0 1 0\n");
    ASSERT_EQ(scene.frame.passes.size(), 2U);
    EXPECT_TRUE(scene.frame.passes[1].targets.empty());
    EXPECT_EQ(scene.frame.passes[1].clearColors, Colors{kGreen});
}

TEST(Passes, ANewTextureOnTheUnitIsANewTargetAndTheOldOneStaysCurrentUntilThen) {
    const Scene scene = run(
        "Texture2D 6 8 8\nRenderToTexture 6\nSphere\nTexture2D 6 8 8\nSphere\nRenderToTexture 6\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 3U);
    EXPECT_EQ(scene.frame.passes[0].steps.size(), 2U);
    EXPECT_NE(scene.frame.passes[1].targets, scene.frame.passes[0].targets);
    EXPECT_TRUE(scene.frame.passes[1].clearColors[0].has_value());
    EXPECT_EQ(scene.frame.passes[1].depthBuffer, scene.frame.passes[0].depthBuffer)
        << "the same list of units";
    EXPECT_FALSE(scene.frame.passes[1].clearDepth);
}

TEST(Passes, ADepthBufferHasTheSizeOfItsTextures) {
    const Scene scene =
        run("Texture2D 6 8 8\nRenderToTexture 6\nSphere\nTexture2D 6 16 16\nRenderToTexture 6\nSphere\n");
    EXPECT_NE(scene.frame.passes.at(1).depthBuffer, scene.frame.passes.at(0).depthBuffer);
    EXPECT_TRUE(scene.frame.passes.at(1).clearDepth);
}

TEST(Passes, TargetsMustBeEmpty2DTexturesOfOneSize) {
    const auto error = [](const std::string& text) { return textsOf(run(text).diagnostics); };
    EXPECT_EQ(error("RenderToTexture 6\n"),
              "1:1 glib-E11 RenderToTexture 6: unit 6 holds no empty 2D texture; write 'Texture2D 6 1024 "
              "1024' first");
    EXPECT_EQ(error("RenderToTexture 2\n"),
              "1:1 glib-E11 RenderToTexture 2: unit 2 holds no empty 2D texture; write 'Texture2D 2 1024 "
              "1024' first");
    EXPECT_EQ(idsOf(run("Texture2D 6 a.bmp\nRenderToTexture 6\n").diagnostics), "glib-E11");
    EXPECT_EQ(idsOf(run("Texture3D 6 8 8 8\nRenderToTexture 6\n").diagnostics), "glib-E11");
    EXPECT_EQ(idsOf(run("Texture1D 6 8\nRenderToTexture 6\n").diagnostics), "glib-E11");
    EXPECT_EQ(
        error("Texture2D 6 8 8\nTexture2D 7 8 9\nRenderToTexture 6 7\n"),
        "3:1 glib-E11 RenderToTexture 6 7: unit 6 is 8 x 8, unit 7 is 8 x 9; all must have the same size");
    EXPECT_EQ(idsOf(run("Texture2D 6 8 8\nRenderToTexture 6 6\n").diagnostics), "glib-E11");
}

TEST(Passes, AFaultyRenderToTextureKeepsTheTarget) {
    const Scene scene = run("Texture2D 6 8 8\nRenderToTexture 6\nSphere\nRenderToTexture 9\nSphere\n");
    ASSERT_EQ(scene.frame.passes.size(), 2U);
    EXPECT_EQ(scene.frame.passes[0].steps.size(), 2U);
}

TEST(Passes, FormatsOfTargetsMayDiffer) {
    const Scene scene = run("Texture2D 6 8 8\nTexture2D 7 8 8 RGBA32F\nRenderToTexture 6 7\nSphere\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "");
    EXPECT_EQ(scene.frame.passes.at(0).targets.size(), 2U);
}

TEST(Passes, NeitherMatrixNorProjectionChangesWithTheTarget) {
    const auto draws =
        drawsOf(run("Ortho\nTranslate 1 2 3\nTexture2D 6 8 8\nSphere\nRenderToTexture 6\nSphere\n"));
    EXPECT_EQ(draws.at(0).modelView, draws.at(1).modelView);
    EXPECT_EQ(draws.at(0).projection->index(), draws.at(1).projection->index());
}

TEST(Passes, MayBeReversed) {
    const Scene scene =
        run("Texture2D a 8 8 rgba8\nPass a from eye reversed clear {0} depth .25\nSphere\nFullScreen\n"
            "EndPass\nPass window\nSphere\nEndPass\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    ASSERT_EQ(scene.frame.passes.size(), 2U);
    EXPECT_TRUE(scene.frame.passes[0].isReversed);
    EXPECT_EQ(scene.frame.passes[0].depthValue, .25);
    EXPECT_FALSE(scene.frame.passes[1].isReversed);
    EXPECT_FALSE(scene.reversesWindow);
    using base::DepthOrder;
    const auto draws = drawsOf(scene);
    EXPECT_EQ(draws.at(0).raster->depthOrder, DepthOrder::reversed);
    EXPECT_EQ(draws.at(1).raster->depthOrder, DepthOrder::reversedCover);
    EXPECT_EQ(draws.at(2).raster->depthOrder, DepthOrder::usual);
    EXPECT_TRUE(run("Let far <true>\nWhen (!far)\nPass window reversed\nEndPass\nElse\nSphere\nEndWhen\n")
                    .reversesWindow)
        << "a value of the variable changes that";
}

TEST(Passes, IntoOneDepthAreAllReversedOrNone) {
    const auto error = [](const std::string& text) { return textsOf(run(text).diagnostics); };
    EXPECT_EQ(error("Sphere\nPass window reversed\nEndPass\n"),
              "2:1 glib-E11 the window is drawn into with reversed depth here and with the usual depth on "
              "line 1; all "
              "passes into one depth are reversed, or none is");
    EXPECT_EQ(error("Pass window reversed\nEndPass\nSphere\n"),
              "3:1 glib-E11 the window is drawn into with the usual depth here and with reversed depth on "
              "line 1; all "
              "passes into one depth are reversed, or none is");
    EXPECT_EQ(
        idsOf(run("Texture2D a 8 8 rgba8\nPass a\nEndPass\nPass a reversed keep\nEndPass\n").diagnostics),
        "glib-E11");
    EXPECT_EQ(
        idsOf(run("Texture2D d 8 8 depth32f\nTexture2D a 8 8 rgba8\nPass a d reversed\nEndPass\nPass d\n"
                  "EndPass\n")
                  .diagnostics),
        "glib-E11");
    EXPECT_EQ(
        error("Texture2D d 8 8 depth24\nPass d reversed\nEndPass\n"),
        "2:8 glib-E11 Pass: reversed depth needs floats, but 'd' is depth24; its format must be depth32f or "
        "depth32f_stencil8");
    EXPECT_EQ(
        error("Texture2D d 8 8 depth32f_stencil8\nPass d reversed\nEndPass\nPass window\nSphere\nEndPass\n"),
        "");
}

}  // namespace
}  // namespace glibra::scene
