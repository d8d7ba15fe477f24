#include "image/pnm/pnm_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

bool isBlank(std::uint8_t character) {
    return character == ' ' || (character >= '\t' && character <= '\r');
}

/// The text part of a file: numbers between blanks and comments, which go from # to the end of the line.
class PnmText {
  public:
    explicit PnmText(ByteSpan file) : file_(file) {}

    [[nodiscard]] std::size_t at() const { return at_; }

    void skipBlanks() {
        while (at_ < file_.size()) {
            if (octetAt(file_, at_) == '#')
                skipComment();
            else if (isBlank(octetAt(file_, at_)))
                ++at_;
            else
                return;
        }
    }
    /// A number without sign; nothing if there is none, or one of more than 32 bits.
    std::optional<std::uint32_t> number() {
        skipBlanks();
        std::uint32_t value = 0;
        const auto [begin, end] = rest();
        const auto [after, failure] = std::from_chars(begin, end, value);
        if (failure != std::errc()) return std::nullopt;
        at_ += static_cast<std::size_t>(after - begin);
        return value;
    }
    std::optional<double> realNumber() {
        skipBlanks();
        double value = 0;
        const auto [begin, end] = rest();
        const auto [after, failure] = std::from_chars(begin, end, value);
        if (failure != std::errc()) return std::nullopt;
        at_ += static_cast<std::size_t>(after - begin);
        return value;
    }
    /// 0 or 1, which need no blank between them.
    std::optional<std::uint32_t> digit() {
        skipBlanks();
        if (at_ >= file_.size() || (octetAt(file_, at_) != '0' && octetAt(file_, at_) != '1'))
            return std::nullopt;
        return octetAt(file_, at_++) - std::uint32_t{'0'};
    }
    /// The one blank before binary pixels, which may be the end of a comment. False if it is missing.
    bool endHeader() {
        if (at_ < file_.size() && octetAt(file_, at_) == '#') {
            skipComment();
            return at_ <= file_.size();
        }
        return at_ < file_.size() && isBlank(octetAt(file_, at_++));
    }
    [[nodiscard]] bool atEnd() {
        skipBlanks();
        return at_ >= file_.size();
    }

  private:
    void skipComment() {
        while (at_ < file_.size() && octetAt(file_, at_) != '\n' && octetAt(file_, at_) != '\r') ++at_;
        if (at_ < file_.size()) ++at_;
    }
    [[nodiscard]] std::pair<const char*, const char*> rest() const {
        const auto* const begin = reinterpret_cast<const char*>(file_.data());
        return {begin + at_, begin + file_.size()};
    }

    ByteSpan file_;
    std::size_t at_ = 2;  // after the magic number
};

struct PnmHeader {
    unsigned kind = 0;  ///< the digit of P1 to P6
    std::uint32_t width = 0, height = 0, most = 1;

    [[nodiscard]] bool isPlain() const { return kind <= 3; }
    [[nodiscard]] bool isBitmap() const { return kind == 1 || kind == 4; }
    [[nodiscard]] std::size_t channels() const { return kind == 3 || kind == 6 ? 3 : 1; }
    /// Of the samples of a row; for a plain file, what they take at least.
    [[nodiscard]] std::uint64_t rowBytes() const {
        const std::uint64_t samples = std::uint64_t{width} * channels();
        if (kind == 1) return samples;
        if (kind == 4) return (samples + 7) / 8;
        return isPlain() ? 2 * samples : samples * (most > 255 ? 2 : 1);
    }
};

constexpr const char* kHeaderEnds = "its header is damaged or ends early";

Result<PnmHeader> readPnmHeader(ByteSpan file, PnmText& text, const FileLabel& label) {
    PnmHeader header;
    header.kind = octetAt(file, 1) - unsigned{'0'};
    const auto width = text.number(), height = text.number();
    const auto most = header.isBitmap() ? std::optional<std::uint32_t>(1) : text.number();
    if (!width || !height || !most || (!header.isPlain() && !text.endHeader()))
        return damaged(label, kHeaderEnds);
    if (*width == 0 || *height == 0) return damaged(label, "the picture has no pixels by its header");
    if (*most < 1 || *most > 65535)
        return damaged(label, fmt::format("the largest value is {}, expected 1 to 65535", *most));
    header.width = *width;
    header.height = *height;
    header.most = *most;
    return header;
}

/// The samples one after the other, whatever the kind.
class PnmSamples {
  public:
    PnmSamples(ByteSpan file, PnmText& text, const PnmHeader& header)
        : file_(file), text_(text), header_(header), begin_(text.at()) {}

    /// Sample `i` of row `y`. Samples are asked for in their order. Nothing if a plain file has no number
    /// there.
    std::optional<std::uint32_t> next(std::uint64_t y, std::uint64_t i) {
        const std::size_t row = begin_ + static_cast<std::size_t>(y * header_.rowBytes());
        switch (header_.kind) {
            case 1:
                return inverted(text_.digit());
            case 4:
                return 1U - (octetAt(file_, row + i / 8) >> (7 - i % 8) & 1U);
            case 2:
            case 3:
                return text_.number();
            default:
                return header_.most > 255 ? big16(file_, row + 2 * i) : octetAt(file_, row + i);
        }
    }

