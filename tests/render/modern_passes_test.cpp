// Passes of modern scenes: depth, layers, what is cleared and kept, stencil, blending, state, and what is
// skipped.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "modern_by_hand.h"

namespace glibra::test {
namespace {

using base::TexelFormat;
using scene::TextureTarget;
using scene::TextureView;

constexpr const char* kConstant = "uniform vec4 uColor; out vec4 fColor; void main() { fColor = uColor; }";
constexpr const char* kRead =
    "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = texture(uMap, vST); }";

using Color = std::array<double, 4>;

/// A scene whose squares have one colour.
struct Squares {
    ModernScene modern;
    scene::ProgramIndex constant, read;

    explicit Squares(int width = 4, int height = 4)
        : modern(width, height),
          constant(modern.shading("Constant", kConstant)),
          read(modern.shading("Read", kRead)) {}

    scene::Draw& square(const Color& color, double z = 0, double size = 1) {
        scene::Draw& drawn = modern.square(constant, z, size);
        modern.set(drawn, {{"uColor", {color[0], color[1], color[2], color[3]}}});
        return drawn;
    }
    void show(const TextureView& view) {
        modern.window();
        modern.set(modern.square(read), {}, {{"uMap", view}});
    }
};

constexpr Color kRed{1, 0, 0, 1}, kGreen{0, 1, 0, 1};
constexpr base::FractionRectangle kLeft{0, 0, .5, 1};

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
    scene.square(kRed, 0).raster.viewport = kLeft;
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
                first.raster.viewport = kLeft;
                first.raster.stencilTest = true;
                first.raster.stencilFront.reference = first.raster.stencilBack.reference = 1;
                first.raster.stencilFront.pass = first.raster.stencilBack.pass = base::StencilAction::replace;
                scene::Pass& second =
                    scene.modern.window(keepsColor ? std::nullopt : std::optional(glm::dvec4(0, 0, 1, 1)));
                second.clearDepth = !keepsDepth;
                if (keepsStencil) second.clearStencil.reset();
                scene::Draw& far = scene.square(kGreen, .5);
                far.raster.stencilTest = true;  // drawn where the stencil is still 0
                far.raster.stencilFront.function = far.raster.stencilBack.function = base::Comparison::equal;
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
    mirror.raster.write.fill({false, false, false, false});
    mirror.raster.depthWrite = false;
    mirror.raster.stencilTest = true;
    mirror.raster.stencilFront.reference = 1;
    mirror.raster.stencilFront.pass = base::StencilAction::replace;
    scene::Draw& image = scene.square(kGreen, .5);
    image.raster.stencilTest = true;
    image.raster.stencilFront.reference = 1;
    image.raster.stencilFront.function = base::Comparison::equal;
    const ModernPicture picture = draw(scene.modern);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            const bool isInside = x > 0 && x < 3 && y > 0 && y < 3;
            EXPECT_EQ(picture.at(x, y), isInside ? (std::array{0, 255, 0}) : (std::array{0, 0, 255}));
        }
}

TEST(ModernPasses, CompareDepthAndStencilAsTheTablesSay) {
    const auto holds = [](base::Comparison comparison, int value, int stored) {
        switch (comparison) {
            case base::Comparison::never:
                return false;
            case base::Comparison::less:
                return value < stored;
            case base::Comparison::lequal:
                return value <= stored;
            case base::Comparison::equal:
                return value == stored;
            case base::Comparison::gequal:
                return value >= stored;
            case base::Comparison::greater:
                return value > stored;
            case base::Comparison::notequal:
                return value != stored;
            case base::Comparison::always:
                break;
        }
        return true;
    };
    for (int i = 0; i < 8; ++i) {
        const auto comparison = static_cast<base::Comparison>(i);
        Squares depth(3, 1), stencil(3, 1);
        depth.modern.window();
        depth.square(kRed, 0);
        stencil.modern.window().clearStencil = 2;
        for (int value = 1; value <= 3; ++value) {
            const base::FractionRectangle third{(value - 1) / 3., 0, 1 / 3., 1};
            scene::Draw& tested = depth.square(kGreen, (value - 2) * .5);
            tested.raster.depthFunction = comparison;
            tested.raster.scissor = third;
            scene::Draw& marked = stencil.square(kGreen);
            marked.raster.stencilTest = true;
            marked.raster.stencilFront.function = comparison;
            marked.raster.stencilFront.reference = value;
            marked.raster.scissor = third;
        }
        const ModernPicture deep = draw(depth.modern), cut = draw(stencil.modern);
        for (int value = 1; value <= 3; ++value) {
            const int wanted = holds(comparison, value, 2) ? 255 : 0;
            EXPECT_EQ(deep.at(value - 1, 0)[1], wanted) << "depth " << i << ", " << value;
            EXPECT_EQ(cut.at(value - 1, 0)[1], wanted) << "stencil " << i << ", " << value;
        }
    }
}

