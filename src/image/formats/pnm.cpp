// The pictures of Netpbm (pbm(5), pgm(5), ppm(5)), and PFM (P. Debevec, "PFM Portable FloatMap Image
// Format"), which glibra writes in every build. OpenImageIO 2.4 refuses plain bitmaps whose digits have no
// blanks between them, and cuts where 16 bits are to be rounded. stb_image 2.28 reads neither plain files nor
// bitmaps, and takes every maximum for 255 or 65535.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "image/bytes.h"
#include "image/formats/readers.h"
#include "image/image.h"

namespace glibra::image {
namespace {

constexpr const char *kHeaderEnds = "its header is damaged or ends early",
                     *kNoPixels = "the picture has no pixels by its header";

/// The text part of a file: numbers between blanks and comments, which go from # to the end of the line.
class PnmText {
  public:
    explicit PnmText(ByteSpan file) : text_(charactersOf(file)) {}

    [[nodiscard]] std::size_t at() const { return at_; }
    /// A number without sign, or a real one; nothing if there is none that fits into the type.
    template <class Number>
    std::optional<Number> number() {
        skipBlanks();
        Number value{};
        const char* const begin = text_.data() + at_;
        const auto [after, failure] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (failure != std::errc()) return std::nullopt;
        at_ += static_cast<std::size_t>(after - begin);
        return value;
    }
    /// 0 or 1, which need no blank between them.
    std::optional<std::uint32_t> digit() {
        if (atEnd() || (text_[at_] != '0' && text_[at_] != '1')) return std::nullopt;
        return static_cast<std::uint32_t>(text_[at_++] - '0');
    }
    /// The one blank before binary pixels, which may be the end of a comment. False if it is missing.
    bool endHeader() {
        const bool isComment = text_.substr(at_, 1) == "#";
        if (isComment) at_ = std::min(text_.find_first_of("\r\n", at_), text_.size() - 1);
        return at_ < text_.size() && (isBlank(text_[at_++]) || isComment);
    }
    bool atEnd() { return skipBlanks(), at_ >= text_.size(); }

  private:
    static bool isBlank(char each) { return each == ' ' || (each >= '\t' && each <= '\r'); }
    void skipBlanks() {
        for (; at_ < text_.size() && (text_[at_] == '#' || isBlank(text_[at_])); ++at_)
            if (text_[at_] == '#') at_ = std::min(text_.find_first_of("\r\n", at_), text_.size() - 1);
    }

