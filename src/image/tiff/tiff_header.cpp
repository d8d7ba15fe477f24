#include "image/tiff/tiff_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "image/bytes.h"

namespace glibra::image {
namespace {

/// Numbers in the byte order of the file. What lies outside of the file is nothing.
class TiffBytes {
  public:
    explicit TiffBytes(ByteSpan file) : file_(file), big_(octetAt(file, 0) == 'M') {}

    [[nodiscard]] std::optional<std::uint64_t> number(std::uint64_t at, std::size_t bytes) const {
        if (at > file_.size() || bytes > file_.size() - at) return std::nullopt;
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            value = value << 8U | octetAt(file_, static_cast<std::size_t>(at) + (big_ ? i : bytes - 1 - i));
        return value;
    }

    /// Where the lowest byte of a number lies.
    [[nodiscard]] std::size_t lowestByte(std::uint64_t at, std::size_t bytes) const {
        return static_cast<std::size_t>(at) + (big_ ? bytes - 1 : 0);
    }

  private:
    ByteSpan file_;
    bool big_;
};

struct TiffEntry {
    std::uint64_t tag = 0, type = 0, count = 0;
    std::uint64_t valueAt = 0;  ///< place of the value, or of its place if it is long
    std::size_t valueBytes = 4;
};

enum : std::uint64_t { kByte = 1, kShort = 3, kLong = 4, kLong8 = 16 };
constexpr std::uint64_t kNoMeaning = 7;  // no photometric interpretation has this number

/// Bytes of a number of a value.
std::size_t sizeOf(const TiffEntry& entry) {
    return entry.type == kByte ? 1 : entry.type == kShort ? 2 : entry.type == kLong ? 4 : 8;
}

/// A number of a value; nothing if it is not a whole number.
std::optional<std::uint64_t> numberOf(const TiffBytes& bytes, const TiffEntry& entry, std::uint64_t index) {
    const std::size_t size = sizeOf(entry);
    if (index >= entry.count || (size == 8 && entry.type != kLong8)) return std::nullopt;
    if (entry.count <= entry.valueBytes / size) return bytes.number(entry.valueAt + index * size, size);
    const auto place = bytes.number(entry.valueAt, entry.valueBytes);
    return place ? bytes.number(*place + index * size, size) : std::nullopt;
}

/// True unless the first numbers of a value differ from `first`.
bool areAll(const TiffBytes& bytes, const TiffEntry& entry, std::uint64_t first) {
    constexpr std::uint64_t kMostCompared = 64;
    for (std::uint64_t i = 1; i < std::min(entry.count, kMostCompared); ++i)
        if (numberOf(bytes, entry, i) != first) return false;
    return true;
}

void take(const TiffBytes& bytes, const TiffEntry& entry, TiffHeader& header) {
    const auto value = numberOf(bytes, entry, 0);
    if (!value) return;
    switch (entry.tag) {
        case 256:
            header.width = *value;
            break;
        case 257:
            header.height = *value;
            break;
        case 258:
            header.bits = *value;
            header.hasBits = true;
            header.isUniform &= areAll(bytes, entry, *value);
            break;
        case 259:
            header.compression = *value;
            break;
        case 266:
            header.fillOrder = *value;
            break;
        case 262:
            // Several do not stand in the entry, and have no meaning.
            header.photometric = entry.count == 1 ? *value : kNoMeaning;
            header.photometricAt = bytes.lowestByte(entry.valueAt, sizeOf(entry));
            break;
        case 274:
            if (*value >= 1 && *value <= 8) header.orientation = static_cast<unsigned>(*value);
            break;
        case 277:
            header.samples = *value;
            break;
        case 317:
            header.predictor = *value;
            break;
        case 322:
            header.tileWidth = *value;
            break;
        case 323:
            header.tileHeight = *value;
            break;
        case 338:
            header.associatedAlpha = *value == 1;
            break;
        case 339:
            header.sampleFormat = *value == 4 ? 1 : *value;  // 4: without a meaning
            header.isUniform &= areAll(bytes, entry, *value);
            break;
        default:
            break;
    }
}

/// Reads the entries of the first directory. False if it does not lie in the file.
bool readDirectory(const TiffBytes& bytes, TiffHeader& header) {
    const bool isBig = bytes.number(2, 2) == 43;
    const auto place = isBig ? bytes.number(8, 8) : bytes.number(4, 4);
    const auto count = place ? bytes.number(*place, isBig ? 8 : 2) : std::nullopt;
    constexpr std::uint64_t kMostEntries = 4096;
    if (!count || *count == 0 || *count > kMostEntries) return false;
    const std::uint64_t first = *place + (isBig ? 8 : 2), step = isBig ? 20 : 12;
    for (std::uint64_t i = 0; i < *count; ++i) {
        const std::uint64_t at = first + i * step;
        const auto tag = bytes.number(at, 2), type = bytes.number(at + 2, 2);
        const auto length = bytes.number(at + 4, isBig ? 8 : 4);
        if (!tag || !type || !length) return false;
        take(bytes, {*tag, *type, *length, at + (isBig ? 12 : 8), isBig ? std::size_t{8} : std::size_t{4}},
             header);
    }
    return true;
}

enum : std::uint64_t { whiteIsZero = 0, blackIsZero = 1, rgb = 2, palette = 3, inks = 5, yCbCr = 6 };
enum : std::uint64_t { plainNumbers = 1, signedNumbers = 2, floatingNumbers = 3 };

/// Samples of the same meaning and format, whose pixels tests have compared.
struct TiffSamples {
    std::uint64_t photometric, format;
    std::uint64_t fewest, most;  ///< per pixel
    std::array<std::uint64_t, 10> bits;
};

constexpr std::array kComparedSamples{
    TiffSamples{whiteIsZero, plainNumbers, 1, 1, {1, 2, 4, 6, 8, 10, 12, 14, 16, 32}},
    TiffSamples{blackIsZero, plainNumbers, 1, 1, {1, 2, 4, 6, 8, 10, 12, 14, 16, 32}},
    TiffSamples{blackIsZero, plainNumbers, 2, 2, {1, 2, 4, 8, 16, 32}},
    TiffSamples{rgb, plainNumbers, 3, 4, {1, 2, 4, 6, 8, 10, 12, 14, 16, 32}},
    TiffSamples{inks, plainNumbers, 4, 4, {8, 16}},
    TiffSamples{palette, plainNumbers, 1, 1, {1, 2, 4, 8}},
    TiffSamples{yCbCr, plainNumbers, 3, 3, {8}},
    TiffSamples{blackIsZero, signedNumbers, 1, 1, {8, 16, 32}},
    TiffSamples{rgb, signedNumbers, 3, 3, {8, 16, 32}},
    TiffSamples{blackIsZero, floatingNumbers, 1, 2, {16, 32}},
    TiffSamples{rgb, floatingNumbers, 3, 4, {16, 32}},
};

constexpr std::uint64_t kDeflate = 8, kOldDeflate = 32946;
/// Of the samples: none, three kinds of fax, LZW, JPEG, Deflate and PackBits.
constexpr std::array<std::uint64_t, 9> kComparedCompressions{1, 2, 3, 4, 5, 7, kDeflate, kOldDeflate, 32773};

template <class Values>
bool holds(const Values& values, std::uint64_t value) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

std::string_view meaningOf(std::uint64_t photometric) {
    constexpr std::array<std::string_view, 9> kMeanings{
        "grey with 0 as white", "grey",  "RGB", "indices of a palette", "a mask", "inks", "YCbCr",
        "of an unknown kind",   "CIELab"};
    return photometric < kMeanings.size() ? kMeanings.at(static_cast<std::size_t>(photometric))
                                          : kMeanings[kNoMeaning];
}

/// Empty, or why the samples are not handed to OpenImageIO.
std::string notCompared(const TiffHeader& header) {
    if (!holds(kComparedCompressions, header.compression))
        return fmt::format("compression {} is not read; save it with LZW", header.compression);
    // OpenImageIO unpacks Deflate by itself, and forgets the order of the bits.
    if (header.fillOrder != 1 && (header.compression == kDeflate || header.compression == kOldDeflate))
        return "its bits stand in reverse order, which cannot be read with Deflate; save it with LZW";
    const bool isFloating = header.sampleFormat == floatingNumbers;
    const bool isPredicted = header.predictor == 1 ||
                             (isFloating ? header.predictor == 3 : header.predictor == 2 && header.bits >= 8);
    const bool isCompared =
        header.isUniform && isPredicted &&
        std::any_of(kComparedSamples.begin(), kComparedSamples.end(), [&](const TiffSamples& each) {
            return each.photometric == header.photometric && each.format == header.sampleFormat &&
                   header.samples >= each.fewest && header.samples <= each.most && header.bits > 0 &&
                   holds(each.bits, header.bits);
        });
    if (isCompared) return {};
    const std::string_view numbers = isFloating                             ? "floating-point "
                                     : header.sampleFormat == signedNumbers ? "signed "
                                     : header.sampleFormat == plainNumbers  ? ""
                                                                            : "complex ";
    return fmt::format(
        "{}samples of {} bits, {} per pixel ({}), are not read; save it as RGB or grey of 8 or 16 bits, "
        "or as 32-bit floating-point numbers",
        numbers, header.bits, header.samples, meaningOf(header.photometric));
}

}  // namespace

std::vector<std::byte> withBlackAsZero(ByteSpan file, const TiffHeader& header) {
    std::vector<std::byte> changed(file.begin(), file.end());
    changed.at(header.photometricAt) = std::byte{blackIsZero};
    return changed;
}

std::vector<std::byte> withBitsPerSample(ByteSpan file) {
    constexpr std::uint64_t kEntry = 12, kTag = 258;
    const TiffBytes bytes(file);
    const auto place = bytes.number(4, 4);
    const auto count = place && bytes.number(2, 2) == 42 ? bytes.number(*place, 2) : std::nullopt;
    if (!count || file.size() > 0xfffffff0U) return {};
    std::vector<std::byte> changed(file.begin(), file.end());
    changed.resize((changed.size() + 1) / 2 * 2);  // directories begin at an even place
    const std::size_t directory = changed.size();
    const bool isBig = octetAt(file, 0) == 'M';
    const auto put = [&](std::size_t at, std::uint64_t value, std::size_t length) {
        changed.resize(std::max(changed.size(), at + length));
        for (std::size_t i = 0; i < length; ++i)
            changed[at + (isBig ? length - 1 - i : i)] = static_cast<std::byte>(value >> (8 * i) & 255U);
    };
    put(4, directory, 4);
    put(directory, *count + 1, 2);
    bool isAdded = false;
    const auto add = [&] {
        const std::size_t at = changed.size();
        put(at, kTag, 2);
        put(at + 2, kShort, 2);
        put(at + 4, 1, 4);
        put(at + 8, 1, 2);
        put(at + 10, 0, 2);
        isAdded = true;
    };
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto at = static_cast<std::size_t>(*place + 2 + i * kEntry);
        if (!isAdded && bytes.number(at, 2) > kTag) add();
        if (at + kEntry > file.size()) return {};
        const ByteSpan entry = file.subspan(at, kEntry);
        changed.insert(changed.end(), entry.begin(), entry.end());
    }
    if (!isAdded) add();
    put(changed.size(), 0, 4);
    return changed;
}

