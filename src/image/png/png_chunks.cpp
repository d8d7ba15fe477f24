#include "image/png/png_chunks.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "image/bytes.h"

namespace glibra::image {
namespace {

/// Adds the content of a chunk; false if it must not occur here.
bool add(std::string_view type, std::span<const std::byte> content, PngChunks& chunks, bool dataEnded) {
    if (type == "IHDR") {
        if (content.size() != 13 || chunks.bitDepth != 0) return false;
        chunks.width = big32(content, 0);
        chunks.height = big32(content, 4);
        chunks.bitDepth = std::to_integer<int>(content[8]);
        chunks.colorType = std::to_integer<int>(content[9]);
        chunks.interlaced = content[12] != std::byte{0};
        return content[10] == std::byte{0} && content[11] == std::byte{0};
    }
    if (chunks.bitDepth == 0) return false;
    if (type == "tRNS") chunks.transparentColor = true;
    if (type == "IDAT") {
        if (dataEnded) return false;
        chunks.data.push_back(content);
        return true;
    }
    if (type == "IEND") return true;
    chunks.others.push_back({type, content, dataEnded});
    return type == "PLTE" || type[0] >= 'a';  // lower case marks ancillary chunks
}

}  // namespace

std::optional<PngChunks> pngChunks(std::span<const std::byte> file) {
    constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
    const auto signature = std::as_bytes(std::span(kSignature));
    if (file.size() < 8 || !std::equal(signature.begin(), signature.end(), file.begin())) return {};
    PngChunks chunks;
    bool dataEnded = false;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t length = big32(file, at);
        if (length > file.size() - at - 12) return {};
        const std::string_view type(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
        if (libdeflate_crc32(0, file.data() + at + 4, length + 4) != big32(file, at + 8 + length)) return {};
        if (type != "IDAT" && !chunks.data.empty()) dataEnded = true;
        if (!add(type, file.subspan(at + 8, length), chunks, dataEnded)) return {};
        at += length + 12;
        if (type == "IEND")
            return at == file.size() && !chunks.data.empty() ? std::optional(chunks) : std::nullopt;
    }
    return {};
}

}  // namespace glibra::image
