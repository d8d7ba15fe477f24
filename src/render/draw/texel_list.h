#pragma once
// Lists of numbers that a vertex stage fetches from a texture, where a driver lacks buffers for them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/texture.h"

namespace glibra::render {

using ListTexel = std::array<float, 4>;

/// The list by rows in a texture whose width is the least that OpenGL ES 3.0 has, as glsl/es fetches it.
/// Errors: those of gpu::Texture::create.
inline Result<gpu::Texture> listTexture(const gpu::Capabilities& capabilities,
                                        std::vector<ListTexel> texels) {
    constexpr std::size_t kRow = 2048;
    const std::size_t rows = std::max<std::size_t>(1, (texels.size() + kRow - 1) / kRow);
    texels.resize(rows * kRow);
    return gpu::Texture::create(capabilities, gpu::TextureShape::texture2D, gpu::TexelFormat::rgba32f,
                                {static_cast<int>(kRow), static_cast<int>(rows)},
                                {std::as_bytes(std::span(std::as_const(texels))), 4, gpu::TexelType::f32});
}

}  // namespace glibra::render
