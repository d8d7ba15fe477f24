#include "image/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <string_view>
#include <vector>

#include "image/bytes.h"
#include "image/file.h"
#include "image/foreign_headers.h"
#include "image/format.h"
#include "image/formats/readers.h"
#include "image/png/png_reader.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

// Formats without a reader of our own are decoded by libraries. A library hands over pixels that are not the
// picture for some kinds of samples, and its next version for others: only kinds whose pixels a test has
// compared with the content of the file or with another decoder are given to it. The headers are read here
// first.

/// What is known of a file after its header.
struct Prepared {
    std::optional<Image> image;          ///< if it needs no library
    std::vector<std::byte> replacement;  ///< what the library reads in place of the file; empty: the file
    unsigned orientation = 1;
    bool associatedAlpha = false;
    bool isInverted = false;  ///< colours count from white
    std::optional<Diagnostic> remark;
};

using Prepare = Result<Prepared> (*)(ByteSpan, const FileLabel&, const Limits&);

Result<Prepared> prepareJpeg(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const JpegFacts facts = jpegFacts(file);
    if (facts.width > 0 && facts.height > 0)
        if (auto tooLarge = checkSize(facts.width, facts.height, 4, limits, label))
            return *std::move(tooLarge);
    if (!hasEndOfImage(file)) return damaged(label, "the file ends before its pixels do");
    if (facts.frame == 0) return damaged(label, "its JPEG header is missing or damaged");
    constexpr std::uint32_t kProgressive = 0xc2, kBits = 8;
    if (facts.frame > kProgressive || facts.bits != kBits ||
        (facts.components != 1 && facts.components != 3 && facts.components != 4))
        return damaged(
            label,
            fmt::format("JPEG pictures of {} components of {} bits, frame {:x}, are not read; save it as a "
                        "baseline or progressive JPEG picture of 8 bits",
                        facts.components, facts.bits, facts.frame));
    Prepared prepared;
    prepared.replacement = withoutMetadata(file);
    if (facts.orientation != 1)
        prepared.remark = diagnose(
            "file-W15",
            fmt::format("'{}' is to be turned by its EXIF data (orientation {}), which are ignored; save "
                        "the picture upright",
                        label.name, facts.orientation),
            label.place);
    return prepared;
}

Result<Prepared> prepareTiff(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto header = readTiffHeader(file, label, limits);
    if (!header) return header.diagnostics;
    Prepared prepared;
    prepared.isInverted = header->photometric == 0;
    if (prepared.isInverted) prepared.replacement = withBlackAsZero(file, *header);
    if (!header->hasBits)
        prepared.replacement = withBitsPerSample(prepared.isInverted ? prepared.replacement : file);
    prepared.orientation = header->orientation;
    prepared.associatedAlpha = header->associatedAlpha;
    return prepared;
}

Result<Prepared> prepareExr(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto header = readExrHeader(file, label, limits);
    if (!header) return header.diagnostics;
    return Prepared{};
}

Result<Prepared> prepareDds(ByteSpan file, const FileLabel& label, const Limits& limits) {
    auto content = decodeDds(file, label, limits);
    if (!content) return std::move(content.diagnostics);
    Prepared prepared;
    prepared.image = std::move(content->image);
    prepared.replacement = std::move(content->blocks);
    prepared.associatedAlpha = content->premultiplied;
    return prepared;
}

/// OpenImageIO reserves memory for all channels of a Photoshop file before it reports a size, and knows
/// neither palettes nor alpha; version 2.5 writes beyond its memory with 16 bits, and gives other values with
/// 16 and 32.
Result<Prepared> preparePhotoshop(ByteSpan file, const FileLabel& label, const Limits& limits) {
    constexpr std::size_t kHeader = 26;
    if (file.size() < kHeader) return damaged(label, "the file ends within the Photoshop header");
    const std::uint64_t channels = big16(file, 12), height = big32(file, 14), width = big32(file, 18),
                        bits = big16(file, 22), mode = big16(file, 24);
    if (auto refused = checkPacked(width, height, (channels * bits + 7) / 8, file.size(), limits, label))
        return *std::move(refused);
    enum : std::uint64_t { bitmap = 0, grey = 1, rgb = 3, inks = 4 };
    const bool isCompared =
        (mode == bitmap && bits == 1 && channels == 1) ||
        (bits == 8 && ((mode == grey && channels == 1) || (mode == rgb && channels == 3) ||
                       (mode == inks && channels == 4)));
    if (!isCompared)
        return damaged(
            label,
            fmt::format("Photoshop pictures of mode {} with {} channels of {} bits are not read; save it "
                        "as RGB of 8 bits without alpha, or as PNG",
                        mode, channels, bits));
    return Prepared{};
}

/// The first picture of an icon, PNG or a DIB, and what follows it; empty if the file ends before it.
ByteSpan pictureOfIcon(ByteSpan file) {
    constexpr std::size_t kPlaceAt = 18, kLeast = 16;
    const std::uint64_t place = file.size() >= kPlaceAt + 4 ? little32(file, kPlaceAt) : file.size();
    return place + kLeast > file.size() ? ByteSpan() : file.subspan(static_cast<std::size_t>(place));
}

