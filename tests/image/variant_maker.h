#pragma once
// Files of simple formats in all their variants, byte by byte, with the pixels that they hold.

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support.h"

namespace glibra::image::testing {

using Bytes = std::vector<std::byte>;

/// A file and its pixels as RGBA numbers, top row first.
struct Variant {
    std::string name;
    std::vector<std::byte> file;
    int width = 0, height = 0;
    std::vector<std::array<double, 4>> pixels;  ///< 0..1, or floats
};

/// TGA: kinds, depths, run lengths, orientations, first entries and identifications.
std::vector<Variant> targaVariants();
/// PBM, PGM and PPM: plain and raw, maxima, comments, blanks.
std::vector<Variant> pnmVariants();
/// Radiance: orientations and packings.
std::vector<Variant> hdrVariants();
/// GIF: depths of the palette, interlacing, places in the screen, transparent colours, resets of the codes.
std::vector<Variant> gifVariants();
/// DDS: masks, bit counts, numbered formats.
std::vector<Variant> ddsVariants();
/// TIFF: what samples mean, their bits, types and number, planes, orders of bytes.
std::vector<Variant> tiffVariants();
/// Photoshop: modes, depths, channels, packings.
std::vector<Variant> photoshopVariants();
/// ICO: depths, masks.
std::vector<Variant> iconVariants();
/// DDS files of random blocks, of which only another decoder knows the pixels: names and files.
std::vector<std::pair<std::string, std::vector<std::byte>>> blockFiles();
/// True for those whose numbers have a sign.
bool isSignedBlocks(const std::string& name);

}  // namespace glibra::image::testing
