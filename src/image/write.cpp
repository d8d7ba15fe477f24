#include "image/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <new>
#include <span>
#include <string_view>
#include <system_error>

#include "image/format.h"
#include "image/video/video_file.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;

Diagnostics writePng(const Image& image, const fs::path& path, const PngOptions& options, NamedBy named) {
    const bool floats = image.type == Component::f32;
    const auto png = floats ? encodePng(withType(image, Component::u16), options) : encodePng(image, options);
    if (png.empty()) return {cannotWrite(path, "there is not enough memory")};
    return writeFileAtomically(path, png, named);
}

/// file-E10 if a side of the picture is longer than the format permits.
Diagnostics tooLongFor(std::string_view format, int largestSide, const Image& image, const fs::path& path) {
    if (std::max(image.width, image.height) <= largestSide) return {};
    return {cannotWrite(path, fmt::format("{} has at most {} pixels per side", format, largestSide))};
}

Diagnostics writeGif(const Image& image, const fs::path& path, NamedBy named) {
    const Diagnostics tooLong = tooLongFor("GIF", kLargestGifSide, image, path);
    return tooLong.empty() ? writeFileAtomically(path, encodeGif(image), named) : tooLong;
}

Diagnostics writeOther(const Image& image, Format format, const fs::path& path, const WriteOptions& options) {
    std::error_code failed;
    if (fs::is_directory(path, failed) &&
        !(options.named == NamedBy::program && fs::is_symlink(path, failed)))
        return {cannotWrite(path, "it is a folder")};
    TemporaryFile temporary(path, options.named);
    if (temporary.path().empty()) return {temporary.failure()};
    Diagnostics problems = writeByModule(image, format, temporary.path(), {path.generic_string(), {}},
                                         options.comment, options.moduleFolders);
    if (hasError(problems)) return problems;
    return temporary.commit();
}

/// file-W14 if the picture has alpha that its format does not keep.
Diagnostics remarksOn(const Image& image, Format format, const fs::path& path) {
    if (keepsAlpha(format) || !isTransparent(image)) return {};
    return {diagnose("file-W14",
                     fmt::format("'{}' has no alpha, so the transparency of the picture is lost; .png "
                                 "and .tif keep it",
                                 path.generic_string()))};
}

Diagnostics writeAs(const Image& image, Format format, const fs::path& path, const WriteOptions& options) {
    if (format == Format::png) return writePng(image, path, options.png, options.named);
    // OpenImageIO reads PFM, but writes it from version 2.5 on only.
    if (format == Format::pfm) return writeFileAtomically(path, encodePfm(image), options.named);
    if (format == Format::gif) return writeGif(image, path, options.named);
    if (format == Format::sgi) {
        constexpr int kLargestSgiSide = 65'535;
        if (auto tooLong = tooLongFor("SGI", kLargestSgiSide, image, path); !tooLong.empty()) return tooLong;
        if (image.type == Component::f32)
            return writeOther(withType(image, Component::u16), format, path, options);
    }
    return writeOther(image, format, path, options);
}

}  // namespace

std::vector<std::byte> encodePfm(const Image& image) {
    static_assert(std::endian::native == std::endian::little);
    const Image colors = withComponents(withType(image, Component::f32), 3);
    const std::string header = fmt::format("PF\n{} {}\n-1.0\n", colors.width, colors.height);
    const auto head = std::as_bytes(std::span(header));
    std::vector<std::byte> file(head.begin(), head.end());
    file.reserve(head.size() + colors.data.size());
    const std::size_t row = 3 * sizeof(float) * static_cast<std::size_t>(colors.width);
    for (std::size_t y = static_cast<std::size_t>(colors.height); y-- > 0;) {
        const auto first = colors.data.begin() + static_cast<std::ptrdiff_t>(y * row);
        file.insert(file.end(), first, first + static_cast<std::ptrdiff_t>(row));
    }
    return file;
}

Diagnostics writeImage(const Image& image, const fs::path& path, const WriteOptions& options) {
    if (!isConsistent(image)) return {cannotWrite(path, "the picture has no pixels")};
    const Format format = formatOfSuffix(path);
    try {
        if (format == Format::unknown || format == Format::rawTexture)
            return {
                cannotWrite(path, fmt::format("the suffix '{}' is not that of a picture format; .png is one",
                                              path.extension().generic_string()))};
        Diagnostics problems = writeAs(image, format, path, options);
        if (!hasError(problems)) append(problems, remarksOn(image, format, path));
        return problems;
    } catch (const std::bad_alloc&) {
        return {cannotWrite(path, "there is not enough memory")};
    }
}

}  // namespace glibra::image
