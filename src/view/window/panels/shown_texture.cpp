#include "view/window/panels/shown_texture.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace glibra::view {

ImTextureID idOf(const gpu::Texture& texture) {
    return std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.id()));
}

std::optional<gpu::Texture> textureOfBytes(const gpu::Capabilities& capabilities, int width, int height,
                                           std::span<const std::byte> bytes, GLint minified, GLint magnified,
                                           int components) {
    Result<gpu::Texture> made =
        gpu::Texture::create(capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
                             {width, height, 1}, {bytes, components});
    if (!made) return std::nullopt;
    glBindTexture(GL_TEXTURE_2D, made->id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minified);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnified);
    return std::move(made.value);
}

}  // namespace glibra::view
