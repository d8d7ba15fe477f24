#include "view/debug_view/pixel_probe.h"

#include <cmath>
#include <glm/matrix.hpp>

#include "image/file.h"
#include "image/write.h"
#include "render/draw/view_matrices.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::ProbedPixel;
using view::Session;

std::vector<double> numbers(const ProbedPixel& probed, std::string_view name) {
    const view::ProbedValue* value = probed.find(name);
    return value ? value->numbers : std::vector<double>();
}

void expectNear(const std::vector<double>& found, const std::vector<double>& expected, double tolerance) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << i;
}

TEST(PixelProbe, GivesInputsOfEveryTypeAsTheVertexStageWritesThem) {
    const SceneFolder folder(
        kHead + kProgram + "QuadXY 0 1\n",
        {{"a.vert",
          "#version 330\nout vec2 vXY; flat out int vInt; out mat2 vMatrix; out float vList[3];\n"
          "out Surface { vec3 n; float unread; } surface;\n"
          "void main() { vXY = aVertex.xy; vInt = -70000; vMatrix = mat2(1., 2., aVertex.x, 4.);\n"
          "vList = float[3](5., 2. * aVertex.y, 7.); surface.n = vec3(aVertex.x, aVertex.y, 3.);\n"
          "surface.unread = 9.; gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
         {"a.frag",
          "#version 330\nin vec2 vXY; flat in int vInt; in mat2 vMatrix; in float vList[3];\n"
          "in Surface { vec3 n; float unread; } surface; out vec4 first; out vec4 c;\n"
          "void main() { first = vec4(vXY, float(vInt), vMatrix[0][0] + vList[1]); c = vec4(surface.n, -2.); "
          "}\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const ProbedPixel probed = session.probe(10, 5);
    ASSERT_TRUE(probed.isDrawn) << text(session.diagnostics());
    EXPECT_EQ(probed.word, "QuadXY");
    EXPECT_EQ(probed.program, "P");
    // The centre of a pixel; y counts downwards.
    const double x = 10.5 / 20 - 1, y = 1 - 5.5 / 20;
    expectNear(numbers(probed, "vXY"), {x, y}, 1e-6);
    expectNear(numbers(probed, "vInt"), {-70000}, 0);
    expectNear(numbers(probed, "vMatrix"), {1, 2, x, 4}, 1e-6);
    expectNear(numbers(probed, "vList"), {5, 2 * y, 7}, 1e-5);
    expectNear(numbers(probed, "surface.n"), {x, y, 3}, 1e-6);
    expectNear(numbers(probed, "surface.unread"), {9}, 0);
    expectNear(numbers(probed, "gl_FragCoord"), {10.5, 34.5, .5, 1}, 1e-6);
    expectNear(numbers(probed, "gl_FrontFacing"), {1}, 0);
    EXPECT_TRUE(probed.isFront);
    // Outputs are not limited to 0..1.
    expectNear(numbers(probed, "c"), {x, y, 3, -2}, 1e-6);
    expectNear(numbers(probed, "first"), {x, y, -70000, 1 + 2 * y}, 1e-2);
}

TEST(PixelProbe, AnswersForTheVisibleFragmentOfSeveralThatBlend) {
    const std::string fragment =
        "#version 330\nuniform float uId; in vec4 vST; out vec4 c;\nvoid main() { if (vST.s < .5) discard; c "
        "= "
        "vec4(uId, 0., 0., .5); }\n";
    const std::string draws =
        "Vertex a.vert\nFragment a.frag\nProgram Near uId 1.\nQuadXY .5 1\nProgram Far uId 2.\nQuadXY 0 1\n";
    const SceneFolder folder(kHead + "Color 1 1 1\nQuadXY -.5 1\n" + draws,
                             {{"a.vert", kPlainVertex}, {"a.frag", fragment}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const ProbedPixel right = session.probe(30, 20);
    ASSERT_TRUE(right.isDrawn);
    EXPECT_EQ(right.program, "Near");
    EXPECT_EQ(right.draw.line, 8);
    expectNear(numbers(right, "uId"), {1}, 0);
    expectNear(numbers(right, "c"), {1, 0, 0, .5}, 0);
    EXPECT_NEAR(right.depth, .25, 1e-6);
    const ProbedPixel left = session.probe(10, 20);
    ASSERT_TRUE(left.isDrawn) << "through what is discarded";
    EXPECT_EQ(left.program, "");
    EXPECT_EQ(left.draw.line, 4);
}

TEST(PixelProbe, InterpolatesInPerspective) {
    // The plane z = -x through the origin, seen by an eye at (0, 0, 4): the ray through a pixel at the height
    // of the eye meets it where x = 4 t / (1 - t), with t the tangent of the ray's angle.
    const SceneFolder folder(
        "WindowSize 40 40\nPerspective 90 1 100\nLookAt 0 0 4 0 0 0 0 1 0\n" + kProgram + "QuadXY 0 3\n",
        {{"a.vert",
          "#version 330\nout vec3 vPlace;\nvoid main() { vec4 p = vec4(aVertex.x, aVertex.y, -aVertex.x, "
          "1.);\n"
          "vPlace = p.xyz; gl_Position = uModelViewProjectionMatrix * p; }\n"},
         {"a.frag", "#version 330\nin vec3 vPlace; out vec4 c;\nvoid main() { c = vec4(vPlace, 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    for (const int pixel : {10, 15, 25}) {
        const ProbedPixel probed = session.probe(pixel, 20);
        ASSERT_TRUE(probed.isDrawn) << pixel;
        // The distance of the point along the view is 4 - z = 4 + x, and x = t (4 + x).
        const double t = (pixel + .5) / 20 - 1, x = 4 * t / (1 - t);
        const double y = (1 - 20.5 / 20) * (4 + x);
        expectNear(numbers(probed, "vPlace"), {x, y, -x}, 1e-4);
    }
}

TEST(PixelProbe, SaysNothingWhereNothingIsDrawn) {
    const SceneFolder folder(kHead + "QuadXY 0 .2\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_FALSE(session.probe(2, 2).isDrawn);
    EXPECT_FALSE(session.probe(-1, 2).isDrawn);
    EXPECT_FALSE(session.probe(2, 40).isDrawn);
    EXPECT_TRUE(session.probe(20, 20).isDrawn);
}

TEST(PixelProbe, ListsUniformsAndNamesOfOldShadersAsTheirAuthorsWriteThem) {
    const SceneFolder folder(
        kHead +
            "Timer 10\nVertex a.vert\nFragment a.frag\nProgram Old uTint {.25 .5 .75} uList [1. 2. "
            "3.]\nQuadXY 0 1\n",
        {{"a.vert",
          "#version 120\nvoid main() { gl_TexCoord[0] = gl_MultiTexCoord0; gl_Position = ftransform(); }\n"},
         {"a.frag",
          "#version 120\nuniform vec3 uTint; uniform float uList[3];\nvoid main() { gl_FragColor = "
          "vec4(uTint * "
          "gl_TexCoord[0].s, uList[2] + Timer); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.clock().setTime(2.5);
    const ProbedPixel probed = session.probe(30, 20);
    ASSERT_TRUE(probed.isDrawn);
    expectNear(numbers(probed, "uTint"), {.25, .5, .75}, 1e-6);
    expectNear(numbers(probed, "uList"), {1, 2, 3}, 0);
    expectNear(numbers(probed, "Timer"), {.25}, 1e-6);
    const double s = 30.5 / 40;
    ASSERT_TRUE(probed.find("gl_TexCoord"));
    EXPECT_NEAR(numbers(probed, "gl_TexCoord").at(0), s, 1e-5);
    expectNear(numbers(probed, "gl_FragColor"), {.25 * s, .5 * s, .75 * s, 3.25}, 1e-5);
}

/// A vertex shader whose outputs need two matrices and three attributes besides those of the position.
const std::string kRichVertex =
    "#version 330\nuniform float uScale; uniform sampler2D uMap;\nout vec3 vPosition, vNormal, vColor; out "
    "vec2 "
    "vST; out float vScaled, vRead;\nvoid main() { vPosition = vec3(uModelViewMatrix * aVertex); vNormal = "
    "uNormalMatrix * aNormal;\nvColor = aColor.rgb; vST = aTexCoord0.st; vScaled = 2. * uScale; vRead = "
    "textureLod(uMap, vec2(.5), 0.).g;\ngl_Position = uModelViewProjectionMatrix * aVertex; }\n";
const std::string kRichInputs =
    "#version 330\nin vec3 vPosition, vNormal, vColor; in vec2 vST; in float vScaled, vRead; out vec4 c;\n";

TEST(PixelProbe, GivesInputsThatThePictureDoesNotDependOn) {
    // The program of the picture reads neither the normals, colours and texture coordinates nor the matrices,
    // the uniform and the texture that these inputs are made from.
    const SceneFolder folder(
        kHead +
            "Color .25 .5 .75\nRotate 30 0 1 0\n"
            "Vertex a.vert\nFragment a.frag\nProgram P uScale 1.5 uMap 6\nTexture 6 map.bmp\nQuadXY 0 1\n",
        {{"a.vert", kRichVertex}, {"a.frag", kRichInputs + "void main() { c = vec4(1., 0., 0., 1.); }\n"}});
    image::Image green{2, 2, 3, image::Component::u8, {}};
    for (int i = 0; i < 4; ++i)
        for (const int each : {0, 204, 0}) green.data.push_back(static_cast<std::byte>(each));
    ASSERT_TRUE(image::writeImage(green, folder / "map.bmp", {}).empty());
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    const std::vector<std::byte> before = pixelsOf(session);
    const std::uint64_t frames = session.framesDrawn();
    for (const int pixel : {8, 20, 30}) {
        const ProbedPixel probed = session.probe(pixel, 12);
        ASSERT_TRUE(probed.isDrawn) << pixel;
        const double angle = std::acos(-1.) / 6;
        const double x = (pixel + .5) / 20 - 1, y = 1 - 12.5 / 20;
        expectNear(numbers(probed, "vPosition"), {x, y, -x * std::tan(angle)}, 1e-5);
        expectNear(numbers(probed, "vNormal"), {std::sin(angle), 0, std::cos(angle)}, 1e-5);
        expectNear(numbers(probed, "vColor"), {.25, .5, .75}, 1e-6);
        expectNear(numbers(probed, "vST"), {(x / std::cos(angle) + 1) / 2, (y + 1) / 2}, 1e-5);
        expectNear(numbers(probed, "vScaled"), {3}, 0);
        expectNear(numbers(probed, "vRead"), {.8}, 1e-6);
        expectNear(numbers(probed, "c"), {1, 0, 0, 1}, 0);
        EXPECT_EQ(probed.find("uScale"), nullptr) << "the picture does not read it";
        EXPECT_EQ(probed.find("glibra_debugChoice"), nullptr);
    }
    EXPECT_EQ(session.framesDrawn(), frames) << "the probe makes no frame necessary";
    session.setNeedsFrame();
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before);
    const plan::FramePlan& plan = session.live().plan();
    ASSERT_EQ(plan.programs.size(), 1U);
    EXPECT_EQ(plan.programs.begin()->interface->inputs.size(), 1U) << "frames read the position alone again";
}

TEST(PixelProbe, GivesInputsThatComeFromATextureWhichThePictureDoesNotRead) {
    // Only the probe needs the pass; its texture is half red on the left, and the vertex stage reads it.
    const SceneFolder folder(
        "WindowSize 40 40\nCamera eye LookAt 0 0 1  0 0 0  0 1 0  Ortho -1 1 -1 1 0 2\n"
        "Texture2D map 8 8 rgba8 nearest clamp\n"
        "Vertex flat.vert\nFragment flat.frag\nProgram Flat\n"
        "Vertex a.vert\nFragment a.frag\nProgram P uMap map\n"
        "Use Flat\nPass map clear {0 0 0}\n    QuadXY 0 1\nEndPass\nUse P\nQuadXY 0 1\n",
        {{"flat.vert", kPlainVertex},
         {"flat.frag", "#version 330\nin vec4 vST; out vec4 c;\nvoid main() { c = vec4(.2, .4, .6, 1.); }\n"},
         {"a.vert", kRichVertex},
         {"a.frag", kRichInputs + "void main() { c = vec4(vST, 0., 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    session.drawIfNeeded();
    const std::vector<std::byte> before = pixelsOf(session);
    const ProbedPixel probed = session.probe(10, 20);
    ASSERT_TRUE(probed.isDrawn) << text(session.diagnostics());
    expectNear(numbers(probed, "vRead"), {.4}, 1. / 255);
    expectNear(numbers(probed, "vNormal"), {0, 0, 1}, 1e-6);
    EXPECT_TRUE(session.probe(30, 20).isDrawn);
    session.setNeedsFrame();
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before);
}

TEST(PixelProbe, GivesTheEyeSpaceOfTheTemplateTeapot) {
    Session session(context(), {});
    ASSERT_TRUE(session.open(GLIBRA_SOURCE_DIR "/glib/start/teapot.glib")) << text(session.diagnostics());
    session.look().resize(300, 200);
    session.drawIfNeeded();
    const ProbedPixel probed = session.probe(150, 110);
    ASSERT_EQ(probed.program, "Glaze") << text(session.diagnostics());
    // The position in eye space is where the pixel's window coordinates and depth come from.
    const scene::Draw* draw = nullptr;
    for (const scene::Pass& pass : session.live().scene().frame.passes)
        for (const auto& step : pass.steps)
            if (const auto* each = std::get_if<scene::Draw>(&step); each && each->id == probed.draw)
                draw = each;
    ASSERT_NE(draw, nullptr);
    const glm::dvec4 clip(2 * 150.5 / 300 - 1, 1 - 2 * 110.5 / 200, 2 * probed.depth - 1, 1);
    const glm::dvec4 eye = glm::inverse(session.live().view().projection(*draw->projection, 1.5)) * clip;
    expectNear(numbers(probed, "vPosition"), {eye.x / eye.w, eye.y / eye.w, eye.z / eye.w}, 1e-3);
    const std::vector<double> normal = numbers(probed, "vNormal"), st = numbers(probed, "vST");
    ASSERT_EQ(normal.size(), 3U);
    EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, .02) << "the interpolated unit normal";
    ASSERT_EQ(st.size(), 2U);
    EXPECT_GT(std::hypot(st[0], st[1]), 0) << "the picture does not read vST";
}

TEST(PixelProbe, NamesInputsThatNoStageWrites) {
    const SceneFolder folder(
        kHead + kProgram + "QuadXY 0 1\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nin vec4 vST; in vec3 vForgotten; out vec4 c;\nvoid main() { c = vST; }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const ProbedPixel probed = session.probe(20, 20);
    ASSERT_TRUE(probed.isDrawn);
    expectNear(numbers(probed, "vST"), {20.5 / 40, 19.5 / 40, 0, 1}, 1e-5);
}

TEST(PixelProbe, LeavesThePictureAndTheStateAsTheyWere) {
    const SceneFolder folder(
        kHead + kProgram + "QuadXY 0 .5\nTranslate .2 .2 .2\nRotate 20 1 1 0\nQuadXY 0 .5\n",
        {{"a.vert", kPlainVertex},
         {"a.frag", "#version 330\nin vec4 vST; out vec4 c;\nvoid main() { c = vec4(vST.st, 1., .5); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const std::vector<std::byte> before = pixelsOf(session);
    EXPECT_TRUE(session.probe(20, 20).isDrawn);
    EXPECT_TRUE(pixelsOf(session) == before);
    session.setNeedsFrame();
    session.drawIfNeeded();
    EXPECT_TRUE(pixelsOf(session) == before);
    EXPECT_TRUE(session.diagnostics().empty()) << text(session.diagnostics());
}

}  // namespace
}  // namespace glibra::test
