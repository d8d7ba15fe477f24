#pragma once
// Copies between textures of one layout by what the driver does fastest.

#include <glad/gl.h>
#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "gpu/context/capabilities.h"
#include "gpu/object/program.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {

/// The texels of all levels and layers.
std::uint64_t bytesOf(const Texture& texture);

/// Copies all texels between textures with equal layouts. Reports gpu-E03 for unequal ones.
Diagnostics copyTexture(const Capabilities& capabilities, const Texture& from, Texture& to);

/// Copies again and again. On a GPU it measures once for each format which way is fastest; glCopyImageSubData
/// is slow for some formats on some drivers. All ways copy every bit.
class TextureCopier {
  public:
    enum class Way { asDriver, drawn, computed };

    /// The same as copyTexture. True if programs and images are bound now that were not before.
    bool copy(const Capabilities& capabilities, const Texture& from, Texture& to, Diagnostics& problems);
    /// Copies in that way; false if the driver, or the layout, does not allow it.
    bool copyBy(Way way, const Capabilities& capabilities, const Texture& from, Texture& to);

  private:
    Way fastest(const Capabilities& capabilities, const Texture& from, Texture& to);
    const Program* programFor(const Capabilities& capabilities, std::size_t texelBytes);

    std::map<TexelFormat, int> large_;   ///< large copies so far
    std::map<TexelFormat, Way> chosen_;  ///< as measured
    std::map<std::size_t, std::optional<Program>> programs_;
};

}  // namespace glibra::gpu
