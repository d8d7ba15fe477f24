// The search for NaN: compares the draws that it names with the draws that were written to make NaN.

#include "render/check/nan_search.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../support/new_folder.h"
#include "gpu/context/context.h"
#include "render/file/job.h"
#include "scene_text.h"

namespace glibra::render {
namespace {

namespace fs = std::filesystem;

/// A scene with its files in a temporary folder, and a context.
class NanSearchTest : public testing::Test {
  protected:
    NanSearchTest() {
        folder = test::newFolder("nan");
        write("p.vert",
              "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
        // A negative number makes NaN in the left half of the picture. GLSL leaves its square root open. Half
        // of what is below shows through: a driver may leave out what is multiplied by 0, and NaN would be
        // lost.
        write("p.frag",
              "#version 330 core\nuniform float uLeft;\nout vec4 fColor;\n"
              "void main() {\n  float x = gl_FragCoord.x < 16. ? uLeft : 1.;\n"
              "  fColor = vec4(x < 0. ? uintBitsToFloat(0x7fc00000u) : sqrt(x), 0., 0., .5);\n}\n");
        write("tex.frag",
              "#version 330 core\nuniform sampler2D uTex;\nout vec4 fColor;\n"
              "void main() { fColor = texture(uTex, gl_FragCoord.xy / 32.); }\n");
    }
    ~NanSearchTest() override { fs::remove_all(folder); }

    void write(const std::string& file, const std::string& content) const {
        std::ofstream(folder / file, std::ios::binary) << content;
    }
    [[nodiscard]] fs::path scene(const std::string& text) const {
        write("scene.glib",
              "WindowSize 32 32\nLookAt 0 0 2 0 0 0 0 1 0\nVertex p.vert\nFragment p.frag\n" + text);
        return folder / "scene.glib";
    }
    static Diagnostics search(const fs::path& scene, const RenderOptions& options = {}) {
        Result<gpu::Context> context = gpu::openContext();
        EXPECT_TRUE(context);
        Result<NanSearch> search = NanSearch::load(*context, scene, options);
        EXPECT_TRUE(search) << test::text(search.diagnostics);
        return search ? search->at(0) : Diagnostics();
    }

    fs::path folder;
};

std::vector<int> linesOf(const Diagnostics& diagnostics) {
    std::vector<int> lines;
    for (const Diagnostic& each : diagnostics) {
        EXPECT_EQ(each.id, "draw-W06");
        lines.push_back(each.place.line);
    }
    return lines;
}

TEST_F(NanSearchTest, FinitePicturesAreNotMentioned) {
    EXPECT_TRUE(search(scene("Program A uLeft 4.\nQuadXY 0 5\nSphere\n")).empty());
    EXPECT_TRUE(search(scene("")).empty());
}

TEST_F(NanSearchTest, NamesTheOneDrawOfMany) {
    // From line 5 on: good draws, except one in the middle.
    for (const int bad : {0, 1, 36, 62, 63}) {
        std::string text = "Program Good uLeft 1.\n";
        for (int i = 0; i < 64; ++i)
            text += i == bad ? "Program Bad uLeft -1.\nQuadXY 0 5\nProgram Good uLeft 1.\n" : "QuadXY 0 5\n";
        const Diagnostics found = search(scene(text));
        EXPECT_EQ(linesOf(found), std::vector<int>{5 + bad + 2}) << bad;
        ASSERT_FALSE(found.empty());
        EXPECT_EQ(found[0].text, "QuadXY leaves NaN or infinity in 512 pixels, the first at 0, 0");
    }
}

TEST_F(NanSearchTest, NamesEveryDrawThatBreaksPixelsOfItsOwn) {
    const Diagnostics found =
        search(scene("Program Bad uLeft -1.\nPushMatrix\nTranslate -.5 -.5 0\nQuadXY 0 .1\nPopMatrix\n"
                     "Program Good uLeft 1.\nQuadXY 0 5\n"
                     "Program AlsoBad uLeft -2.\nTranslate -.5 .5 0\nQuadXY 0 .1\n"));
    EXPECT_EQ(linesOf(found), (std::vector<int>{8, 14}));
}

TEST_F(NanSearchTest, WhatIsClearedAwayIsNotNamed) {
    EXPECT_TRUE(search(scene("Program Bad uLeft -1.\nQuadXY 0 5\nClear\nProgram Good uLeft 1.\nQuadXY 0 5\n"))
                    .empty());
    EXPECT_EQ(linesOf(search(scene("Program Bad uLeft -1.\nQuadXY 0 5\nClear\nProgram Worse uLeft -2.\n"
                                   "Sphere\n"))),
              std::vector<int>{9});
}

TEST_F(NanSearchTest, ManyAreCounted) {
    std::string text = "Ortho -16 16 -16 16\nProgram Bad uLeft -1.\nTranslate -8 -13 0\n";
    for (int i = 0; i < 12; ++i) text += "Translate 0 2 0\nQuadXY 0 .6\n";
    const Diagnostics found = search(scene(text));
    ASSERT_EQ(found.size(), 8U);
    EXPECT_NE(found.back().text.find("4 more draws do so"), std::string::npos) << found.back().text;
}

TEST_F(NanSearchTest, ATextureIsTracedToTheDrawIntoIt) {
    const Diagnostics found =
        search(scene("Texture2D 6 32 32 RGBA32F\nRenderToTexture 6\nProgram Bad uLeft -1.\nQuadXY 0 5\n"
                     "RenderToTexture\nFragment tex.frag\nProgram Show uTex 6\nQuadXY 0 5\n"));
    EXPECT_EQ(linesOf(found), (std::vector<int>{8, 12}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NE(found[0].text.find("of the texture of unit 6"), std::string::npos) << found[0].text;
    EXPECT_NE(found[1].text.find("samples what line 8 drew"), std::string::npos) << found[1].text;
}

TEST_F(NanSearchTest, EveryWayToNotANumberLeadsToItsLine) {
    write(
        "st.vert",
        "#version 330 core\nuniform float uZero;\nout vec3 vST;\nvoid main() { vST = aTexCoord0.stp + uZero; "
        "gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
    write("broken.vert",
          "#version 330 core\nuniform float uZero;\nout vec3 vST;\nvoid main() { vST = vec3(uZero / uZero); "
          "gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
    const auto fragment = [&](const std::string& name, const std::string& red) {
        write(name,
              "#version 330 core\nuniform float uZero;\nin vec3 vST;\nout vec4 fColor;\nvoid main() { "
              "fColor = vec4(" +
                  red + ", vST.t, 0., 1.); }\n");
    };
    fragment("good.frag", "vST.s");
    fragment("division.frag", "uZero / uZero");
    fragment("infinite.frag", "1. / uZero");
    fragment("root.frag", "sqrt(vST.s - 2.)");
    fragment("power.frag", "pow(-1. - vST.s, .5)");
    const std::string good = "Vertex st.vert\nFragment good.frag\nProgram Good uZero 0\nSphere .3\n";
    struct Way {
        std::string vertex, fragment;
    };
    for (const Way& way :
         {Way{"st.vert", "division.frag"}, Way{"st.vert", "infinite.frag"}, Way{"st.vert", "root.frag"},
          Way{"st.vert", "power.frag"}, Way{"broken.vert", "good.frag"}}) {
        const std::string bad =
            "Vertex " + way.vertex + "\nFragment " + way.fragment + "\nProgram Bad uZero 0\n";
        // Four lines of the header, four of a good draw, three of the program: the quad is line 12.
        EXPECT_EQ(linesOf(search(scene(good + bad + "QuadXY 0 .5\n" + good))), std::vector<int>{12})
            << way.vertex << " " << way.fragment;
        // In a float texture that is shown, and then in the window: two lines later, and where it is shown.
        EXPECT_EQ(linesOf(search(scene(good + "Texture2D 6 32 32 RGBA16F\nRenderToTexture 6\n" + bad +
                                       "QuadXY 0 5\nRenderToTexture\nVertex p.vert\nFragment tex.frag\n"
                                       "Program Show uTex 6\nQuadXY 0 5\n"))),
                  (std::vector<int>{14, 19}))
            << way.vertex << " " << way.fragment;
    }
}

std::vector<std::string> told(const Diagnostics& diagnostics, const std::string& id) {
    std::vector<std::string> all;
    for (const Diagnostic& each : diagnostics)
        if (each.id == id) all.push_back(std::to_string(each.place.line) + " " + each.text);
    return all;
}
using Told = std::vector<std::string>;

TEST_F(NanSearchTest, VerticesPlacedAtNanAreTold) {
    // Vertices to the right of uRight are lost. The ball has two triangles per cell, except at the poles.
    write("lost.vert",
          "#version 330 core\nuniform float uRight, uZero;\nvoid main() {\n"
          "  gl_Position = uModelViewProjectionMatrix * aVertex;\n"
          "  if (aVertex.x > uRight) gl_Position.y = uZero / uZero;\n}\n");
    write("one.frag", "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n");
    const std::string start = "Vertex lost.vert\nFragment one.frag\n";
    const std::string lists =
        "glBegin triangles\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 0 1 0\nglVertex 0 0 0\nglVertex .5 0 "
        "0\nglVertex 0 1 0\nglEnd\n"
        "glBegin lines\nglVertex 0 0 0\nglVertex 1 0 0\nglEnd\n"
        "glBegin points\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 1 0 0\nglEnd\n";
    // A list's line is where it ends.
    EXPECT_EQ(told(search(scene(start + "Program P uRight .8 uZero 0\n" + lists)), "draw-W09"),
              (Told{"15 triangles: gl_Position is NaN or infinite in 1 of 2 triangles, which is lost",
                    "19 lines: gl_Position is NaN or infinite in 1 of 1 lines, which is lost",
                    "24 points: gl_Position is NaN or infinite in 2 of 3 points, which are lost"}));
    EXPECT_TRUE(search(scene(start + "Program P uRight 9 uZero 0\n" + lists)).empty());
    // Every triangle of the ball, once.
    EXPECT_EQ(told(search(scene(start + "Program P uRight -9 uZero 0\nSphere 1 40 40\n")), "draw-W09"),
              Told{"8 Sphere: gl_Position is NaN or infinite in 3,120 of 3,120 triangles, which are lost"});
}

TEST_F(NanSearchTest, VerticesPlacedAtNanByLaterStagesAreTold) {
    write("plain.vert", "#version 400 core\nvoid main() { gl_Position = aVertex; }\n");
    write("some.tese",
          "#version 400 core\nlayout(quads, equal_spacing) in;\nuniform float uZero;\nvoid main() {\n"
          "  gl_Position = vec4(gl_TessCoord.xy - .5, 0., gl_TessCoord.x > .9 ? uZero / uZero : 1.);\n}\n");
    write("four.tesc",
          "#version 400 core\nlayout(vertices = 1) out;\nvoid main() {\n  for (int i = 0; i < 4; ++i) "
          "gl_TessLevelOuter[i] = 4.;\n  gl_TessLevelInner[0] = gl_TessLevelInner[1] = 4.;\n}\n");
    write("fan.geom",
          "#version 400 core\nlayout(points) in;\nlayout(line_strip, max_vertices = 4) out;\nuniform float "
          "uZero;\nvoid main() {\n  for (int i = 0; i < 4; ++i) {\n    gl_Position = gl_in[0].gl_Position + "
          "float(i);\n    if (i == 3) gl_Position.z = 1. / uZero;\n    EmitVertex();\n  }\n}\n");
    write("one.frag", "#version 400 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n");
    // 16 cells of two triangles; four cells lie at the edge.
    EXPECT_EQ(
        told(search(scene("Vertex plain.vert\nTessControl four.tesc\nTessEvaluation some.tese\nFragment "
                          "one.frag\nProgram P uZero 0\nNumPatchVertices 1\nglBegin patches\nglVertex 0 0 "
                          "0\nglEnd\n")),
             "draw-W09"),
        Told{"13 patches: gl_Position is NaN or infinite in 8 of 32 triangles, which are lost"});
    // Three lines per point; the last one ends at infinity.
    EXPECT_EQ(told(search(scene("Vertex plain.vert\nGeometry fan.geom\nFragment one.frag\nProgram P uZero 0\n"
                                "glBegin points\nglVertex 0 0 0\nglVertex 0 0 .5\nglEnd\n")),
                   "draw-W09"),
              Told{"12 points: gl_Position is NaN or infinite in 2 of 6 lines, which are lost"});
}

TEST_F(NanSearchTest, WhatIsSearchedForPositionsIsDrawnAllTheSame) {
    Result<gpu::Context> context = gpu::openContext();
    ASSERT_TRUE(context);
    const fs::path path = scene("Program Good uLeft 1.\nQuadXY 0 .5\nProgram Also uLeft 4.\nSphere .4\n");
    Stats stats;
    Result<SceneRenderer> renderer = SceneRenderer::load(*context, path, {}, stats);
    ASSERT_TRUE(renderer);
    const Result<image::Image> before = renderer->draw(0, stats);
    PositionSearch search(*context);
    EXPECT_TRUE(search.search(*renderer, 0, stats).empty());
    const Result<image::Image> after = renderer->draw(0, stats);
    ASSERT_TRUE(before && after);
    EXPECT_TRUE(before->data == after->data);
}

TEST_F(NanSearchTest, TiledPicturesAreSearchedToo) {
    RenderOptions options;
    options.width = options.height = 300;
    options.tileSize = 64;
    EXPECT_EQ(linesOf(search(scene("Program Good uLeft 1.\nQuadXY 0 5\nProgram Bad uLeft -1.\nQuadXY 0 5\n"),
                             options)),
              std::vector<int>{8});
}

TEST_F(NanSearchTest, AJobTellsItOfABytePicture) {
    // Bytes cannot hold NaN, so only the search can find it.
    Result<gpu::Context> context = gpu::openContext();
    ASSERT_TRUE(context);
    Job job;
    job.scene = scene("Program Bad uLeft -1.\nQuadXY 0 5\n");
    job.output = folder / "out.png";
    JobResult result = runJob(*context, job, [](int) {});
    EXPECT_FALSE(test::has(result.diagnostics, "draw-W06")) << test::text(result.diagnostics);
    job.options.checkNan = true;
    result = runJob(*context, job, [](int) {});
    EXPECT_TRUE(test::has(result.diagnostics, "draw-W06"));
    EXPECT_FALSE(result.failed);
    job.options.strict = true;
    result = runJob(*context, job, [](int) {});
    EXPECT_TRUE(result.failed);
}

TEST_F(NanSearchTest, TheLibraryTellsItWithThePicture) {
    Result<Renderer> renderer = Renderer::open();
    ASSERT_TRUE(renderer);
    const fs::path bad = scene("Program Bad uLeft -1.\nQuadXY 0 5\n");
    EXPECT_FALSE(test::has(renderer->render(bad).diagnostics, "draw-W06"));
    RenderOptions options;
    options.checkNan = true;
    const Result<Picture> searched = renderer->render(bad, options);
    EXPECT_TRUE(searched);
    EXPECT_TRUE(test::has(searched.diagnostics, "draw-W06")) << test::text(searched.diagnostics);
}

}  // namespace
}  // namespace glibra::render
