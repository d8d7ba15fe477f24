#include "image/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>

#include "image/bmp/bmp_reader.h"
#include "image/file.h"
#include "image/foreign.h"
#include "image/format.h"
#include "image/gif/gif_reader.h"
#include "image/hdr/hdr_reader.h"
#include "image/png/png_reader.h"
#include "image/pnm/pnm_reader.h"
#include "image/sgi/sgi_reader.h"
#include "image/tga/targa_reader.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

using Reader = Result<Image> (*)(std::span<const std::byte>, const FileLabel&, const Limits&);

struct ReaderRow {
    Format format;
    Reader read;
};

/// The formats that are read here, without a library that opens them.
constexpr std::array kReaderRows{
    ReaderRow{Format::png, decodePng},     ReaderRow{Format::bmp, decodeBmp},
    ReaderRow{Format::targa, decodeTarga}, ReaderRow{Format::hdr, decodeHdr},
    ReaderRow{Format::gif, decodeGif},     ReaderRow{Format::pnm, decodePnm},
    ReaderRow{Format::pfm, decodePfm},     ReaderRow{Format::sgi, decodeSgi},
};

Result<Image> decode(std::span<const std::byte> file, Format format, const fs::path& path,
                     const FileLabel& label, const ReadOptions& options) {
    if (format == Format::unknown || format == Format::rawTexture)
        return diagnose("file-E03", fmt::format("'{}' is {}", label.name, describeUnknown(file)),
                        label.place);
    if (const auto inner = format == Format::bmp ? embeddedPicture(file) : std::nullopt) {
        const Format wrapped = formatOf(*inner);
        if (wrapped == Format::png || wrapped == Format::jpeg)
            return decode(*inner, wrapped, {}, label, options);
        return damaged(label, "the BMP header announces a JPEG or PNG picture, but the file contains none");
    }
    const auto* const row = std::find_if(kReaderRows.begin(), kReaderRows.end(),
                                         [&](const ReaderRow& each) { return each.format == format; });
    if (row != kReaderRows.end()) return row->read(file, label, options.limits);
    return decodeForeign(format, file, path, label, options);
}

}  // namespace

Result<Image> decodeImage(std::span<const std::byte> file, const fs::path& path, const Place& place,
                          const ReadOptions& options) {
    const FileLabel label{path.filename().string(), place};
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
    auto file = readFile(source, {source.path.filename().string(), place}, options.limits.fileBytes);
    if (!file) return std::move(file.diagnostics);
    return decodeImage(*file, source.path, place, options);
}

}  // namespace glibra::image
