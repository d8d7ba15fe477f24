#pragma once
// Pixels as a picture file, in the format that the suffix names.

#include <glibra/result.h>

#include <filesystem>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/module_loader.h"
#include "image/png/png_writer.h"

namespace glibra::image {

struct WriteOptions {
    PngOptions png;
    std::vector<std::filesystem::path> moduleFolders = defaultModuleFolders();
    /// Kept by EXR ("comments"), TIFF (ImageDescription) and JPEG; PNG has texts of its own.
    std::string comment = {};
};

/// Writes .png by our own writer (float pictures as 16 bits, limited to 0..1) and every other suffix by the
/// OpenImageIO module: .jpg, .bmp, .tif, .exr, .hdr, .tga and others. The file appears when it is whole.
/// Empty if that worked, else one of file-E03 (the module is not installed) and file-E10 (unknown suffix, or
/// the file cannot be written).
Diagnostics writeImage(const Image& image, const std::filesystem::path& path,
                       const WriteOptions& options = {});

}  // namespace glibra::image
