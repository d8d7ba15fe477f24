#include "image/exr/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "image/bytes.h"

namespace glibra::image {
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

/// Reads the header of one part: nothing if it is damaged, and a part without channels behind the last one.
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
                                    part.tileWidth, part.tileHeight, readableBytes(limits.texelBytes)),
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
        if (part->channels.empty()) break;  // behind the last part
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
