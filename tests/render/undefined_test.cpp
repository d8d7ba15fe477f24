// --check-undefined: what shaders do that GLSL leaves undefined is counted and reported with its place.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "modern_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

constexpr const char* kAnyVertex =
    "#version 430 core\nvoid main() { gl_Position = vec4(aVertex.xy, 0, 1); }\n";

class Undefined : public testing::Test {
  protected:
    void SetUp() override {
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }

    /// "line: text" of each message about undefined effects of a picture of 4 x 4 pixels.
    static std::vector<std::string> found(const std::string& scene, bool isChecked = true) {
        RenderOptions options;
        options.checkUndefined = isChecked;
        const SceneFolder folder(scene, {{"a.vert", kAnyVertex}});
        std::vector<std::string> all;
        for (const Diagnostic& each : draw(folder, options).diagnostics)
            if (each.id >= "glsl-W29" && each.id <= "glsl-W32" && each.id.starts_with("glsl-W"))
                all.push_back(std::to_string(each.place.line) + ": " + each.text);
        return all;
    }

    /// A scene whose fragment stage has that statement in line 10.
    static std::string stating(const std::string& statement) {
        return "WindowSize 4 4\nTexture2D map 2 3 rgba8\nFragment inline\n#version 430 core\n"
               "uniform int uN; uniform float uZero; uniform sampler2D uMap; out vec4 f;\n"
               "struct Pair { float a[3]; };\nfloat twice(float x) { return 2. * x; }\n"
               "void main() {\n  f = vec4(.5);\n  " +
               statement +
               "\n}\nEndFragment\nProgram P  uN 3 uZero 0. uMap map\n"
               "Fill window with P\n";
    }
};

struct Case {
    const char* statement;
    std::vector<std::string> messages;
};

TEST_F(Undefined, EffectsAreReportedWhereTheyHappen) {
    const std::vector<Case> cases{
        {"float a[3] = float[3](1., 2., 3.); f.r = a[uN];",
         {"the subscript in 'a[uN]' is outside of the 3 elements 16 times, the first time 3"}},
        {"Pair p = Pair(float[3](1., 2., 3.)); f.r = p.a[uN - 4];",
         {"the subscript in 'p.a[uN-4]' is outside of the 3 elements 16 times, the first time -1"}},
        {"mat2 m = mat2(1.); f.rg = m[uN];",
         {"the subscript in 'm[uN]' is outside of the 2 elements 16 times, the first time 3"}},
        {"f[uN + 1] = 1.;",
         {"the subscript in 'f[uN+1]' is outside of the 4 elements 16 times, the first time 4"}},
        {"f[int(gl_FragCoord.x) + 1] = 1.;",
         {"the subscript in 'f[int(gl_FragCoord.x)+1]' is outside of the 4 elements 4 times, the first time "
          "4"}},
        {"f[uN] = 1.;", {}},
        {"f = texelFetch(uMap, ivec2(gl_FragCoord.xy), 0);",
         {"'texelFetch(uMap,ivec2(gl_FragCoord.xy),0)' is outside 10 times, the first time at "}},
        {"f = texelFetch(uMap, ivec2(1, 2), 0);", {}},
        {"f = texelFetch(uMap, ivec2(0), uN);",
         {"'texelFetch(uMap,ivec2(0),uN)' names a level that the texture lacks 16 times, the first time 3 of "
          "1 levels"}},
        {"f.r = 1. / uZero;", {"the divisor 'uZero' is 0 16 times"}},
        {"f.r = 1. / (uZero * 2.);", {"the divisor '(uZero*2.)' is 0 16 times"}},
        {"f.r = mod(1., uZero);", {"the divisor 'uZero' is 0 16 times"}},
        {"f.r /= uZero + 1.;", {}},
        {"f.r = float(5 % (uN - 3));", {"the divisor '(uN-3)' is 0 16 times"}},
        {"f.r = float(5 / int(gl_FragCoord.x));", {"the divisor 'int(gl_FragCoord.x)' is 0 4 times"}},
        // A quotient that is infinite at some pixels is no mistake, if no uniform is the reason.
        {"f.r = min(1. / floor(gl_FragCoord.x), 2.);", {}},
        {"f.r = twice(1.) / twice(2.);", {}}};
    for (const Case& each : cases) {
        const std::vector<std::string> messages = found(stating(each.statement));
        ASSERT_EQ(messages.size(), each.messages.size()) << each.statement;
        for (std::size_t i = 0; i < messages.size(); ++i)
            EXPECT_TRUE(messages[i].starts_with("10: " + each.messages[i])) << messages[i];
        EXPECT_EQ(found(stating(each.statement), false), std::vector<std::string>()) << each.statement;
    }
}

