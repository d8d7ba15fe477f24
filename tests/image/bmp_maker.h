#pragma once
// Builds BMP files of any form for tests, byte by byte.

#include <array>
#include <cstdint>
#include <vector>

#include "support.h"

namespace glibra::image::testing {

/// Any BMP file, including invalid ones. The fields have the meaning of the format's descriptions.
struct BmpMaker {
    std::uint32_t headerSize = 40;
    std::int32_t width = 1, height = 1;
    std::uint32_t bits = 24, compression = 0, colorsUsed = 0;
    std::vector<std::uint32_t> masks{};         ///< after a 40-byte header, inside longer ones
    std::vector<std::array<int, 3>> palette{};  ///< red, green, blue
    std::vector<int> pixels{};
    std::size_t gap = 0;           ///< unused bytes before the pixels
    std::int64_t dataOffset = -1;  ///< -1: the correct one

    [[nodiscard]] std::vector<std::byte> file() const {
        std::vector<std::byte> header;
        putLittle(header, headerSize, 4);
        if (headerSize == 12) {
            putLittle(header, static_cast<std::uint32_t>(width), 2);
            putLittle(header, static_cast<std::uint32_t>(height), 2);
            putLittle(header, 1, 2);
            putLittle(header, bits, 2);
        } else {
            putLittle(header, static_cast<std::uint32_t>(width), 4);
            putLittle(header, static_cast<std::uint32_t>(height), 4);
            putLittle(header, 1, 2);
            putLittle(header, bits, 2);
            putLittle(header, compression, 4);
            for (int i = 0; i < 3; ++i) putLittle(header, 0, 4);
            putLittle(header, colorsUsed, 4);
            putLittle(header, 0, 4);
            for (const std::uint32_t mask : masks) putLittle(header, mask, 4);
            if (headerSize > 40) header.resize(headerSize);
        }
        for (const auto& color : palette) {
            for (const int c : {color[2], color[1], color[0]})
                putLittle(header, static_cast<std::uint32_t>(c), 1);
            if (headerSize != 12) putLittle(header, 0x55, 1);
        }
        header.resize(header.size() + gap);
        std::vector<std::byte> bytes = bytesOf({'B', 'M'});
        putLittle(bytes, 0, 4);  // file size, which readers ignore
        putLittle(bytes, 0, 4);
        putLittle(bytes,
                  static_cast<std::uint32_t>(dataOffset < 0 ? 14 + static_cast<std::int64_t>(header.size())
                                                            : dataOffset),
                  4);
        bytes.insert(bytes.end(), header.begin(), header.end());
        const auto data = bytesOf(pixels);
        bytes.insert(bytes.end(), data.begin(), data.end());
        return bytes;
    }
};

}  // namespace glibra::image::testing
