// Lines that are wider than a driver of OpenGL ES draws them, compared with Mesa's own wide lines.

#include <glibra/scene.h>

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

PFNGLGETFLOATVPROC ownGetFloatv = nullptr;

/// The driver's answers, but for the range of line widths: that of drivers which draw them one pixel wide.
void getFloatv(GLenum what, GLfloat* values) {
    ownGetFloatv(what, values);
    if (what == GL_ALIASED_LINE_WIDTH_RANGE) values[0] = values[1] = 1;
}

/// Contexts of OpenGL ES that are opened meanwhile have thin lines.
class ThinLines {
  public:
    ThinLines() {
        ownGetFloatv = glad_glGetFloatv;
        glad_glGetFloatv = getFloatv;
    }
    ThinLines(const ThinLines&) = delete;
    ThinLines& operator=(const ThinLines&) = delete;
    ~ThinLines() { glad_glGetFloatv = ownGetFloatv; }
};

class WideLines : public testing::Test {
  protected:
    void SetUp() override {
        const Result<gpu::Context> context = gpu::openContext({.driver = Driver::gles});
        if (!context || !context->capabilities().isSoftware)
            GTEST_SKIP() << "no OpenGL ES by Mesa's software driver";
    }
};

struct BothLines {
    Picture own, made;        ///< by Mesa's wide lines, and by quads
    Diagnostics diagnostics;  ///< of the second one
};

BothLines bothLines(const std::string& scene, const RenderOptions& options) {
    const SceneFolder folder(scene);
    // Opening a context of this driver fills the table of functions, which is then changed.
    Result<Renderer> wide = Renderer::open(Driver::gles);
    if (!wide) throw std::runtime_error(text(wide.diagnostics));
    Result<Picture> own = wide->render(folder / "scene.glib", options);
    EXPECT_TRUE(own) << text(own.diagnostics);
    const ThinLines thin;
    Result<Renderer> narrow = Renderer::open(Driver::gles);
    if (!narrow) throw std::runtime_error(text(narrow.diagnostics));
    Result<Picture> made = narrow->render(folder / "scene.glib", options);
    EXPECT_TRUE(made) << text(made.diagnostics);
    if (!own || !made) throw std::runtime_error("no picture");
    return {std::move(*own), std::move(*made), std::move(made.diagnostics)};
}

/// Pixels that differ by more than 2 of 255, and those that are not black in the first picture.
struct LineCounts {
    int different = 0, drawn = 0;
};

LineCounts linesCompared(const Picture& own, const Picture& made) {
    LineCounts counts;
    for (int y = 0; y < own.height; ++y)
        for (int x = 0; x < own.width; ++x) {
            const auto a = pixel(own, x, y), b = pixel(made, x, y);
            int most = 0;
            for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(a.at(i) - b.at(i)));
            counts.different += most > 2 ? 1 : 0;
            counts.drawn += a != std::array{0, 0, 0} ? 1 : 0;
        }
    return counts;
}

LineCounts lineCounts(const std::string& scene, const RenderOptions& options = {}) {
    const BothLines pictures = bothLines(scene, options);
    EXPECT_EQ(text(pictures.diagnostics), "");
    return linesCompared(pictures.own, pictures.made);
}

/// A program whose vertices are the number `i`, and begin of a scene of 200 x 150 pixels.
std::string linesOf(const std::string& place, const std::string& color = "vec3(1., .8, .2)",
                    const std::string& stages = "", const std::string& qualifier = "") {
    return "WindowSize 200 150\nBackground 0 0 0\nVertex inline\n#version 330 core\n" + qualifier +
           " out vec3 vColor;\nvoid main() {\n int i = gl_VertexID;\n vec2 pixel = " + place +
           ";\n vColor = " + color +
           ";\n gl_Position = vec4(pixel / vec2(100., 75.) - 1., 0., 1.);\n}\nEndVertex\n" + stages +
           "Fragment inline\n#version 330 core\n" + qualifier +
           " in vec3 vColor;\nout vec4 fColor;\nvoid main() { fColor = vec4(vColor, 1.); }\nEndFragment\n"
           "Program Lines\n";
}

