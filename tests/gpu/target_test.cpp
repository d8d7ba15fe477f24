#include "gpu/object/framebuffer.h"

#include <cmath>
#include <utility>

#include "fixture.h"
#include "gpu/object/buffer.h"

namespace glibra::gpu {
namespace {

using test::pixels;
using test::Rgba;
using test::text;

class TargetTest : public test::GpuTest {
  protected:
    /// Runs a fragment stage over all pixels of the bound target.
    void cover(const Program& program) {
        const VertexArray nothing({});
        nothing.bind();
        program.use();
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
};

/// The window coordinates of the pixel's centre.
constexpr const char* kWhere = R"(#version 410 core
out vec4 fColor;
void main() { fColor = vec4(gl_FragCoord.xy, 0, 1); }
)";

TEST_F(TargetTest, TheFirstRowReadIsTheTopRow) {
    const auto target = Target::window(driver(), 7, 5, TexelFormat::rgba32f);
    ASSERT_TRUE(target) << text(target.diagnostics);
    const auto program = build(test::kCoverAll, kWhere);
    ASSERT_TRUE(program);
    target->bind();
    cover(*program);
    const std::vector<Rgba> read = pixels(context(), *target);
    for (std::size_t row = 0; row < 5; ++row)
        for (std::size_t x = 0; x < 7; ++x)
            EXPECT_EQ(read[row * 7 + x],
                      (Rgba{static_cast<float>(x) + .5F, 4.5F - static_cast<float>(row), 0, 1}));
}

TEST_F(TargetTest, FlippingByHandGivesTheSameRows) {
    const auto target = Target::window(driver(), 7, 5, TexelFormat::rgba32f);
    ASSERT_TRUE(target);
    const auto program = build(test::kCoverAll, kWhere);
    ASSERT_TRUE(program);
    target->bind();
    cover(*program);
    Capabilities without = driver();
    without.packInvert = false;
    for (const int height : {1, 2, 5}) {
        const auto byDriver =
            readPixels(driver(), target->readable(), 0, {1, 0, 3, height}, {3, TexelType::f32});
        const auto byHand =
            readPixels(without, target->readable(), 0, {1, 0, 3, height}, {3, TexelType::f32});
        ASSERT_TRUE(byDriver && byHand);
        EXPECT_EQ(*byDriver, *byHand);
    }
}

TEST_F(TargetTest, ReadingAPartGivesThatPart) {
    const auto target = Target::window(driver(), 8, 8, TexelFormat::rgba32f);
    ASSERT_TRUE(target);
    const auto program = build(test::kCoverAll, kWhere);
    ASSERT_TRUE(program);
    target->bind();
    cover(*program);
    std::vector<Rgba> read(6);
    ASSERT_TRUE(readPixels(driver(), target->readable(), 0, {2, 5, 3, 2}, {4, TexelType::f32},
                           std::as_writable_bytes(std::span(read)))
                    .empty());
    EXPECT_EQ(read[0], (Rgba{2.5F, 6.5F, 0, 1}));
    EXPECT_EQ(read[5], (Rgba{4.5F, 5.5F, 0, 1}));
}

TEST_F(TargetTest, ClearedBytesAreRoundedToNearest) {
    const auto target = Target::window(driver(), 3, 2, TexelFormat::rgba8);
    ASSERT_TRUE(target);
    target->bind();
    target->clearColor(0, {18 / 255.F, 27.4F / 255.F, 33.6F / 255.F, 2});
    for (const int components : {1, 3, 4}) {
        const auto read =
            readPixels(driver(), target->readable(), 0, {0, 0, 3, 2}, {components, TexelType::u8});
        ASSERT_TRUE(read);
        ASSERT_EQ(read->size(), 6U * static_cast<std::size_t>(components));
        const std::array<int, 4> expected{18, 27, 34, 255};
        for (std::size_t i = 0; i < read->size(); ++i)
            EXPECT_EQ(std::to_integer<int>((*read)[i]), expected[i % static_cast<std::size_t>(components)]);
    }
    std::vector<std::uint16_t> wide(24);
    ASSERT_TRUE(readPixels(driver(), target->readable(), 0, {0, 0, 3, 2}, {4, TexelType::u16},
                           std::as_writable_bytes(std::span(wide)))
                    .empty());
    EXPECT_EQ(wide[0], 18 * 257);
    EXPECT_EQ(wide[3], 65535);
}

TEST_F(TargetTest, ThreeComponentsAreTheFirstOfFour) {
    // Every pixel has its own colour. The larger size is read in several parts.
    constexpr const char* kNumbered = R"(#version 410 core
out vec4 fColor;
void main() {
    int x = int(gl_FragCoord.x), y = int(gl_FragCoord.y);
    fColor = vec4(ivec4(x, y, x / 256 * 16 + y / 256, 255 - x) & 255) / 255.;
}
)";
    const auto program = build(test::kCoverAll, kNumbered);
    ASSERT_TRUE(program);
    Capabilities without = driver();
    without.packInvert = false;
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 5), std::pair(3001, 1500)}) {
        const auto target = Target::window(driver(), width, height, TexelFormat::rgba8);
        ASSERT_TRUE(target);
        target->bind();
        cover(*program);
        const PixelRectangle all{0, 0, width, height};
        const auto four = readPixels(driver(), target->readable(), 0, all, {4, TexelType::u8});
        ASSERT_TRUE(four);
        for (const Capabilities& used : {driver(), without}) {
            const auto three = readPixels(used, target->readable(), 0, all, {3, TexelType::u8});
            ASSERT_TRUE(three);
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < three->size(); ++i)
                wrong += (*three)[i] != (*four)[i / 3 * 4 + i % 3];
            EXPECT_EQ(wrong, 0U) << width;
        }
    }
}

