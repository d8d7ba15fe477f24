#include "image/bmp/bmp_run_lengths.h"

#include <algorithm>

namespace glibra::image {
namespace {

/// The place of the next pixel; rows are counted in the order of the file.
class Canvas {
  public:
    Canvas(const RunLengthLayout& layout, std::span<const BmpPixel> colors, std::span<BmpPixel> pixels)
        : layout_(layout), colors_(colors), pixels_(pixels) {}

    void put(std::uint32_t index) {
        if (x_ < layout_.width && y_ < layout_.height) {
            const std::uint64_t row = layout_.topDown ? y_ : layout_.height - 1 - y_;
            pixels_[row * layout_.width + x_] = colors_[index];
        }
        ++x_;
    }
    void endRow() {
        x_ = 0;
        ++y_;
    }
    void skip(std::uint32_t right, std::uint32_t rows) {
        x_ += right;
        y_ += rows;
    }
    [[nodiscard]] bool full() const {
        return y_ >= layout_.height || (y_ + 1 == layout_.height && x_ >= layout_.width);
    }
    [[nodiscard]] std::uint64_t row() const { return y_; }

  private:
    RunLengthLayout layout_;
    std::span<const BmpPixel> colors_;
    std::span<BmpPixel> pixels_;
    std::uint64_t x_ = 0, y_ = 0;
};

}  // namespace

std::uint64_t decodeRunLengths(std::span<const std::byte> data, const RunLengthLayout& layout,
                               std::span<const BmpPixel> colors, std::span<BmpPixel> pixels) {
    std::fill(pixels.begin(), pixels.end(), colors[0]);
    Canvas canvas(layout, colors, pixels);
    const auto byteAt = [&](std::size_t at) { return std::to_integer<std::uint32_t>(data[at]); };
    // Pixel i of a run (`from` points at its only byte) or of literal pixels (`from` points at their first
    // byte).
    const auto index = [&](std::size_t from, std::uint32_t i, bool literal) {
        if (layout.bits == 8) return byteAt(from + (literal ? i : 0));
        return byteAt(from + (literal ? i / 2 : 0)) >> (i % 2 == 0 ? 4U : 0U) & 15U;
    };

    std::size_t at = 0;
    while (at + 2 <= data.size() && canvas.row() < layout.height) {
        const std::uint32_t count = byteAt(at), command = byteAt(at + 1);
        at += 2;
        if (count > 0) {
            for (std::uint32_t i = 0; i < count; ++i) canvas.put(index(at - 1, i, false));
        } else if (command == 0) {
            canvas.endRow();
        } else if (command == 1) {
            return layout.height;
        } else if (command == 2) {
            if (at + 2 > data.size()) break;
            canvas.skip(byteAt(at), byteAt(at + 1));
            at += 2;
        } else {
            const std::size_t bytes = layout.bits == 8 ? command : (command + 1) / 2;
            if (at + bytes > data.size()) break;
            for (std::uint32_t i = 0; i < command; ++i) canvas.put(index(at, i, true));
            at += bytes + bytes % 2;
        }
    }
    return canvas.full() ? layout.height : canvas.row();
}

}  // namespace glibra::image