/// Horizontal and vertical lines in both directions. Their places are eighths of pixels and a bit more, so
/// that no end is on the edge of a diamond.
const std::string kParallel =
    "(i / 2 % 2 == 0 ? vec2(4.03 + float(i % 2) * 80.375 + float(i / 2) * .125, 3. + float(i / 2) * 5.125)"
    " : vec2(100. + float(i / 2) * 4.125, 10.03 + .125 * float(i / 2) + float(1 - i % 2) * 120.))";
const std::string kMirrored = "(vec2(200., 150.) - " + kParallel + ")";
/// Radii of a circle.
const std::string kStar =
    "(vec2(100., 75.) + float(10 + 55 * (i % 2)) * vec2(cos(float(i / 2) * .1963), sin(float(i / 2) * "
    ".1963)))";

TEST_F(WideLines, AreThoseOfTheDriverAlongTheAxes) {
    for (const std::string& each : {kParallel, kMirrored})
        for (const char* width : {"2", "3", "4", "7.5", "1.4"}) {
            SCOPED_TRACE(width);
            const LineCounts counts =
                lineCounts(linesOf(each) + "LineWidth " + width + "\nVertices lines 48\n");
            EXPECT_EQ(counts.different, 0);
            EXPECT_GT(counts.drawn, 1000);
        }
}

TEST_F(WideLines, AreThoseOfTheDriverInOtherDirections) {
    for (const char* width : {"2", "3", "8"}) {
        const LineCounts counts = lineCounts(linesOf(kStar, "vec3(1., float(i % 2), float(i) / 64.)") +
                                             "LineWidth " + width + "\nVertices lines 64\n");
        EXPECT_LT(counts.different * 100, counts.drawn * 2);
        EXPECT_GT(counts.drawn, 1000);
    }
}

TEST_F(WideLines, AreRectanglesWithSamples) {
    RenderOptions options;
    options.samples = 4;
    const LineCounts counts = lineCounts(linesOf(kStar) + "LineWidth 5\nVertices lines 64\n", options);
    EXPECT_LT(counts.different * 100, counts.drawn * 2);
    // Mesa loses columns and rows of samples whose left or lower edge is just before a multiple of 64 pixels.
    const LineCounts parallel = lineCounts(
        linesOf("(vec2(.03, 0.) + " + kParallel + ")") + "LineWidth 3\nVertices lines 48\n", options);
    EXPECT_LT(parallel.different * 100, parallel.drawn * 3);
}

TEST_F(WideLines, AreMadeOfStripsLoopsAndIndices) {
    const std::string path = "vec2(100. + 80. * cos(float(i) * 2.4), 75. + 60. * sin(float(i) * 2.4))";
    for (const char* draw :
         {"Vertices line_strip 9", "Vertices line_loop 9", "Vertices lines 10",
          "Buffer order uint [0 3 1 4  4294967295  7 2 8]\nVertices line_strip indices order",
          "Buffer order uint [0 3 1 4  4294967295  7 2 8]\nVertices line_loop indices order",
          "Buffer order uint [0 3 1 4 7 2]\nVertices lines indices order"}) {
        SCOPED_TRACE(draw);
        for (const char* qualifier : {"", "flat"}) {
            const LineCounts counts =
                lineCounts(linesOf(path, "vec3(float(i % 2), .5, float(i % 3) * .5)", "", qualifier) +
                           "LineWidth 5\n" + draw + "\n");
            EXPECT_LT(counts.different * 100, counts.drawn * 2);
            EXPECT_GT(counts.drawn, 500);
        }
    }
}

TEST_F(WideLines, AreThoseOfAllInstances) {
    const std::string place =
        "vec2(20. + float(gl_InstanceID) * 30. + float(i % 2) * 20., 20. + float(i) * 30. + 15. * "
        "float(gl_InstanceID % 2))";
    const LineCounts counts = lineCounts(linesOf(place, "vec3(float(gl_InstanceID) * .2, 1., float(i % 2))") +
                                         "LineWidth 4\nInstances 5\nVertices line_strip 4\n");
    EXPECT_LT(counts.different * 100, counts.drawn * 2);
    EXPECT_GT(counts.drawn, 500);
}

