#pragma once
// Pictures that libraries of others decode. A library hands over pixels that are not the picture for some
// kinds of samples, and its next version for others: only kinds whose pixels a test has compared with the
// content of the file or with another decoder are given to it. The headers are read here first.

#include <glibra/result.h>

#include <filesystem>
#include <span>

#include "image/format.h"
#include "image/image.h"
#include "image/module_loader.h"

namespace glibra::image {

/// Reads a picture of any format that the image module has. TIFF is turned upright, and colours that were
/// multiplied by alpha are divided by it, except in EXR. file-W15 if EXIF data that are ignored turn a JPEG.
/// Errors: file-E04 for kinds that no test has compared; those of readByModule.
Result<Image> decodeForeign(Format format, std::span<const std::byte> file, const std::filesystem::path& path,
                            const FileLabel& label, const ReadOptions& options);

}  // namespace glibra::image
