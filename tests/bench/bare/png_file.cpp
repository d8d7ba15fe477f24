#include "png_file.h"

#include <libdeflate.h>

#include <cstdio>
#include <cstring>

namespace bare {
namespace {

void putBigEndian(std::uint8_t* at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

}  // namespace

bool writePng(const char* name, const std::vector<std::uint8_t>& pixels, std::size_t width,
              std::size_t height) {
    const std::size_t rowBytes = 1 + 3 * width;
    std::vector<std::uint8_t> filtered(rowBytes * height);
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint8_t* from = &pixels[(height - 1 - y) * 4 * width];
        const std::uint8_t* above = y > 0 ? from + 4 * width : nullptr;
        std::uint8_t* to = &filtered[y * rowBytes];
        *to++ = 2;
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                *to++ = static_cast<std::uint8_t>(from[4 * x + c] - (above ? above[4 * x + c] : 0));
    }

    libdeflate_compressor* compressor = libdeflate_alloc_compressor(1);
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor, filtered.size());
    constexpr std::size_t kHeader = 8 + 25;
    std::vector<std::uint8_t> file(kHeader + 12 + bound + 12);
    const auto finishChunk = [&](std::size_t start, std::size_t length, const char* type) {
        putBigEndian(&file[start], static_cast<std::uint32_t>(length));
        std::memcpy(&file[start + 4], type, 4);
        putBigEndian(&file[start + 8 + length], libdeflate_crc32(0, &file[start + 4], 4 + length));
        return start + 12 + length;
    };
    std::memcpy(file.data(), "\x89PNG\r\n\x1a\n", 8);
    putBigEndian(&file[16], static_cast<std::uint32_t>(width));
    putBigEndian(&file[20], static_cast<std::uint32_t>(height));
    file[24] = 8;
    file[25] = 2;
    std::size_t at = finishChunk(8, 13, "IHDR");
    const std::size_t packed =
        libdeflate_zlib_compress(compressor, filtered.data(), filtered.size(), &file[at + 8], bound);
    libdeflate_free_compressor(compressor);
    at = finishChunk(at, packed, "IDAT");
    at = finishChunk(at, 0, "IEND");

    std::FILE* out = std::fopen(name, "wb");
    if (!out) return false;
    const bool isWritten = std::fwrite(file.data(), 1, at, out) == at;
    return std::fclose(out) == 0 && isWritten;
}

}  // namespace bare
