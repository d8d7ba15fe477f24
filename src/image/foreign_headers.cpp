#include "image/foreign_headers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "image/bytes.h"

namespace glibra::image {
namespace {

constexpr unsigned kRestart0 = 0xd0, kRestart7 = 0xd7, kEndOfImage = 0xd9, kStartOfScan = 0xda, kApp0 = 0xe0,
                   kApp14 = 0xee, kApp15 = 0xef, kComment = 0xfe;

bool isMetadata(unsigned marker) {
    return marker == kComment || (marker > kApp0 && marker <= kApp15 && marker != kApp14);
}

}  // namespace

JpegFacts jpegFacts(ByteSpan jpeg) {
    constexpr std::size_t kLeastFrame = 8;  // after the length: precision, height, width, components
    constexpr std::string_view kExif("Exif\0\0", 6);
    JpegFacts facts;
    bool hasExif = false;  // of several, the first one counts
    for (std::size_t at = 2; at + 4 <= jpeg.size() && octetAt(jpeg, at) == 0xff;) {
        const unsigned marker = octetAt(jpeg, at + 1);
        if (marker == 0xff) {  // a fill byte
            ++at;
            continue;
        }
        const std::size_t length = big16(jpeg, at + 2);
        if (marker == kStartOfScan || marker < 0xc0 || length < 2 || at + 2 + length > jpeg.size()) break;
        const ByteSpan content = jpeg.subspan(at + 4, length - 2);
        const bool isFrame = marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (isFrame && length >= kLeastFrame) {
            facts.frame = marker;
            facts.bits = octetAt(content, 0);
            facts.height = big16(content, 1);
            facts.width = big16(content, 3);
            facts.components = octetAt(content, 5);
        }
        if (!hasExif && marker == kApp0 + 1 && content.size() > kExif.size() &&
            std::equal(kExif.begin(), kExif.end(), reinterpret_cast<const char*>(content.data()))) {
            facts.orientation = tiffOrientation(content.subspan(kExif.size()));
            hasExif = true;
        }
        at += 2 + length;
    }
    return facts;
}

std::vector<std::byte> withoutMetadata(std::span<const std::byte> jpeg) {
    std::vector<std::byte> kept;
    kept.reserve(jpeg.size());
    std::size_t at = 2;  // after the start-of-image marker
    std::size_t copied = 0;
    const auto copyUntil = [&](std::size_t end) {
        kept.insert(kept.end(), jpeg.begin() + static_cast<std::ptrdiff_t>(copied),
                    jpeg.begin() + static_cast<std::ptrdiff_t>(end));
    };
    while (at + 4 <= jpeg.size() && octetAt(jpeg, at) == 0xff) {
        const unsigned marker = octetAt(jpeg, at + 1);
        if (marker == 0xff) {  // a fill byte
            ++at;
            continue;
        }
        const std::size_t end = at + 2 + big16(jpeg, at + 2);
        if (marker == kStartOfScan || marker < 0xc0 || end < at + 4 || end > jpeg.size()) break;
        if (isMetadata(marker)) {
            copyUntil(at);
            copied = end;
        }
        at = end;
    }
    copyUntil(jpeg.size());
    return kept;
}

bool hasEndOfImage(std::span<const std::byte> jpeg) {
    std::size_t at = 2;
    while (at + 2 <= jpeg.size()) {
        // Both between segments and within a scan, anything that is not a marker is pixel data or fill.
        const unsigned marker = octetAt(jpeg, at + 1);
        const bool data = octetAt(jpeg, at) != 0xff || marker == 0 || marker == 0xff ||
                          (marker >= kRestart0 && marker <= kRestart7);
        if (data) {
            ++at;
        } else if (marker == kEndOfImage) {
            return true;
        } else {
            if (at + 4 > jpeg.size()) return false;
            at += 2 + big16(jpeg, at + 2);
        }
    }
    return false;
}

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

constexpr std::uint64_t kJpeg = 7, kDeflate = 8, kOldDeflate = 32946;
/// Of the samples: none, three kinds of fax, LZW, JPEG, Deflate and PackBits.
constexpr std::array<std::uint64_t, 9> kComparedCompressions{1,     2,        3,           4,    5,
                                                             kJpeg, kDeflate, kOldDeflate, 32773};

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
    // OpenImageIO 2.5 multiplies these by alpha.
    if (header.compression == kJpeg && (header.samples == 2 || header.samples == 4))
        return "JPEG with alpha is not read; save it with LZW";
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
        return diagnose(
            "file-E09",
            fmt::format("'{}' has tiles of {} x {} pixels, the limit of one is {}", label.name,
                        header.tileWidth, header.tileHeight, base::readableBytes(limits.texelBytes)),
            label.place);
    return header;
}

