// The skip rules, one by one: the GL calls, bytes and opened files that each saves, with a picture that is
// the same bit for bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "render/check/scene_check.h"
#include "render/file/job.h"
#include "render/scene_renderer.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

using Words = std::vector<std::string>;

const std::string kVertex =
    "#version 330 core\nout vec3 vST;\nvoid main() { vST = aTexCoord0.stp; gl_Position = "
    "uModelViewProjectionMatrix * aVertex; }\n";
std::string fragment(const std::string& declarations, const std::string& color) {
    return "#version 330 core\nin vec3 vST;\nout vec4 fColor;\n" + declarations +
           "void main() { fColor = vec4(" + color + ", 1.); }\n";
}
/// A raw texture of 2 x 2 texels: its sizes, then four bytes per texel.
std::string rawTexture(unsigned char value) {
    const std::string bytes{2, 0, 0, 0, 2, 0, 0, 0};
    return bytes + std::string(16, static_cast<char>(value));
}
const std::map<std::string, std::string> kSkipFiles{
    {"a.vert", kVertex},
    {"plain.frag", fragment("", "vST.st, 0.")},
    {"red.frag", fragment("", "1., 0., 0.")},
    {"noise.frag", fragment("", "texture(Noise3, vST).rgb")},
    {"tex.frag", fragment("uniform sampler2D uTex;\n", "texture(uTex, vST.st).rgb")},
    {"five.tex", rawTexture(200)},
    {"six.tex", rawTexture(90)}};

const std::string kSkipStart =
    "WindowSize 64 48\nBackground .1 .2 .3\nLookAt 0 0 4  0 0 0  0 1 0\nVertex a.vert\n";
std::string program(const std::string& name, const std::string& pairs = {}) {
    return "Fragment " + name + ".frag\nProgram " + name + " " + pairs + "\n";
}
SceneFolder sceneOf(const std::string& text) {
    return SceneFolder(kSkipStart + text, kSkipFiles);
}
bool opened(const Drawing& run, const std::string& file) {
    return run.opened.contains(file);
}

TEST(SkipRule, NoNoiseTextureUnlessAnActiveUniformSamplesIt) {
    const BothWays pair = drawBothWays(sceneOf(program("plain") + "Sphere 1\n"));
    EXPECT_EQ(pair.skipping.calls.texturesFilled, 0U);
    EXPECT_EQ(pair.whole.calls.texturesFilled, 2U);
    EXPECT_GT(pair.whole.calls.bytesUploaded, pair.skipping.calls.bytesUploaded + (std::uint64_t{2} << 20));
    EXPECT_EQ(pair.skipping.skipped("noise texture").size(), 2U);
    const BothWays used = drawBothWays(sceneOf(program("noise") + "Sphere 1\n"));
    EXPECT_EQ(used.skipping.calls.texturesFilled, 1U);
    EXPECT_EQ(used.skipping.skipped("noise texture"), Words{"unit 2 / 2D: no active sampler reads it"});
}

TEST(SkipRule, NoTextureFileWhoseUnitNoActiveSamplerReads) {
    const BothWays pair = drawBothWays(
        sceneOf("Texture2D 5 five.tex\nTexture2D 6 six.tex\n" + program("tex", "uTex 5") + "QuadXY 0 1\n"));
    EXPECT_TRUE(opened(pair.skipping, "five.tex"));
    EXPECT_FALSE(opened(pair.skipping, "six.tex"));
    EXPECT_TRUE(opened(pair.whole, "six.tex"));
    EXPECT_EQ(pair.skipping.calls.texturesFilled, 1U);
    EXPECT_EQ(pair.skipping.skipped("texture"), Words{"unit 6 / 2D: no active sampler reads it"});
    EXPECT_EQ(pair.skipping.count("files read"), 4U);
    EXPECT_EQ(pair.whole.count("files read"), 5U);
}

TEST(SkipRule, FilesThatTwoStatementsNameAreReadOnce) {
    const BothWays pair =
        drawBothWays(sceneOf("Texture2D 5 five.tex\nTexture2D 6 five.tex\n" + program("tex", "uTex 5") +
                             "QuadXY 0 1\n" + program("tex", "uTex 6") + "QuadXY 1 .5\n"));
    EXPECT_EQ(pair.skipping.calls.texturesFilled, 1U);
    EXPECT_EQ(pair.whole.calls.texturesFilled, 4U) << "two files, two noise textures";
    EXPECT_EQ(pair.skipping.skipped("texture"),
              Words{"unit 6 / 2D: shares the texture that line 5 makes from the same file"});
}