TEST_F(WideLines, AreThoseThatAGeometryStageEmits) {
    for (const int most : {4, 20}) {
        const std::string last = std::to_string(most - 1);
        const std::string geometry =
            "Geometry inline\n#version 330 core\nlayout(points) in;\nlayout(line_strip, max_vertices = " +
            std::to_string(most) +
            ") out;\nin vec3 vColor[];\nout vec3 vEdge;\nvoid main() {\n for (int i = 0; i < " + last +
            "; ++i) {\n  vEdge = mix(vColor[0], vec3(0., 1., 0.), float(i) / " + last +
            ".);\n  gl_Position = gl_in[0].gl_Position + vec4(.0513 * float(i), .1071 * float(i % 2), 0., "
            "0.);\n  "
            "EmitVertex();\n }\n"
            " EndPrimitive();\n}\nEndGeometry\n";
        std::string scene = linesOf("vec2(10. + 4. * float(i), 8. + 14. * float(i))",
                                    "vec3(1., .2, float(i) * .1)", geometry);
        scene.replace(scene.rfind("in vec3 vColor"), 14, "in vec3 vEdge ");
        scene.replace(scene.rfind("vColor"), 6, "vEdge");
        const LineCounts counts = lineCounts(scene + "LineWidth 3\nVertices points 9\n");
        EXPECT_LT(counts.different * 100, counts.drawn * 2);
        EXPECT_GT(counts.drawn, 300);
    }
}

TEST_F(WideLines, AreThoseThatTessellationDelivers) {
    for (const char* const control :
         {"TessLevels 3 20 1 1 1 1\n",
          "layout(vertices = 2) out;\nin vec3 vColor[];\nout vec3 tColor[];\nvoid main() {\n"
          " gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
          " tColor[gl_InvocationID] = vColor[gl_InvocationID];\n gl_TessLevelOuter[0] = 3.;\n"
          " gl_TessLevelOuter[1] = 9. + 20. * vColor[0].x;\n}\n"}) {
        const bool isStage = control[0] == 'l';
        const std::string input = isStage ? "tColor" : "vColor";
        const std::string stages =
            (isStage ? std::string("TessControl inline\n#version 410 core\n") + control + "EndTessControl\n"
                     : "") +
            "TessEvaluation inline\n#version 410 core\nlayout(isolines) in;\nin vec3 " + input +
            "[];\nout vec3 vEdge;\nvoid main() {\n float t = gl_TessCoord.x;\n"
            " gl_Position = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, t) + vec4(0., .3 * sin(9. * t) + "
            ".2 * "
            "gl_TessCoord.y, 0., 0.);\n vEdge = mix(" +
            input + "[0], vec3(0., t, 1.), gl_TessCoord.y);\n}\nEndTessEvaluation\n";
        std::string scene = linesOf("vec2(10. + 170. * float(i % 2), 30. + float(i) * 20.)",
                                    "vec3(float(i / 2), 1., .2)", stages);
        scene.replace(scene.rfind("in vec3 vColor"), 14, "in vec3 vEdge ");
        scene.replace(scene.rfind("vColor"), 6, "vEdge");
        const LineCounts counts = lineCounts(scene + (isStage ? "" : control) +
                                             "NumPatchVertices 2\nLineWidth 4\nVertices patches 4\n");
        EXPECT_LT(counts.different * 100, counts.drawn * 2);
        EXPECT_GT(counts.drawn, 2000);
    }
}

TEST_F(WideLines, MayBecomeMoreAndFewerFromFrameToFrame) {
    std::string scene = linesOf(
        "vec2(10. + 170. * float(i % 2), 30.)", "vec3(1.)",
        "TessControl inline\n#version 410 core\nlayout(vertices = 2) out;\nuniform float Timer;\nvoid main() "
        "{\n"
        " gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
        " gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = 1. + 60. * Timer;\n}\nEndTessControl\n"
        "TessEvaluation inline\n#version 410 core\nlayout(isolines) in;\nout vec3 vEdge;\nvoid main() {\n"
        " gl_Position = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x);\n"
        " gl_Position.y += gl_TessCoord.y + .2 * sin(9. * gl_TessCoord.x);\n"
        " vEdge = vec3(gl_TessCoord.xy, 1.);\n}\nEndTessEvaluation\n");
    scene.replace(scene.rfind("in vec3 vColor"), 14, "in vec3 vEdge ");
    scene.replace(scene.rfind("vColor"), 6, "vEdge");
    const SceneFolder folder(scene + "NumPatchVertices 2\nLineWidth 3\nVertices patches 2\n");
    const std::vector<double> times{0, 1, 9, 2, 9.5, .1};
    std::vector<Picture> own;
    Result<Renderer> wide = Renderer::open(Driver::gles);
    ASSERT_TRUE(wide);
    for (const double time : times) {
        RenderOptions options;
        options.time = time;
        Result<Picture> picture = wide->render(folder / "scene.glib", options);
        ASSERT_TRUE(picture) << text(picture.diagnostics);
        own.push_back(std::move(*picture));
    }
    const ThinLines thin;
    Result<Renderer> narrow = Renderer::open(Driver::gles);
    ASSERT_TRUE(narrow);
    Result<Scene> loaded = narrow->load(folder / "scene.glib");
    ASSERT_TRUE(loaded) << text(loaded.diagnostics);
    for (std::size_t i = 0; i < times.size(); ++i) {
        SCOPED_TRACE(times[i]);
        DrawOptions options;
        options.time = times[i];
        Result<Picture> picture = loaded->draw(options);
        ASSERT_TRUE(picture) << text(picture.diagnostics);
        EXPECT_EQ(text(picture.diagnostics), "");
        const LineCounts counts = linesCompared(own[i], *picture);
        EXPECT_LT(counts.different * 100, counts.drawn * 2);
        EXPECT_GT(counts.drawn, 400);
    }
}

