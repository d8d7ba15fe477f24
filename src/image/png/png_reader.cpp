#include "image/png/png_reader.h"

#include <fmt/format.h>
#include <spng.h>

#include <algorithm>
#include <memory>

#include "image/png/png_quick_reader.h"

namespace glibra::image {
namespace {

struct FreeContext {
    void operator()(spng_ctx* each) const { spng_ctx_free(each); }
};
using Context = std::unique_ptr<spng_ctx, FreeContext>;

/// Deflate packs at most 1032 bytes into one (zlib's technical notes). So a short file that claims a huge
/// picture is rejected before memory is reserved.
constexpr std::uint64_t kLargestRatio = 1032;

Diagnostic broken(const FileLabel& label, int code) {
    return damaged(label, fmt::format("damaged PNG file ({})", spng_strerror(code)));
}

/// A lower bound of the bytes of the unfiltered picture (interlacing adds a little).
std::uint64_t packedBytes(const spng_ihdr& header) {
    constexpr std::uint64_t kChannels[] = {1, 0, 3, 1, 2, 0, 4};
    const std::uint64_t bits =
        std::uint64_t{header.width} * header.bit_depth * kChannels[header.color_type % 7];
    return (bits + 7) / 8 * header.height;
}

}  // namespace

Result<Image> decodePng(std::span<const std::byte> file, const FileLabel& label, const Limits& limits) {
    const Context context(spng_ctx_new(0));
    if (!context) return damaged(label, "there is not enough memory to read it");
    // Compressed text and profiles may grow to this size; no chunk of a valid file is longer than the file.
    constexpr std::size_t kSpareBytes = std::size_t{16} << 20;
    spng_set_chunk_limits(context.get(), std::min<std::size_t>(file.size() + kSpareBytes, 0x7fffffff),
                          file.size() + 4 * kSpareBytes);
    spng_set_png_buffer(context.get(), file.data(), file.size());

    spng_ihdr header{};
    if (const int failed = spng_get_ihdr(context.get(), &header); failed != 0) return broken(label, failed);
    const bool wide = header.bit_depth == 16;
    if (auto tooLarge = checkSize(header.width, header.height, wide ? 8 : 4, limits, label))
        return *std::move(tooLarge);
    if (packedBytes(header) / kLargestRatio > file.size())
        return damaged(label, fmt::format("{} bytes cannot hold {} x {} pixels", file.size(), header.width,
                                          header.height));
    if (auto usual = decodeUsualPng(file)) return *std::move(usual);

    const int format = wide ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
    std::size_t size = 0;
    if (const int failed = spng_decoded_image_size(context.get(), format, &size); failed != 0)
        return broken(label, failed);
    Image image{static_cast<int>(header.width),
                static_cast<int>(header.height),
                4,
                wide ? Component::u16 : Component::u8,
                {}};
    image.data.resize(size);
    const int failed = spng_decode_image(context.get(), image.data.data(), size, format, SPNG_DECODE_TRNS);
    if (failed == SPNG_IO_EOF || failed == SPNG_EIDAT_TOO_SHORT)
        return damaged(label,
                       fmt::format("the file ends before the pixels of its {} rows do", header.height));
    if (failed != 0) return broken(label, failed);
    return image;
}

}  // namespace glibra::image