    std::string_view text_;
    std::size_t at_ = 2;  // after the magic number
};

}  // namespace

Result<Image> decodePnm(ByteSpan file, const FileLabel& label, const Limits& limits) {
    PnmText text(file);
    const unsigned kind = octetAt(file, 1) - unsigned{'0'};
    const bool isPlain = kind <= 3, isBitmap = kind % 3 == 1;
    const std::size_t channels = kind % 3 == 0 ? 3 : 1;
    const auto width = text.number<std::uint32_t>(), height = text.number<std::uint32_t>();
    const auto most = isBitmap ? std::optional<std::uint32_t>(1) : text.number<std::uint32_t>();
    if (!width || !height || !most || (!isPlain && !text.endHeader())) return damaged(label, kHeaderEnds);
    if (*width == 0 || *height == 0) return damaged(label, kNoPixels);
    if (*most < 1 || *most > 65535)
        return damaged(label, fmt::format("the largest value is {}, expected 1 to 65535", *most));
    const std::size_t bytes = *most > 255 ? 2 : 1;  // of a component
    if (auto tooLarge = checkSize(*width, *height, 4 * bytes, limits, label)) return *std::move(tooLarge);
    // What the samples of a row take; for a plain file at least, whose last number needs no blank after it.
    const std::uint64_t samples = std::uint64_t{*width} * channels;
    const std::uint64_t rowBytes = kind == 4              ? (samples + 7) / 8
                                   : isPlain && !isBitmap ? 2 * samples
                                                          : samples * bytes;
    const std::size_t begin = text.at();
    const std::uint64_t have = file.size() - begin + (isPlain && !isBitmap ? 1 : 0);
    if (have / rowBytes < *height) return endsEarly(label, have / rowBytes, *height);

    const auto sampleOf = [&](std::size_t y, std::size_t i) -> std::optional<std::uint32_t> {
        const std::size_t row = begin + y * static_cast<std::size_t>(rowBytes);
        if (isPlain) return isBitmap ? text.digit() : text.number<std::uint32_t>();
        if (isBitmap) return octetAt(file, row + i / 8) >> (7 - i % 8) & 1U;
        return bytes == 2 ? big16(file, row + 2 * i) : octetAt(file, row + i);
    };
    Image image = blankImage(*width, *height, bytes == 2 ? Component::u16 : Component::u8);
    const std::uint16_t full = bytes == 2 ? 65535 : 255;
    std::byte* to = image.data.data();
    for (std::size_t y = 0; y < *height; ++y)
        for (std::size_t x = 0; x < *width; ++x, to += 4 * bytes) {
            std::array<std::uint16_t, 4> pixel{0, 0, 0, full};
            for (std::size_t c = 0; c < channels; ++c) {
                const auto sample = sampleOf(y, x * channels + c);
                if (!sample && text.atEnd()) return endsEarly(label, y, *height);
                if (!sample)
                    return damaged(label, fmt::format("row {} has something that is no number", y + 1));
                if (*sample > *most)
                    return damaged(label, fmt::format("row {} has the value {}, but the largest is {}", y + 1,
                                                      *sample, *most));
                const std::uint32_t value = isBitmap ? 1 - *sample : *sample;  // 1 is black
                pixel.at(c) = static_cast<std::uint16_t>((std::uint64_t{value} * full + *most / 2) / *most);
            }
            if (channels == 1) pixel[1] = pixel[2] = pixel[0];
            if (bytes == 2) std::memcpy(to, pixel.data(), sizeof pixel);
            for (std::size_t c = 0; bytes == 1 && c < 4; ++c) to[c] = static_cast<std::byte>(pixel.at(c));
        }
    return image;
}

Result<Image> decodePfm(ByteSpan file, const FileLabel& label, const Limits& limits) {
    PnmText text(file);
    const std::size_t channels = octetAt(file, 1) == 'F' ? 3 : 1;
    const auto width = text.number<std::uint32_t>(), height = text.number<std::uint32_t>();
    const auto scale = text.number<double>();
    if (!width || !height || !scale || !std::isfinite(*scale) || *scale == 0 || !text.endHeader())
        return damaged(label, kHeaderEnds);
    if (*width == 0 || *height == 0) return damaged(label, kNoPixels);
    if (auto tooLarge = checkSize(*width, *height, 4 * sizeof(float), limits, label))
        return *std::move(tooLarge);
    const std::uint64_t rowBytes = std::uint64_t{*width} * channels * sizeof(float);
    if ((file.size() - text.at()) / rowBytes < *height)
        return endsEarly(label, (file.size() - text.at()) / rowBytes, *height);

    Image image = blankImage(*width, *height, Component::f32);
    const auto factor = static_cast<float>(std::abs(*scale));
    std::size_t at = text.at();
    for (std::size_t y = *height; y-- > 0;)  // the bottom row comes first
        for (std::size_t x = 0; x < *width; ++x) {
            std::array<float, 4> pixel{0, 0, 0, 1};
            for (std::size_t c = 0; c < channels; ++c, at += sizeof(float))
                pixel.at(c) =
                    factor * std::bit_cast<float>(*scale < 0 ? little32(file, at) : big32(file, at));
            if (channels == 1) pixel[1] = pixel[2] = pixel[0];
            std::memcpy(image.data.data() + (y * *width + x) * sizeof pixel, pixel.data(), sizeof pixel);
        }
    return image;
}

}  // namespace glibra::image
