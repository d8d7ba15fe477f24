#include "image/format.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "image/bytes.h"
#include "image/formats/readers.h"
#include "image/png/png_reader.h"

namespace glibra::image {
namespace {

using namespace std::string_view_literals;

// One row per format. What has no signature is recognised in formatOf().
constexpr auto kFormatRows = std::to_array<FormatRow>({
    {Format::unknown, "neither a picture nor a raw texture", "", ""},
    {Format::bmp, "a BMP picture", "bmp", ".bmp .dib ", Holds::nothing, decodeBmp},
    {Format::png, "a PNG picture", "png", ".png .apng ", Holds::alpha, decodePng, {"\x89PNG\r\n\x1a\n"sv}},
    {Format::jpeg,
     "a JPEG picture",
     "jpeg",
     ".jpg .jpeg .jpe .jfif ",
     Holds::nothing,
     nullptr,
     {"\xff\xd8\xff"sv}},
    {Format::tiff,
     "a TIFF picture",
     "tiff",
     ".tif .tiff ",
     Holds::alpha,
     nullptr,
     {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}},
    {Format::openExr, "an EXR picture", "openexr", ".exr ", Holds::alphaAndFloats, nullptr, {"v/1\x01"sv}},
    {Format::hdr,
     "an HDR picture",
     "hdr",
     ".hdr .rgbe ",
     Holds::floats,
     decodeHdr,
     {"#?RADIANCE"sv, "#?RGBE"sv}},
    {Format::targa, "a TGA picture", "targa", ".tga .tpic ", Holds::alpha, decodeTarga},
    {Format::gif, "a GIF picture", "gif", ".gif ", Holds::nothing, nullptr, {"GIF87a"sv, "GIF89a"sv}},
    {Format::webp, "a WebP picture", "webp", ".webp ", Holds::alpha},
    {Format::photoshop, "a Photoshop picture", "psd", ".psd ", Holds::nothing, nullptr, {"8BPS"sv}},
    {Format::dds, "a DDS picture", "dds", ".dds ", Holds::nothing, nullptr, {"DDS "sv}},
    {Format::pnm, "a PNM picture", "pnm", ".ppm .pgm .pbm .pnm ", Holds::nothing, decodePnm},
    {Format::pfm, "a PFM picture", "pnm", ".pfm ", Holds::floats, decodePfm},
    {Format::sgi,
     "an SGI picture",
     "sgi",
     ".sgi .rgb .rgba .bw ",
     Holds::alpha,
     nullptr,
     {"\x01\xda\0\x01"sv, "\x01\xda\x01\x01"sv, "\x01\xda\0\x02"sv, "\x01\xda\x01\x02"sv}},
    {Format::icon, "an ICO picture", "ico", ".ico ", Holds::alpha, nullptr, {"\0\0\x01\0"sv}},
    {Format::heif,
     "a HEIF picture",
     "heif",
     ".heic .heif .avif ",
     Holds::alpha,
     nullptr,
     {"ftypheic"sv, "ftypheix"sv, "ftypmif1"sv, "ftypavif"sv},
     4},
    {Format::rawTexture, "a raw texture", "", ".tex "},
});

bool hasAt(std::span<const std::byte> bytes, std::size_t offset, std::string_view text) {
    if (bytes.size() < offset + text.size()) return false;
    return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset),
                      [](char a, std::byte b) {
                          return static_cast<unsigned char>(a) == std::to_integer<unsigned char>(b);
                      });
}

bool isBmp(std::span<const std::byte> bytes) {
    if (!hasAt(bytes, 0, "BM") || bytes.size() < 18) return false;
    constexpr std::array<unsigned, 7> kHeaderSizes{12, 40, 52, 56, 64, 108, 124};
    const bool small = octetAt(bytes, 15) == 0 && octetAt(bytes, 16) == 0 && octetAt(bytes, 17) == 0;
    return small &&
           std::find(kHeaderSizes.begin(), kHeaderSizes.end(), octetAt(bytes, 14)) != kHeaderSizes.end();
}

/// Format::pnm, Format::pfm or Format::unknown.
Format pnmOrPfm(std::span<const std::byte> bytes) {
    if (bytes.size() < 3 || octetAt(bytes, 0) != 'P') return Format::unknown;
    const unsigned kind = octetAt(bytes, 1), separator = octetAt(bytes, 2);
    if (separator != '\n' && separator != '\r' && separator != ' ' && separator != '\t' && separator != '#')
        return Format::unknown;
    if (kind == 'F' || kind == 'f') return Format::pfm;
    return kind >= '1' && kind <= '6' ? Format::pnm : Format::unknown;
}

/// Texts that version control and downloads leave in the place of a picture. They begin with these words, in
/// upper or lower case.
struct Placeholder {
    std::string_view begin, what;
};
constexpr std::string_view kLfs =
    "a pointer of Git LFS, whose picture has not been downloaded; `git lfs pull` downloads it";
constexpr std::string_view kAnnex =
    "a pointer of git-annex, whose picture has not been downloaded; `git annex get` downloads it";