namespace {

std::int32_t signed32(ByteSpan bytes, std::size_t at) {
    return static_cast<std::int32_t>(little32(bytes, at));
}

std::uint64_t lengthOf(std::int32_t first, std::int32_t last) {
    return last < first ? 0 : static_cast<std::uint64_t>(std::int64_t{last} - first + 1);
}

/// Reads the attributes of a file one after the other.
class ExrCursor {
  public:
    explicit ExrCursor(ByteSpan file, std::size_t at = 0) : file_(file), at_(at) {}

    /// A text up to its zero byte; nothing if the file or the limit of a name ends before.
    std::optional<std::string_view> name() {
        constexpr std::size_t kLongest = 256;
        const std::string_view rest(reinterpret_cast<const char*>(file_.data()) + at_,
                                    std::min(file_.size() - at_, kLongest));
        const std::size_t end = rest.find('\0');
        if (end == std::string_view::npos) return std::nullopt;
        at_ += end + 1;
        return rest.substr(0, end);
    }
    std::optional<ByteSpan> bytes(std::size_t count) {
        if (count > file_.size() - at_) return std::nullopt;
        at_ += count;
        return file_.subspan(at_ - count, count);
    }
    std::optional<std::uint32_t> number() {
        const auto four = bytes(4);
        return four ? std::optional(little32(*four, 0)) : std::nullopt;
    }