TEST(SkipRule, NoAttributeThatNoLinkedProgramReads) {
    const BothWays pair = drawBothWays(sceneOf(program("plain") + "Sphere 1 20 20\n"));
    EXPECT_EQ(pair.skipping.calls.buffersFilled, 3U) << "indices, positions, texture coordinates";
    EXPECT_EQ(pair.whole.calls.buffersFilled, 5U) << "normals and tangents too";
    EXPECT_EQ(pair.skipping.skipped("attribute"),
              (Words{"normal of Sphere: no program reads it", "tangent of Sphere: no program reads it"}));
}

TEST(SkipRule, OneMeshHoweverOftenItIsDrawn) {
    const std::string more = "Translate .1 0 0\nSphere 1 20 20\nTranslate .1 0 0\nSphere 1 20 20\n";
    const BothWays once = drawBothWays(sceneOf(program("plain") + "Sphere 1 20 20\n"));
    const BothWays thrice = drawBothWays(sceneOf(program("plain") + "Sphere 1 20 20\n" + more));
    EXPECT_EQ(thrice.skipping.calls.bytesUploaded, once.skipping.calls.bytesUploaded);
    EXPECT_EQ(thrice.skipping.calls.draws, 3U);
    EXPECT_EQ(thrice.skipping.skipped("mesh"), Words{"Sphere: one mesh serves all its 3 draws"});
    EXPECT_TRUE(once.skipping.skipped("mesh").empty());
    EXPECT_EQ(thrice.whole.calls.buffersFilled, 15U);
}

TEST(SkipRule, NoProgramThatNothingIsDrawnWith) {
    const BothWays pair = drawBothWays(sceneOf(program("red") + program("plain") + "Sphere 1\n"));
    EXPECT_EQ(pair.skipping.calls.programsLinked, 1U);
    EXPECT_EQ(pair.whole.calls.programsLinked, 2U);
    EXPECT_FALSE(opened(pair.skipping, "red.frag"));
    EXPECT_TRUE(opened(pair.whole, "red.frag"));
    EXPECT_EQ(pair.skipping.skipped("program"), Words{"'red': nothing is drawn with it"});
}

TEST(SkipRule, NoPassWhoseTargetNobodySamples) {
    const std::string target = "Texture2D 7 32 32\nRenderToTexture 7\n" + program("red") +
                               "Teapot\nRenderToTexture\n" + program("plain") + "Sphere 1 10 10\n";
    const BothWays pair = drawBothWays(sceneOf(target));
    EXPECT_EQ(pair.skipping.calls.draws, 1U);
    EXPECT_EQ(pair.whole.calls.draws, 2U);
    EXPECT_EQ(pair.skipping.calls.programsLinked, 1U);
    EXPECT_LT(pair.skipping.calls.calls, pair.whole.calls.calls);
    EXPECT_EQ(pair.skipping.skipped("pass"), Words{"nothing visible samples its targets"});
    const BothWays sampled = drawBothWays(sceneOf(target + program("tex", "uTex 7") + "QuadXY 1 .5\n"));
    EXPECT_EQ(sampled.skipping.calls.draws, 3U);
}

TEST(SkipRule, NoDrawThatAClearOfTheWindowCovers) {
    const BothWays pair =
        drawBothWays(sceneOf(program("red") + "Teapot\nClear\n" + program("plain") + "Sphere 1\n"));
    EXPECT_EQ(pair.skipping.calls.draws, 1U);
    EXPECT_EQ(pair.whole.calls.draws, 2U);
    EXPECT_EQ(pair.skipping.calls.programsLinked, 1U) << "its text is read, to see that it writes no image";
    EXPECT_EQ(pair.skipping.skipped("draw"), Words{"Teapot: the window is cleared again on line 8"});
}

TEST(SkipRule, NoDrawOfSizeZero) {
    const BothWays pair =
        drawBothWays(sceneOf(program("red") + "Box 0 1 1\n" + program("plain") + "Sphere 1\n"));
    EXPECT_EQ(pair.skipping.calls.programsLinked, 1U);
    EXPECT_EQ(pair.skipping.skipped("draw"), Words{"Box: it has no size and draws nothing"});
}

