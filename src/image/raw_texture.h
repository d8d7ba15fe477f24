#pragma once
// Raw textures (language, 8.3): d little-endian sizes, then RGBA texels, s fastest, t = 0 first.

#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// One interpretation of a file as a raw texture.
struct RawShape {
    int dimensions = 1;
    std::array<std::uint32_t, 3> sizes{1, 1, 1};
    Component type = Component::u8;  ///< u8 or f32
};

/// Every interpretation whose length is exactly right, in the order of preference: fewer dimensions first,
/// bytes before floats. `dimensions` is 1, 2, 3, or 0 for any.
std::vector<RawShape> rawShapes(std::span<const std::byte> file, int dimensions);

/// True if the first bytes are sizes within the limits for one of the requested dimensions, so that the file
/// may be a raw texture even if its length is wrong.
bool looksRaw(std::span<const std::byte> file, int dimensions, const Limits& limits = {});

/// The texels. Float texels are not changed, including NaN. file-W07 if several interpretations fit (the
/// first is used). Errors: file-E05 if none fits, with the lengths that would; file-E09 exceeds the limits.
Result<TexelBlock> decodeRawTexture(std::span<const std::byte> file, int dimensions, const FileLabel& label,
                                    const Limits& limits = {});

}  // namespace glibra::image
