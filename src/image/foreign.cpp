#include "image/foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
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
    std::optional<Diagnostic> remark;
};

using Prepare = Result<Prepared> (*)(ByteSpan, const FileLabel&, const Limits&);

Result<Prepared> prepareJpeg(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const JpegFacts facts = jpegFacts(file);
    if (facts.width > 0 && facts.height > 0)
        if (auto tooLarge = checkSize(facts.width, facts.height, 4, limits, label))
            return *std::move(tooLarge);
    if (!hasEndOfImage(file)) return damaged(label, "the file ends before its pixels do");
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
    if (!header->hasBits) prepared.replacement = withBitsPerSample(file);
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

/// OpenImageIO reserves memory for all channels of a Photoshop file before it reports a size.
Result<Prepared> preparePhotoshop(ByteSpan file, const FileLabel& label, const Limits& limits) {
    constexpr std::size_t kHeader = 26;
    if (file.size() < kHeader) return damaged(label, "the file ends within the Photoshop header");
    const std::uint64_t channels = big16(file, 12), height = big32(file, 14), width = big32(file, 18),
                        bits = big16(file, 22);
    if (auto refused = checkPacked(width, height, (channels * bits + 7) / 8, file.size(), limits, label))
        return *std::move(refused);
    return Prepared{};
}

struct PrepareRow {
    Format format;
    Prepare prepare;
};

constexpr std::array kPrepareRows{
    PrepareRow{Format::jpeg, prepareJpeg},           PrepareRow{Format::tiff, prepareTiff},
    PrepareRow{Format::openExr, prepareExr},         PrepareRow{Format::dds, prepareDds},
    PrepareRow{Format::photoshop, preparePhotoshop},
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
    if (prepared->associatedAlpha) unassociateAlpha(*read);
    if (prepared->orientation != 1) *read = upright(*std::move(read.value), prepared->orientation);
    if (prepared->remark) read.diagnostics.push_back(*std::move(prepared->remark));
    return read;
}

}  // namespace glibra::image