TEST(SkipRule, NoDrawOutOfSightNorWhatOnlyItNeeds) {
    const BothWays pair =
        drawBothWays(sceneOf("Texture2D 5 five.tex\n" + program("plain") + "Sphere 1 10 10\n" +
                             program("tex", "uTex 5") + "Translate 0 0 9\nTeapot\n"));
    EXPECT_EQ(pair.skipping.calls.draws, 1U);
    EXPECT_EQ(pair.whole.calls.draws, 2U);
    EXPECT_EQ(pair.skipping.calls.programsLinked, 1U);
    EXPECT_EQ(pair.skipping.calls.texturesFilled, 0U);
    EXPECT_EQ(pair.skipping.calls.buffersFilled, 3U);
    EXPECT_FALSE(opened(pair.skipping, "five.tex"));
    EXPECT_EQ(pair.skipping.skipped("draw"),
              Words{"Teapot: it is behind the eye or in front of the near plane"});
}

TEST(SkipRule, NoDrawBesideTheTargetItGoesInto) {
    // The texture is square: what is left of it can be inside the window, which is wider.
    const std::string inside = program("red") + "Translate -2.2 0 0\nQuadXY 0 .1\nTranslate 2.2 0 0\n";
    const BothWays pair = drawBothWays(sceneOf("Texture2D 7 32 32\nRenderToTexture 7\n" + inside +
                                               program("plain") + "QuadXY 0 .1\nRenderToTexture\n" + inside +
                                               program("tex", "uTex 7") + "QuadXY 0 1\n"));
    EXPECT_EQ(pair.whole.calls.draws, 4U);
    EXPECT_EQ(pair.skipping.calls.draws, 3U);
    EXPECT_EQ(pair.skipping.skipped("draw"), Words{"QuadXY: it is left of what is shown"});
}

TEST(SkipRule, NoTriangleSmallerThanTheGapsBetweenPixels) {
    const BothWays pair =
        drawBothWays(sceneOf(program("red") + "Sphere .001\n" + program("plain") + "QuadXY -1 .3\n"));
    EXPECT_EQ(pair.skipping.calls.draws, 1U);
    EXPECT_EQ(pair.skipping.skipped("draw"), Words{"Sphere: it is too small to cover the centre of a pixel"});
    RenderOptions manySamples;
    manySamples.samples = 4;
    EXPECT_EQ(drawBothWays(sceneOf(program("red") + "Sphere .001\n"), manySamples).skipping.calls.draws, 1U);
    EXPECT_EQ(drawBothWays(sceneOf(program("red") + "PointSize 3\nPointCloud 1 1 1\n")).skipping.calls.draws,
              1U);
}

TEST(SkipRule, NoBlendingOfWhatIsOpaque) {
    const std::string overlapping = "Sphere 1\nTranslate .5 .2 .3\nSphere 1\n";
    for (const int samples : {1, 4}) {
        RenderOptions options;
        options.samples = samples;
        const BothWays opaque = drawBothWays(sceneOf(program("plain") + overlapping), options);
        EXPECT_EQ(opaque.skipping.skipped("blending"), Words{"'plain': always writes 1 for alpha"});
        EXPECT_TRUE(opaque.whole.skipped("blending").empty());
        auto files = kSkipFiles;
        files["half.frag"] =
            "#version 330 core\nin vec3 vST;\nout vec4 fColor;\nvoid main() { fColor = "
            "vec4(vST.st, 0., .5); }\n";
        const BothWays half =
            drawBothWays(SceneFolder(kSkipStart + program("plain") + overlapping + program("half") +
                                         "Translate -.4 .1 .5\nSphere 1\n",
                                     files),
                         options);
        EXPECT_EQ(half.skipping.skipped("blending").size(), 1U);
        EXPECT_NE(half.skipping.pixels, opaque.skipping.pixels);
    }
}

TEST(SkipRule, WhatAShiftOfThePictureMayShowIsDrawn) {
    // One ball is at the corner of four pixels, another just right of the picture.
    const SceneFolder folder(
        "WindowSize 64 64\nOrtho -1 1 -1 1\nLookAt 0 0 2  0 0 0  0 1 0\nVertex a.vert\n" + program("red") +
            "Sphere .004\nTranslate 1.01 .01 0\nSphere .009\n",
        kSkipFiles);
    RenderOptions options;
    options.tileSize = 4096;
    std::array<std::vector<std::byte>, 2> pixels;
    for (const bool skip : {true, false}) {
        options.skip = skip;
        render::Stats stats;
        auto loaded = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
        ASSERT_TRUE(loaded);
        loaded->setShift({-.45, .45});
        auto picture = loaded->draw(0, stats);
        ASSERT_TRUE(picture);
        pixels[skip ? 0 : 1] = std::move(picture->data);
    }
    EXPECT_TRUE(pixels[0] == pixels[1]);
    EXPECT_NE(std::count(pixels[1].begin(), pixels[1].end(), std::byte{255}), 0) << "the ball covers a pixel";
}

