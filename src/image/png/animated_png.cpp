#include "image/png/animated_png.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "image/bytes.h"
#include "image/convert.h"
#include "image/png/png_data.h"
#include "image/png/png_writer.h"

namespace glibra::image {
namespace {

constexpr int kPixel = 3;     // bytes
constexpr int kSmallest = 9;  // level: films are written once and loaded often

struct Bounds {
    int left = 0, top = 0, right = 0, bottom = 0;  ///< the last two are outside
};

/// Where two pictures of one size differ; empty if they are equal.
Bounds differenceOf(const Image& a, const Image& b) {
    Bounds bounds{a.width, a.height, 0, 0};
    for (int y = 0; y < a.height; ++y) {
        const std::span<const std::byte> rowA = a.row(y), rowB = b.row(y);
        if (std::memcmp(rowA.data(), rowB.data(), rowA.size()) == 0) continue;
        const auto first = std::mismatch(rowA.begin(), rowA.end(), rowB.begin()).first - rowA.begin();
        const auto last = rowA.rend() - std::mismatch(rowA.rbegin(), rowA.rend(), rowB.rbegin()).first;
        bounds.left = std::min(bounds.left, static_cast<int>(first) / kPixel);
        bounds.right = std::max(bounds.right, (static_cast<int>(last) + kPixel - 1) / kPixel);
        bounds.top = std::min(bounds.top, y);
        bounds.bottom = y + 1;
    }
    return bounds;
}

Image partOf(const Image& image, const Bounds& bounds) {
    Image part{bounds.right - bounds.left, bounds.bottom - bounds.top, kPixel, Component::u8, {}};
    part.data.reserve(part.rowBytes() * static_cast<std::size_t>(part.height));
    for (int y = bounds.top; y < bounds.bottom; ++y) {
        const std::span<const std::byte> row =
            image.row(y).subspan(static_cast<std::size_t>(bounds.left) * kPixel, part.rowBytes());
        part.data.insert(part.data.end(), row.begin(), row.end());
    }
    return part;
}

void putBig16(std::vector<std::byte>& to, std::uint32_t value) {
    to.push_back(static_cast<std::byte>(value >> 8U & 0xffU));
    to.push_back(static_cast<std::byte>(value & 0xffU));
}

}  // namespace

void AnimatedPng::add(const Image& frame) {
    Image next = withComponents(withType(frame, Component::u8), kPixel);
    if (frames_.empty()) {
        frames_.push_back({0, 0, 1, next});
    } else if (const Bounds bounds = differenceOf(last_, next); bounds.right > 0) {
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