/// DIBs of 8, 24 or 32 bits.
Result<Prepared> prepareIcon(ByteSpan file, const FileLabel& label, const Limits& /*limits*/) {
    constexpr std::size_t kBitsAt = 14, kDibHeader = 40;
    const ByteSpan picture = pictureOfIcon(file);
    if (picture.empty()) return damaged(label, "the file ends before its first picture");
    const std::uint32_t bits = little16(picture, kBitsAt);
    if (little32(picture, 0) == kDibHeader && (bits == 8 || bits == 24 || bits == 32)) return Prepared{};
    return damaged(label, fmt::format("icons of {} bits are not read; save it as PNG", bits));
}

/// Alpha is a picture of its own, whose kind has a name. OpenImageIO gives other colours where there is one.
Result<Prepared> prepareHeif(ByteSpan file, const FileLabel& label, const Limits& /*limits*/) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    for (const std::string_view alpha :
         {"urn:mpeg:hevc:2015:auxid:1", "urn:mpeg:mpegB:cicp:systems:auxiliary:alpha"})
        if (text.find(alpha) != std::string_view::npos)
            return damaged(label, "HEIF pictures with alpha are not read; save it as PNG");
    return Prepared{};
}

struct PrepareRow {
    Format format;
    Prepare prepare;
};

constexpr std::array kPrepareRows{
    PrepareRow{Format::jpeg, prepareJpeg},           PrepareRow{Format::tiff, prepareTiff},
    PrepareRow{Format::openExr, prepareExr},         PrepareRow{Format::dds, prepareDds},
    PrepareRow{Format::photoshop, preparePhotoshop}, PrepareRow{Format::icon, prepareIcon},
    PrepareRow{Format::heif, prepareHeif},
};

/// Reads a picture of any format that the image module has. TIFF is turned upright, and colours that were
/// multiplied by alpha are divided by it, except in EXR. file-W15 if EXIF data that are ignored turn a JPEG.
/// Errors: file-E04 for kinds that no test has compared; those of readByModule.
Result<Image> decodeForeign(Format format, ByteSpan file, const fs::path& path, const FileLabel& label,
                            const ReadOptions& options) {
    Result<Prepared> prepared = Prepared{};
    const auto* const row = std::find_if(kPrepareRows.begin(), kPrepareRows.end(),
                                         [&](const PrepareRow& each) { return each.format == format; });
    if (row != kPrepareRows.end()) prepared = row->prepare(file, label, options.limits);
    if (!prepared) return std::move(prepared.diagnostics);
    if (prepared->image) return *std::move(prepared->image);

    const bool isReplaced = !prepared->replacement.empty();
    Result<Image> read = readByModule(format, isReplaced ? ByteSpan(prepared->replacement) : file,
                                      isReplaced ? fs::path() : path, label, options);
    if (!read) return read;
    if (prepared->isInverted) invertColors(*read);
    if (prepared->associatedAlpha) unassociateAlpha(*read);
    if (prepared->orientation != 1) *read = upright(*std::move(read.value), prepared->orientation);
    if (prepared->remark) read.diagnostics.push_back(*std::move(prepared->remark));
    return read;
}

Result<Image> decode(ByteSpan file, Format format, const fs::path& path, const FileLabel& label,
                     const ReadOptions& options) {
    if (format == Format::unknown || format == Format::rawTexture)
        return diagnose("file-E03", fmt::format("'{}' is {}", label.name, describeUnknown(file)),
                        label.place);
    if (const auto inner = format == Format::bmp ? embeddedPicture(file) : std::nullopt) {
        const Format wrapped = formatOf(*inner);
        if (wrapped == Format::png || wrapped == Format::jpeg)
            return decode(*inner, wrapped, {}, label, options);
        return damaged(label, "the BMP header announces a JPEG or PNG picture, but the file contains none");
    }
    // OpenImageIO divides by what a damaged header says.
    if (format == Format::icon && formatOf(pictureOfIcon(file)) == Format::png)
        return decode(pictureOfIcon(file), Format::png, {}, label, options);
    if (const Reader read = rowOf(format).read) return read(file, label, options.limits);
    return decodeForeign(format, file, path, label, options);
}

}  // namespace

Result<Image> decodeImage(std::span<const std::byte> file, const fs::path& path, const Place& place,
                          const ReadOptions& options) {
    const FileLabel label{path.filename().generic_string(), place};
    const Format format = formatOf(file), promised = formatOfSuffix(path);
    Result<Image> result;
    try {
        result = decode(file, format, path, label, options);
    } catch (const std::bad_alloc&) {
        result = damaged(label, "there is not enough memory to read it");
    }
    if (result && promised != Format::unknown && promised != format)
        result.diagnostics.push_back(
            diagnose("file-W03", fmt::format("'{}' is {}", label.name, describe(format)), place));
    return result;
}

Result<Image> readImage(const base::FileSource& source, const Place& place, const ReadOptions& options) {
    auto file = readFile(source, {source.path.filename().generic_string(), place}, options.limits.fileBytes);
    if (!file) return std::move(file.diagnostics);
    return decodeImage(*file, source.path, place, options);
}

}  // namespace glibra::image