  private:
    /// 1 is black.
    static std::optional<std::uint32_t> inverted(std::optional<std::uint32_t> bit) {
        if (bit) *bit = 1 - *bit;
        return bit;
    }

    ByteSpan file_;
    PnmText& text_;
    const PnmHeader& header_;
    std::size_t begin_;
};

template <class Value>
std::optional<Diagnostic> readSamples(PnmSamples samples, PnmText& text, const PnmHeader& header,
                                      const FileLabel& label, Image& image) {
    constexpr std::uint64_t kMost = std::numeric_limits<Value>::max();
    const std::size_t channels = header.channels();
    std::byte* to = image.data.data();
    for (std::uint64_t y = 0; y < header.height; ++y)
        for (std::uint64_t x = 0; x < header.width; ++x, to += 4 * sizeof(Value)) {
            std::array<Value, 4> pixel{};
            pixel[3] = kMost;
            for (std::size_t c = 0; c < channels; ++c) {
                const auto sample = samples.next(y, x * channels + c);
                if (!sample && text.atEnd()) return endsEarly(label, y, header.height);
                if (!sample)
                    return damaged(label, fmt::format("row {} has something that is no number", y + 1));
                if (*sample > header.most)
                    return damaged(label, fmt::format("row {} has the value {}, but the largest is {}", y + 1,
                                                      *sample, header.most));
                pixel.at(c) = static_cast<Value>((*sample * kMost + header.most / 2) / header.most);
            }
            if (channels == 1) pixel[1] = pixel[2] = pixel[0];
            std::memcpy(to, pixel.data(), sizeof pixel);
        }
    return std::nullopt;
}

}  // namespace

Result<Image> decodePnm(ByteSpan file, const FileLabel& label, const Limits& limits) {
    PnmText text(file);
    const auto read = readPnmHeader(file, text, label);
    if (!read) return read.diagnostics;
    const PnmHeader& header = *read;
    const Component type = header.most > 255 ? Component::u16 : Component::u8;
    if (auto tooLarge = checkSize(header.width, header.height, 4 * bytesOf(type), limits, label))
        return *std::move(tooLarge);
    // The last number of a plain file needs no blank after it.
    const std::uint64_t have = file.size() - text.at() + (header.kind == 2 || header.kind == 3 ? 1 : 0);
    if (have / header.rowBytes() < header.height)
        return endsEarly(label, have / header.rowBytes(), header.height);

    Image image = blankImage(header.width, header.height, type);
    const PnmSamples samples(file, text, header);
    auto problem = type == Component::u8 ? readSamples<std::uint8_t>(samples, text, header, label, image)
                                         : readSamples<std::uint16_t>(samples, text, header, label, image);
    if (problem) return *std::move(problem);
    return image;
}

Result<Image> decodePfm(ByteSpan file, const FileLabel& label, const Limits& limits) {
    PnmText text(file);
    const std::size_t channels = octetAt(file, 1) == 'F' ? 3 : 1;
    const auto width = text.number(), height = text.number();
    const auto scale = text.realNumber();
    if (!width || !height || !scale || !std::isfinite(*scale) || *scale == 0 || !text.endHeader())
        return damaged(label, kHeaderEnds);
    if (*width == 0 || *height == 0) return damaged(label, "the picture has no pixels by its header");
    if (auto tooLarge = checkSize(*width, *height, 4 * sizeof(float), limits, label))
        return *std::move(tooLarge);
    const std::uint64_t rowBytes = std::uint64_t{*width} * channels * sizeof(float);
    if ((file.size() - text.at()) / rowBytes < *height)
        return endsEarly(label, (file.size() - text.at()) / rowBytes, *height);

    Image image = blankImage(*width, *height, Component::f32);
    const auto factor = static_cast<float>(std::abs(*scale));
    for (std::size_t y = 0; y < *height; ++y)
        for (std::size_t x = 0; x < *width; ++x) {
            std::array<float, 4> pixel{0, 0, 0, 1};
            for (std::size_t c = 0; c < channels; ++c) {
                // The bottom row comes first.
                const std::size_t at = text.at() + (*height - 1 - y) * static_cast<std::size_t>(rowBytes) +
                                       (x * channels + c) * sizeof(float);
                pixel.at(c) =
                    factor * std::bit_cast<float>(*scale < 0 ? little32(file, at) : big32(file, at));
            }
            if (channels == 1) pixel[1] = pixel[2] = pixel[0];
            std::memcpy(image.data.data() + (y * *width + x) * sizeof pixel, pixel.data(), sizeof pixel);
        }
    return image;
}

}  // namespace glibra::image
