#include "gpu/object/texture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "fixture.h"
#include "stored_numbers.h"

namespace glibra::gpu {
namespace {

using test::Rgba;
using test::text;

/// A counter-based hash, so that every run has the same texels.
std::uint32_t hash(std::uint32_t value) {
    value ^= value >> 16;
    value *= 0x7feb352dU;
    value ^= value >> 15;
    value *= 0x846ca68bU;
    return value ^ (value >> 16);
}

/// Texels of any input type and the numbers that they represent.
struct Input {
    std::vector<std::byte> data;
    std::vector<double> numbers;
};

Input makeInput(std::size_t count, TexelType type) {
    Input input;
    input.data.resize(count * bytesOf(type));
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t random = hash(static_cast<std::uint32_t>(i) + 17);
        switch (type) {
            case TexelType::u8: {
                const auto value = static_cast<std::uint8_t>(random);
                std::memcpy(&input.data[i], &value, 1);
                input.numbers.push_back(value / 255.);
                break;
            }
            case TexelType::u16: {
                const auto value = static_cast<std::uint16_t>(random);
                std::memcpy(&input.data[2 * i], &value, 2);
                input.numbers.push_back(value / 65535.);
                break;
            }
            default: {
                const auto value = static_cast<float>(random % 4096) / 4096.F;
                std::memcpy(&input.data[4 * i], &value, 4);
                input.numbers.push_back(static_cast<double>(value));
                break;
            }
        }
    }
    return input;
}

void expectKept(TexelFormat format, double stored, double given) {
    switch (format) {
        case TexelFormat::rgba8:
            return glibra::test::expectStored(stored * 255, given * 255);
        case TexelFormat::rgba16:
            return glibra::test::expectStored(stored * 65535, given * 65535);
        case TexelFormat::rgba16f:
            EXPECT_NEAR(stored, given, 1. / 2048);  // 11 bits of mantissa, values up to 1
            return;
        default:  // 32-bit floats
            EXPECT_NEAR(stored, given, 1e-7);
    }
}

std::vector<Rgba> content(const Texture& texture, GLenum image, std::size_t texels) {
    std::vector<Rgba> read(texels);
    texture.bind(0);
    glGetTexImage(image, 0, GL_RGBA, GL_FLOAT, read.data());
    return read;
}

class TextureTest : public test::GpuTest {};

TEST_F(TextureTest, EveryFormatKeepsEveryKindOfInput) {
    constexpr TextureSize kSize{5, 3, 1};
    for (const TexelFormat format : {TexelFormat::rgba8, TexelFormat::rgba16, TexelFormat::rgba16f,
                                     TexelFormat::rgba32f, TexelFormat::r32f})
        for (const TexelType type : {TexelType::u8, TexelType::u16, TexelType::f32})
            for (std::size_t components = 1; components <= 4; ++components) {
                SCOPED_TRACE(std::string(name(format)) + " from " + std::to_string(components) + " of type " +
                             std::to_string(static_cast<int>(type)));
                const Input input = makeInput(15 * components, type);
                const auto texture = Texture::create(driver(), TextureShape::texture2D, format, kSize,
                                                     {input.data, static_cast<int>(components), type});
                ASSERT_TRUE(texture) << text(texture.diagnostics);
                const std::vector<Rgba> read = content(*texture, GL_TEXTURE_2D, 15);
                for (std::size_t i = 0; i < 15; ++i)
                    for (std::size_t c = 0; c < 4; ++c) {
                        double expected = c == 3 ? 1 : 0;
                        if (c < components && (c == 0 || format != TexelFormat::r32f))
                            expected = input.numbers[i * components + c];
                        SCOPED_TRACE(testing::Message() << "texel " << i << "." << c);
                        expectKept(format, static_cast<double>(read[i][c]), expected);
                    }
            }
}

TEST_F(TextureTest, BytesAndShortsAreKeptExactly) {
    std::vector<std::byte> bytes(1024);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i / 4);
    const auto texture =
        Texture::create(driver(), TextureShape::texture1D, TexelFormat::rgba8, {256}, {bytes});
    ASSERT_TRUE(texture);
    std::vector<std::byte> read(bytes.size());
    texture->bind(0);
    glGetTexImage(GL_TEXTURE_1D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    EXPECT_EQ(read, bytes);

    std::vector<std::uint16_t> shorts(4096);
    for (std::size_t i = 0; i < shorts.size(); ++i) shorts[i] = static_cast<std::uint16_t>(16 * i + 3);
    const auto wide = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba16, {32, 32},
                                      {std::as_bytes(std::span(shorts)), 4, TexelType::u16});
    ASSERT_TRUE(wide);
    std::vector<std::uint16_t> readShorts(shorts.size());
    wide->bind(0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_SHORT, readShorts.data());
    EXPECT_EQ(readShorts, shorts);
}

