#pragma once
// Reads any picture file as pixels. The content determines the format, never the suffix (language, 8.1).

#include <glibra/result.h>

#include <filesystem>
#include <span>

#include "base/files.h"
#include "image/image.h"
#include "image/module_loader.h"

namespace glibra::image {

/// The picture as RGBA, top row first: u8, u16 (16-bit PNG and similar) or f32 (EXR, HDR and similar). PNG,
/// BMP, TGA, HDR, PNM, PFM and DDS but for BC1 to BC3, BC6H and BC7 are read here, all else by the image
/// module. `place` is the place in the scene that names the file. file-W03 if the suffix stands for another
/// format. Errors: file-E01, E02 and E14 missing, empty or unreadable; file-E03 not a picture, or one that
/// needs the module, which is not installed; file-E04 damaged or short; file-E09 exceeds the limits; file-E11
/// its decoder crashed or took too long; draw-E08 exceeds what the textures of a scene may have together.
Result<Image> readImage(const base::FileSource& source, const Place& place = {},
                        const ReadOptions& options = {});

/// The same for a file that is already in memory. `path` gives the name for messages, and the suffix.
Result<Image> decodeImage(std::span<const std::byte> file, const std::filesystem::path& path,
                          const Place& place = {}, const ReadOptions& options = {});

}  // namespace glibra::image
