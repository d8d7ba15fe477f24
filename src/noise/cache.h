#pragma once
// Texels of large noise textures kept between runs, in $XDG_CACHE_HOME/glibra (default ~/.cache/glibra). The
// cache is never required: where the folder is missing, unwritable or holds damaged files, texels are simply
// computed.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "noise/texel_bytes.h"

namespace glibra::noise {

/// Textures below this many bytes are computed, never cached: computing them on two processors takes as long
/// as reading them back and checking them (25 ms for 256 cubed), and the first time they need not be written.
inline constexpr std::size_t kSmallestCachedBytes = std::size_t{128} << 20;

/// The cache's folder by the environment; empty if there is none (neither variable set to an absolute path).
std::filesystem::path cacheFolder();

/// The stored texels of the noise texture with 2 or 3 dimensions and size n, or nothing: no such file, wrong
/// size, wrong checksum, or written for other tables than this program's.
std::optional<TexelBytes> loadTexels(const std::filesystem::path& folder, int dimensions, int n);

/// Stores texels, under a temporary name first, renamed when whole. False if that was not possible; nothing
/// is left then.
bool storeTexels(const std::filesystem::path& folder, int dimensions, int n,
                 std::span<const std::uint8_t> texels);

/// noise3Texels or noise2Texels by way of the cache in `folder` (empty: no cache); textures of fewer bytes
/// than `smallest` are computed.
TexelBytes cachedTexels(int dimensions, int n, const std::filesystem::path& folder = cacheFolder(),
                        std::size_t smallest = kSmallestCachedBytes);

}  // namespace glibra::noise
