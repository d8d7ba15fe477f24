#pragma once
// Files as texels: what Texture1D, Texture2D, Texture3D, Texture and CubeMap load (language, 3.4 and 8).

#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/files.h"
#include "image/file.h"
#include "image/image.h"
#include "image/read.h"

namespace glibra::image {

// Raw textures (language, 8.3): d little-endian sizes, then RGBA texels, s fastest, t = 0 first.

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

/// RGBA texels of one file, t = 0 first (the bottom row of a picture). `dimensions` is 1, 2 or 3, or 0 for
/// `Texture`: then a picture is 2D, and the header of a raw texture decides. A picture as a 1D texture is its
/// bottom row (file-W08 if it has more). Warnings: file-W03, W07, W08. Errors: those of readImage; file-E05 a
/// raw texture of another length; file-E03 also for a picture as a 3D texture.
Result<TexelBlock> readTexture(const base::FileSource& source, int dimensions = 0, const Place& place = {},
                               const ReadOptions& options = {});

/// The six faces of a cube map in GL's order (+x -x +y -y +z -z), one after the other in one block with faces
/// = 6: top row of the picture first; the last row of a raw 2D file is its top row. If the types differ, all
/// faces become the widest type. Errors: those of readTexture; file-E06 if the faces are not six squares of
/// equal size.
Result<TexelBlock> readCubeMap(std::span<const base::FileSource> six, const Place& place = {},
                               const ReadOptions& options = {});

/// Pictures, or raw files of `dimensions` (1 or 2), of equal size as the layers of an array or the slices of
/// a 3D texture, the first one first; t = 0 first in each. If the types differ, all become the widest type.
/// Errors: those of readTexture; file-E06 if the sizes differ.
Result<TexelBlock> readLayers(std::span<const base::FileSource> files, int dimensions,
                              const Place& place = {}, const ReadOptions& options = {});

/// The six faces of a cube map in GL's order, as readCubeMap gives them, of one picture:
/// - 2:1, a panorama: the longitude runs along a row, with -z in the middle and +x a quarter to the right;
///   the top row is +y. Faces have a quarter of its width as their side; a texel is the mean of four
///   bilinear samples.
/// - 4:3, a cross: +y above and -y below +z in the row -x +z +x -z. Its texels are copied.
/// Errors: those of readImage; file-E06 for another shape.
Result<TexelBlock> readCubePicture(const base::FileSource& source, const Place& place = {},
                                   const ReadOptions& options = {});

/// The direction (not normalised) that GL's cube map of that face reads at s, t in 0..1, where the first row
/// has t = 0 (OpenGL 4.6, table 8.19).
std::array<double, 3> cubeDirection(int face, double s, double t);

}  // namespace glibra::image
