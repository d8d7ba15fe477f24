// A PNG writer for the generators: 8-bit RGB, the filter with the smallest residue per row, best compression.
#include <libdeflate.h>

#include <cstdio>
#include <cstdlib>

#include "march.h"

namespace generate {
namespace {

using Bytes = std::vector<std::uint8_t>;

void appendNumber(Bytes& out, std::uint32_t n) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(n >> shift));
}

void appendChunk(Bytes& out, const char* name, const Bytes& data) {
    appendNumber(out, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), name, name + 4);
    out.insert(out.end(), data.begin(), data.end());
    appendNumber(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

// What the PNG filter `kind` (0..4) predicts from the left, upper and upper left byte.
int prediction(int kind, int left, int up, int upLeft) {
    if (kind == 1) return left;
    if (kind == 2) return up;
    if (kind == 3) return (left + up) / 2;
    if (kind == 0) return 0;
    const int p = left + up - upLeft;
    const int toLeft = std::abs(p - left), toUp = std::abs(p - up), toUpLeft = std::abs(p - upLeft);
    if (toLeft <= toUp && toLeft <= toUpLeft) return left;
    return toUp <= toUpLeft ? up : upLeft;
}

Bytes filtered(const Picture& picture) {
    const int stride = 3 * picture.width;
    Bytes out;
    for (int y = 0; y < picture.height; ++y) {
        const auto at = [&](int row, int i) -> int {
            return row < 0 || i < 0 ? 0 : picture.rgb[static_cast<std::size_t>(row * stride + i)];
        };
        Bytes best;
        long bestCost = -1;
        for (int kind = 0; kind < 5; ++kind) {
            Bytes row{static_cast<std::uint8_t>(kind)};
            long cost = 0;
            for (int i = 0; i < stride; ++i) {
                const auto d = static_cast<std::uint8_t>(
                    at(y, i) - prediction(kind, at(y, i - 3), at(y - 1, i), i < 3 ? 0 : at(y - 1, i - 3)));
                row.push_back(d);
                cost += d < 128 ? d : 256 - d;
            }
            if (bestCost < 0 || cost < bestCost) {
                bestCost = cost;
                best = row;
            }
        }
        out.insert(out.end(), best.begin(), best.end());
    }
    return out;
}

}  // namespace

void writePng(const Picture& picture, const std::string& path) {
    const Bytes raw = filtered(picture);
    libdeflate_compressor* compressor = libdeflate_alloc_compressor(12);
    Bytes packed(libdeflate_zlib_compress_bound(compressor, raw.size()));
    packed.resize(libdeflate_zlib_compress(compressor, raw.data(), raw.size(), packed.data(), packed.size()));
    libdeflate_free_compressor(compressor);

    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header;
    appendNumber(header, static_cast<std::uint32_t>(picture.width));
    appendNumber(header, static_cast<std::uint32_t>(picture.height));
    header.insert(header.end(), {8, 2, 0, 0, 0});
    appendChunk(file, "IHDR", header);
    appendChunk(file, "IDAT", packed);
    appendChunk(file, "IEND", {});
    std::FILE* out = std::fopen(path.c_str(), "wb");
    if (out == nullptr || std::fwrite(file.data(), 1, file.size(), out) != file.size() ||
        std::fclose(out) != 0) {
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
        std::exit(1);
    }
}

}  // namespace generate