TEST(SkipRule, ADrawWhoseProgramMovesItIsDrawnWhereverItsMeshLies) {
    const SceneFolder folder(
        kSkipStart + "Vertex moved.vert\n" + program("red") + "Translate 0 0 9\nTeapot\n", kSkipFiles);
    folder.write("moved.vert",
                 "#version 330 core\nout vec3 vST;\nvoid main() { vST = vec3(0.); gl_Position = "
                 "uModelViewProjectionMatrix * (aVertex - vec4(0., 0., 9., 0.)); }\n");
    const BothWays pair = drawBothWays(folder);
    EXPECT_EQ(pair.skipping.calls.draws, 1U);
}

TEST(SkipRule, ATransformOfTheViewCountsAsWell) {
    const SceneFolder folder = sceneOf(program("red") + "Translate 0 0 9\nTeapot\n");
    RenderOptions options;
    options.viewState.eye[14] = -9;
    EXPECT_EQ(drawBothWays(folder, options).skipping.calls.draws, 1U);
    EXPECT_EQ(drawBothWays(folder).skipping.calls.draws, 0U);
}

TEST(SkipRule, ATileIsSparedWhatLiesBesideIt) {
    std::string balls = program("plain");
    for (const char* place : {"-1.5 -1 0", "3 0 0", "-3 2 0", "3 0 0"})
        balls += "Translate " + std::string(place) + "\nSphere .2 12 12\n";
    const SceneFolder folder =
        sceneOf(balls + "LineWidth 9\nVertex\nFragment\nProgram B\nWireSphere .3 8 8\n");
    RenderOptions options;
    options.width = 1024;
    options.height = 768;
    options.tileSize = 64;
    const BothWays pair = drawBothWays(folder, options);
    EXPECT_EQ(pair.whole.calls.draws, 16U * 12 * 5);
    EXPECT_LT(pair.skipping.calls.draws, 16U * 12 * 2);
    const std::uint64_t spared = pair.skipping.count(std::string(render::kDrawsOutOfTheirTile));
    EXPECT_EQ(pair.skipping.calls.draws + spared, 16U * 12 * 5);
    render::Job job;
    job.scene = folder / "scene.glib";
    job.output = folder / "tiled.png";
    job.options = options;
    job.explain = true;
    const render::JobResult done = render::runJob(sharedContext(), job, [](int) {});
    EXPECT_NE(done.explanation.find(std::to_string(spared) + " lie outside their tile"), std::string::npos)
        << done.explanation;
}

const std::string kBuffered =
    "WindowSize 32 32\nVertex inline\n#version 430 core\nin vec3 aPosition;\nbuffer used { float x[]; };\n"
    "void main() { gl_Position = vec4(aPosition.xy * x[1], 0., 1.); }\nEndVertex\n"
    "Fragment inline\n#version 430 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\nEndFragment\n"
    "Program P\nBox 1\n";

TEST(SkipRule, NoBufferThatNothingReads) {
    const SceneFolder folder("Buffer idle float 9 (1/(3 - i))\nBuffer used float 9 (.1*i)\n" + kBuffered);
    const Drawing run = draw(folder);
    EXPECT_EQ(run.skipped("buffer"), Words{"'idle': nothing reads it"});
    EXPECT_EQ(run.count("buffers"), 1U);
    const auto idsOf = [](const Diagnostics& all) {
        std::string ids;
        for (const Diagnostic& each : all)
            if (each.severity == Severity::error) ids += each.id + " ";
        return ids;
    };
    // What is wrong with it is found by `glibra check`, and where it is read, each time once.
    EXPECT_EQ(idsOf(run.diagnostics), "");
    EXPECT_EQ(idsOf(render::checkScene(sharedContext(), folder / "scene.glib", {}).diagnostics), "expr-E06 ");
    RenderOptions wanted;
    wanted.wantedObjects = {"idle"};
    render::Stats stats;
    EXPECT_EQ(
        idsOf(render::SceneRenderer::load(sharedContext(), folder / "scene.glib", wanted, stats).diagnostics),
        "expr-E06 ");
    folder.write("scene.glib", "Buffer used float 9 (1/(3 - i))\n" + kBuffered);
    EXPECT_EQ(
        idsOf(render::SceneRenderer::load(sharedContext(), folder / "scene.glib", {}, stats).diagnostics),
        "expr-E06 ");
}

