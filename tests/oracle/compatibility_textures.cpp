#include "compatibility_textures.h"

#include <filesystem>
#include <stdexcept>

#include "image/texture_file.h"
#include "noise/noise.h"

namespace glibra::oracle {
namespace {

GLenum internalFormat(scene::TexelFormat format) {
    switch (format) {
        case scene::TexelFormat::rgba16f:
            return GL_RGBA16F;
        case scene::TexelFormat::rgba32f:
            return GL_RGBA32F;
        case scene::TexelFormat::r32f:
            return GL_R32F;
        default:  // a classic scene names no other
            break;
    }
    return GL_RGBA8;
}

int dimensionsOf(GLenum target) {
    return target == GL_TEXTURE_1D ? 1 : target == GL_TEXTURE_3D ? 3 : 2;
}

}  // namespace

CompatibilityTextures::~CompatibilityTextures() {
    for (const auto& [index, name] : names_) gl_.DeleteTextures(1, &name);
}

GLenum CompatibilityTextures::targetOf(scene::TextureIndex index) const {
    switch (scene_.textures[index].target) {
        case scene::TextureTarget::texture1D:
            return GL_TEXTURE_1D;
        case scene::TextureTarget::texture2D:
            return GL_TEXTURE_2D;
        case scene::TextureTarget::texture3D:
            return GL_TEXTURE_3D;
        case scene::TextureTarget::texture2DArray:
            return GL_TEXTURE_2D_ARRAY;
        case scene::TextureTarget::texture1DArray:  // no classic scene has these
        case scene::TextureTarget::rectangle:
        case scene::TextureTarget::cubeArray:
        case scene::TextureTarget::cube:
            break;
    }
    return GL_TEXTURE_CUBE_MAP;
}

GLuint CompatibilityTextures::texture(scene::TextureIndex index) {
    const auto [entry, isNew] = names_.try_emplace(index, 0);
    if (isNew) {
        gl_.GenTextures(1, &entry->second);
        gl_.BindTexture(targetOf(index), entry->second);
        fill(index);
    }
    return entry->second;
}

void CompatibilityTextures::fill(scene::TextureIndex index) const {
    const scene::Texture& texture = scene_.textures[index];
    const GLenum target = targetOf(index);
    if (const auto* noise = std::get_if<scene::NoiseSource>(&texture.source)) {
        const int n = noise->size;
        const auto bytes = noise->dimensions == 3 ? noise::noise3Texels(n) : noise::noise2Texels(n);
        if (noise->dimensions == 3)
            gl_.TexImage3D(target, 0, GL_RGBA16, n, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        else
            gl_.TexImage2D(target, 0, GL_RGBA16, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        return;
    }
    if (const auto* empty = std::get_if<scene::EmptySource>(&texture.source)) {
        const auto texels = static_cast<std::size_t>(empty->width) * static_cast<std::size_t>(empty->height);
        const std::vector<std::byte> zeros(texels * 4);
        gl_.TexImage2D(target, 0, static_cast<GLint>(internalFormat(empty->format)), empty->width,
                       empty->height, 0, GL_RGBA, GL_UNSIGNED_BYTE, zeros.data());
        return;
    }
    const auto& picture = std::get<scene::PictureSource>(texture.source);
    std::vector<base::FileSource> files;
    for (const scene::FileIndex file : picture.files) files.push_back(scene_.files[file].source());
    const Result<image::TexelBlock> read = target == GL_TEXTURE_CUBE_MAP
                                               ? image::readCubeMap(files)
                                               : image::readTexture(files.front(), dimensionsOf(target));
    if (!read || read->type != image::Component::u8 || read->components != 4)
        throw std::runtime_error("the oracle reads textures of RGBA bytes only: " +
                                 files.front().path.string());
    const image::TexelBlock& block = *read;
    if (target == GL_TEXTURE_1D) {
        gl_.TexImage1D(target, 0, GL_RGBA8, block.width, 0, GL_RGBA, GL_UNSIGNED_BYTE, block.data.data());
    } else if (target == GL_TEXTURE_2D) {
        gl_.TexImage2D(target, 0, GL_RGBA8, block.width, block.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       block.data.data());
    } else {
        for (GLenum face = 0; face < 6; ++face)
            gl_.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, block.width, block.height, 0,
                           GL_RGBA, GL_UNSIGNED_BYTE, block.data.data() + face * (block.data.size() / 6));
    }
}

void CompatibilityTextures::bind(scene::TextureIndex index, GLuint unit, bool clamp) {
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    const GLuint name = texture(index);
    const GLenum target = targetOf(index);
    gl_.BindTexture(target, name);
    const bool isNoise = std::holds_alternative<scene::NoiseSource>(scene_.textures[index].source);
    const bool clamped = target == GL_TEXTURE_CUBE_MAP || (clamp && !isNoise);
    for (const int wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl_.TexParameteri(target, static_cast<GLenum>(wrap), clamped ? GL_CLAMP_TO_EDGE : GL_REPEAT);
    gl_.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.ActiveTexture(GL_TEXTURE0);
}

}  // namespace glibra::oracle
