// Which loops may not end, so that another process draws them (LiveScene::openLoops).

#include <glad/gl.h>

#include <algorithm>
#include <array>

#include "gpu/object/program.h"
#include "render/live/live_scene.h"
#include "render/scene_renderer.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

/// The lines of the fragment shader whose loops may not end.
std::vector<int> openLines(const std::string& body, double rounds = 10) {
    const SceneFolder folder(
        kHead + "Vertex a.vert\nFragment a.frag\nProgram P uN " + std::to_string(rounds) + "\nQuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag", "#version 330\nuniform float uN; out vec4 c;\nfloat f(float x) {\n" + body +
                        "\nreturn x; }\nvoid main() { c = vec4(f(gl_FragCoord.x)); }\n"}});
    const render::LiveScene::Loading loading =
        render::LiveScene::load(context(), folder.scene(), {}, nullptr);
    EXPECT_TRUE(loading.scene && !hasError(loading.diagnostics)) << text(loading.diagnostics);
    std::vector<int> lines;
    for (const Place& each : loading.scene->openLoops()) lines.push_back(each.line);
    return lines;
}

TEST(OpenLoops, AreThoseWhoseRoundsAreUnknownOrMany) {
    const std::vector<int> none, first{4};
    EXPECT_EQ(openLines("x += 1.;"), none);
    EXPECT_EQ(openLines("for (int i = 0; i < 10; ++i) x *= x;"), none);
    EXPECT_EQ(openLines("for (int i = 0; i < 10; ++i)\nfor (int j = 0; j < 10; ++j) x *= x + float(j);"),
              none);
    EXPECT_EQ(openLines("for (float i = 0.; i < uN; ++i) x *= x;"), none);
    EXPECT_EQ(openLines("for (float i = 0.; i < uN; ++i) x *= x;", 1e6), first);
    EXPECT_EQ(openLines("for (int i = 0; i < 100000; ++i) x *= x;"), first);
    EXPECT_EQ(openLines("for (int i = 0; i < 1000; ++i)\nfor (int j = 0; j < 1000; ++j) x *= x;"), first);
    EXPECT_EQ(openLines("for (int i = 0; i < 10; ) x *= x + 1.;"), first);
    EXPECT_EQ(openLines("while (x > 0.) x = abs(sin(x)) + 1.;"), first);
    EXPECT_EQ(openLines("for (;;) { x *= 2.; if (x > 1e9) break; }"), first);
    EXPECT_EQ(openLines("do x *= 2.; while (x < 1e9);"), first);
    EXPECT_EQ(openLines("for (int i = 0; i < 10; ++i) while (x < 9.) x *= 2.;"), first);
    EXPECT_EQ(openLines("// while (true)\n/* for (;;) */ x += 1.;"), none);
}

/// True if this driver's compiler removes what the loop is part of: then uN is unused. Mesa 22 does, Mesa 25
/// keeps the loop, and there is nothing to explain.
bool removesUniform(const std::string& shader) {
    constexpr const char* kPoint = "#version 330\nvoid main() { gl_Position = vec4(0.); }\n";
    const std::array<gpu::StageSource, 2> stages{{{GL_VERTEX_SHADER, kPoint}, {GL_FRAGMENT_SHADER, shader}}};
    const gpu::BuildOutcome built = gpu::buildProgram(context().capabilities(), {.stages = stages});
    EXPECT_TRUE(built.program);
    return built.program && glGetUniformLocation(built.program->id(), "uN") < 0;
}

TEST(EndlessLoops, AreThoseWhoseConditionNothingChanges) {
    const auto shaderOf = [](const std::string& body) {
        return "#version 330\nuniform float uN; out vec4 c;\nvoid main() { float x = uN; int i = 0;\n" +
               body + "\nc = vec4(x * uN); }\n";
    };
    const auto linesOf = [&](const std::string& body) {
        const SceneFolder folder(kHead + "Vertex a.vert\nFragment a.frag\nProgram P uN 1\nQuadXY 0 1\n",
                                 {{"a.vert", kPlainVertex}, {"a.frag", shaderOf(body)}});
        const render::LiveScene::Loading loading =
            render::LiveScene::load(context(), folder.scene(), {}, nullptr);
        std::vector<int> lines;
        for (const Diagnostic& each : loading.diagnostics)
            if (each.id == "view-W02") lines.push_back(each.place.line);
        return lines;
    };
    const std::vector<int> none, first{4};
    for (const char* body : {"for (int j = 0; j < 10; ) x += 1.;", "while (i < 10) { x += 1.; }"})
        EXPECT_EQ(linesOf(body), removesUniform(shaderOf(body)) ? first : none) << body;
    EXPECT_EQ(linesOf("while (i < 10) { x += 1.; ++i; }"), none);
    EXPECT_EQ(linesOf("for (int j = 0; j < 10; ++j) x += 1.;"), none);
    EXPECT_EQ(linesOf("while (i < 10) { x += 1.; if (x > 9.) break; }"), none);
}

TEST(EndlessLoops, ExplainNothingOfOtherPrograms) {
    const std::string endless =
        "#version 330\nuniform float uN; out vec4 c;\nvoid main() { float x = uN; int i = 0;\n"
        "while (i < 10) { x += 1.; }\nc = vec4(x * uN); }\n";
    const std::string unused = "#version 330\nuniform float uN; out vec4 c;\nvoid main() { c = vec4(1.); }\n";
    const SceneFolder folder(kHead +
                                 "Vertex a.vert\nFragment a.frag\nProgram P uN 1\nQuadXY 0 1\n"
                                 "Fragment b.frag\nProgram Q uN 1\nQuadXY 0 1\n",
                             {{"a.vert", kPlainVertex}, {"a.frag", endless}, {"b.frag", unused}});
    const render::LiveScene::Loading loading =
        render::LiveScene::load(context(), folder.scene(), {}, nullptr);
    std::vector<std::string> found;
    for (const Diagnostic& each : loading.diagnostics)
        if (each.id == "view-W02" || each.id == "glib-W24")
            found.push_back(each.id + " " + std::to_string(each.place.line));
    const int line = static_cast<int>(std::count(kHead.begin(), kHead.end(), '\n')) + 6;
    std::vector<std::string> expected{"glib-W24 " + std::to_string(line)};
    if (removesUniform(endless)) expected.emplace_back("view-W02 4");
    EXPECT_EQ(found, expected);
}

TEST(EndlessLoops, ExplainAnOverrideThatHasNoEffect) {
    const std::string endless =
        "#version 330\nuniform float uN; out vec4 c;\nvoid main() { float x = uN; int i = 0;\n"
        "while (i < 10) { x += 1.; }\nc = vec4(x * uN); }\n";
    const SceneFolder folder(kHead + "Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n",
                             {{"a.vert", kPlainVertex}, {"a.frag", endless}});
    RenderOptions options;
    options.set = {"uN=2"};
    render::Stats stats;
    const auto made = render::SceneRenderer::load(context(), folder.scene(), options, stats);
    std::vector<std::string> ids;
    for (const Diagnostic& each : made.diagnostics) ids.push_back(each.id);
    // A driver that keeps the loop keeps the uniform, and there is nothing to explain.
    EXPECT_EQ(ids,
              removesUniform(endless) ? std::vector<std::string>{"view-W02"} : std::vector<std::string>());
}

}  // namespace
}  // namespace glibra::test
