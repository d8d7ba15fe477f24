#include "image/read.h"

#include <fmt/format.h>

#include <new>

#include "image/bmp/bmp_reader.h"
#include "image/file.h"
#include "image/format.h"
#include "image/jpeg_segments.h"
#include "image/png/png_reader.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

Result<Image> decodeJpeg(std::span<const std::byte> file, const FileLabel& label,
                         const ReadOptions& options) {
    auto read = readByModule(Format::jpeg, withoutMetadata(file), {}, label, options.limits,
                             options.moduleFolders, options.decoder);
    if (read && !hasEndOfImage(file)) return damaged(label, "the file ends before its pixels do");
    return read;
}

Result<Image> decode(std::span<const std::byte> file, Format format, const fs::path& path,
                     const FileLabel& label, const ReadOptions& options) {
    switch (format) {
        case Format::png:
            return decodePng(file, label, options.limits);
        case Format::bmp:
            if (const auto inner = embeddedPicture(file)) {
                const Format wrapped = formatOf(*inner);
                if (wrapped == Format::png || wrapped == Format::jpeg)
                    return decode(*inner, wrapped, {}, label, options);
                return damaged(label,
                               "the BMP header announces a JPEG or PNG picture, but the file contains none");
            }
            return decodeBmp(file, label, options.limits);
        case Format::unknown:
        case Format::rawTexture:
            return diagnose("file-E03", fmt::format("'{}' is {}", label.name, describe(Format::unknown)),
                            label.place);
        case Format::jpeg:
            return decodeJpeg(file, label, options);
        default:
            return readByModule(format, file, path, label, options.limits, options.moduleFolders,
                                options.decoder);
    }
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

Result<Image> readImage(const fs::path& path, const Place& place, const ReadOptions& options) {
    auto file = readFile(path, {path.filename().string(), place}, options.limits.fileBytes);
    if (!file) return std::move(file.diagnostics);
    return decodeImage(*file, path, place, options);
}

}  // namespace glibra::image