TEST_F(TargetTest, FloatTargetsKeepWhatIsBeyondOne) {
    const auto target = Target::window(driver(), 1, 1, TexelFormat::rgba32f);
    ASSERT_TRUE(target);
    target->bind();
    target->clearColor(0, {-7.25F, 1e20F, 3, .125F});
    EXPECT_EQ(pixels(context(), *target).at(0), (Rgba{-7.25F, 1e20F, 3, .125F}));
}

TEST_F(TargetTest, DepthDecidesWhatIsInFrontAndIsClearedToFar) {
    const auto target = Target::window(driver(), 2, 2, TexelFormat::rgba32f);
    ASSERT_TRUE(target);
    const auto program = build(R"(#version 410 core
uniform float uDepth;
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., uDepth, 1); }
)",
                               R"(#version 410 core
uniform float uDepth;
out vec4 fColor;
void main() { fColor = vec4(uDepth); }
)");
    ASSERT_TRUE(program);
    glEnable(GL_DEPTH_TEST);
    target->bind();
    target->clearColor(0, {9, 9, 9, 9});
    target->clearDepth();
    for (const float depth : {.5F, -.25F, .75F}) {
        program->use();
        glUniform1f(glGetUniformLocation(program->id(), "uDepth"), depth);
        cover(*program);
    }
    EXPECT_EQ(pixels(context(), *target).at(0)[0], -.25F);
    target->bind();
    target->clearDepth();
    glUniform1f(glGetUniformLocation(program->id(), "uDepth"), .75F);
    cover(*program);
    EXPECT_EQ(pixels(context(), *target).at(0)[0], .75F);
    glDisable(GL_DEPTH_TEST);
}

TEST_F(TargetTest, ResolvingAveragesTheSamplesOfAPixel) {
    const auto target = Target::window(driver(), 4, 4, TexelFormat::rgba32f, 4);
    ASSERT_TRUE(target) << text(target.diagnostics);
    if (target->samples() == 1) GTEST_SKIP() << "no multisampling here";
    // The half plane x < 1.5 pixels covers whole pixels on its side, and samples of one column at its edge.
    const auto program = build(R"(#version 410 core
void main() {
    vec2 corner = vec2(gl_VertexID / 2, gl_VertexID % 2);
    gl_Position = vec4(mix(vec2(-1, -1), vec2(-.25, 1), corner), 0, 1);
}
)",
                               R"(#version 410 core
out vec4 fColor;
void main() { fColor = vec4(8, 4, 2, 1); }
)");
    ASSERT_TRUE(program);
    const VertexArray nothing({});
    target->bind();
    target->clearColor(0, {0, 0, 0, 0});
    nothing.bind();
    program->use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    target->resolve();
    const std::vector<Rgba> read = pixels(context(), *target);
    const auto samples = static_cast<float>(target->samples());
    for (std::size_t row = 0; row < 4; ++row) {
        EXPECT_EQ(read[4 * row + 0], (Rgba{8, 4, 2, 1}));
        const float covered = read[4 * row + 1][3];
        EXPECT_GT(covered, 0.F);
        EXPECT_LT(covered, 1.F);
        EXPECT_EQ(std::round(covered * samples), covered * samples) << "a whole number of samples";
        EXPECT_EQ(read[4 * row + 1], (Rgba{8 * covered, 4 * covered, 2 * covered, covered}));
        EXPECT_EQ(read[4 * row + 2], (Rgba{0, 0, 0, 0}));
    }
}

TEST_F(TargetTest, MoreSamplesThanThereAreAreLowered) {
    const auto target = Target::window(driver(), 4, 4, TexelFormat::rgba8, 4096);
    ASSERT_TRUE(target) << text(target.diagnostics);
    EXPECT_LE(target->samples(), driver().maxSamples);
    EXPECT_EQ(target->depth()->samples(), target->samples());
}