TEST_F(WideLines, PassOnEveryKindOfOutput) {
    const std::string varyings =
        "flat %s ivec2 vWhole;\nflat %s uint vCount;\n%s float vList[3];\n%s mat2 vTurn;\n"
        "%s Block { vec2 at; } %s;\n";
    const auto as = [&](const std::string& way, const std::string& instance) {
        std::string text = varyings;
        for (std::size_t at; (at = text.find("%s")) != std::string::npos;)
            text.replace(at, 2, text.find("%s", at + 1) == std::string::npos ? instance : way);
        return text;
    };
    const LineCounts counts = lineCounts(
        "WindowSize 200 150\nBackground 0 0 0\nVertex inline\n#version 330 core\n" + as("out", "vOut") +
        "void main() {\n int i = gl_VertexID;\n vec2 at = vec2(cos(float(i) * 2.4), sin(float(i) * "
        "2.4));\n"
        " vWhole = ivec2(i, -i - 1);\n vCount = 4294967290u - uint(i);\n"
        " for (int k = 0; k < 3; ++k) vList[k] = float(i * k) / 20.;\n vTurn = mat2(at, -at);\n vOut.at "
        "= at;\n"
        " gl_Position = vec4(at * .8, 0., 1.);\n}\nEndVertex\nFragment inline\n#version 330 core\n" +
        as("in", "vIn") +
        "out vec4 fColor;\nvoid main() {\n float whole = float(vWhole.x - vWhole.y) / 40. + float(vCount "
        "% 16u) / 32.;\n"
        " fColor = vec4(whole, vList[1] + vList[2], .5 + .25 * dot(vTurn[1], vIn.at) + .1 * vTurn[0].x, "
        "1.);\n}\n"
        "EndFragment\nProgram Lines\nLineWidth 6\nVertices line_strip 9\n");
    EXPECT_LT(counts.different * 100, counts.drawn * 2);
    EXPECT_GT(counts.drawn, 2000);
}

TEST_F(WideLines, AreNumberedAndCut) {
    std::string scene = linesOf(kStar);
    scene.replace(scene.rfind("vec4(vColor, 1.)"), 16,
                  "vec4(vColor * float(gl_PrimitiveID % 4 + 1) / 4., 1.)");
    const LineCounts numbered = lineCounts(scene + "LineWidth 5\nVertices lines 64\n");
    EXPECT_LT(numbered.different * 100, numbered.drawn * 2);
    scene = linesOf(kStar);
    scene.insert(scene.find(" gl_Position"),
                 " gl_ClipDistance[0] = pixel.x - 60.;\n gl_ClipDistance[1] = 110. - pixel.y;\n");
    const LineCounts cut = lineCounts(scene + "LineWidth 5\nVertices lines 64\n");
    EXPECT_LT(cut.different * 100, cut.drawn * 2);
    EXPECT_LT(cut.drawn, numbered.drawn * 9 / 10);
}