TEST_F(TextureTest, FloatsAreKeptBitForBitEvenBeyondOne) {
    std::vector<float> values{-3.5F, 1e30F, 1e-30F, -0.F, INFINITY, .1F, 65536.25F, -INFINITY};
    const auto texture = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba32f, {2, 1},
                                         {std::as_bytes(std::span(values)), 4, TexelType::f32});
    ASSERT_TRUE(texture);
    const std::vector<Rgba> read = content(*texture, GL_TEXTURE_2D, 2);
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(std::bit_cast<std::uint32_t>(read[i / 4][i % 4]), std::bit_cast<std::uint32_t>(values[i]))
            << i;
}

TEST_F(TextureTest, FirstTexelLiesAtTheOriginOfTheTextureCoordinates) {
    std::vector<std::byte> texels(12);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::byte>(10 * (i + 1));
    const auto texture = Texture::create(driver(), TextureShape::texture3D, TexelFormat::rgba8, {3, 2, 2},
                                         {texels, 1, TexelType::u8});
    ASSERT_TRUE(texture);
    const auto program = build(test::kCoverAll, R"(#version 410 core
uniform sampler3D uTexture;
uniform vec3 uPlace;
out vec4 fColor;
void main() { fColor = texture(uTexture, uPlace); }
)");
    ASSERT_TRUE(program);
    const Sampler sampler(Wrap::repeat);
    for (int p = 0; p < 2; ++p)
        for (int t = 0; t < 2; ++t)
            for (int s = 0; s < 3; ++s) {
                program->use();
                texture->bind(3);
                sampler.bind(3);
                glUniform1i(glGetUniformLocation(program->id(), "uTexture"), 3);
                glUniform3f(glGetUniformLocation(program->id(), "uPlace"), (static_cast<float>(s) + .5F) / 3,
                            (static_cast<float>(t) + .5F) / 2, (static_cast<float>(p) + .5F) / 2);
                EXPECT_NEAR(shade(*program).at(0)[0] * 255, 10 * (1 + s + 3 * t + 6 * p), .01) << s << t << p;
            }
}

