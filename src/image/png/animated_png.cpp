#include "image/png/animated_png.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "image/bytes.h"
#include "image/convert.h"
#include "image/difference.h"
#include "image/png/png_data.h"
#include "image/png/png_writer.h"

namespace glibra::image {
namespace {

constexpr int kPixel = 3;     // bytes
constexpr int kSmallest = 9;  // level: films are written once and loaded often

void putBig16(std::vector<std::byte>& to, std::uint32_t value) {
    to.push_back(static_cast<std::byte>(value >> 8U & 0xffU));
    to.push_back(static_cast<std::byte>(value & 0xffU));
}

}  // namespace

void AnimatedPng::add(const Image& frame) {
    Image next = withComponents(withType(frame, Component::u8), kPixel);
    if (frames_.empty()) {
        frames_.push_back({0, 0, 1, next});
    } else if (const Bounds bounds = differenceOf(last_, next); !bounds.isEmpty()) {
        frames_.push_back({bounds.left, bounds.top, 1, partOf(next, bounds)});
    } else {
        ++frames_.back().lasts;
    }
    last_ = std::move(next);
}

std::vector<std::byte> AnimatedPng::finish() const {
    if (frames_.empty()) return {};
    std::vector<std::byte> png;
    putPngHeader(png, frames_.front().part);
    std::vector<std::byte> content;
    putBig32(content, static_cast<std::uint32_t>(frames_.size()));
    putBig32(content, 0);  // plays for ever
    putPngChunk(png, "acTL", content);
    std::uint32_t sequence = 0;
    for (const Frame& each : frames_) {
        content.clear();
        putBig32(content, sequence++);
        putBig32(content, static_cast<std::uint32_t>(each.part.width));
        putBig32(content, static_cast<std::uint32_t>(each.part.height));
        putBig32(content, static_cast<std::uint32_t>(each.left));
        putBig32(content, static_cast<std::uint32_t>(each.top));
        constexpr double kMilliseconds = 1000, kLongest = 65'535;
        putBig16(content, static_cast<std::uint32_t>(std::clamp(
                              std::round(kMilliseconds * each.lasts / framesPerSecond_), 1.0, kLongest)));
        putBig16(content, static_cast<std::uint32_t>(kMilliseconds));
        content.insert(content.end(), 2, std::byte{0});  // what is there stays, and the part replaces it
        putPngChunk(png, "fcTL", content);
        const std::vector<std::byte> data = packPngData(each.part, kSmallest, 1);
        if (data.empty()) return {};
        if (&each == &frames_.front()) {
            putPngChunk(png, "IDAT", data);
            continue;
        }
        content.clear();
        putBig32(content, sequence++);
        content.insert(content.end(), data.begin(), data.end());
        putPngChunk(png, "fdAT", content);
    }
    putPngChunk(png, "IEND", {});
    return png;
}

}  // namespace glibra::image
