// Levels, layers, faces and samples of textures: drawn into, cleared, copied, sampled and read.

#include <cmath>
#include <cstring>

#include "fixture.h"
#include "gpu/object/buffer.h"
#include "gpu/object/texture.h"
#include "gpu/object/texture_copy.h"

namespace glibra::gpu {
namespace {

using test::Rgba;

class TexturePartTest : public test::GpuTest {
  protected:
    static Texture make(const TextureLayout& layout) {
        auto made = Texture::create(driver(), layout);
        EXPECT_TRUE(made) << test::text(made.diagnostics);
        return made ? std::move(*made) : Texture();
    }
    static Target targetOf(const TexturePart& part) {
        const std::array<TexturePart, 1> parts{part};
        auto made = Target::parts(driver(), parts, std::nullopt);
        EXPECT_TRUE(made) << test::text(made.diagnostics);
        return made ? std::move(*made) : Target();
    }
    static void clearTo(const TexturePart& part, const std::array<double, 4>& color) {
        const Target target = targetOf(part);
        target.bind();
        target.clearColorOfAnyFormat(0, color);
    }
    template <class T>
    static std::vector<T> read(const Texture& texture, int level, int components, TexelType type) {
        const auto bytes = texture.read(level, components, type);
        EXPECT_TRUE(bytes) << test::text(bytes.diagnostics);
        if (!bytes) return {};
        std::vector<T> values(bytes->size() / sizeof(T));
        std::memcpy(values.data(), bytes->data(), values.size() * sizeof(T));
        return values;
    }
    /// The first component of each texel as a float.
    static std::vector<float> reds(const Texture& texture, int level = 0) {
        return read<float>(texture, level, 1, TexelType::f32);
    }
};

TEST_F(TexturePartTest, LevelsHalveDownToOneTexel) {
    EXPECT_EQ(mostLevels(TextureShape::texture2D, {8, 3, 1}), 4);
    EXPECT_EQ(mostLevels(TextureShape::texture3D, {8, 3, 32}), 6);
    EXPECT_EQ(mostLevels(TextureShape::array2D, {8, 3, 32}), 4) << "layers stay";
    EXPECT_EQ(sizeOfLevel(TextureShape::texture2D, {8, 3, 1}, 2), (TextureSize{2, 1, 1}));
    EXPECT_EQ(sizeOfLevel(TextureShape::array2D, {8, 3, 5}, 1), (TextureSize{4, 1, 5}));
    EXPECT_EQ(sizeOfLevel(TextureShape::array1D, {8, 1, 5}, 1), (TextureSize{4, 1, 5}));
    EXPECT_EQ(mostLevels(TextureShape::array1D, {8, 1, 32}), 4);
    EXPECT_EQ(mostLevels(TextureShape::rectangle, {8, 3, 1}), 1);
    EXPECT_EQ(mostLevels(TextureShape::multisampledArray, {8, 3, 4}), 1);
    EXPECT_FALSE(Texture::create(driver(), {TextureShape::texture2D, TexelFormat::rgba8, {8, 8}, 5}));
    EXPECT_FALSE(Texture::create(driver(), {TextureShape::texture2D, TexelFormat::rgba8, {8, 8}, 0}));
}

TEST_F(TexturePartTest, NewTexturesAreZeroInEveryLevelAndLayer) {
    for (const TextureShape shape :
         {TextureShape::texture1D, TextureShape::texture2D, TextureShape::texture3D, TextureShape::array1D,
          TextureShape::array2D, TextureShape::cube, TextureShape::rectangle})
        for (const TexelFormat format : {TexelFormat::rgba8, TexelFormat::r32f, TexelFormat::rgba8_snorm}) {
            const int levels = shape == TextureShape::rectangle ? 1 : 3;
            const Texture texture = make({shape, format, {8, 8, 4}, levels});
            for (int level = 0; level < levels; ++level)
                for (const float each : reds(texture, level)) ASSERT_EQ(each, 0);
        }
}

TEST_F(TexturePartTest, EachLevelIsATargetOfItsOwn) {
    const Texture texture = make({TextureShape::texture2D, TexelFormat::r32f, {8, 4}, 4});
    for (int level = 0; level < 4; ++level) clearTo({&texture, level}, {level + 1., 0, 0, 0});
    for (int level = 0; level < 4; ++level) {
        const TextureSize size = sizeOfLevel(TextureShape::texture2D, {8, 4}, level);
        EXPECT_EQ(reds(texture, level), std::vector<float>(static_cast<std::size_t>(size.width * size.height),
                                                           static_cast<float>(level + 1)));
    }
}

TEST_F(TexturePartTest, EachLayerAndFaceIsATargetOfItsOwn) {
    for (const TextureShape shape : {TextureShape::texture3D, TextureShape::array2D, TextureShape::cube}) {
        const Texture texture = make({shape, TexelFormat::r16f, {4, 4, 6}, 1});
        ASSERT_EQ(texture.layers(), 6);
        for (int layer = 0; layer < 6; ++layer) clearTo({&texture, 0, layer}, {layer + 1., 0, 0, 0});
        const std::vector<float> values = reds(texture);
        ASSERT_EQ(values.size(), 96U);
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_EQ(values[i], static_cast<float>(i / 16 + 1)) << i;
    }
}

TEST_F(TexturePartTest, AWholeCubeOrArrayIsLayered) {
    for (const TextureShape shape : {TextureShape::texture3D, TextureShape::array2D, TextureShape::cube}) {
        const Texture texture = make({shape, TexelFormat::rgba8, {4, 4, 6}});
        EXPECT_TRUE(TexturePart{&texture}.isLayered());
        clearTo({&texture}, {1, 0, 0, 1});
        EXPECT_EQ(reds(texture), std::vector<float>(96, 1));
    }
}

TEST_F(TexturePartTest, LayersOf1DArraysHaveOneRow) {
    const Texture texture = make({TextureShape::array1D, TexelFormat::r16f, {4, 9, 3}});
    EXPECT_EQ(texture.size(), (TextureSize{4, 1, 3}));
    for (int layer = 0; layer < 3; ++layer) clearTo({&texture, 0, layer}, {layer + 1., 0, 0, 0});
    EXPECT_EQ(reds(texture), (std::vector<float>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
    EXPECT_TRUE(TexturePart{&texture}.isLayered());
    clearTo({&texture}, {7, 0, 0, 0});
    EXPECT_EQ(reds(texture), std::vector<float>(12, 7));
    if (!driver().atLeast(4, 3)) return;
    const auto part = texture.view(std::nullopt, 1);
    ASSERT_TRUE(part) << test::text(part.diagnostics);
    EXPECT_EQ(part->shape(), TextureShape::texture1D);
    EXPECT_EQ(reds(*part), std::vector<float>(4, 7));
}

TEST_F(TexturePartTest, TheGeometryStageChoosesTheLayer) {
    const Texture texture = make({TextureShape::array2D, TexelFormat::r32f, {2, 2, 3}});
    const Target target = targetOf({&texture});
    const std::array<StageSource, 3> stages{
        {{GL_VERTEX_SHADER, test::kCoverAll},
         {GL_GEOMETRY_SHADER, R"(#version 410 core
layout(triangles, invocations = 3) in;
layout(triangle_strip, max_vertices = 3) out;
void main() {
    for (int i = 0; i < 3; ++i) {
        gl_Layer = gl_InvocationID;
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
)"},
         {GL_FRAGMENT_SHADER,
          "#version 430 core\nout vec4 fColor;\nvoid main() { fColor = vec4(gl_Layer + 1); }\n"}}};
    if (!driver().atLeast(4, 3)) GTEST_SKIP() << "gl_Layer in fragment stages needs GL 4.3";
    const BuildOutcome built = buildProgram(driver(), {.stages = stages});
    ASSERT_TRUE(built.program) << built.linkLog;
    const VertexArray nothing({});
    target.bind();
    target.clearDepth();
    nothing.bind();
    built.program->use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    EXPECT_EQ(reds(texture), (std::vector<float>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
}

TEST_F(TexturePartTest, IntegersAreClearedExactly) {
    const auto cleared = [&](TexelFormat format, double value, TexelType type) {
        const Texture texture = make({TextureShape::texture2D, format, {1, 1}});
        clearTo({&texture}, {value, value, value, value});
        return texture.read(0, 1, type);
    };
    const auto wide = cleared(TexelFormat::rgba32ui, 0xfedcba98U, TexelType::u32);
    ASSERT_TRUE(wide);
    std::uint32_t word = 0;
    std::memcpy(&word, wide->data(), sizeof word);
    EXPECT_EQ(word, 0xfedcba98U);
    const auto small = cleared(TexelFormat::r8i, -5, TexelType::i8);
    ASSERT_TRUE(small);
    EXPECT_EQ(static_cast<std::int8_t>(small->front()), -5);
    const auto middle = cleared(TexelFormat::rg16i, -30000, TexelType::i16);
    ASSERT_TRUE(middle);
    std::int16_t half = 0;
    std::memcpy(&half, middle->data(), sizeof half);
    EXPECT_EQ(half, -30000);
}

TEST_F(TexturePartTest, IntegersAreUploadedAndReadAsTheyAre) {
    Texture texture = make({TextureShape::texture2D, TexelFormat::rg16ui, {2, 1}});
    const std::vector<std::uint16_t> values{0, 1, 40000, 65535};
    EXPECT_TRUE(texture.upload(0, {std::as_bytes(std::span(values)), 2, TexelType::u16}).empty());
    EXPECT_EQ(read<std::uint16_t>(texture, 0, 2, TexelType::u16), values);
    EXPECT_FALSE(texture.upload(1, {std::as_bytes(std::span(values)), 2, TexelType::u16}).empty());
    EXPECT_FALSE(texture.upload(0, {std::as_bytes(std::span(values)), 1, TexelType::u16}).empty());
}

TEST_F(TexturePartTest, LevelsAreUploadedOneByOneAndMipmapsAreMeans) {
    Texture texture = make({TextureShape::texture2D, TexelFormat::r32f, {4, 2}, 3});
    const std::vector<float> values{0, 2, 4, 6, 8, 10, 12, 14};
    ASSERT_TRUE(texture.upload(0, {std::as_bytes(std::span(values)), 1, TexelType::f32}).empty());
    const std::vector<float> given{-1, -2};
    ASSERT_TRUE(texture.upload(1, {std::as_bytes(std::span(given)), 1, TexelType::f32}).empty());
    EXPECT_EQ(reds(texture, 1), given);
    texture.generateMipmaps();
    EXPECT_EQ(reds(texture, 0), values);
    EXPECT_EQ(reds(texture, 1), (std::vector<float>{5, 9}));
    EXPECT_EQ(reds(texture, 2), std::vector<float>{7});
}

TEST_F(TexturePartTest, CopiesAreEqualThroughBothWays) {
    for (const TextureShape shape :
         {TextureShape::texture1D, TextureShape::texture2D, TextureShape::texture3D, TextureShape::array1D,
          TextureShape::array2D, TextureShape::cube, TextureShape::rectangle}) {
        const int levels = shape == TextureShape::rectangle ? 1 : 2;
        const Texture from = make({shape, TexelFormat::r32f, {4, 4, 2}, levels});
        for (int level = 0; level < levels; ++level)
            for (int layer = 0; layer < from.layers(level); ++layer)
                clearTo({&from, level, layer}, {10. * level + layer + 1, 0, 0, 0});
        Capabilities old = driver();
        old.major = 4;
        old.minor = 1;
        for (const Capabilities& driver : {GpuTest::driver(), old}) {
            Texture to = make({shape, TexelFormat::r32f, {4, 4, 2}, levels});
            const Diagnostics problems = copyTexture(driver, from, to);
            EXPECT_TRUE(problems.empty()) << test::text(problems);
            for (int level = 0; level < levels; ++level) EXPECT_EQ(reds(to, level), reds(from, level));
        }
    }
    const Texture from = make({TextureShape::texture2D, TexelFormat::r32f, {4, 4}});
    Texture other = make({TextureShape::texture2D, TexelFormat::r32f, {4, 5}});
    EXPECT_FALSE(copyTexture(driver(), from, other).empty());
}

TEST_F(TexturePartTest, EveryWayOfCopyingKeepsEveryBit) {
    int copies = 0;
    for (const base::TexelFormatRow& row : base::texelFormats()) {
        const FormatUse use = useOf(driver(), row.format);
        if (hasDepth(row.format) || !use.color) continue;
        for (const int levels : {1, 3}) {
            const TextureSize size{37, 29, 1};
            Texture from = make({TextureShape::texture2D, row.format, size, levels});
            for (int level = 0; level < levels; ++level)
                clearTo({&from, level}, {.3 + level, 9. - level, 200., .7});
            const Texels texels{{}, 4, isInteger(row.format) ? TexelType::u8 : TexelType::f32};
            std::vector<std::byte> content(37 * 29 * 4 * bytesOf(texels.type));
            for (std::size_t i = 0; i < content.size(); ++i)
                content[i] = std::byte(i * 2654435761U >> 8U & 63U);
            EXPECT_TRUE(from.upload(0, {content, 4, texels.type}).empty());
            TextureCopier copier;
            for (const auto way :
                 {TextureCopier::Way::asDriver, TextureCopier::Way::drawn, TextureCopier::Way::computed}) {
                Texture to = make({TextureShape::texture2D, row.format, size, levels});
                if (!copier.copyBy(way, driver(), from, to)) continue;
                ++copies;
                for (int level = 0; level < levels; ++level)
                    EXPECT_EQ(*from.read(level, 4, texels.type), *to.read(level, 4, texels.type))
                        << row.name << " level " << level << " way " << static_cast<int>(way);
            }
        }
    }
    EXPECT_GT(copies, driver().compute ? 40 : 0);
}

TEST_F(TexturePartTest, TheFastestWayIsMeasuredAndCopies) {
    Capabilities hardware = driver();
    hardware.isSoftware = false;
    const TextureLayout layout{TextureShape::texture2D, TexelFormat::r8ui, {1024, 1024}};
    const Texture from = make(layout);
    TextureCopier copier;
    for (int i = 1; i < 12; ++i) {
        clearTo({&from}, {i + 0., 0, 0, 0});
        Texture to = make(layout);
        Diagnostics problems;
        copier.copy(hardware, from, to, problems);
        EXPECT_TRUE(problems.empty()) << test::text(problems);
        EXPECT_EQ(*from.read(0, 1, TexelType::u8), *to.read(0, 1, TexelType::u8)) << i;
    }
    Texture other = make({TextureShape::texture2D, TexelFormat::r8ui, {1024, 1023}});
    Diagnostics problems;
    copier.copy(hardware, from, other, problems);
    EXPECT_FALSE(problems.empty());
}

/// Formats that cannot be drawn into are cleared without a framebuffer.
TEST_F(TexturePartTest, EveryFormatAndShapeIsClearedToZero) {
    for (const base::TexelFormatRow& row : base::texelFormats()) {
        if (hasDepth(row.format)) continue;
        for (const auto shape : {TextureShape::texture2D, TextureShape::array2D, TextureShape::texture3D,
                                 TextureShape::cube, TextureShape::array1D}) {
            const TexelType type = isInteger(row.format) ? TexelType::u32 : TexelType::f32;
            for (const bool isOld : {false, true}) {
                Capabilities capabilities = driver();
                if (isOld) capabilities.minor = std::min(capabilities.minor, 3);
                Texture texture = make({shape, row.format, {8, 8, 3}, 2});
                std::vector<std::byte> content(texelCount(texture.shape(), texture.size()) * 4 *
                                               bytesOf(type));
                for (std::size_t i = 0; i < content.size(); ++i) content[i] = std::byte(i % 61);
                EXPECT_TRUE(texture.upload(0, {content, 4, type}).empty()) << row.name;
                texture.clear(capabilities);
                const auto read = texture.read(0, row.components, type);
                ASSERT_TRUE(read) << row.name;
                EXPECT_EQ(*read, std::vector<std::byte>(read->size())) << row.name;
            }
        }
    }
}

TEST_F(TexturePartTest, ADepthTextureIsComparedAndReadRaw) {
    const Texture depth = make({TextureShape::texture2D, TexelFormat::depth32f, {1, 1}});
    const auto target = Target::parts(driver(), {}, TexturePart{&depth});
    ASSERT_TRUE(target) << test::text(target.diagnostics);
    target->bind();
    target->clearDepth(.625F);
    EXPECT_EQ(reds(depth), std::vector<float>{.625F});

    const auto raw = build(test::kCoverAll, R"(#version 410 core
uniform sampler2D uMap;
out vec4 fColor;
void main() { fColor = texture(uMap, vec2(.5)); }
)");
    const auto compared = build(test::kCoverAll, R"(#version 410 core
uniform sampler2DShadow uMap;
out vec4 fColor;
void main() { fColor = vec4(texture(uMap, vec3(.5, .5, .5)), texture(uMap, vec3(.5, .5, .625)), texture(uMap, vec3(.5, .5, .75)), 1.); }
)");
    ASSERT_TRUE(raw && compared);
    const Sampler plain(SamplerState{.filter = base::Filter::nearest, .border = {}});
    SamplerState comparing;
    comparing.wrap.fill(Wrap::clampToBorder);
    comparing.border = {1, 1, 1, 1};
    const Sampler shadow(comparing, base::Comparison::lequal);
    depth.bind(0);
    plain.bind(0);
    EXPECT_EQ(shade(*raw).at(0)[0], .625F);
    depth.bind(0);
    shadow.bind(0);
    EXPECT_EQ(shade(*compared).at(0), (Rgba{1, 1, 0, 1}));
    glBindSampler(0, 0);
}

TEST_F(TexturePartTest, TheBorderIsReadOutside) {
    const Texture texture = make({TextureShape::texture2D, TexelFormat::rgba8, {2, 2}});
    const auto outside = build(test::kCoverAll, R"(#version 410 core
uniform sampler2D uMap;
out vec4 fColor;
void main() { fColor = texture(uMap, vec2(2., .5)); }
)");
    ASSERT_TRUE(outside);
    SamplerState state;
    state.wrap[0] = Wrap::clampToBorder;
    state.border = {.25, .5, .75, 1};
    const Sampler sampler(state);
    texture.bind(0);
    sampler.bind(0);
    const Rgba read = shade(*outside).at(0);
    glBindSampler(0, 0);
    // The border is stored as the texture stores numbers, or more exactly.
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_LT(std::abs(read[c] - state.border[c]) * 255, 1) << "component " << c;
}

TEST_F(TexturePartTest, SamplesOfAMultisampledTextureAreReadOneByOne) {
    const Texture texture = make({TextureShape::multisampled, TexelFormat::rgba32f, {1, 1}, 1, 4});
    ASSERT_EQ(texture.samples(), 4);
    const Target target = targetOf({&texture});
    EXPECT_EQ(target.samples(), 4);
    target.bind();
    target.clearColor(0, {.5F, 0, 0, 1});
    const auto mean = build(test::kCoverAll, R"(#version 410 core
uniform sampler2DMS uMap;
out vec4 fColor;
void main() {
    fColor = vec4(0.);
    for (int i = 0; i < 4; ++i) fColor += texelFetch(uMap, ivec2(0), i) * float(i + 1);
}
)");
    ASSERT_TRUE(mean);
    texture.bind(0);
    EXPECT_EQ(shade(*mean).at(0), (Rgba{5, 0, 0, 10}));
}

TEST_F(TexturePartTest, EachLayerOfAMultisampledArrayIsResolved) {
    Capabilities old = driver();
    old.major = 4;
    old.minor = 1;
    for (const Capabilities& capabilities : {GpuTest::driver(), old}) {
        const auto made = Texture::create(
            capabilities, {TextureShape::multisampledArray, TexelFormat::r32f, {2, 2, 3}, 1, 4});
        ASSERT_TRUE(made) << test::text(made.diagnostics);
        const Texture& texture = *made;
        EXPECT_EQ(texture.samples(), 4);
        for (int layer = 0; layer < 3; ++layer) clearTo({&texture, 0, layer}, {layer + 1., 0, 0, 0});
        const Texture single = make({TextureShape::array2D, TexelFormat::r32f, {2, 2, 3}});
        resolveSamples(texture, single);
        EXPECT_EQ(reds(single), (std::vector<float>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
        auto copy = Texture::create(capabilities,
                                    {TextureShape::multisampledArray, TexelFormat::r32f, {2, 2, 3}, 1, 4});
        ASSERT_TRUE(copy) << test::text(copy.diagnostics);
        EXPECT_TRUE(copyTexture(capabilities, texture, *copy).empty());
        clearTo({&texture}, {9, 0, 0, 0});
        resolveSamples(texture, single);
        EXPECT_EQ(reds(single), std::vector<float>(12, 9));
        resolveSamples(*copy, single);
        EXPECT_EQ(reds(single), (std::vector<float>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
    }
}

TEST_F(TexturePartTest, PartsThatDoNotFitTogetherAreRefused) {
    const Texture small = make({TextureShape::texture2D, TexelFormat::rgba8, {4, 4}, 2});
    const Texture large = make({TextureShape::texture2D, TexelFormat::rgba8, {8, 8}, 2});
    const Texture array = make({TextureShape::array2D, TexelFormat::rgba8, {4, 4, 2}});
    const Texture depth = make({TextureShape::texture2D, TexelFormat::depth24, {4, 4}});
    const auto together = [&](const TexturePart& a, const TexturePart& b) {
        const std::array<TexturePart, 2> parts{a, b};
        return Target::parts(driver(), parts, std::nullopt).value.has_value();
    };
    EXPECT_TRUE(together({&small}, {&large, 1})) << "level 1 has the size of the small one";
    EXPECT_FALSE(together({&small}, {&large}));
    EXPECT_FALSE(together({&small}, {&array})) << "layered and not";
    EXPECT_TRUE(together({&small}, {&array, 0, 1}));
    EXPECT_FALSE(together({&small}, {&depth})) << "depth as a colour";
    EXPECT_FALSE(Target::parts(driver(), {}, std::nullopt));
    const std::array<TexturePart, 1> color{{{&small}}};
    EXPECT_TRUE(Target::parts(driver(), color, TexturePart{&depth}));
    EXPECT_FALSE(Target::parts(driver(), color, TexturePart{&large})) << "a colour as depth";
}

}  // namespace
}  // namespace glibra::gpu
