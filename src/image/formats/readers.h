#pragma once
// The picture formats that are read here, without a library: BMP, which most scenes use, and those of which
// every library that was tried gets some files wrong; each file names the faults. PNG has its own folder.

#include <glibra/result.h>

#include <optional>
#include <span>
#include <vector>

#include "image/file.h"
#include "image/image.h"

namespace glibra::image {

// All results are RGBA. Errors of all: file-E04 damaged or short; file-E09 exceeds the limits.

/// Every form of language, 8.2: headers of 12, 40, 52, 56, 64, 108 and 124 bytes, 1, 4 and 8 bits with
/// palette, 16, 24 and 32 bits, bit fields, RLE4 and RLE8, top-down; u8. Alpha is 1, except in 32-bit pixels
/// with an alpha mask. Pixels that run lengths skip have palette entry 0; colours that the palette lacks are
/// black (file-W16). A BMP file that only wraps a JPEG or PNG is not read here; see embeddedPicture.
Result<Image> decodeBmp(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

/// The complete JPEG or PNG file that a BMP file wraps (compression 4 and 5); empty if it wraps none.
std::optional<std::span<const std::byte>> embeddedPicture(std::span<const std::byte> file);

/// TGA: colour-mapped, true-colour and grey, plain and run-length encoded, in all four orientations; u8. The
/// index of a colour-mapped pixel counts from the first entry that the header names; one outside of the map
/// is file-E04. Alpha is that of 32-bit pixels and entries, of 16-bit pixels if the header has attribute
/// bits, and of 16-bit grey; it is 1 if the extension area says that there is none, and colours that it calls
/// premultiplied are divided by it.
Result<Image> decodeTarga(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

/// Radiance: run lengths of both kinds and none, the eight orientations of the resolution line; f32. EXPOSURE
/// is ignored; XYZ colours are file-E04.
Result<Image> decodeHdr(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

/// P1 to P6: u8 for a maximum up to 255, u16 for more. Of several pictures the first is read.
Result<Image> decodePnm(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});
/// PF and Pf: f32, multiplied by the scale of the header.
Result<Image> decodePfm(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

/// What a DDS file holds: pixels, or a DDS file that has the first picture alone, so that the image module
/// finds no further levels, faces, layers or lengths.
struct DdsContent {
    std::optional<Image> image;
    std::vector<std::byte> blocks;
    bool premultiplied = false;  ///< the colours of the blocks are multiplied by alpha
};

/// DDS, the largest level of the first face or layer: u8 for up to 8 bits per component, u16 for up to 16,
/// f32 for more, for floats, for fractions with a sign and for whole numbers, which stay what they are; u8
/// for BC4 and BC5 without a sign. A single component is grey; others that are missing are 0, alpha 1. Blocks
/// of other kinds are for the module. Volumes and unknown kinds are file-E04.
Result<DdsContent> decodeDds(std::span<const std::byte> file, const FileLabel& label,
                             const Limits& limits = {});

}  // namespace glibra::image
