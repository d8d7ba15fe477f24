// The table of formats against what the driver makes of it.

#include <algorithm>
#include <cctype>
#include <cstring>

#include "fixture.h"
#include "gpu/format/pixel_format.h"

namespace glibra::gpu {
namespace {

using base::TexelClass;
using base::texelFormats;

class TexelFormatTest : public test::GpuTest {};

std::string upper(std::string_view word) {
    std::string text(word);
    for (char& each : text) each = static_cast<char>(std::toupper(static_cast<unsigned char>(each)));
    return text;
}

TEST(TexelFormatTable, EveryFormatIsFoundByItsNameInAnyCase) {
    for (const base::TexelFormatRow& row : texelFormats()) {
        EXPECT_EQ(base::texelFormatNamed(row.name), row.format) << row.name;
        EXPECT_EQ(base::texelFormatNamed(upper(row.name)), row.format) << row.name;
    }
    EXPECT_FALSE(base::texelFormatNamed("rgba9"));
    EXPECT_FALSE(base::texelFormatNamed(""));
    EXPECT_FALSE(base::texelFormatNamed("rgba"));
}

TEST_F(TexelFormatTest, TheDriverStoresTheComponentsThatTheTableNames) {
    for (const base::TexelFormatRow& row : texelFormats()) {
        SCOPED_TRACE(std::string(row.name));
        const auto texture = Texture::create(driver(), TextureShape::texture2D, row.format, {4, 4});
        ASSERT_TRUE(texture) << test::text(texture.diagnostics);
        texture->bind(0);
        const auto size = [](GLenum what) {
            GLint bits = 0;
            glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, what, &bits);
            return bits;
        };
        EXPECT_EQ(static_cast<GLenum>(size(GL_TEXTURE_INTERNAL_FORMAT)), internalFormat(row.format));
        int components = 0, bits = 0;
        for (const GLenum each : std::initializer_list<GLenum>{
                 GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE,
                 GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE}) {
            components += size(each) > 0 ? 1 : 0;
            bits += size(each);
        }
        EXPECT_EQ(components, row.components);
        EXPECT_LE(bits, 8 * row.bytes);
        EXPECT_GT(bits, 4 * row.bytes);
        if (hasDepth(row.format) || row.components < 1) continue;
        const GLint kind = size(GL_TEXTURE_RED_TYPE);
        switch (row.kind) {
            case TexelClass::normalized:
                EXPECT_EQ(kind, GL_UNSIGNED_NORMALIZED);
                break;
            case TexelClass::signedNormalized:
                EXPECT_EQ(kind, GL_SIGNED_NORMALIZED);
                break;
            case TexelClass::floating:
                EXPECT_EQ(kind, GL_FLOAT);
                break;
            case TexelClass::integer:
                EXPECT_EQ(kind, GL_INT);
                break;
            default:
                EXPECT_EQ(kind, GL_UNSIGNED_INT);
                break;
        }
    }
}

TEST_F(TexelFormatTest, TheNativeLayoutLosesNothing) {
    for (const base::TexelFormatRow& row : texelFormats()) {
        if (hasDepth(row.format)) continue;  // 24 bits of depth go through 32
        SCOPED_TRACE(std::string(row.name));
        const auto texture = Texture::create(driver(), TextureShape::texture2D, row.format, {8, 4});
        ASSERT_TRUE(texture);
        std::vector<std::uint8_t> texels(std::size_t{32} * row.bytes), read(texels.size());
        for (std::size_t i = 0; i < texels.size(); ++i)
            // Below .25 as the upper half of a float, and never -128, which stands for the same as -127.
            texels[i] = static_cast<std::uint8_t>(1 + i * 37 % 60);
        const auto [format, type] = nativeTransfer(row.format);
        texture->bind(0);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 4, format, type, texels.data());
        glGetTexImage(GL_TEXTURE_2D, 0, format, type, read.data());
        EXPECT_EQ(read, texels);
    }
}

TEST_F(TexelFormatTest, ADriverThatSaysYesKeepsItsWord) {
    for (const base::TexelFormatRow& row : texelFormats()) {
        SCOPED_TRACE(std::string(row.name));
        const FormatUse use = useOf(driver(), row.format);
        EXPECT_EQ(use.depth, hasDepth(row.format)) << "the depth formats are all required";
        EXPECT_FALSE(use.color && hasDepth(row.format));
        EXPECT_FALSE(use.filter && isInteger(row.format));
        const auto texture = Texture::create(driver(), TextureShape::texture2D, row.format, {4, 4});
        ASSERT_TRUE(texture);
        const std::array<TexturePart, 1> part{{{&*texture}}};
        const auto target =
            use.depth ? Target::parts(driver(), {}, part[0]) : Target::parts(driver(), part, std::nullopt);
        EXPECT_EQ(target.value.has_value(), use.color || use.depth) << test::text(target.diagnostics);
        if (use.image && driver().imageUnits > 0) texture->bindImage(0, 0, {}, GL_READ_WRITE);
        const auto sampled = Texture::create(
            driver(), {TextureShape::multisampled, row.format, {4, 4}, 1, std::max(2, use.samples)});
        EXPECT_EQ(sampled.value.has_value(), use.samples > 1) << test::text(sampled.diagnostics);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

TEST_F(TexelFormatTest, WhatGlGuaranteesIsPartOfTheDriversAnswer) {
    Capabilities old = driver();
    old.major = 4;
    old.minor = 2;
    for (const base::TexelFormatRow& row : texelFormats()) {
        SCOPED_TRACE(std::string(row.name));
        const FormatUse least = useOf(old, row.format), all = useOf(driver(), row.format);
        EXPECT_LE(least.color, all.color);
        EXPECT_LE(least.depth, all.depth);
        EXPECT_LE(least.filter, all.filter);
        EXPECT_LE(least.blend, all.blend);
        EXPECT_LE(least.image, all.image);
    }
}

}  // namespace
}  // namespace glibra::gpu