  private:
    ByteSpan file_;
    std::size_t at_;
};

constexpr std::size_t kMostChannels = 1024;

bool readChannelList(ByteSpan value, std::vector<ExrChannel>& channels) {
    constexpr std::size_t kRest = 16;  // type, linearity, sampling
    ExrCursor cursor(value);
    for (;;) {
        const auto name = cursor.name();
        if (!name) return false;
        if (name->empty()) return true;
        const auto rest = cursor.bytes(kRest);
        if (!rest || little32(*rest, 0) > 2 || channels.size() == kMostChannels) return false;
        if (signed32(*rest, 8) < 1 || signed32(*rest, 12) < 1) return false;
        channels.push_back({std::string(*name), static_cast<ExrNumber>(little32(*rest, 0))});
    }
}

bool readWindow(ByteSpan value, ExrWindow& window) {
    if (value.size() != 16) return false;
    window = {signed32(value, 0), signed32(value, 4), signed32(value, 8), signed32(value, 12)};
    return window.width() > 0 && window.height() > 0;
}

/// Takes an attribute over. False if it is damaged.
bool takeAttribute(std::string_view name, std::string_view type, ByteSpan value, ExrPart& part) {
    if (name == "channels" && type == "chlist") return readChannelList(value, part.channels);
    if (name == "dataWindow" && type == "box2i") return readWindow(value, part.data);
    if (name == "displayWindow" && type == "box2i") return readWindow(value, part.display);
    if (name == "tiles" && type == "tiledesc") {
        if (value.size() != 9) return false;
        part.tileWidth = little32(value, 0);
        part.tileHeight = little32(value, 4);
        return part.tileWidth > 0 && part.tileHeight > 0;
    }
    if (name == "type" && type == "string") {
        const std::string_view text(reinterpret_cast<const char*>(value.data()), value.size());
        part.isDeep = text.starts_with("deep");
    }
    return true;
}

/// Reads the header of one part: nothing if it is damaged, and a part without channels after the last one.
std::optional<ExrPart> readPart(ExrCursor& cursor) {
    ExrPart part;
    bool any = false;
    for (;; any = true) {
        const auto name = cursor.name();
        if (!name) return std::nullopt;
        if (name->empty()) break;
        const auto type = cursor.name();
        const auto size = cursor.number();
        const auto value = size ? cursor.bytes(*size) : std::nullopt;
        if (!type || !value || !takeAttribute(*name, *type, *value, part)) return std::nullopt;
    }
    if (!any) return part;
    const bool isWhole = !part.channels.empty() && part.data.width() > 0 && part.display.width() > 0;
    return isWhole ? std::optional(std::move(part)) : std::nullopt;
}

/// The reason why a part is not read.
std::optional<Diagnostic> judgePart(const ExrPart& part, const FileLabel& label, const Limits& limits) {
    constexpr std::uint64_t kBytes = 4 * sizeof(float);
    const auto side = static_cast<std::uint64_t>(limits.side);
    if (auto tooLarge = checkSize(part.display.width(), part.display.height(), kBytes, limits, label))
        return tooLarge;
    // All channels of a row are read together.
    if (part.data.width() > side || part.data.height() > side ||
        part.data.width() * part.channels.size() * sizeof(float) > limits.texelBytes)
        return diagnose("file-E09",
                        fmt::format("'{}' has a data window of {} x {} pixels, the limit is {} per side",
                                    label.name, part.data.width(), part.data.height(), side),
                        label.place);
    const std::uint64_t tile = std::uint64_t{part.tileWidth} * part.tileHeight;
    if (tile > (std::uint64_t{1} << 32) ||
        tile * part.channels.size() * sizeof(float) > std::max<std::uint64_t>(limits.texelBytes, 1))
        return diagnose("file-E09",
                        fmt::format("'{}' has tiles of {} x {} pixels, the limit of one is {}", label.name,
                                    part.tileWidth, part.tileHeight, base::readableBytes(limits.texelBytes)),
                        label.place);
    return std::nullopt;
}

std::string_view wordFor(ExrNumber number) {
    return number == ExrNumber::whole ? "uint" : number == ExrNumber::half ? "half" : "float";
}

}  // namespace

std::uint64_t ExrWindow::width() const {
    return lengthOf(left, right);
}
std::uint64_t ExrWindow::height() const {
    return lengthOf(top, bottom);
}

Result<ExrPart> readExrHeader(ByteSpan file, const FileLabel& label, const Limits& limits) {
    constexpr std::size_t kStart = 8, kMostParts = 1024;
    constexpr std::uint32_t kNotImage = 0x800, kSeveralParts = 0x1000;
    if (file.size() < kStart) return damaged(label, "the file ends within the EXR header");
    const std::uint32_t version = little32(file, 4);
    if ((version & 0xffU) != 2)
        return damaged(label, fmt::format("EXR version {} is not known", version & 0xffU));
    ExrCursor cursor(file, kStart);
    std::optional<ExrPart> chosen;
    for (std::size_t i = 0; i < kMostParts; ++i) {
        auto part = readPart(cursor);
        if (!part) return damaged(label, "its EXR header is damaged or ends early");
        if (part->channels.empty()) break;  // after the last part
        // The library reserves memory for every part.
        if (auto refused = judgePart(*part, label, limits)) return *std::move(refused);
        if ((version & kSeveralParts) == 0 && (version & kNotImage) != 0) part->isDeep = true;
        if (!chosen || (chosen->isDeep && !part->isDeep)) chosen = std::move(part);
        if ((version & kSeveralParts) == 0) break;
    }
    if (!chosen) return damaged(label, "its EXR header has no parts");
    if (chosen->isDeep) return damaged(label, "it is a deep picture");
    return *std::move(chosen);
}

std::string describeExr(const ExrPart& part) {
    std::string text =
        fmt::format("display window at {} {}, data window {} x {} at {} {}, channels", part.display.left,
                    part.display.top, part.data.width(), part.data.height(), part.data.left, part.data.top);
    for (const ExrChannel& each : part.channels)
        text += fmt::format(" {} ({})", each.name, wordFor(each.number));
    return text;
}

}  // namespace glibra::image