TEST_F(TargetTest, EveryOutputReachesItsOwnTexture) {
    for (const int samples : {1, 4}) {
        std::vector<Texture> textures;
        std::vector<const Texture*> list;
        list.reserve(3);
        for (const TexelFormat format : {TexelFormat::rgba8, TexelFormat::rgba32f, TexelFormat::rgba16f}) {
            auto texture = Texture::create(driver(), TextureShape::texture2D, format, {6, 4});
            ASSERT_TRUE(texture);
            textures.push_back(std::move(*texture));
        }
        for (const Texture& each : textures) list.push_back(&each);
        const auto target = Target::textures(driver(), list, samples);
        ASSERT_TRUE(target) << text(target.diagnostics);
        const auto program = build(test::kCoverAll, R"(#version 410 core
layout(location = 0) out vec4 fFirst;
layout(location = 1) out vec4 fSecond;
layout(location = 2) out vec4 fThird;
void main() { fFirst = vec4(1, 0, 0, 1); fSecond = vec4(2, 3, 4, 5); fThird = vec4(.5, -1, 0, 1); }
)");
        ASSERT_TRUE(program);
        target->bind();
        for (int i = 0; i < 3; ++i) target->clearColor(i, {.25F, .25F, .25F, .25F});
        cover(*program);
        target->resolve();
        EXPECT_EQ(pixels(context(), *target, 0).at(5), (Rgba{1, 0, 0, 1}));
        EXPECT_EQ(pixels(context(), *target, 1).at(5), (Rgba{2, 3, 4, 5}));
        EXPECT_EQ(pixels(context(), *target, 2).at(5), (Rgba{.5F, -1, 0, 1}));
    }
}

TEST_F(TargetTest, TargetsCanShareADepthBuffer) {
    auto first = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba32f, {2, 2});
    auto second = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba32f, {2, 2});
    ASSERT_TRUE(first && second);
    const std::array<const Texture*, 1> one{&*first};
    const std::array<const Texture*, 1> other{&*second};
    const auto near = Target::textures(driver(), one);
    ASSERT_TRUE(near);
    const auto far = Target::textures(driver(), other, 1, near->depth());
    ASSERT_TRUE(far);
    const auto program =
        build(test::kCoverAll, "#version 410 core\nout vec4 fColor; void main() { fColor = vec4(1); }");
    ASSERT_TRUE(program);
    glEnable(GL_DEPTH_TEST);
    near->bind();
    near->clearDepth();
    cover(*program);
    far->bind();
    far->clearColor(0, {0, 0, 0, 0});
    cover(*program);
    glDisable(GL_DEPTH_TEST);
    EXPECT_EQ(pixels(context(), *far).at(0)[0], 0.F) << "equal depth does not pass GL_LESS";
}

TEST_F(TargetTest, TexturesOfDifferentSizesAreRefused) {
    auto first = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {2, 2});
    auto second = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {2, 3});
    ASSERT_TRUE(first && second);
    const std::array<const Texture*, 2> both{&*first, &*second};
    const auto target = Target::textures(driver(), both);
    ASSERT_FALSE(target);
    EXPECT_EQ(target.diagnostics.at(0).id, "gpu-E05");
    EXPECT_FALSE(Target::textures(driver(), {}));
}

TEST_F(TargetTest, SizesBeyondTheDriverAreErrors) {
    const auto target = Target::window(driver(), driver().maxRenderbufferSide + 1, 4, TexelFormat::rgba8);
    ASSERT_FALSE(target);
    EXPECT_EQ(target.diagnostics.at(0).id, "gpu-E04");
    EXPECT_FALSE(Target::window(driver(), 0, 4, TexelFormat::rgba8));
}

TEST_F(TargetTest, ASpanOfTheWrongSizeIsRefusedUnwritten) {
    const auto target = Target::window(driver(), 4, 4, TexelFormat::rgba8);
    ASSERT_TRUE(target);
    std::vector<std::byte> small(63);
    const Diagnostics problems = readPixels(driver(), target->readable(), 0, {0, 0, 4, 4}, {}, small);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].id, "gpu-E03");
    EXPECT_FALSE(readPixels(driver(), target->readable(), 1, {0, 0, 4, 4}, {}));
    EXPECT_FALSE(readPixels(driver(), target->readable(), 0, {0, 0, 0, 4}, {}));
    EXPECT_FALSE(readPixels(driver(), target->readable(), 0, {0, 0, 4, -4}, {}));
}

TEST_F(TargetTest, DroppedTargetsLeaveNoNameBehind) {
    for (int i = 0; i < 50; ++i) {
        GLuint framebuffer = 0;
        GLuint depth = 0;
        {
            const auto target = Target::window(driver(), 16, 16, TexelFormat::rgba8, 4);
            ASSERT_TRUE(target);
            framebuffer = target->readable().id();
            depth = target->depth()->id();
            EXPECT_TRUE(glIsFramebuffer(framebuffer));
            EXPECT_TRUE(glIsRenderbuffer(depth));
        }
        EXPECT_FALSE(glIsFramebuffer(framebuffer));
        EXPECT_FALSE(glIsRenderbuffer(depth));
    }
}

}  // namespace
}  // namespace glibra::gpu
