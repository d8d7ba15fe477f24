// What raster state does to pixels, against blending, comparisons and stencil actions computed here.

#include <algorithm>
#include <cmath>

#include "fixture.h"
#include "gpu/object/buffer.h"
#include "raster_fixture.h"

namespace glibra::gpu {
namespace {

using base::BlendEquation;
using base::BlendFactor;
using base::Comparison;
using base::RasterState;
using base::StencilAction;
using test::pixels;
using test::Rgba;

/// A target with stencil, and a program that writes uColor at depth uDepth.
class RasterDrawTest : public test::RasterTest {
  protected:
    void prepare(int width, int height, TexelFormat format) {
        auto color = Texture::create(driver(), TextureShape::texture2D, format, {width, height});
        auto depth = Texture::create(driver(), TextureShape::texture2D, TexelFormat::depth24_stencil8,
                                     {width, height});
        ASSERT_TRUE(color && depth);
        color_ = std::move(*color);
        depth_ = std::move(*depth);
        const std::array<TexturePart, 1> colors{{{&color_}}};
        auto target = Target::parts(driver(), colors, TexturePart{&depth_});
        ASSERT_TRUE(target) << test::text(target.diagnostics);
        target_ = std::move(target.value);
        program_ = build(R"(#version 410 core
uniform float uDepth;
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., uDepth * 2. - 1., 1);
}
)",
                         R"(#version 410 core
uniform vec4 uColors[3];
out vec4 fColor;
void main() { fColor = uColors[int(gl_FragCoord.x) % 3]; }
)");
        ASSERT_TRUE(program_);
        program_->use();
        setColors({{{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}});
        target_->bind();
        tracker_.emplace(driver());
        tracker_->targetBound(width, height);
        tracker_->openForClears();
        nothing_.emplace(std::span<const AttributeSource>{});
        nothing_->bind();
    }
    void setColors(const std::array<Rgba, 3>& colors) {
        glUniform4fv(glGetUniformLocation(program_->id(), "uColors"), 3, colors[0].data());
    }
    void draw(const RasterState& state, const PixelRectangle& where, float depth = .5F) {
        glUniform1f(glGetUniformLocation(program_->id(), "uDepth"), depth);
        tracker_->limitTo(where);
        tracker_->apply(state);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        tracker_->limitTo({});
    }
    /// Bottom row first.
    std::vector<Rgba> result() {
        tracker_->openForClears();
        std::vector<Rgba> top = pixels(context(), *target_);
        std::vector<Rgba> turned;
        const auto width = static_cast<std::size_t>(target_->width());
        for (std::size_t row = top.size() / width; row-- > 0;)
            turned.insert(turned.end(), top.begin() + static_cast<std::ptrdiff_t>(row * width),
                          top.begin() + static_cast<std::ptrdiff_t>((row + 1) * width));
        target_->bind();
        return turned;
    }

    Texture color_, depth_;
    std::optional<Target> target_;
    std::optional<Program> program_;
    std::optional<RasterTracker> tracker_;
    std::optional<VertexArray> nothing_;
};

/// OpenGL 4.6 core, table 17.2.
std::array<double, 4> factorOf(BlendFactor factor, const Rgba& source, const Rgba& stored,
                               const std::array<double, 4>& constant) {
    const auto all = [](double value) { return std::array{value, value, value, value}; };
    const auto of = [](const auto& color) {
        return std::array{static_cast<double>(color[0]), static_cast<double>(color[1]),
                          static_cast<double>(color[2]), static_cast<double>(color[3])};
    };
    const auto rest = [](std::array<double, 4> values) {
        for (double& each : values) each = 1 - each;
        return values;
    };
    switch (factor) {
        case BlendFactor::zero:
            return all(0);
        case BlendFactor::one:
            return all(1);
        case BlendFactor::sourceColor:
            return of(source);
        case BlendFactor::oneMinusSourceColor:
            return rest(of(source));
        case BlendFactor::destinationColor:
            return of(stored);
        case BlendFactor::oneMinusDestinationColor:
            return rest(of(stored));
        case BlendFactor::sourceAlpha:
            return all(source[3]);
        case BlendFactor::oneMinusSourceAlpha:
            return all(1. - source[3]);
        case BlendFactor::destinationAlpha:
            return all(stored[3]);
        case BlendFactor::oneMinusDestinationAlpha:
            return all(1. - stored[3]);
        case BlendFactor::constantColor:
            return of(constant);
        case BlendFactor::oneMinusConstantColor:
            return rest(of(constant));
        case BlendFactor::constantAlpha:
            return all(constant[3]);
        case BlendFactor::oneMinusConstantAlpha:
            return all(1 - constant[3]);
        case BlendFactor::sourceAlphaSaturate:
            break;
    }
    const double least = std::min<double>(source[3], 1. - stored[3]);
    return {least, least, least, 1};
}