TEST(SkipRule, ACheckMakesOnlyTheNoiseThatASamplerReadsAndSharesIt) {
    const auto filled = [](const SceneFolder& folder, render::SharedParts* shared) {
        const gpu::CallCounter counter;
        EXPECT_FALSE(
            hasError(render::checkScene(sharedContext(), folder / "scene.glib", {}, shared).diagnostics));
        return counter.counts().texturesFilled;
    };
    EXPECT_EQ(filled(sceneOf(program("plain") + "Sphere 1\n"), nullptr), 0U);
    const SceneFolder noisy = sceneOf(program("noise") + "Sphere 1\n");
    render::SharedParts shared;
    EXPECT_EQ(filled(noisy, &shared), 1U);
    EXPECT_EQ(filled(noisy, &shared), 0U);
}

TEST(SkipRule, WhatIsSkippedIsStillCheckedWhenNothingIs) {
    const SceneFolder folder = sceneOf(program("broken") + "Translate 0 0 9\nTeapot\n" + program("plain") +
                                       "Translate 0 0 -9\nSphere 1\n");
    folder.write("broken.frag", "#version 330 core\nvoid main() { gl_FragColor = missing; }\n");
    EXPECT_FALSE(hasError(draw(folder).diagnostics));
}

/// Shapes of all kinds in and out of sight, with the built-in program and with the scene's.
std::string randomScene(std::mt19937& random) {
    const auto number = [&](double low, double high) {
        return std::to_string(std::uniform_real_distribution<double>(low, high)(random));
    };
    const std::vector<std::string> shapes{
        "Box .5 .4 .3",  "Sphere .4 9 7", "Cone .3 .6",          "Torus .1 .4 8 12",    "QuadXY 0 .5",
        "WireBox 1 1 1", "WireSphere .5", "PointCloud 3 3 3 .8", "WireTorus .1 .4 5 9", "Sphere .004 5 5"};
    std::string text = "WindowSize 61 47\nBackground .1 .1 .2\n";
    text += random() % 3 == 0 ? "Ortho -2 2 -2 2 -3 9\n" : "Perspective " + number(20, 110) + " .5 12\n";
    text += "LookAt 0 0 4  0 0 0  0 1 0\nVertex a.vert\n" + program("plain");
    for (int i = 0; i < 12; ++i) {
        if (i == 6) text += "Vertex\nFragment\nProgram Builtin\n";
        text += "PushMatrix\nTranslate " + number(-6, 6) + " " + number(-6, 6) + " " + number(-9, 6) +
                "\nRotate " + number(0, 360) + " " + number(-1, 1) + " 1 " + number(-1, 1) + "\nLineWidth " +
                number(1, 9) + "\nPointSize " + number(1, 20) + "\nColor " + number(0, 1) + " " +
                number(0, 1) + " 1 .7\n" + shapes[random() % shapes.size()] + "\nPopMatrix\n";
    }
    return text;
}

TEST(SkipRule, RandomScenesAreTheSameWholeAndInTiles) {
    std::mt19937 random(11);
    std::uint64_t left = 0;
    std::uint64_t all = 0;
    for (int i = 0; i < (GLIBRA_SANITIZED ? 40 : 80); ++i) {
        const std::string text = randomScene(random);
        const SceneFolder folder(text, kSkipFiles);
        RenderOptions options;
        if (i % 4 == 1) options.tileSize = 16;
        if (i % 4 == 1) options.width = options.height = 300;
        if (i % 4 == 2) options.samples = 4;
        const BothWays pair = drawBothWays(folder, options);
        if (HasFailure()) FAIL() << text;
        left += pair.whole.calls.draws - pair.skipping.calls.draws;
        all += pair.whole.calls.draws;
    }
    EXPECT_GT(4 * left, all) << "a quarter at least is out of sight";
}

}  // namespace
}  // namespace glibra::test
