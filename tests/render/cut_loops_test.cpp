// draw-W08 for loops whose rounds no text shows: the programs themselves record which loops the driver ends.
// The counts that a scene makes are too small exactly where the message stands, whatever the driver is.

#include <glibra/scene.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "modern_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

struct Counting {
    std::string functions, body;  ///< `body` adds 1 to t in each round
    int rounds;
};

const std::vector<Counting>& countings() {
    static const std::string row =
        "int row(int n) { int s = 0; for (int i = 0; i < n; i++) s++; return s; }\n";
    static const std::vector<Counting> all{
        {"", "for (int i = 0; i < 500; i++) for (int j = 0; j < i; j++) t++;", 124'750},
        {"", "for (int i = 0; i < 400; i++) for (int j = i; j < 400; j++) { t++; }", 80'200},
        {"", "for (int i = 0; i < 100; i++) for (int j = 0; j < i; j++) t++;", 4'950},
        {row, "for (int j = 0; j < 300; j++) t += row(300);", 90'000},
        {row, "for (int j = 0; j < 100; j++) t += row(100 + j - j);", 10'000},
        {row, "t += row(90000);", 90'000},
        {row, "t += row(60000);", 60'000},
        {row, "int j = 0; while (j++ < row(300)) t += row(300);", 90'000},
        {"",
         "int stack[4]; int top = 0; stack[top++] = 90000; while (top > 0) { int n = stack[--top]; "
         "if (n > 1) stack[top++] = n - 1; t++; }",
         90'000},
        {"", "int m = 70000; do { t++; m -= (t & 1) + 0; } while (m > 0 && t < 70001 + int(one) - 1);",
         70'001},
        {"", "int n = 80000; while (true) { if (n == 0) break; n = n - 1 - (n & 0); t++; }", 80'000},
        {"", "int n = 80000; while (bool goes = n-- > 0) t++;", 80'000},
        {"", "int i = 0; while (i++, i < 70001) t++;", 70'000},
        {"", "int i = 0; for (; i++, i < 70001;) t++;", 70'000},
        {"", "int i = 0; do t++; while (i++, i < 70000);", 70'000},
        {"\n#define MORE i++, i < 70001\n", "int i = 0; while (MORE) t++;", 70'000},
        {"\n#define REPEAT(i, n) for (int i = 0; int(i * one) < n; i++)\n", "REPEAT(i, 70000) t++;", 70'000},
        {"\n#define REPEAT(i, n) for (int i = 0; int(i * one) < n; i++) {\n#define END }\n",
         "REPEAT(i, 300) REPEAT(j, 300) t++; if (t < 0) break; END END", 90'000},
        {"\n#define FOREVER while (true)\n", "FOREVER { t++; if (t >= int(70000 * one)) break; }", 70'000},
        {"", "int n = 80000; while (const bool goes = n-- > 0) t++;", 80'000},
        {"",
         "int n = 30; for (;;) { switch (n) { case 0: n = -1; break; default: n--; } if (n < 0) break; t++; "
         "}",
         30},
        {"", "int n = 27, m = 0; while (n != 1) { n = (n & 1) == 1 ? 3 * n + 1 : n / 2; t++; }", 111},
        {"int find(int n) { for (int i = 0; ; i++) { if (i * i > n) return i; } return 0; }\n",
         "for (int i = 0; i < 500; i++) t += find(90000);", 150'500},
    };
    return all;
}

class CutLoops : public testing::Test {
  protected:
    void SetUp() override {
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }

    /// The count that a stage writes into `total`, and whether draw-W08 is reported in line `line`.
    static void expectReport(const Counting& of, const std::string& scene, const std::string& buffer) {
        const SceneFolder folder(scene);
        render::Stats stats;
        RenderOptions options;
        options.checks = true;  // so that the buffer is wanted
        auto loaded = render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
        ASSERT_TRUE(loaded) << text(loaded.diagnostics);
        const Result<image::Image> picture = loaded->draw(0, stats);
        ASSERT_TRUE(picture) << text(picture.diagnostics);
        double seen = -1;
        const auto& buffers = loaded->scene().buffers;
        for (const scene::BufferIndex each : buffers.indices())
            if (buffers[each].name == buffer) seen = loaded->device().buffers().read({each}, 0, 1).front();
        EXPECT_LE(seen, of.rounds) << of.body;
        const std::string all = text(loaded.diagnostics) + text(picture.diagnostics);
        EXPECT_EQ(all.find("[draw-W08]") != std::string::npos, seen < of.rounds)
            << seen << " of " << of.body << "\n"
            << all;
    }
};

TEST_F(CutLoops, OfComputeStagesAreReportedExactlyWhereTheDriverEndsThem) {
    for (const Counting& each : countings())
        expectReport(each,
                     "WindowSize 4 4\nBuffer out int [0]\nCompute inline\n#version 430\n"
                     "layout(local_size_x = 1) in;\nlayout(std430) buffer Out { int total; };\n"
                     "uniform float one;\n" +
                         each.functions + "void main() { int t = 0;\n" + each.body +
                         "\ntotal = t;\n}\nEndCompute\nProgram Count  one 1.  Out out\nDispatch Count 1\n"
                         "Expect range out 0 1000000\n",
                     "out");
}

/// What a stage without effects draws is recorded beside the draw, which stays as it is.
TEST_F(CutLoops, OfStagesThatDrawAreReportedToo) {
    for (const Counting& each : countings())
        for (const bool inVertexStage : {false, true}) {
            const std::string count = "uniform float one;\n" + each.functions + "int count() { int t = 0;\n" +
                                      each.body + "\nreturn t; }\n";
            const std::string vertex =
                "Vertex inline\n#version 430\nflat out int vT;\n" + (inVertexStage ? count : std::string()) +
                "void main() { vT = " + (inVertexStage ? "count()" : "0") +
                "; gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.); }\n"
                "EndVertex\n";
            const std::string fragment = "Fragment inline\n#version 430\nflat in int vT; out float f;\n" +
                                         (inVertexStage ? std::string() : count) +
                                         "void main() { f = float(" + (inVertexStage ? "vT" : "count()") +
                                         "); }\nEndFragment\n";
            // The compute stage copies what the draw has counted.
            expectReport(each,
                         "WindowSize 4 4\nTexture2D map 2 2 r32f nearest\nBuffer out float [0]\n" + vertex +
                             fragment +
                             "Program Count  one 1.\nPass map\nVertices triangles 3\nEndPass\n"
                             "Compute inline\n#version 430\nlayout(local_size_x = 1) in;\n"
                             "layout(std430) buffer Out { float total; }; uniform sampler2D map;\n"
                             "void main() { total = texelFetch(map, ivec2(0), 0).r; }\nEndCompute\n"
                             "Program Copy  Out out map map\nDispatch Copy 1\nExpect range out 0 1000000\n",
                         "out");
        }
}

TEST_F(CutLoops, AreRecordedWithoutAnotherPicture) {
    for (const char* loop : {"while (h > .001 && s < 40.) { h = length(mod(s * d, 4.) - 2.) - 1.; s += h; }",
                             "int n = 0; while (n < int(gl_FragCoord.x * 700.)) { n++; s += .001 * h; }"}) {
        const std::string scene =
            std::string(
                "WindowSize 64 48\nFragment inline\n#version 430\nout vec4 f;\nvoid main() {\n"
                "vec3 d = normalize(vec3(gl_FragCoord.xy / 32. - 1., 1.5)); float s = 0., h = 1.;\n") +
            loop + "\nf = vec4(s / 40., h, s - floor(s), 1.);\n}\nEndFragment\nProgram P\n";
        TextScene alone(scene + "Fill window with P\n");
        // A store in the same program is another way to record: the draw itself does.
        const image::Image once = alone.draw(0), again = alone.draw(0), third = alone.draw(0);
        EXPECT_EQ(once.data, again.data);  // the third frame is the first that records nothing
        EXPECT_EQ(once.data, third.data);
    }
}

TEST(LoopsOfOpenGlEs, HaveTheirRoundsAlsoWhereNoTrialSeesThem) {
    Result<Renderer> renderer = Renderer::open(Driver::gles);
    if (!renderer) GTEST_SKIP() << "no OpenGL ES";
    const std::string version = "\nFragment inline\n#version 330\n";
    for (const auto& [format, prefix] : {std::pair("rgba32f", ""), std::pair("rgba32i", "i")}) {
        const SceneFolder folder(
            std::string("WindowSize 16 16\nTexture2D counts 16 16 ") + format + version +
            "uniform int uRounds; out " + prefix +
            "vec4 o;\nvoid main() { int t = 0; for (int i = 0; i < uRounds; i++) t++; o = " + prefix +
            "vec4(t); }\nEndFragment\nProgram P uRounds 20000\nFill counts with P" + version + "uniform " +
            prefix +
            "sampler2D uCounts; out vec4 o;\nvoid main() { o = vec4(int(texelFetch(uCounts, ivec2(3), 0).r) "
            "== "
            "20000); }\nEndFragment\nProgram Show uCounts counts\nFill window with Show\n");
        const Result<Picture> picture = renderer->render(folder / "scene.glib");
        ASSERT_TRUE(picture) << text(picture.diagnostics);
        EXPECT_EQ(picture->data.at(0), std::byte{255}) << format << "\n" << text(picture.diagnostics);
    }
}

}  // namespace
}  // namespace glibra::test