double blended(BlendEquation equation, double source, double sourceFactor, double stored,
               double storedFactor) {
    switch (equation) {
        case BlendEquation::add:
            return source * sourceFactor + stored * storedFactor;
        case BlendEquation::subtract:
            return source * sourceFactor - stored * storedFactor;
        case BlendEquation::reverseSubtract:
            return stored * storedFactor - source * sourceFactor;
        case BlendEquation::min:
            return std::min(source, stored);
        case BlendEquation::max:
            break;
    }
    return std::max(source, stored);
}

class BlendTest : public RasterDrawTest, public testing::WithParamInterface<TexelFormat> {};

TEST_P(BlendTest, EveryFactorAndEquationIsThatOfTheSpecification) {
    const TexelFormat format = GetParam();
    const bool isByte = format == TexelFormat::rgba8;
    constexpr int kWidth = base::kBlendFactorCount * 3;
    constexpr int kEquations = GLIBRA_SANITIZED ? 1 : base::kBlendEquationCount;
    constexpr int kHeight = base::kBlendFactorCount * kEquations;
    prepare(kWidth, kHeight, format);
    // All are multiples of 1/255, so that bytes hold them exactly.
    const std::array<Rgba, 3> sources{{{.2F, .4F, .6F, .8F}, {1, 0, .8F, .2F}, {.4F, 1, .2F, 0}}};
    const Rgba stored{.6F, .2F, 1, .4F};
    const std::array<double, 4> constant{.8, .2, .4, .6};
    setColors(sources);
    target_->clearColor(0, stored);
    target_->clearDepth();

    const auto functionsAt = [](int source, int destination, int equation) {
        const auto turned = [](int value, int by) {
            return static_cast<BlendFactor>((value + by) % base::kBlendFactorCount);
        };
        base::Blend blend{true, {}, {}};
        blend.color = {turned(source, 0), turned(destination, 0), static_cast<BlendEquation>(equation)};
        // Alpha has other factors and another equation, so that a mix-up shows.
        blend.alpha = {turned(source, 4), turned(destination, 7),
                       static_cast<BlendEquation>((equation + 1) % base::kBlendEquationCount)};
        return blend;
    };
    RasterState state;
    state.blendConstant = constant;
    for (int equation = 0; equation < kEquations; ++equation)
        for (int source = 0; source < base::kBlendFactorCount; ++source)
            for (int destination = 0; destination < base::kBlendFactorCount; ++destination) {
                state.blendAll(functionsAt(source, destination, equation));
                draw(state, {source * 3, equation * base::kBlendFactorCount + destination, 3, 1});
            }

    const std::vector<Rgba> drawn = result();
    const double tolerance = isByte ? 1.01 / 255 : 1e-6;
    double worst = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Rgba& source = sources[static_cast<std::size_t>(x % 3)];
            const base::Blend blend =
                functionsAt(x / 3, y % base::kBlendFactorCount, y / base::kBlendFactorCount);
            for (std::size_t c = 0; c < 4; ++c) {
                const base::BlendFunction& function = c < 3 ? blend.color : blend.alpha;
                double wanted = blended(function.equation, source[c],
                                        factorOf(function.source, source, stored, constant)[c], stored[c],
                                        factorOf(function.destination, source, stored, constant)[c]);
                if (isByte) wanted = std::clamp(wanted, 0., 1.);
                const double found = drawn[static_cast<std::size_t>(y * kWidth + x)][c];
                worst = std::max(worst, std::abs(found - wanted));
                ASSERT_NEAR(found, wanted, tolerance)
                    << "source " << x / 3 << ", destination " << y % base::kBlendFactorCount << ", equation "
                    << y / base::kBlendFactorCount << ", component " << c;
            }
        }
    RecordProperty("worst", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(Formats, BlendTest, testing::Values(TexelFormat::rgba32f, TexelFormat::rgba8),
                         [](const auto& each) { return std::string(name(each.param)); });

bool holds(Comparison function, double left, double right) {
    switch (function) {
        case Comparison::never:
            return false;
        case Comparison::less:
            return left < right;
        case Comparison::lequal:
            return left <= right;
        case Comparison::equal:
            return left == right;
        case Comparison::gequal:
            return left >= right;
        case Comparison::greater:
            return left > right;
        case Comparison::notequal:
            return left != right;
        case Comparison::always:
            break;
    }
    return true;
}

TEST_F(RasterDrawTest, DepthFunctionsCompareTheNewDepthWithTheStoredOne) {
    prepare(8, 3, TexelFormat::rgba8);
    target_->clearColor(0, {0, 0, 0, 0});
    target_->clearDepth(.5F);
    constexpr std::array<float, 3> kDepths{.25F, .5F, .75F};
    RasterState state;
    for (int function = 0; function < 8; ++function)
        for (int i = 0; i < 3; ++i) {
            state.depthFunction = static_cast<Comparison>(function);
            draw(state, {function, i, 1, 1}, kDepths[static_cast<std::size_t>(i)]);
        }
    const std::vector<Rgba> drawn = result();
    for (int function = 0; function < 8; ++function)
        for (int i = 0; i < 3; ++i)
            EXPECT_EQ(drawn[static_cast<std::size_t>(i * 8 + function)][0] == 1,
                      holds(static_cast<Comparison>(function), kDepths[static_cast<std::size_t>(i)], .5))
                << function << ", " << i;
}

std::vector<std::uint8_t> stencilOf(const Target& target) {
    std::vector<std::uint8_t> values(static_cast<std::size_t>(target.width() * target.height()));
    target.readable().bindForReading();
    glReadPixels(0, 0, target.width(), target.height(), GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
    return values;
}

TEST_F(RasterDrawTest, StencilFunctionsCompareTheReferenceWithTheStoredValueUnderTheMask) {
    prepare(8, 4, TexelFormat::rgba8);
    target_->clearColor(0, {0, 0, 0, 0});
    target_->clearDepth();
    target_->clearStencil(0x35);
    struct Row {
        int reference;
        std::uint32_t mask;
    };
    constexpr std::array<Row, 4> kRows{{{0x35, 0xff}, {0x34, 0xff}, {0xf5, 0x0f}, {0x36, 0x0f}}};
    RasterState state;
    state.stencilTest = true;
    for (int function = 0; function < 8; ++function)
        for (int i = 0; i < 4; ++i) {
            const Row& row = kRows[static_cast<std::size_t>(i)];
            state.stencilFront = {
                .function = static_cast<Comparison>(function), .reference = row.reference, .mask = row.mask};
            state.stencilBack = {.function = Comparison::never};
            draw(state, {function, i, 1, 1});
        }
    const std::vector<Rgba> drawn = result();
    for (int function = 0; function < 8; ++function)
        for (int i = 0; i < 4; ++i) {
            const Row& row = kRows[static_cast<std::size_t>(i)];
            EXPECT_EQ(drawn[static_cast<std::size_t>(i * 8 + function)][0] == 1,
                      holds(static_cast<Comparison>(function), static_cast<int>(row.mask) & row.reference,
                            static_cast<int>(row.mask) & 0x35))
                << function << ", " << i;
        }
}

TEST_F(RasterDrawTest, StencilActionsChangeTheStoredValue) {
    // By action: keep, zero, replace with 9, increment, decrement, invert, increment and decrement wrapping.
    constexpr std::array<std::uint8_t, 3> kStored{0, 5, 255};
    constexpr std::array<std::array<std::uint8_t, 8>, 3> kWanted{
        {{0, 0, 9, 1, 0, 255, 1, 255}, {5, 0, 9, 6, 4, 250, 6, 4}, {255, 0, 9, 255, 254, 0, 0, 254}}};
    prepare(8, 3, TexelFormat::rgba8);
    enum { stencilFails, depthFails, passes };
    for (const int outcome : {stencilFails, depthFails, passes})
        for (std::size_t stored = 0; stored < kStored.size(); ++stored) {
            tracker_->openForClears();
            target_->clearDepth(.5F);
            target_->clearStencil(kStored[stored]);
            RasterState state;
            state.stencilTest = true;
            for (int action = 0; action < 8; ++action) {
                base::StencilFace& face = state.stencilFront;
                face = {.function = outcome == stencilFails ? Comparison::never : Comparison::always,
                        .reference = 9};
                (outcome == stencilFails ? face.fail
                 : outcome == depthFails ? face.depthFail
                                         : face.pass) = static_cast<StencilAction>(action);
                draw(state, {action, 0, 1, 1}, outcome == depthFails ? .75F : .25F);
            }
            const std::vector<std::uint8_t> values = stencilOf(*target_);
            for (std::size_t action = 0; action < 8; ++action)
                EXPECT_EQ(values[action], kWanted[stored][action])
                    << "outcome " << outcome << ", stored " << int{kStored[stored]} << ", action " << action;
            target_->bind();
        }
}

TEST_F(RasterDrawTest, MasksDoNotHinderClears) {
    prepare(2, 2, TexelFormat::rgba8);
    RasterState state;
    state.write.fill({false, false, false, false});
    state.depthWrite = false;
    state.stencilTest = true;
    state.stencilFront.writeMask = state.stencilBack.writeMask = 0;
    state.scissor = base::FractionRectangle{0, 0, .5, .5};
    tracker_->apply(state);
    tracker_->openForClears();
    target_->clearColor(0, {1, 0, 1, 0});
    target_->clearStencil(7);
    EXPECT_EQ(stencilOf(*target_), std::vector<std::uint8_t>(4, 7));
    for (const Rgba& each : result()) EXPECT_EQ(each, (Rgba{1, 0, 1, 0}));
}

TEST_F(RasterDrawTest, AColourMaskKeepsTheOtherComponents) {
    prepare(1, 1, TexelFormat::rgba8);
    target_->clearColor(0, {0, 0, 0, 0});
    target_->clearDepth();
    RasterState state;
    state.write.fill({true, false, true, false});
    draw(state, {0, 0, 1, 1});
    EXPECT_EQ(result().at(0), (Rgba{1, 0, 1, 0}));
}

}  // namespace
}  // namespace glibra::gpu