/// The factor of a component (GL 4.6, table 17.2).
double factorOf(base::BlendFactor factor, std::size_t component, const Color& source, const Color& stored,
                const Color& constant) {
    using enum base::BlendFactor;
    switch (factor) {
        case zero:
            return 0;
        case one:
            return 1;
        case sourceColor:
            return source[component];
        case oneMinusSourceColor:
            return 1 - source[component];
        case destinationColor:
            return stored[component];
        case oneMinusDestinationColor:
            return 1 - stored[component];
        case sourceAlpha:
            return source[3];
        case oneMinusSourceAlpha:
            return 1 - source[3];
        case destinationAlpha:
            return stored[3];
        case oneMinusDestinationAlpha:
            return 1 - stored[3];
        case constantColor:
            return constant[component];
        case oneMinusConstantColor:
            return 1 - constant[component];
        case constantAlpha:
            return constant[3];
        case oneMinusConstantAlpha:
            return 1 - constant[3];
        case sourceAlphaSaturate:
            break;
    }
    return component == 3 ? 1 : std::min(source[3], 1 - stored[3]);
}

double blended(const base::BlendFunction& function, std::size_t component, const Color& source,
               const Color& stored, const Color& constant) {
    const double s = source[component], d = stored[component];
    const double left = s * factorOf(function.source, component, source, stored, constant);
    const double right = d * factorOf(function.destination, component, source, stored, constant);
    switch (function.equation) {
        case base::BlendEquation::add:
            return left + right;
        case base::BlendEquation::subtract:
            return left - right;
        case base::BlendEquation::reverseSubtract:
            return right - left;
        case base::BlendEquation::min:
            return std::min(s, d);
        case base::BlendEquation::max:
            break;
    }
    return std::max(s, d);
}

TEST(ModernPasses, BlendWithEveryFactorAndEquation) {
    // One picture per equation: a pixel for each pair of factors.
    constexpr Color kSource{.9, .35, .6, .7}, kStored{.25, .8, .5, .4}, kBlendConstant{.3, .55, .75, .65};
    for (int equation = 0; equation < base::kBlendEquationCount; ++equation) {
        Squares scene(base::kBlendFactorCount, base::kBlendFactorCount);
        const auto map = scene.modern.texture("map", TexelFormat::rgba32f, base::kBlendFactorCount,
                                              base::kBlendFactorCount);
        scene.modern.pass({map}, glm::dvec4(kStored[0], kStored[1], kStored[2], kStored[3]));
        const auto functionAt = [&](int x, int y) {
            return base::BlendFunction{static_cast<base::BlendFactor>(x), static_cast<base::BlendFactor>(y),
                                       static_cast<base::BlendEquation>(equation)};
        };
        for (int y = 0; y < base::kBlendFactorCount; ++y)
            for (int x = 0; x < base::kBlendFactorCount; ++x) {
                scene::Draw& drawn = scene.square(kSource);
                drawn.raster.depthTest = false;
                constexpr double kSide = base::kBlendFactorCount;
                drawn.raster.scissor = base::FractionRectangle{x / kSide, y / kSide, 1 / kSide, 1 / kSide};
                drawn.raster.blend[0] = {true, functionAt(x, y), functionAt(x, y)};
                drawn.raster.blendConstant = kBlendConstant;
            }
        scene.show({.texture = map});
        scene.modern.scene.textures[map].sampler.filter = base::Filter::nearest;
        RenderOptions options;
        options.floatPixels = true;
        options.alpha = true;
        const ModernPicture picture = draw(scene.modern, options);
        for (int y = 0; y < base::kBlendFactorCount; ++y)
            for (int x = 0; x < base::kBlendFactorCount; ++x) {
                std::array<float, 4> found{};
                const auto row = picture.image.row(base::kBlendFactorCount - 1 - y);
                std::memcpy(found.data(), row.data() + static_cast<std::size_t>(x) * sizeof found,
                            sizeof found);
                for (std::size_t i = 0; i < 4; ++i)
                    ASSERT_NEAR(static_cast<double>(found[i]),
                                blended(functionAt(x, y), i, kSource, kStored, kBlendConstant), 2e-6)
                        << "factors " << x << ", " << y << ", equation " << equation << ", component " << i;
            }
    }
}