TEST_F(WideLines, AreTheSameInTilesAndViewports) {
    RenderOptions tiled;
    tiled.tileSize = 64;
    const std::string lines = "LineWidth 5\nVertices lines 64\n";
    for (const std::string& each : {lines, "Viewport .1 .2 .7 .6\n" + lines}) {
        const LineCounts whole = lineCounts(linesOf(kStar) + each);
        EXPECT_LT(whole.different * 100, whole.drawn * 2);
        const BothLines one = bothLines(linesOf(kStar) + each, {}),
                        parts = bothLines(linesOf(kStar) + each, tiled);
        EXPECT_TRUE(isSame(one.own, parts.own)) << "by the driver";
        EXPECT_TRUE(isSame(one.made, parts.made));
    }
}

TEST_F(WideLines, LeaveWhatElseTheirProgramDraws) {
    const std::string scene =
        linesOf("vec2(30. + 60. * float(i % 3), 20. + 40. * float(i / 2))", "vec3(1., float(i % 2), .5)") +
        "Vertices triangles 3\nLineWidth 4\nVertices lines 4\nVertices points 6\nLineWidth 1\n"
        "Vertices line_loop 6\n";
    const LineCounts counts = lineCounts(scene);
    EXPECT_LT(counts.different * 100, counts.drawn);
    EXPECT_GT(counts.drawn, 1000);
    EXPECT_EQ(lineCounts(linesOf(kStar) + "Vertices lines 64\n").different, 0);
}

TEST_F(WideLines, AreThinWithOutputsThatCannotBeCaptured) {
    for (const char* const type : {"vec4 vMany[16]", "Pair vPair"}) {
        const std::string name = std::string(type).substr(0, 4) == "Pair" ? "vPair.a" : "vMany[15]";
        const std::string declared = std::string("struct Pair { vec4 a; };\n");
        const std::string scene =
            "WindowSize 64 64\nBackground 0 0 0\nVertex inline\n#version 330 core\n" + declared + "out " +
            type + ";\nvoid main() {\n " + name +
            " = vec4(1.);\n gl_Position = vec4(float(gl_VertexID) - .5, 0.01, 0., "
            "1.);\n}\nEndVertex\nFragment "
            "inline\n#version 330 core\n" +
            declared + "in " + type + ";\nout vec4 fColor;\nvoid main() { fColor = " + name +
            "; }\nEndFragment\nProgram Lines\nLineWidth 3\nVertices lines 2\nVertices lines 2\n";
        const BothLines pictures = bothLines(scene, {});
        EXPECT_TRUE(has(pictures.diagnostics, "draw-W04")) << type;
        EXPECT_EQ(pictures.diagnostics.size(), 1U) << text(pictures.diagnostics);
        EXPECT_EQ(countPixels(pictures.own, kWhite), 96);
        EXPECT_EQ(countPixels(pictures.made, kWhite), 32);
    }
}

/// A scene in space.
std::string inSpace(const std::string& camera, const std::string& draws) {
    return "WindowSize 200 150\nBackground 0 0 0\nCamera eye LookAt " + camera +
           " 0 1 0  Perspective 50 .5 100\nLineWidth 4\n" + draws;
}

TEST_F(WideLines, AreEdgesOfTriangles) {
    const LineCounts counts =
        lineCounts(inSpace("0 1 4  0 0 0 ",
                           "State polygon line cull off\nColor 1 .5 0\nBox 2\nColor 0 .5 "
                           "1\nTranslate 1 0 0\nSphere .7 8 6\n"));
    EXPECT_LT(counts.different * 100, counts.drawn * 2);
    EXPECT_GT(counts.drawn, 2000);
}

TEST_F(WideLines, AreClippedAtTheNearPlane) {
    for (const char* reversed : {"", "reversed"}) {
        const LineCounts counts = lineCounts(
            inSpace(".1 .05 0  0 0 -5 ", "Pass window " + std::string(reversed) +
                                             " clear {0 0 0}\nColor 1 .5 0\nScale .4 .3 20\nWireBox 1\n"
                                             "Color 0 .5 1\nWireTorus .2 .4\nEndPass\n"));
        EXPECT_LT(counts.different * 100, counts.drawn * 2);
        EXPECT_GT(counts.drawn, 1000);
    }
}

TEST_F(WideLines, BlendEachPixelOnce) {
    const std::string scene =
        linesOf(kStar, "vec3(.25)") + "State blend one one\nLineWidth 12\nVertices lines 16\n";
    const LineCounts counts = lineCounts(scene);
    EXPECT_LT(counts.different * 100, counts.drawn * 2);
    EXPECT_GT(counts.drawn, 2000);
}

}  // namespace
}  // namespace glibra::test
