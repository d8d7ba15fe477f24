#pragma once
// Which kind of picture a file holds, told by its first bytes (language reference, 8.1), and which kind its
// suffix promises.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace glibra::image {

enum class Format {
    unknown,
    bmp,
    png,
    jpeg,
    tiff,
    openExr,
    hdr,
    targa,
    gif,
    webp,
    photoshop,
    dds,
    pnm,
    sgi,
    icon,
    heif,
    rawTexture  ///< never told by content alone (8.3 decides by the length), but promised by the suffix .tex
};

/// By content: Format::unknown if the bytes begin like no picture we know.
Format formatOf(std::span<const std::byte> bytes);

/// By the suffix, in any case: Format::unknown if it says nothing.
Format formatOfSuffix(const std::filesystem::path& path);

/// With article, for messages: "a TIFF picture", "an EXR picture", "a raw texture".
std::string_view describe(Format format);

/// The name under which OpenImageIO knows the format, for every format but unknown and rawTexture ("").
std::string_view openImageIoName(Format format);

}  // namespace glibra::image