TEST(ModernPasses, BlendAndMaskEachTargetAlone) {
    Squares scene;
    const auto first = scene.modern.texture("first", TexelFormat::rgba8, 4, 4);
    const auto second = scene.modern.texture("second", TexelFormat::rgba8, 4, 4);
    const auto both =
        scene.modern.shading("Both",
                             "layout(location = 0) out vec4 fFirst; layout(location = 1) out vec4 "
                             "fSecond; void main() { fFirst = fSecond = vec4(.2, .4, .6, 1.); }");
    scene.modern.pass({first, second}, glm::dvec4(.2, .2, .2, 1));
    scene::Draw& drawn = scene.modern.square(both);
    drawn.raster.blend[0] = {
        true, {base::BlendFactor::one, base::BlendFactor::one, base::BlendEquation::add}, {}};
    drawn.raster.write[1] = {false, true, false, true};
    const auto show =
        scene.modern.shading("Show",
                             "uniform sampler2D first, second; out vec4 fColor; void main() { fColor = vST.s "
                             "< .5 ? texture(first, vST) : texture(second, vST); }");
    scene.modern.window();
    scene.modern.square(show);
    const ModernPicture picture = draw(scene.modern);
    EXPECT_EQ(picture.at(0, 1), (std::array{102, 153, 204}));
    EXPECT_EQ(picture.at(3, 1), (std::array{51, 102, 51}));
}

TEST(ModernPasses, KeepViewportAndScissorInTiles) {
    Squares scene(40, 24);
    scene.modern.window(glm::dvec4(0, 0, 1, 1));
    scene::Draw& first = scene.square(kRed, .5);
    first.raster.viewport = {.125, .25, .5, .5};
    scene::Draw& second = scene.square(kGreen, 0, .5);
    second.raster.viewport = {.5, .25, .375, .625};
    second.raster.scissor = base::FractionRectangle{.25, .3, .5, .4};
    const ModernPicture whole = draw(scene.modern);
    RenderOptions options;
    options.tileSize = 16;
    EXPECT_TRUE(whole.image.data == draw(scene.modern, options).image.data);
    // Rectangles by hand: (5, 6) with 20 x 12 pixels; (20, 6) with 15 x 15, of which the middle half, cut.
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

TEST(ModernPasses, AreNotMovedWithTheWindowUnlessItsCameraSeesThem) {
    // The window's eye is moved by half a picture; the pass of another camera is not.
    constexpr const char* kPlaced = R"(#version 330 core
in vec4 aVertex;
uniform mat4 uModelViewProjectionMatrix;
void main() { gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz, 1.); }
)";
    for (const std::string camera : {"light", "eye"}) {
        ModernScene modern(4, 4);
        const auto placed = modern.program(
            "Placed", {{glsl::Stage::vertex, kPlaced}, {glsl::Stage::fragment, R"(#version 330 core
out vec4 fColor;
void main() { fColor = vec4(1.); }
)"}});
        const auto map = modern.texture("uMap", TexelFormat::rgba8, 4, 4);
        const auto read = modern.shading("Read", kRead);
        modern.pass({map}, glm::dvec4(0, 0, 0, 1)).camera = camera;
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
    constexpr const char* kPlaced = R"(#version 330 core
in vec4 aVertex;
uniform mat4 uModelViewProjectionMatrix;
void main() { gl_Position = uModelViewProjectionMatrix * vec4(aVertex.xyz, 1.); }
)";
    for (const bool clamps : {false, true}) {
        ModernScene modern(4, 4);
        const auto placed = modern.program(
            "Placed", {{glsl::Stage::vertex, kPlaced}, {glsl::Stage::fragment, R"(#version 330 core
out vec4 fColor;
void main() { fColor = vec4(1.); }
)"}});
        modern.window();
        modern.square(placed, 1.5).raster.depthClamp = clamps;
        const ModernPicture picture = draw(modern);
        EXPECT_EQ(picture.at(1, 1)[0], clamps ? 255 : 0);
        const bool isSkipped = std::any_of(
            picture.stats.skipped.begin(), picture.stats.skipped.end(), [](const plan::Skipped& each) {
                return each.what == "draw" && each.why.find("far plane") != std::string::npos;
            });
        EXPECT_EQ(isSkipped, !clamps);
    }
}

}  // namespace
}  // namespace glibra::test
