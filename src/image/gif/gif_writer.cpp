#include "image/gif/gif_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "image/convert.h"
#include "image/difference.h"
#include "image/gif/gif_palette.h"

namespace glibra::image {
namespace {

constexpr int kRgbComponents = 3;
constexpr long long kShortestFrame = 2;  // hundredths of a second

void putGifText(std::vector<std::byte>& to, std::string_view text) {
    for (const char each : text) to.push_back(static_cast<std::byte>(each));
}

void putLittle16(std::vector<std::byte>& to, unsigned value) {
    to.push_back(static_cast<std::byte>(value & 0xffU));
    to.push_back(static_cast<std::byte>(value >> 8U & 0xffU));
}

/// The codes of the pixels (GIF89a, appendix F), in blocks of up to 255 bytes.
class CodeWriter {
  public:
    CodeWriter(std::vector<std::byte>& to, unsigned bits) : to_(to), bits_(bits) {
        to_.push_back(static_cast<std::byte>(bits));
        clear();
    }

    void add(std::uint8_t pixel) {
        if (prefix_ < 0) {
            prefix_ = pixel;
            return;
        }
        std::uint16_t& next = next_[static_cast<std::size_t>(prefix_) << 8U | pixel];
        if (next != 0) {
            prefix_ = next;
            return;
        }
        put(static_cast<unsigned>(prefix_));
        prefix_ = pixel;
        if (free_ == kMostCodes) return clear();
        next = static_cast<std::uint16_t>(free_);
        if (free_++ == 1U << width_) ++width_;
    }

    void finish() {
        if (prefix_ >= 0) put(static_cast<unsigned>(prefix_));
        // A decoder has as many codes now: it adds one for each that it reads, except for the first.
        if (free_ == 1U << width_ && free_ < kMostCodes) ++width_;
        put((1U << bits_) + 1);
        if (filled_ > 0) block_.push_back(static_cast<std::byte>(buffer_ & 0xffU));
        endBlock();
        to_.push_back(std::byte{0});
    }

  private:
    static constexpr unsigned kMostCodes = 4096;

    void clear() {
        std::fill(next_.begin(), next_.end(), std::uint16_t{0});
        free_ = (1U << bits_) + 2;
        if (width_ == 0) width_ = bits_ + 1;
        put(1U << bits_);
        width_ = bits_ + 1;
    }
    void put(unsigned code) {
        buffer_ |= code << filled_;
        filled_ += width_;
        for (; filled_ >= 8; filled_ -= 8, buffer_ >>= 8U) {
            block_.push_back(static_cast<std::byte>(buffer_ & 0xffU));
            constexpr std::size_t kLongest = 255;
            if (block_.size() == kLongest) endBlock();
        }
    }
    void endBlock() {
        if (block_.empty()) return;
        to_.push_back(static_cast<std::byte>(block_.size()));
        to_.insert(to_.end(), block_.begin(), block_.end());
        block_.clear();
    }

    std::vector<std::byte>& to_;
    const unsigned bits_;  ///< of a pixel
    /// By a code and the pixel after it: the code of both; 0: none.
    std::vector<std::uint16_t> next_ = std::vector<std::uint16_t>(std::size_t{kMostCodes} << 8U);
    std::vector<std::byte> block_;
    std::uint32_t buffer_ = 0;
    unsigned filled_ = 0;  ///< bits of the buffer
    unsigned width_ = 0;   ///< bits of a code
    unsigned free_ = 0;    ///< the next code
    int prefix_ = -1;      ///< the code of the pixels that are not written yet
};

/// A frame: its delay, place and pixels. Returns where the delay stands.
std::size_t putFrame(std::vector<std::byte>& to, const Image& part, int left, int top) {
    constexpr std::string_view kControl("\x21\xf9\x04\x04", 4);  // what is there stays
    putGifText(to, kControl);
    const std::size_t delayAt = to.size();
    putLittle16(to, 0);
    to.insert(to.end(), 2, std::byte{0});
    const Indexed made = indexed(part);
    const auto colors = std::max<std::size_t>(2, std::bit_ceil(made.palette.size()));
    const auto bits = static_cast<unsigned>(std::countr_zero(colors));
    to.push_back(std::byte{0x2c});
    for (const int each : {left, top, part.width, part.height}) putLittle16(to, static_cast<unsigned>(each));
    to.push_back(static_cast<std::byte>(0x80U | (bits - 1)));
    for (std::size_t i = 0; i < colors; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            to.push_back(i < made.palette.size() ? static_cast<std::byte>(made.palette[i][c]) : std::byte{0});
    CodeWriter codes(to, std::max(2U, bits));
    for (const std::uint8_t each : made.pixels) codes.add(each);
    codes.finish();
    return delayAt;
}

}  // namespace

long long AnimatedGif::hundredthsAt(long long frame) const {
    constexpr double kHundredths = 100, kLongest = 1e15;
    return std::llround(
        std::min(kLongest, kHundredths * static_cast<double>(frame) / std::max(1e-9, framesPerSecond_)));
}

/// The frame that is shown ends where the next one begins.
void AnimatedGif::endShown() {
    constexpr long long kLongest = 65'535;
    const auto delay =
        static_cast<unsigned>(std::clamp(hundredthsAt(added_) - shownSince_, kShortestFrame, kLongest));
    body_[delayAt_] = static_cast<std::byte>(delay & 0xffU);
    body_[delayAt_ + 1] = static_cast<std::byte>(delay >> 8U);
}

void AnimatedGif::add(const Image& frame) {
    const long long begin = hundredthsAt(added_);
    if (stored_ > 0 && begin - shownSince_ < kShortestFrame) {
        ++added_;
        return;
    }
    Image next = withComponents(withType(frame, Component::u8), kRgbComponents);
    const Bounds bounds = stored_ == 0 ? Bounds{0, 0, next.width, next.height} : differenceOf(last_, next);
    if (!bounds.isEmpty()) {
        if (stored_ > 0) endShown();
        delayAt_ = putFrame(body_, partOf(next, bounds), bounds.left, bounds.top);
        shownSince_ = begin;
        ++stored_;
    }
    ++added_;
    last_ = std::move(next);
}

std::vector<std::byte> AnimatedGif::finish() {
    if (stored_ == 0) return {};
    std::vector<std::byte> file;
    putGifText(file, "GIF89a");
    putLittle16(file, static_cast<unsigned>(last_.width));
    putLittle16(file, static_cast<unsigned>(last_.height));
    putGifText(file, std::string_view("\x70\0\0", 3));  // eight bits per colour, no palette for all
    if (added_ > 1) {
        endShown();
        putGifText(file, std::string_view("\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0\0", 19));  // for ever
    }
    file.insert(file.end(), body_.begin(), body_.end());
    file.push_back(std::byte{0x3b});
    return file;
}

std::vector<std::byte> encodeGif(const Image& image) {
    AnimatedGif file(1);
    file.add(image);
    return file.finish();
}

}  // namespace glibra::image
