#include "image/foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "image/alpha.h"
#include "image/bytes.h"
#include "image/dds/dds_reader.h"
#include "image/exr/exr_header.h"
#include "image/jpeg_segments.h"
#include "image/orientation.h"
#include "image/tiff/tiff_header.h"

namespace glibra::image {
namespace {

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
    prepared.replacement = std::move(content->blocks.file);
    prepared.associatedAlpha = content->blocks.premultiplied;
    return prepared;
}

/// OpenImageIO reserves memory for all channels of a Photoshop file before it reports a size, and knows
/// neither palettes nor alpha.
Result<Prepared> preparePhotoshop(ByteSpan file, const FileLabel& label, const Limits& limits) {
    constexpr std::size_t kHeader = 26;
    if (file.size() < kHeader) return damaged(label, "the file ends within the Photoshop header");
    const std::uint64_t channels = big16(file, 12), height = big32(file, 14), width = big32(file, 18),
                        bits = big16(file, 22), mode = big16(file, 24);
    if (auto refused = checkPacked(width, height, (channels * bits + 7) / 8, file.size(), limits, label))
        return *std::move(refused);
    enum : std::uint64_t { bitmap = 0, grey = 1, rgb = 3, inks = 4 };
    const bool isWhole = bits == 8 || bits == 16;
    const bool isCompared = (mode == bitmap && bits == 1 && channels == 1) ||
                            (mode == grey && (isWhole || bits == 32) && channels == 1) ||
                            (mode == rgb && (isWhole || bits == 32) && channels == 3) ||
                            (mode == inks && isWhole && channels == 4);
    if (!isCompared)
        return damaged(
            label,
            fmt::format("Photoshop pictures of mode {} with {} channels of {} bits are not read; save it "
                        "as RGB without alpha, or as PNG",
                        mode, channels, bits));
    return Prepared{};
}

/// The first picture of an icon: PNG, or a DIB of 8, 24 or 32 bits.
Result<Prepared> prepareIcon(ByteSpan file, const FileLabel& label, const Limits& /*limits*/) {
    constexpr std::size_t kPlaceAt = 18, kBitsAt = 14, kDibHeader = 40;
    const std::uint64_t place = file.size() >= kPlaceAt + 4 ? little32(file, kPlaceAt) : file.size();
    if (place + kBitsAt + 2 > file.size()) return damaged(label, "the file ends before its first picture");
    const ByteSpan picture = file.subspan(static_cast<std::size_t>(place));
    const std::uint32_t bits = little16(picture, kBitsAt);
    const bool isDib = little32(picture, 0) == kDibHeader && (bits == 8 || bits == 24 || bits == 32);
    if (isDib || formatOf(picture) == Format::png) return Prepared{};
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

}  // namespace

Result<Image> decodeForeign(Format format, ByteSpan file, const std::filesystem::path& path,
                            const FileLabel& label, const ReadOptions& options) {
    Result<Prepared> prepared = Prepared{};
    const auto* const row = std::find_if(kPrepareRows.begin(), kPrepareRows.end(),
                                         [&](const PrepareRow& each) { return each.format == format; });
    if (row != kPrepareRows.end()) prepared = row->prepare(file, label, options.limits);
    if (!prepared) return std::move(prepared.diagnostics);
    if (prepared->image) return *std::move(prepared->image);

    const bool isReplaced = !prepared->replacement.empty();
    Result<Image> read = readByModule(format, isReplaced ? ByteSpan(prepared->replacement) : file,
                                      isReplaced ? std::filesystem::path() : path, label, options);
    if (!read) return read;
    if (prepared->isInverted) invertColors(*read);
    if (prepared->associatedAlpha) unassociateAlpha(*read);
    if (prepared->orientation != 1) *read = upright(*std::move(read.value), prepared->orientation);
    if (prepared->remark) read.diagnostics.push_back(*std::move(prepared->remark));
    return read;
}

}  // namespace glibra::image
