#pragma once
// Writes pixels as a picture file in the format of the suffix.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "image/file.h"
#include "image/image.h"
#include "image/module_loader.h"
#include "image/png/png_writer.h"

namespace glibra::image {

struct WriteOptions {
    PngOptions png;
    std::vector<std::filesystem::path> moduleFolders = defaultModuleFolders();
    /// Stored by EXR ("comments"), TIFF (ImageDescription) and JPEG; PNG has its own texts.
    std::string comment = {};
    NamedBy named = NamedBy::user;  ///< what becomes of a link that has the name of the file
};

/// The default options, for a file whose name was chosen by `named`.
inline WriteOptions writtenAs(NamedBy named) {
    WriteOptions options;
    options.named = named;
    return options;
}

/// A PFM file: colours without alpha as little-endian floats, from the bottom row to the top one (P. Debevec,
/// "PFM Portable FloatMap Image Format").
std::vector<std::byte> encodePfm(const Image& image);

/// Writes .png with png_writer (float pictures as 16 bits, limited to 0..1), .pfm as floats without alpha,
/// .gif with its writer, and every other suffix with the image module: .jpg, .bmp, .tif, .exr, .hdr, .tga,
/// .sgi and others. The file appears when it is complete. No error on success, but file-W14 if alpha is lost;
/// otherwise file-E03 (the module is not installed) or file-E10 (unknown suffix, or the file cannot be
/// written). Colours are never multiplied by alpha.
Diagnostics writeImage(const Image& image, const std::filesystem::path& path,
                       const WriteOptions& options = {});

}  // namespace glibra::image
