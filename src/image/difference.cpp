#include "image/difference.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace glibra::image {
namespace {

constexpr int kRgb = 3;  // bytes

}  // namespace

Bounds differenceOf(const Image& a, const Image& b) {
    Bounds bounds{a.width, a.height, 0, 0};
    for (int y = 0; y < a.height; ++y) {
        const std::span<const std::byte> rowA = a.row(y), rowB = b.row(y);
        if (std::memcmp(rowA.data(), rowB.data(), rowA.size()) == 0) continue;
        const auto first = std::mismatch(rowA.begin(), rowA.end(), rowB.begin()).first - rowA.begin();
        const auto last = rowA.rend() - std::mismatch(rowA.rbegin(), rowA.rend(), rowB.rbegin()).first;
        bounds.left = std::min(bounds.left, static_cast<int>(first) / kRgb);
        bounds.right = std::max(bounds.right, (static_cast<int>(last) + kRgb - 1) / kRgb);
        bounds.top = std::min(bounds.top, y);
        bounds.bottom = y + 1;
    }
    return bounds;
}

Image partOf(const Image& image, const Bounds& bounds) {
    Image part{bounds.right - bounds.left, bounds.bottom - bounds.top, kRgb, Component::u8, {}};
    part.data.reserve(part.rowBytes() * static_cast<std::size_t>(part.height));
    for (int y = bounds.top; y < bounds.bottom; ++y) {
        const std::span<const std::byte> row =
            image.row(y).subspan(static_cast<std::size_t>(bounds.left) * kRgb, part.rowBytes());
        part.data.insert(part.data.end(), row.begin(), row.end());
    }
    return part;
}

}  // namespace glibra::image