constexpr std::string_view kConflict =
    "not a picture but has the marks of a merge conflict; choose one of its two sides with `git checkout "
    "--ours` or `git checkout --theirs`";
constexpr std::string_view kWebPage =
    "a web page, such as a download that failed leaves, and not a picture; download it again";
constexpr std::array kPlaceholders{
    Placeholder{"version https://git-lfs.github.com/spec/", kLfs},
    Placeholder{"version https://hawser.github.com/spec/", kLfs},
    Placeholder{"/annex/objects/", kAnnex},
    Placeholder{"../.git/annex/objects/", kAnnex},
    Placeholder{"<<<<<<< ", kConflict},
    Placeholder{"<!doctype html", kWebPage},
    Placeholder{"<html", kWebPage},
};

/// TGA has no signature: its whole header must be valid, and either the footer of version 2 exists or the
/// length of uncompressed pixels agrees.
bool isTarga(std::span<const std::byte> bytes) {
    if (bytes.size() < 18) return false;
    const unsigned mapType = octetAt(bytes, 1), kind = octetAt(bytes, 2), mapBits = octetAt(bytes, 7);
    const std::size_t mapLength = little16(bytes, 5);
    const std::size_t width = little16(bytes, 12);
    const std::size_t height = little16(bytes, 14);
    const unsigned bits = octetAt(bytes, 16);
    const bool mapped = kind == 1 || kind == 9;
    if (mapType > 1 || !(mapped || kind == 2 || kind == 3 || kind == 10 || kind == 11)) return false;
    if (mapped && mapType == 0) return false;
    if (width == 0 || height == 0 || (octetAt(bytes, 17) & 0xc0U) != 0) return false;
    if (bits != 8 && bits != 15 && bits != 16 && bits != 24 && bits != 32) return false;
    if (mapType == 0 ? mapLength != 0 : mapLength == 0) return false;
    if (hasAt(bytes, bytes.size() - 18, "TRUEVISION-XFILE.")) return true;
    const std::size_t pixels = 18 + octetAt(bytes, 0) + mapLength * ((mapBits + 7) / 8);
    if (kind >= 9) return bytes.size() > pixels;  // run lengths, whose length cannot be checked
    return bytes.size() >= pixels + width * height * ((bits + 7) / 8);
}

}  // namespace

Format formatOf(std::span<const std::byte> bytes) {
    if (isBmp(bytes)) return Format::bmp;
    for (const FormatRow& row : kFormatRows)
        for (const std::string_view each : row.signatures)
            if (!each.empty() && hasAt(bytes, row.signatureAt, each)) return row.format;
    if (hasAt(bytes, 0, "RIFF") && hasAt(bytes, 8, "WEBP")) return Format::webp;
    if (const Format format = pnmOrPfm(bytes); format != Format::unknown) return format;
    if (isTarga(bytes)) return Format::targa;
    return Format::unknown;
}

Format formatOfSuffix(const std::filesystem::path& path) {
    const std::string suffix = base::lower(path.extension().generic_string()) + ' ';
    if (suffix.size() < 3) return Format::unknown;
    for (const FormatRow& row : kFormatRows)
        if (row.suffixes.find(suffix) != std::string_view::npos) return row.format;
    return Format::unknown;
}

bool holdsFloats(const std::filesystem::path& path) {
    const Holds holds = rowOf(formatOfSuffix(path)).holds;
    return holds == Holds::floats || holds == Holds::alphaAndFloats;
}

std::string_view placeholderOf(std::span<const std::byte> bytes) {
    constexpr std::size_t kLongest = 64;
    std::string begin;
    for (const std::byte each : bytes.first(std::min(bytes.size(), kLongest))) {
        const char c = static_cast<char>(each);
        if (begin.empty() && (c == ' ' || c == '\n' || c == '\r' || c == '\t')) continue;
        begin += base::lower(c);
    }
    const auto* const found = std::ranges::find_if(
        kPlaceholders, [&](const Placeholder& each) { return begin.starts_with(each.begin); });
    return found == kPlaceholders.end() ? std::string_view() : found->what;
}

std::string_view describeUnknown(std::span<const std::byte> bytes) {
    const std::string_view instead = placeholderOf(bytes);
    return instead.empty() ? describe(Format::unknown) : instead;
}

const FormatRow& rowOf(Format format) {
    return *std::ranges::find(kFormatRows, format, &FormatRow::format);
}

bool keepsAlpha(Format format) {
    const Holds holds = rowOf(format).holds;
    return holds == Holds::alpha || holds == Holds::alphaAndFloats;
}

std::string_view describe(Format format) {
    return rowOf(format).description;
}

std::span<const FormatRow> formats() {
    return kFormatRows;
}

std::string_view openImageIoName(Format format) {
    return rowOf(format).openImageIo;
}

Diagnostics warnIfShownOtherwise(std::span<const std::byte> file, const std::string& path) {
    const std::string why = formatOf(file) == Format::png ? shownOtherwise(file) : std::string();
    if (why.empty()) return {};
    return {diagnose(
        "file-W19",
        fmt::format("'{}' may be shown as another picture than the one that is compared: {}", path, why),
        {path, 1, 1})};
}

}  // namespace glibra::image
