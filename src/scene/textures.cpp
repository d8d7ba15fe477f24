#include "scene/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/text.h"
#include "image/file.h"
#include "image/foreign_headers.h"
#include "image/format.h"
#include "noise/noise.h"
#include "system/file.h"

namespace glibra::scene {
namespace {

constexpr std::size_t kLookedAt = 32;

/// A file's first bytes and its length.
struct Beginning {
    std::array<std::byte, kLookedAt> bytes{};
    std::size_t count = 0;
    std::uint64_t length = 0;

    [[nodiscard]] std::uint64_t integer(std::size_t index) const {
        std::uint64_t value = 0;
        for (std::size_t i = 4; i-- > 0;)
            value = value << 8U | std::to_integer<std::uint64_t>(bytes[4 * index + i]);
        return value;
    }
};

std::optional<Beginning> beginningOf(const base::FileSource& source) {
    Beginning beginning;
    if (source.content) {
        const auto bytes = std::as_bytes(std::span(*source.content));
        beginning.length = bytes.size();
        beginning.count = std::min(bytes.size(), kLookedAt);
        std::ranges::copy(bytes.first(beginning.count), beginning.bytes.begin());
    } else if (const system::File file = system::openToRead(source.path, system::Links::followed)) {
        system::FileFacts facts;
        if (factsOf(file, facts) != 0 || facts.kind != system::FileKind::regular) return std::nullopt;
        beginning.length = facts.size;
        if (readFull(file, beginning.bytes, beginning.count) != 0) return std::nullopt;
    }
    if (beginning.count == 0) return std::nullopt;
    return beginning;
}

/// True if the file's length is 4 d + 4 c * (product of the d sizes), with c bytes per component and all
/// sizes at least 1.
bool fitsRaw(const Beginning& beginning, std::size_t dimensions, std::uint64_t componentBytes) {
    const std::uint64_t header = 4 * dimensions;
    if (beginning.count < header || beginning.length <= header) return false;
    std::uint64_t texels = 1;
    const std::uint64_t most =
        beginning.length;  // a file has no more texels than bytes; the limit also prevents overflow
    for (std::size_t i = 0; i < dimensions; ++i) {
        const std::uint64_t size = beginning.integer(i);
        if (size == 0 || size > most / texels) return false;
        texels *= size;
    }
    return beginning.length - header == 4 * componentBytes * texels;
}

std::optional<std::array<double, 3>> sizeOfJpeg(const base::FileSource& source) {
    const auto bytes = image::readFile(source, {source.path.generic_string(), {}});
    const image::JpegFacts facts = bytes ? image::jpegFacts(*bytes) : image::JpegFacts();
    if (facts.width == 0 || facts.height == 0) return std::nullopt;
    return std::array<double, 3>{static_cast<double>(facts.width), static_cast<double>(facts.height), 1};
}

}  // namespace

std::optional<std::array<double, 3>> sizeOfFile(const base::FileSource& source, std::size_t dimensions) {
    const auto beginning = beginningOf(source);
    if (!beginning) return std::nullopt;
    const auto byte = [&](std::size_t at) { return std::to_integer<std::uint32_t>(beginning->bytes.at(at)); };
    const auto whole = [](std::uint32_t value) {
        return std::abs(static_cast<double>(static_cast<std::int32_t>(value)));
    };
    constexpr std::size_t kNeeded = 26;  // the head of a PNG or BMP up to its size
    std::array<double, 3> size{1, 1, 1};
    switch (image::formatOf(std::span(beginning->bytes).first(beginning->count))) {
        case image::Format::jpeg:
            return sizeOfJpeg(source);
        case image::Format::png:
            if (beginning->count < kNeeded) return std::nullopt;
            for (std::size_t i = 0; i < 2; ++i) {
                const std::size_t at = 16 + 4 * i;
                size.at(i) = whole(byte(at) << 24U | byte(at + 1) << 16U | byte(at + 2) << 8U | byte(at + 3));
            }
            break;
        case image::Format::bmp:
            if (beginning->count < kNeeded) return std::nullopt;
            for (std::size_t i = 0; i < 2; ++i) {
                const bool isCore = byte(14) == 12;  // BITMAPCOREHEADER
                const std::size_t at = 18 + (isCore ? 2 : 4) * i;
                const std::uint32_t low = byte(at) | byte(at + 1) << 8U;
                // The height of rows from the top is negative.
                size.at(i) = whole(isCore ? low : low | byte(at + 2) << 16U | byte(at + 3) << 24U);
            }
            break;
        case image::Format::unknown: {
            if (!fitsRaw(*beginning, dimensions, 1) && !fitsRaw(*beginning, dimensions, 4))
                return std::nullopt;
            for (std::size_t i = 0; i < dimensions; ++i)
                size.at(i) = static_cast<double>(beginning->integer(i));
            break;
        }
        default:
            return std::nullopt;
    }
    if (dimensions == 1) size[1] = 1;
    return size;
}

TextureTarget targetOfFile(const base::FileSource& source) {
    const auto beginning = beginningOf(source);
    if (!beginning) return TextureTarget::texture2D;
    const std::span<const std::byte> bytes(beginning->bytes.data(), beginning->count);
    if (image::formatOf(bytes) != image::Format::unknown) return TextureTarget::texture2D;
    constexpr std::array kTargets{TextureTarget::texture1D, TextureTarget::texture2D,
                                  TextureTarget::texture3D};
    for (std::size_t i = 0; i < kTargets.size(); ++i)
        if (fitsRaw(*beginning, i + 1, 1) || fitsRaw(*beginning, i + 1, 4)) return kTargets[i];
    return TextureTarget::texture2D;
}

bool holdsNoise(const base::FileSource& source, int dimensions, int size) {
    const auto beginning = beginningOf(source);
    if (!beginning || !fitsRaw(*beginning, static_cast<std::size_t>(dimensions), 1)) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions); ++i)
        if (beginning->integer(i) != static_cast<std::uint64_t>(size)) return false;
    return true;
}

