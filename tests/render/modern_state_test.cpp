// The state of draws in modern scenes: every comparison, blend factor and equation against its formula.

#include <algorithm>
#include <cstring>

#include "modern_squares.h"

namespace glibra::test {
namespace {

using base::TexelFormat;

TEST(ModernState, CompareDepthAndStencilAsTheTablesSay) {
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
            tested.raster.change().depthFunction = comparison;
            tested.raster.change().scissor = third;
            scene::Draw& marked = stencil.square(kGreen);
            marked.raster.change().stencilTest = true;
            marked.raster.change().stencilFront.function = comparison;
            marked.raster.change().stencilFront.reference = value;
            marked.raster.change().scissor = third;
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

TEST(ModernState, BlendWithEveryFactorAndEquation) {
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
                drawn.raster.change().depthTest = false;
                constexpr double kSide = base::kBlendFactorCount;
                drawn.raster.change().scissor =
                    base::FractionRectangle{x / kSide, y / kSide, 1 / kSide, 1 / kSide};
                drawn.raster.change().blend[0] = {true, functionAt(x, y), functionAt(x, y)};
                drawn.raster.change().blendConstant = kBlendConstant;
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

TEST(ModernState, BlendAndMaskEachTargetAlone) {
    Squares scene;
    const auto first = scene.modern.texture("first", TexelFormat::rgba8, 4, 4);
    const auto second = scene.modern.texture("second", TexelFormat::rgba8, 4, 4);
    const auto both =
        scene.modern.shading("Both",
                             "layout(location = 0) out vec4 fFirst; layout(location = 1) out vec4 "
                             "fSecond; void main() { fFirst = fSecond = vec4(.2, .4, .6, 1.); }");
    scene.modern.pass({first, second}, glm::dvec4(.2, .2, .2, 1));
    scene::Draw& drawn = scene.modern.square(both);
    drawn.raster.change().blend[0] = {
        true, {base::BlendFactor::one, base::BlendFactor::one, base::BlendEquation::add}, {}};
    drawn.raster.change().write[1] = {false, true, false, true};
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

}  // namespace
}  // namespace glibra::test