unsigned tiffOrientation(ByteSpan bytes) {
    TiffHeader header;
    const bool read = bytes.size() >= 8 && readDirectory(TiffBytes(bytes), header);
    return read ? header.orientation : 1;
}

Result<TiffHeader> readTiffHeader(ByteSpan file, const FileLabel& label, const Limits& limits) {
    TiffHeader header;
    if (file.size() < 8 || !readDirectory(TiffBytes(file), header))
        return damaged(label, "its first directory is damaged or lies outside of the file");
    if (header.width == 0 || header.height == 0)
        return damaged(label, "the picture has no pixels by its TIFF header");
    constexpr std::uint64_t kMostBits = 64, kMostSamples = 64;
    if (header.bits < 1 || header.bits > kMostBits || header.samples < 1 || header.samples > kMostSamples)
        return damaged(label, fmt::format("{} samples of {} bits are not read", header.samples, header.bits));
    if (const std::string problem = notCompared(header); !problem.empty()) return damaged(label, problem);
    const std::uint64_t component = header.bits <= 8 ? 1 : header.bits <= 16 ? 2 : 4;
    if (auto refused = checkPacked(header.width, header.height, 4 * component, file.size(), limits, label))
        return *std::move(refused);
    const std::uint64_t most = limits.texelBytes / (header.samples * (header.bits + 7) / 8);
    if (header.tileWidth > 0 && header.tileHeight > most / header.tileWidth)
        return diagnose("file-E09",
                        fmt::format("'{}' has tiles of {} x {} pixels, the limit of one is {}", label.name,
                                    header.tileWidth, header.tileHeight, readableBytes(limits.texelBytes)),
                        label.place);
    return header;
}

}  // namespace glibra::image