std::optional<NoiseName> noiseNameOf(std::string_view fileName) {
    constexpr std::string_view kMiddle = "d.";
    constexpr std::string_view kSuffix = ".tex";
    const std::string name = base::lower(fileName.substr(fileName.find_last_of("/\\") + 1));
    NoiseName noise;
    if (name.starts_with("noise2"))
        noise.dimensions = 2;
    else if (!name.starts_with("noise3"))
        return std::nullopt;
    const std::size_t start = 6 + kMiddle.size();
    if (name.size() < start + 3 + kSuffix.size() || name.substr(6, kMiddle.size()) != kMiddle ||
        !name.ends_with(kSuffix))
        return std::nullopt;
    const char* const end = name.data() + name.size() - kSuffix.size();
    const auto [stop, failure] = std::from_chars(name.data() + start, end, noise.size);
    if (failure != std::errc() || stop != end) return std::nullopt;
    const int largest = noise.dimensions == 2 ? noise::kLargestSize2 : noise::kLargestSize3;
    return noise.size >= 1 && noise.size <= largest ? std::optional(noise) : std::nullopt;
}

std::string noiseFileName(int dimensions, int size) {
    return fmt::format("noise{}d.{:03}.tex", dimensions, size);
}

FileReference noiseFileBeside(const SearchFolders& folders, int dimensions, int size, const Place& place) {
    FileReference file{noiseFileName(dimensions, size), {}, {}, place};
    const base::FileSource source = folders.sourceAt(folders.beside.front() / file.name);
    if (source.path.empty()) return file;
    if (holdsNoise(source, dimensions, size)) {
        if (!source.content && !folders.mayRead(source.path)) return file;
        file.path = source.path;
        file.content = source.content;
        file.remarks.push_back(
            diagnose("file-N01", fmt::format("noise is read from '{}' beside the scene", file.name), place));
    } else {
        const std::string texels =
            dimensions == 2 ? fmt::format("{0} x {0}", size) : fmt::format("{0} x {0} x {0}", size);
        file.remarks.push_back(diagnose(
            "file-W10", fmt::format("'{}' does not hold {} byte texels; it is ignored", file.name, texels),
            place));
    }
    return file;
}

}  // namespace glibra::scene
