// Passes of modern scenes: depth, layers, what is cleared and kept, tiles, and what is skipped.

#include <algorithm>
#include <cmath>

#include "modern_squares.h"
#include "scene_text.h"

namespace glibra::test {
namespace {

using base::TexelFormat;
using scene::TextureTarget;
using scene::TextureView;

TEST(ModernPasses, IntoDepthAloneNeedNoFragmentStage) {
    Squares scene;
    const auto shadow = scene.modern.texture("shadow", TexelFormat::depth32f, 4, 4);
    const auto depthOnly = scene.modern.program("Depth", {{glsl::Stage::vertex, kPlaceVertex}});
    scene.modern.pass({}, {}).depth = TextureView{.texture = shadow};
    scene.modern.square(depthOnly, -.5);
    scene.show({.texture = shadow});
    const ModernPicture picture = draw(scene.modern);
    EXPECT_EQ(picture.at(1, 1)[0], 64) << text(picture.diagnostics);
    EXPECT_TRUE(picture.diagnostics.empty()) << text(picture.diagnostics);
}

TEST(ModernPasses, TestAgainstTheDepthThatAnEarlierPassLeft) {
    Squares scene;
    const auto depth = scene.modern.texture("depth", TexelFormat::depth24, 4, 4);
    const auto color = scene.modern.texture("color", TexelFormat::rgba8, 4, 4);
    scene.modern.pass({}, {}).depth = TextureView{.texture = depth};
    scene.square(kRed, 0).raster.change().viewport = kLeft;
    scene::Pass& second = scene.modern.pass({color}, glm::dvec4(0, 0, 0, 1));
    second.depth = TextureView{.texture = depth};
    second.clearDepth = false;
    scene.square(kGreen, .5);
    scene.show({.texture = color});
    const ModernPicture picture = draw(scene.modern);
    EXPECT_EQ(picture.at(0, 1), (std::array{0, 0, 0})) << "behind what the first pass drew";
    EXPECT_EQ(picture.at(3, 1), (std::array{0, 255, 0}));
}

TEST(ModernPasses, DrawIntoAllLayersOfAWholeTexture) {
    Squares scene;
    const auto layers =
        scene.modern.texture("layers", TexelFormat::rgba8, 4, 4, TextureTarget::texture2DArray, 3);
    const auto layered = scene.modern.program("Layered", {{glsl::Stage::vertex, kPlaceVertex},
                                                          {glsl::Stage::geometry, R"(#version 330 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 9) out;
flat out int vLayer;
void main() {
    for (int layer = 0; layer < 3; ++layer) {
        for (int i = 0; i < 3; ++i) {
            gl_Layer = layer;
            vLayer = layer;
            gl_Position = gl_in[i].gl_Position;
            EmitVertex();
        }
        EndPrimitive();
    }
}
)"},
                                                          {glsl::Stage::fragment, R"(#version 330 core
flat in int vLayer;
out vec4 fColor;
void main() { fColor = vec4(float(vLayer) / 2., 1., 0., 1.); }
)"}});
    scene.modern.pass({layers}, glm::dvec4(0));
    scene.modern.square(layered);
    const auto array = scene.modern.shading("Array",
                                            "uniform sampler2DArray layers; out vec4 fColor; void main() { "
                                            "fColor = texture(layers, vec3(vST, floor(vST.s * 3.))); }");
    scene.modern.window();
    scene.modern.square(array);
    const ModernPicture picture = draw(scene.modern);
    EXPECT_EQ(picture.at(0, 1), (std::array{0, 255, 0}));
    EXPECT_EQ(picture.at(3, 1), (std::array{255, 255, 0}));
}

TEST(ModernPasses, ClearAndKeepEachPartAsTheySay) {
    // The second pass draws a far square; what it leaves tells colour, depth and stencil apart.
    for (const bool keepsColor : {false, true})
        for (const bool keepsDepth : {false, true})
            for (const bool keepsStencil : {false, true}) {
                SCOPED_TRACE(testing::Message() << keepsColor << keepsDepth << keepsStencil);
                Squares scene;
                scene.modern.window();
                scene::Draw& first = scene.square(kRed, 0);
                scene::RasterState& raster = first.raster.change();
                raster.viewport = kLeft;
                raster.stencilTest = true;
                raster.stencilFront.reference = raster.stencilBack.reference = 1;
                raster.stencilFront.pass = raster.stencilBack.pass = base::StencilAction::replace;
                scene::Pass& second =
                    scene.modern.window(keepsColor ? std::nullopt : std::optional(glm::dvec4(0, 0, 1, 1)));
                second.clearDepth = !keepsDepth;
                if (keepsStencil) second.clearStencil.reset();
                scene::Draw& far = scene.square(kGreen, .5);
                scene::RasterState& kept = far.raster.change();
                kept.stencilTest = true;  // drawn where the stencil is still 0
                kept.stencilFront.function = kept.stencilBack.function = base::Comparison::equal;
                const ModernPicture picture = draw(scene.modern);
                const std::array<int, 3> background =
                    keepsColor ? std::array{255, 0, 0} : std::array{0, 0, 255};
                EXPECT_EQ(picture.at(0, 1),
                          keepsDepth || keepsStencil ? background : (std::array{0, 255, 0}));
                EXPECT_EQ(picture.at(3, 1), (std::array{0, 255, 0}));
            }
}

TEST(ModernPasses, MirrorWithTheStencil) {
    Squares scene;
    scene.modern.window(glm::dvec4(0, 0, 1, 1));
    scene::Draw& mirror = scene.square(kRed, 0, .5);
    mirror.raster.change().write.fill({false, false, false, false});
    mirror.raster.change().depthWrite = false;
    mirror.raster.change().stencilTest = true;
    mirror.raster.change().stencilFront.reference = 1;
    mirror.raster.change().stencilFront.pass = base::StencilAction::replace;
    scene::Draw& image = scene.square(kGreen, .5);
    image.raster.change().stencilTest = true;
    image.raster.change().stencilFront.reference = 1;
    image.raster.change().stencilFront.function = base::Comparison::equal;
    const ModernPicture picture = draw(scene.modern);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            const bool isInside = x > 0 && x < 3 && y > 0 && y < 3;
            EXPECT_EQ(picture.at(x, y), isInside ? (std::array{0, 255, 0}) : (std::array{0, 0, 255}));
        }
}

TEST(ModernPasses, KeepViewportAndScissorInTiles) {
    Squares scene(40, 24);
    scene.modern.window(glm::dvec4(0, 0, 1, 1));
    scene::Draw& first = scene.square(kRed, .5);
    first.raster.change().viewport = {.125, .25, .5, .5};
    scene::Draw& second = scene.square(kGreen, 0, .5);
    second.raster.change().viewport = {.5, .25, .375, .625};
    second.raster.change().scissor = base::FractionRectangle{.25, .3, .5, .4};
    const ModernPicture whole = draw(scene.modern);
    RenderOptions options;
    options.tileSize = 16;
    EXPECT_TRUE(whole.image.data == draw(scene.modern, options).image.data);
    // Rectangles by hand: (5, 6) with 20 x 12 pixels; (20, 6) with 15 x 15 pixels, cut to its middle half.
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x) {
            const int up = 23 - y;
            const bool isRed = x >= 5 && x < 25 && up >= 6 && up < 18;
            const double centreX = x + .5 - 27.5, centreY = up + .5 - 13.5;
            const bool isGreen = std::abs(centreX) < 3.75 && std::abs(centreY) < 3.75 && x >= 10 && x < 30 &&
                                 up >= 7 && up < 17;
            const std::array<int, 3> wanted = isGreen ? std::array{0, 255, 0}
                                              : isRed ? std::array{255, 0, 0}
                                                      : std::array{0, 0, 255};
            ASSERT_EQ(whole.at(x, y), wanted) << x << ", " << up;
        }
}

TEST(ModernPasses, ThatNothingReadsAreSkipped) {
    Squares scene;
    const auto seen = scene.modern.texture("seen", TexelFormat::rgba8, 4, 4);
    const auto unseen = scene.modern.texture("unseen", TexelFormat::rgba8, 4, 4);
    const auto depth = scene.modern.texture("depth", TexelFormat::depth24, 4, 4);
    scene.modern.pass({seen}, glm::dvec4(0));  // overwritten before it is read
    scene.square(kRed);
    scene.modern.pass({unseen}, glm::dvec4(0));
    scene.square(kRed);
    scene.modern.pass({}, {}).depth = TextureView{.texture = depth};
    scene.square(kRed);
    scene.modern.pass({seen}, glm::dvec4(0, 0, 0, 1));
    scene.square(kGreen);
    scene.show({.texture = seen});
    scene.modern.pass({seen}, glm::dvec4(0));  // after the last reader
    scene.square(kRed);
    const ModernPicture picture = draw(scene.modern);
    EXPECT_EQ(picture.at(1, 1), (std::array{0, 255, 0}));
    std::vector<std::string> why;
    for (const plan::Skipped& each : picture.stats.skipped)
        if (each.what == "pass") why.push_back(each.why);
    EXPECT_EQ(why, (std::vector<std::string>{"nothing visible reads what it draws into 'seen'",
                                             "nothing visible reads what it draws into 'unseen'",
                                             "nothing visible reads what it draws into 'depth'",
                                             "nothing visible reads what it draws into 'seen'"}));
    RenderOptions everything;
    everything.skip = false;
    EXPECT_TRUE(picture.image.data == draw(scene.modern, everything).image.data);
}

TEST(ModernPasses, IntoIntegersClearToIntegers) {
    Squares scene;
    const auto numbers = scene.modern.texture("numbers", TexelFormat::r32i, 4, 4);
    scene.modern.pass({numbers}, glm::dvec4(-70000.9, 0, 0, 0));
    const auto show = scene.modern.shading("Show",
                                           "uniform isampler2D numbers; out vec4 fColor; void main() { "
                                           "fColor = vec4(texture(numbers, vST).r == -70000 ? 1. : 0.); }");
    scene.modern.window();
    scene.modern.square(show);
    EXPECT_EQ(draw(scene.modern).at(1, 1)[0], 255);
}

TEST(ModernPasses, AreFilledByProgramsWithoutVertexStage) {
    // As Fill: three vertices without data.
    for (const int tile : {0, 16}) {
        ModernScene modern(24, 20);
        const auto fill = modern.program("Fill", {{glsl::Stage::fragment, R"(#version 330 core
in vec2 vST;
out vec4 fColor;
void main() { fColor = vec4(vST, 0., 1.); }
)"}});
        modern.window();
        scene::Draw& drawn = modern.square(fill);
        scene::Shape triangle;
        triangle.numbers = {3};
        triangle.bare = geometry::Topology::triangles;
        drawn.shape = modern.scene.shapes.add(triangle);
        RenderOptions options;
        options.tileSize = tile;
        const ModernPicture picture = draw(modern, options);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 24; ++x) {
                const std::array<int, 3> found = picture.at(x, y);
                ASSERT_NEAR(found[0], (x + .5) / 24 * 255, 1) << text(picture.diagnostics);
                ASSERT_NEAR(found[1], (19.5 - y) / 20 * 255, 1);
            }
    }
}

TEST(ModernPasses, SayWhatIsFoundByName) {
    ModernScene modern(4, 4);
    const auto named = modern.program("Named", {{glsl::Stage::vertex, R"(#version 330 core
in vec3 vertPos;
uniform mat4 mvp;
void main() { gl_Position = mvp * vec4(vertPos, 1.); }
)"},
                                                {glsl::Stage::fragment, R"(#version 330 core
uniform float uSize;
out vec4 fColor;
void main() { fColor = vec4(uSize); }
)"}});
    modern.scene.namedValues.push_back({"uSize", glib::UniformForm::number, {1}, {1, 1}, {1, 1}});
    modern.window();
    modern.square(named);
    std::string found;
    for (const plan::Skipped& each : draw(modern).stats.foundByName)
        found += each.what + ": " + each.why + "\n";
    EXPECT_NE(found.find("'Named': uniform 'mvp' is the model-view-projection matrix\n"), std::string::npos)
        << found;
    EXPECT_NE(found.find("'Named': uniform 'uSize' is the variable 'uSize'\n"), std::string::npos);
    EXPECT_NE(found.find("'Named': vertex input 'vertPos' is the attribute position\n"), std::string::npos);
}

TEST(ModernPasses, GiveAFragmentStageAloneTheMatricesOfTheCamera) {
    // The inverse of a perspective of 90 degrees, 1 to 10: 1, 1, -.45 and .55 where they stand here.
    const std::string head =
        "WindowSize 8 8\nCamera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 90 1 10\nTranslate 7 7 7\n";
    const std::string show =
        "Fragment inline\n#version 330\nin vec2 vST;\nout vec4 fColor;\nuniform mat4 invProjection, mv;\n"
        "void main() { fColor = vec4(.4 * invProjection[1][1], invProjection[3][3], -mv[3][2] / 20., vST.x); "
        "}\n"
        "EndFragment\nProgram Show\n";
    const std::string other =
        "Vertex inline\n#version 330\nvoid main() { gl_Position = vec4(2.); }\nEndVertex\n";
    const std::string inPass = "Pass window\nFullScreen\nEndPass\n";
    for (const std::string& scene :
         {head + show + "Fill window with Show\n", head + other + show + "Fill window with Show\n",
          head + show + inPass, head + other + show + inPass})
        EXPECT_EQ(pixel(picture(scene), 4, 4), (std::array<int, 3>{102, 140, 64})) << scene;
}

TEST(ModernPasses, BlendFullScreenRectanglesOfAFragmentStageAlone) {
    const Picture drawn = picture(
        "WindowSize 8 8\nFragment inline\n#version 330\nin vec2 vST;\nout vec4 fColor;\n"
        "void main() { fColor = vec4(step(.5, vST), 0., 1.); }\nEndFragment\nProgram Halves\n"
        "Pass window clear {0 0 .2}\nState blend add\nFullScreen\nFullScreen\nEndPass\n");
    EXPECT_EQ(pixel(drawn, 1, 1), (std::array<int, 3>{0, 255, 51}));
    EXPECT_EQ(pixel(drawn, 6, 1), (std::array<int, 3>{255, 255, 51}));
    EXPECT_EQ(pixel(drawn, 6, 6), (std::array<int, 3>{255, 0, 51}));
}

TEST(ModernPasses, GiveAStorageBlockTheBufferThatIsNamedLikeItsLastMember) {
    const Picture drawn = picture(
        "WindowSize 8 8\nBuffer lights vec4 [0 .2 .4 1]\nFragment inline\n#version 430\nout vec4 fColor;\n"
        "layout(std430) readonly buffer Lights { vec4 lights[]; };\nvoid main() { fColor = lights[0]; }\n"
        "EndFragment\nProgram Show\nFill window with Show\n");
    EXPECT_EQ(pixel(drawn, 4, 4), (std::array<int, 3>{0, 51, 102}));
}

/// A white program that places vertices by the matrices.
auto placedProgram(ModernScene& modern) {
    return modern.program("Placed", {{glsl::Stage::vertex, R"(#version 330 core
in vec4 aVertex;
uniform mat4 uModelViewProjectionMatrix;
void main() { gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz, 1.); }
)"},
                                     {glsl::Stage::fragment, R"(#version 330 core
out vec4 fColor;
void main() { fColor = vec4(1.); }
)"}});
}

TEST(ModernPasses, AreNotMovedWithTheWindowUnlessItsCameraSeesThem) {
    // The window's eye is moved by half a picture; the pass of another camera is not.
    for (const std::string camera : {"light", "eye"}) {
        ModernScene modern(4, 4);
        const auto placed = placedProgram(modern);
        const auto map = modern.texture("uMap", TexelFormat::rgba8, 4, 4);
        const auto read = modern.shading("Read", kRead);
        scene::Pass& pass = modern.pass({map}, glm::dvec4(0, 0, 0, 1));
        pass.camera = camera;
        if (camera != "eye") pass.rootCamera = camera;
        modern.square(placed);
        modern.window();
        modern.square(read);
        RenderOptions options;
        options.viewState.eye[12] = 1;  // along x
        EXPECT_EQ(draw(modern, options).at(0, 1)[0], camera == "eye" ? 0 : 255) << camera;
    }
}

TEST(ModernPasses, ProveNothingOutOfSightThatTheirStateShows) {
    // A square beyond the far plane is seen only where depths are clamped.
    for (const bool clamps : {false, true}) {
        ModernScene modern(4, 4);
        const auto placed = placedProgram(modern);
        modern.window();
        modern.square(placed, 1.5).raster.change().depthClamp = clamps;
        const ModernPicture picture = draw(modern);
        EXPECT_EQ(picture.at(1, 1)[0], clamps ? 255 : 0);
        const bool isSkipped = std::ranges::any_of(picture.stats.skipped, [](const plan::Skipped& each) {
            return each.what == "draw" && each.why.find("far plane") != std::string::npos;
        });
        EXPECT_EQ(isSkipped, !clamps);
    }
}

}  // namespace
}  // namespace glibra::test
