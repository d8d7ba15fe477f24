#pragma once
// Pictures that libraries of others decode. What a library is known to get wrong, or to reserve before it has
// judged, is read here from the header first.

#include <glibra/result.h>

#include <filesystem>
#include <span>

#include "image/format.h"
#include "image/image.h"
#include "image/module_loader.h"

namespace glibra::image {

/// Reads a picture of any format that the image module has. TIFF is turned upright, and colours that were
/// multiplied by alpha are divided by it, except in EXR. file-W15 if EXIF data that are ignored turn a JPEG.
/// Errors: those of readByModule.
Result<Image> decodeForeign(Format format, std::span<const std::byte> file, const std::filesystem::path& path,
                            const FileLabel& label, const ReadOptions& options);

}  // namespace glibra::image