TEST_F(Undefined, VerticesBeyondTheMostAreCounted) {
    EXPECT_EQ(
        found("WindowSize 4 4\nVertex a.vert\nGeometry inline\n#version 430 core\nlayout(triangles) in;\n"
              "layout(triangle_strip, max_vertices = 4) out; uniform int uN;\nvoid main() {\n"
              "  for (int i = 0; i < uN; ++i) { gl_Position = gl_in[i % 3].gl_Position;\n"
              "    EmitVertex(); }\n}\nEndGeometry\nFragment inline\n#version 430 core\nout vec4 f;\n"
              "void main() { f = vec4(.5); }\nEndFragment\nLet n 6\nProgram P  uN n\n"
              "Vertices triangles 3\n"),
        (std::vector<std::string>{"9: EmitVertex() exceeds max_vertices = 4 2 times; the surplus is lost"}));
}

TEST_F(Undefined, InvocationsOfControlStagesHaveTheirOwnVertex) {
    const auto scene = [](const char* statement) {
        return std::string(
                   "WindowSize 4 4\nVertex a.vert\nTessControl inline\n#version 430 core\n"
                   "layout(vertices = 3) out;\nout float vSize[];\nvoid main() {\n") +
               statement +
               "\n  vSize[gl_InvocationID] = 1.;\n"
               "  gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
               "  gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelInner[0] "
               "= 1.;\n"
               "}\nEndTessControl\nTessEvaluation inline\n#version 430 core\nlayout(triangles) in;\n"
               "in float vSize[];\nvoid main() { gl_Position = gl_in[0].gl_Position * gl_TessCoord.x * "
               "vSize[0]; }\n"
               "EndTessEvaluation\nFragment inline\n#version 430 core\nout vec4 f;\nvoid main() { f = "
               "vec4(.5); }\n"
               "EndFragment\nLet n 6\nProgram P\nglBegin patches 3\nglVertex 0 0 0\nglVertex 1 0 0\n"
               "glVertex 0 1 0\nglEnd\n";
    };
    EXPECT_EQ(found(scene("  float own = 1.;")), std::vector<std::string>());
    // An array of the invocation's own is another matter.
    EXPECT_EQ(
        found(scene("  float a[2] = float[2](1., 2.); gl_TessLevelInner[1] = a[gl_InvocationID];")),
        (std::vector<std::string>{"8: the subscript in 'a[gl_InvocationID]' is outside of the 2 elements "
                                  "once, the first time 2"}));
}

/// Shipped scenes do nothing undefined, and are drawn as without the option.
TEST_F(Undefined, ShippedScenesAreFreeOfItAndKeepTheirPictures) {
    int drawn = 0;
    for (const char* folder : {"start", "tessellation", "geometry"})
        for (const auto& each : std::filesystem::directory_iterator(std::filesystem::path(GLIBRA_SOURCE_DIR) /
                                                                    "glib" / folder)) {
            if (each.path().extension() != ".glib") continue;
            std::vector<std::byte> pixels[2];
            for (const bool isChecked : {false, true}) {
                render::Stats stats;
                RenderOptions options;
                options.width = 48;
                options.height = 36;
                options.checkUndefined = isChecked;
                auto scene = render::SceneRenderer::load(sharedContext(), each.path(), options, stats);
                ASSERT_TRUE(scene) << each.path() << text(scene.diagnostics);
                const Result<image::Image> picture = scene->draw(0, stats);
                ASSERT_TRUE(picture) << each.path() << text(picture.diagnostics);
                EXPECT_EQ(text(picture.diagnostics).find("[glsl-W"), std::string::npos)
                    << each.path() << text(picture.diagnostics);
                pixels[isChecked ? 1 : 0] = picture->data;
            }
            EXPECT_TRUE(pixels[0] == pixels[1]) << each.path();
            ++drawn;
        }
    EXPECT_GT(drawn, 12);
}

}  // namespace
}  // namespace glibra::test
