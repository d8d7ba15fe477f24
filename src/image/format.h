#pragma once
// The format of a picture file by its first bytes (language, 8.1), and by its suffix.

#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace glibra::image {

struct FileLabel;
struct Image;
struct Limits;

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
    pfm,  ///< the floats of PNM
    sgi,
    icon,
    heif,
    rawTexture  ///< never recognised by content alone (language, 8.3 uses the length), but by the suffix .tex
};

/// By content. Format::unknown if the bytes do not start like any known picture.
Format formatOf(std::span<const std::byte> bytes);

/// By the suffix, in upper or lower case. Format::unknown if the suffix is not known.
Format formatOfSuffix(const std::filesystem::path& path);

/// True for the suffixes of formats that keep floats outside of 0..1: EXR, HDR and PFM.
bool holdsFloats(const std::filesystem::path& path);

/// True if a picture that is written in this format keeps its alpha.
bool keepsAlpha(Format format);

/// With article, for messages: "a TIFF picture", "an EXR picture", "a raw texture".
std::string_view describe(Format format);

/// What a file is that takes the place of a picture, and what to do: "a pointer of Git LFS ..., `git lfs
/// pull` downloads it", a file with the marks of a merge conflict, a web page. Empty for all others.
std::string_view placeholderOf(std::span<const std::byte> bytes);
/// That, or the description of Format::unknown.
std::string_view describeUnknown(std::span<const std::byte> bytes);

/// OpenImageIO's name of the format; "" for unknown and rawTexture.
std::string_view openImageIoName(Format format);

/// file-W19 for a PNG file of which shownOtherwise() (png/png_reader.h) says something. `path`: for the
/// message.
Diagnostics warnIfShownOtherwise(std::span<const std::byte> file, const std::string& path);

/// Reads a whole file (formats/readers.h).
using Reader = Result<Image> (*)(std::span<const std::byte> file, const FileLabel& label,
                                 const Limits& limits);

/// What a file holds besides colours of 0 to 1.
enum class Holds { nothing, alpha, floats, alphaAndFloats };

/// One kind of file.
struct FormatRow {
    Format format;
    std::string_view description;  ///< as `describe` gives it
    std::string_view openImageIo;  ///< as `openImageIoName` gives it
    std::string_view suffixes;     ///< each with its dot and a blank after it
    Holds holds = Holds::nothing;  ///< of those that are written, too
    Reader read = nullptr;         ///< null: a library reads it
    std::array<std::string_view, 4>
        signatures{};             ///< one of them stands in each file; none if others have it, too
    std::size_t signatureAt = 0;  ///< the byte at which they begin
};
/// That of a format.
const FormatRow& rowOf(Format format);
std::span<const FormatRow> formats();

}  // namespace glibra::image
