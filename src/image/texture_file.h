#pragma once
// Files as texels: what Texture1D, Texture2D, Texture3D, Texture and CubeMap load (language, 3.4 and 8).

#include <glibra/result.h>

#include <span>

#include "base/files.h"
#include "image/image.h"
#include "image/read.h"

namespace glibra::image {

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

}  // namespace glibra::image
