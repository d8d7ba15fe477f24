#pragma once
// Pixels as textures, for ImGui to draw.

#include <glad/gl.h>
#include <imgui.h>

#include <cstddef>
#include <optional>
#include <span>

#include "gpu/object/texture.h"

namespace glibra::view {

/// How ImGui names it.
ImTextureID idOf(const gpu::Texture& texture);

/// Bytes, `components` per texel, as a texture with these filters; nothing without memory. It stays bound.
std::optional<gpu::Texture> textureOfBytes(const gpu::Capabilities& capabilities, int width, int height,
                                           std::span<const std::byte> bytes, GLint minified, GLint magnified,
                                           int components = 4);

}  // namespace glibra::view
