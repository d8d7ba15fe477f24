// The custom mutator of libFuzzer for pictures: changes inside a chunk of a PNG, with the chunk's length and
// checksum right again, and of the pixels with the compression right again. Without it, nearly every changed
// PNG is refused by its first checksum. Other files get changes of bytes.

#include <libdeflate.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "check.h"
#include "random.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace glibra::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kLargestPixels = 1U << 16;  ///< bytes that are unpacked

struct Chunk {
    std::string type;
    Bytes data;
};

std::uint32_t number(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U | std::uint32_t{bytes[2]} << 8U |
           bytes[3];
}

void append(Bytes& bytes, std::uint32_t number) {
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// The chunks of a PNG, as far as they are whole; consecutive IDAT as one. None for other files.
std::vector<Chunk> chunksOf(const std::uint8_t* data, std::size_t size) {
    std::vector<Chunk> chunks;
    if (size < 8 || std::memcmp(data, kSignature, 8) != 0) return chunks;
    for (std::size_t at = 8; size - at >= 12;) {
        const std::size_t length = number(data + at);
        if (length > size - at - 12) break;
        Chunk chunk{{reinterpret_cast<const char*>(data + at + 4), 4},
                    {data + at + 8, data + at + 8 + length}};
        if (chunk.type == "IDAT" && !chunks.empty() && chunks.back().type == "IDAT")
            chunks.back().data.insert(chunks.back().data.end(), chunk.data.begin(), chunk.data.end());
        else
            chunks.push_back(std::move(chunk));
        at += 12 + length;
    }
    return chunks;
}

Bytes fileOf(const std::vector<Chunk>& chunks) {
    Bytes file(std::begin(kSignature), std::end(kSignature));
    for (const Chunk& chunk : chunks) {
        append(file, static_cast<std::uint32_t>(chunk.data.size()));
        const std::size_t begin = file.size();
        file.insert(file.end(), chunk.type.begin(), chunk.type.end());
        file.insert(file.end(), chunk.data.begin(), chunk.data.end());
        append(file, libdeflate_crc32(0, file.data() + begin, file.size() - begin));
    }
    return file;
}

void changeBytes(Bytes& bytes, std::size_t more) {
    const std::size_t size = bytes.size();
    bytes.resize(size + more);
    bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

/// Changes the filtered rows inside an IDAT, if it can be unpacked.
void changePixels(Bytes& packed, Random& random) {
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> unpacker(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    Bytes rows(kLargestPixels);
    std::size_t size = 0;
    if (libdeflate_zlib_decompress(unpacker.get(), packed.data(), packed.size(), rows.data(), rows.size(),
                                   &size) != LIBDEFLATE_SUCCESS)
        return changeBytes(packed, 16);
    rows.resize(size);
    changeBytes(rows, 64);
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> packer(
        libdeflate_alloc_compressor(static_cast<int>(random.below(13))), libdeflate_free_compressor);
    packed.resize(libdeflate_zlib_compress_bound(packer.get(), rows.size()));
    packed.resize(
        libdeflate_zlib_compress(packer.get(), rows.data(), rows.size(), packed.data(), packed.size()));
}

void changeChunks(std::vector<Chunk>& chunks, Random& random) {
    constexpr const char* kTypes[] = {"IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "sRGB", "iCCP", "tEXt",
                                      "zTXt", "iTXt", "bKGD", "pHYs", "sBIT", "hIST", "tIME", "eXIf", "acTL"};
    const std::size_t index = random.below(chunks.size());
    const auto at = chunks.begin() + static_cast<std::ptrdiff_t>(index);
    switch (random.below(10)) {
        case 0:
            chunks.erase(at);
            break;
        case 1:
            chunks.insert(at, Chunk(chunks[random.below(chunks.size())]));
            break;
        case 2:
            std::swap(*at, chunks[random.below(chunks.size())]);
            break;
        case 3:
            chunks.insert(at, {random.oneOf(kTypes),
                               Bytes(random.below(40), static_cast<std::uint8_t>(random.next()))});
            break;
        case 4:  // the pixels in two chunks
            if (at->data.size() > 1) {
                const auto middle =
                    at->data.begin() + static_cast<std::ptrdiff_t>(random.below(at->data.size()));
                Chunk rest{at->type, {middle, at->data.end()}};
                at->data.erase(middle, at->data.end());
                chunks.insert(at + 1, std::move(rest));
            }
            break;
        case 5:
        case 6:
        case 7:
            for (Chunk& chunk : chunks)
                if (chunk.type == "IDAT") return changePixels(chunk.data, random);
            break;
        default:
            changeBytes(at->data, 16);
            break;
    }
}

}  // namespace
}  // namespace glibra::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
    using namespace glibra::fuzz;
    Random random(seed);
    std::vector<Chunk> chunks = chunksOf(data, size);
    if (chunks.empty() || random.oneIn(4)) return LLVMFuzzerMutate(data, size, largest);
    changeChunks(chunks, random);
    const Bytes file = fileOf(chunks);
    if (file.size() > largest) return LLVMFuzzerMutate(data, size, largest);
    std::memcpy(data, file.data(), file.size());
    return file.size();
}