TEST_F(TextureTest, EmptyTexturesAreTransparentBlackEverywhere) {
    struct Case {
        TextureShape shape;
        TextureSize size;
        std::vector<GLenum> images;
    };
    std::vector<GLenum> faces;
    for (GLenum face = 0; face < 6; ++face) faces.push_back(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
    const std::vector<Case> cases{{TextureShape::texture1D, {7}, {GL_TEXTURE_1D}},
                                  {TextureShape::texture2D, {7, 5}, {GL_TEXTURE_2D}},
                                  {TextureShape::texture3D, {4, 3, 5}, {GL_TEXTURE_3D}},
                                  {TextureShape::array1D, {5, 1, 3}, {GL_TEXTURE_1D_ARRAY}},
                                  {TextureShape::array2D, {4, 3, 5}, {GL_TEXTURE_2D_ARRAY}},
                                  {TextureShape::rectangle, {7, 5}, {GL_TEXTURE_RECTANGLE}},
                                  {TextureShape::cube, {6, 6}, faces}};
    for (const Case& each : cases)
        for (const TexelFormat format : {TexelFormat::rgba8, TexelFormat::rgba16f, TexelFormat::rgba32f}) {
            const auto texture = Texture::create(driver(), each.shape, format, each.size);
            ASSERT_TRUE(texture) << text(texture.diagnostics);
            const auto texels = static_cast<std::size_t>(each.size.width) *
                                static_cast<std::size_t>(each.size.height) *
                                static_cast<std::size_t>(each.size.depth);
            for (const GLenum image : each.images)
                for (const Rgba& texel : content(*texture, image, texels))
                    EXPECT_EQ(texel, (Rgba{0, 0, 0, 0}));
        }
}

TEST_F(TextureTest, CubeFacesFollowOneAnother) {
    std::vector<std::byte> texels(96);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::byte>(40 * (i / 16) + 5);
    const auto texture =
        Texture::create(driver(), TextureShape::cube, TexelFormat::rgba8, {4, 4}, {texels, 1, TexelType::u8});
    ASSERT_TRUE(texture) << text(texture.diagnostics);
    const auto program = build(test::kCoverAll, R"(#version 410 core
uniform samplerCube uTexture;
uniform vec3 uDirection;
out vec4 fColor;
void main() { fColor = texture(uTexture, uDirection); }
)");
    ASSERT_TRUE(program);
    const Sampler sampler(Wrap::clampToEdge);
    const std::array<std::array<float, 3>, 6> directions{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    for (std::size_t face = 0; face < 6; ++face) {
        texture->bind(0);
        sampler.bind(0);
        program->use();
        glUniform3fv(glGetUniformLocation(program->id(), "uDirection"), 1, directions[face].data());
        EXPECT_NEAR(shade(*program).at(0)[0] * 255, static_cast<double>(40 * face + 5), .01);
    }
}

TEST_F(TextureTest, SamplersDecideHowCoordinatesWrap) {
    const std::vector<std::byte> texels{std::byte{0}, std::byte{85}, std::byte{170}, std::byte{255}};
    const auto texture = Texture::create(driver(), TextureShape::texture1D, TexelFormat::rgba8, {4},
                                         {texels, 1, TexelType::u8});
    ASSERT_TRUE(texture);
    const auto program = build(test::kCoverAll, R"(#version 410 core
uniform sampler1D uTexture;
uniform float uS;
out vec4 fColor;
void main() { fColor = texture(uTexture, uS); }
)");
    ASSERT_TRUE(program);
    const auto value = [&](Wrap wrap, float s) {
        const Sampler sampler(wrap);
        texture->bind(0);
        sampler.bind(0);
        program->use();
        glUniform1f(glGetUniformLocation(program->id(), "uS"), s);
        const float red = shade(*program).at(0)[0];
        glBindSampler(0, 0);
        return std::lround(red * 255);
    };
    EXPECT_EQ(value(Wrap::repeat, 1.125F), 0);
    EXPECT_EQ(value(Wrap::clampToEdge, 1.125F), 255);
    EXPECT_EQ(value(Wrap::mirroredRepeat, 1.125F), 255);
    EXPECT_EQ(value(Wrap::mirroredRepeat, 1.875F), 0);
    EXPECT_EQ(value(Wrap::clampToEdge, -5), 0);
    EXPECT_EQ(value(Wrap::repeat, .5F), std::lround((85 + 170) / 2.)) << "linear between texel centres";
}

TEST_F(TextureTest, BytesAreFilteredLinearlyBetweenTexelCentres) {
    // Compares with the formula of OpenGL 4.1, section 3.8.11 (GL_LINEAR, REPEAT), in the shader's float
    // arithmetic.
    const Input input = makeInput(std::size_t{16} * 16 * 4, TexelType::u8);
    const auto texture =
        Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {16, 16}, {input.data});
    ASSERT_TRUE(texture);
    const auto program = build(test::kCoverAll, R"(#version 410 core
uniform sampler2D uTexture;
uniform bool uByHand;
out vec4 fColor;
void main() {
    vec2 st = mat2(.8, .3, -.3, .8) * gl_FragCoord.xy / 40.;
    vec2 place = st * 16. - .5;
    vec2 weight = fract(place);
    ivec2 low = ivec2(floor(place)) & 15;
    ivec2 high = (low + 1) & 15;
    vec4 lower = mix(texelFetch(uTexture, low, 0), texelFetch(uTexture, ivec2(high.x, low.y), 0), weight.x);
    vec4 upper = mix(texelFetch(uTexture, ivec2(low.x, high.y), 0), texelFetch(uTexture, high, 0), weight.x);
    fColor = uByHand ? mix(lower, upper, weight.y) : texture(uTexture, st);
}
)");
    ASSERT_TRUE(program);
    const Sampler sampler;
    texture->bind(0);
    sampler.bind(0);
    program->use();
    const GLint byHand = glGetUniformLocation(program->id(), "uByHand");
    glUniform1i(byHand, 0);
    const std::vector<Rgba> filtered = shade(*program, 64, 64);
    glUniform1i(byHand, 1);
    const std::vector<Rgba> expected = shade(*program, 64, 64);
    double worst = 0;
    for (std::size_t i = 0; i < filtered.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            worst = std::max(worst, static_cast<double>(std::fabs(filtered[i][c] - expected[i][c])));
    // Hardware has weights of 8 bits in each direction, which it may cut. llvmpipe is set to compute in
    // float; otherwise its error is 1.6/255.
    const bool inFloat = driver().isSoftware;
    EXPECT_LT(worst, inFloat ? 1e-5 : 2. / 256);
}

TEST_F(TextureTest, SizesBeyondTheDriverAreErrorsThatNameTheLimit) {
    const int beyond = driver().max3DTextureSide + 1;
    const auto texture =
        Texture::create(driver(), TextureShape::texture3D, TexelFormat::rgba8, {1, 1, beyond});
    ASSERT_FALSE(texture);
    EXPECT_EQ(texture.diagnostics.at(0).id, "gpu-E04");
    EXPECT_NE(texture.diagnostics[0].text.find(std::to_string(driver().max3DTextureSide)), std::string::npos);
    EXPECT_FALSE(Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {0, 5}));
    EXPECT_FALSE(Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {-4, 5}));
    EXPECT_FALSE(Texture::create(driver(), TextureShape::cube, TexelFormat::rgba8, {4, 5}));
}

TEST_F(TextureTest, TexelsThatDoNotFitTheSizeAreRefusedUnread) {
    const std::vector<std::byte> bytes(47);
    for (const int components : {0, 3, 4, 5}) {
        const auto texture = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {4, 4},
                                             {bytes, components, TexelType::u8});
        ASSERT_FALSE(texture) << components;
        EXPECT_EQ(texture.diagnostics.at(0).id, "gpu-E03");
    }
}

TEST_F(TextureTest, NamesAreGivenBack) {
    GLuint id = 0;
    {
        const auto texture = Texture::create(driver(), TextureShape::texture2D, TexelFormat::rgba8, {4, 4});
        ASSERT_TRUE(texture);
        id = texture->id();
        EXPECT_TRUE(glIsTexture(id));
    }
    EXPECT_FALSE(glIsTexture(id));
}

}  // namespace
}  // namespace glibra::gpu
