#include "image/gif/gif_palette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

namespace glibra::image {
namespace {

constexpr std::size_t kLargestPalette = 256;

using Rgb = std::array<std::uint8_t, 3>;

Rgb rgbAt(const Image& rgb, std::size_t pixel) {
    return {std::to_integer<std::uint8_t>(rgb.data[3 * pixel]),
            std::to_integer<std::uint8_t>(rgb.data[3 * pixel + 1]),
            std::to_integer<std::uint8_t>(rgb.data[3 * pixel + 2])};
}

std::uint32_t rgbKey(const Rgb& color) {
    return color[0] | std::uint32_t{color[1]} << 8U | std::uint32_t{color[2]} << 16U;
}

/// The picture with its own colours; nothing if these are more than 256.
std::optional<Indexed> exactly(const Image& rgb) {
    Indexed made;
    std::unordered_map<std::uint32_t, std::uint8_t> known;
    const std::size_t count = rgb.data.size() / 3;
    made.pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Rgb color = rgbAt(rgb, i);
        const auto [place, isNew] =
            known.try_emplace(rgbKey(color), static_cast<std::uint8_t>(made.palette.size()));
        if (isNew) {
            if (made.palette.size() == kLargestPalette) return std::nullopt;
            made.palette.push_back(color);
        }
        made.pixels.push_back(place->second);
    }
    return made;
}

/// The pixels whose colours agree in their upper five bits.
struct Bin {
    double weight = 0;
    std::array<double, 3> sum{}, squares{};

    void add(const Bin& other) {
        weight += other.weight;
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] += other.sum[c];
            squares[c] += other.squares[c];
        }
    }
    [[nodiscard]] double mean(std::size_t c) const { return sum[c] / weight; }
    /// The sum of the squared distances from the mean.
    [[nodiscard]] double spread(std::size_t c) const { return squares[c] - sum[c] * sum[c] / weight; }
};

constexpr unsigned kBinBits = 5;

std::size_t binOf(const Rgb& color) {
    return std::size_t{color[0]} >> (8 - kBinBits) << (2 * kBinBits) |
           std::size_t{color[1]} >> (8 - kBinBits) << kBinBits | std::size_t{color[2]} >> (8 - kBinBits);
}

struct Box {
    std::size_t begin = 0, end = 0;  ///< of the bins
    Bin all;
    std::size_t axis = 0;  ///< with the largest spread
    double spread = 0;
};

Box boxOf(const std::vector<Bin>& bins, std::size_t begin, std::size_t end) {
    Box box{begin, end, {}, 0, 0};
    for (std::size_t i = begin; i < end; ++i) box.all.add(bins[i]);
    for (std::size_t c = 0; c < 3; ++c)
        if (const double spread = box.all.spread(c); spread > box.spread) {
            box.spread = spread;
            box.axis = c;
        }
    if (end - begin < 2) box.spread = 0;  // it cannot be cut
    return box;
}

/// Cuts the box with the largest spread at its mean, until there are enough.
std::vector<Rgb> medianCut(const Image& rgb) {
    std::vector<Bin> all(std::size_t{1} << (3 * kBinBits));
    for (std::size_t i = 0; i < rgb.data.size() / 3; ++i) {
        const Rgb color = rgbAt(rgb, i);
        Bin& bin = all[binOf(color)];
        ++bin.weight;
        for (std::size_t c = 0; c < 3; ++c) {
            bin.sum[c] += color[c];
            bin.squares[c] += double{1} * color[c] * color[c];
        }
    }
    std::erase_if(all, [](const Bin& each) { return each.weight == 0; });
    std::vector<Box> boxes{boxOf(all, 0, all.size())};
    while (boxes.size() < kLargestPalette) {
        const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                             [](const Box& a, const Box& b) { return a.spread < b.spread; });
        if (widest->spread <= 0) break;
        const std::size_t axis = widest->axis;
        const double middle = widest->all.mean(axis);
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(widest->begin);
        const auto end = all.begin() + static_cast<std::ptrdiff_t>(widest->end);
        auto cut = std::partition(begin, end, [&](const Bin& each) { return each.mean(axis) < middle; });
        if (cut == begin || cut == end) cut = begin + 1;  // equal means, up to rounding
        const auto at = static_cast<std::size_t>(cut - all.begin());
        const Box low = boxOf(all, widest->begin, at), high = boxOf(all, at, widest->end);
        *widest = low;
        boxes.push_back(high);
    }
    std::vector<Rgb> palette;
    for (const Box& each : boxes) {
        Rgb& color = palette.emplace_back();
        for (std::size_t c = 0; c < 3; ++c)
            color[c] = static_cast<std::uint8_t>(std::lround(each.all.mean(c)));
    }
    return palette;
}

class Nearest {
  public:
    explicit Nearest(const std::vector<Rgb>& palette) : palette_(palette) {}

    /// The index of the nearest colour; colours that agree in six bits each are taken as one.
    std::uint8_t operator()(const Rgb& color) {
        int& known = known_[std::size_t{color[0]} >> 2U << 12U | std::size_t{color[1]} >> 2U << 6U |
                            std::size_t{color[2]} >> 2U];
        if (known >= 0) return static_cast<std::uint8_t>(known);
        int least = std::numeric_limits<int>::max();
        for (std::size_t i = 0; i < palette_.size(); ++i) {
            int distance = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const int apart = int{palette_[i][c]} - int{color[c]};
                distance += apart * apart;
            }
            if (distance >= least) continue;
            least = distance;
            known = static_cast<int>(i);
        }
        return static_cast<std::uint8_t>(known);
    }

  private:
    const std::vector<Rgb>& palette_;
    std::vector<int> known_ = std::vector<int>(std::size_t{1} << 18U, -1);
};

void diffuse(const Image& rgb, Indexed& made) {
    const auto width = static_cast<std::size_t>(rgb.width);
    Nearest nearest(made.palette);
    // The errors of a row and of the next one, in sixteenths, with a pixel more at each end.
    std::vector<std::array<int, 3>> here(width + 2), below(width + 2);
    made.pixels.reserve(width * static_cast<std::size_t>(rgb.height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(rgb.height); ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            Rgb wanted = rgbAt(rgb, y * width + x);
            std::array<int, 3> exact{};
            for (std::size_t c = 0; c < 3; ++c) {
                exact[c] = std::clamp(wanted[c] + here[x + 1][c] / 16, 0, 255);
                wanted[c] = static_cast<std::uint8_t>(exact[c]);
            }
            const std::uint8_t index = nearest(wanted);
            made.pixels.push_back(index);
            for (std::size_t c = 0; c < 3; ++c) {
                const int error = exact[c] - made.palette[index][c];
                here[x + 2][c] += 7 * error;
                below[x][c] += 3 * error;
                below[x + 1][c] += 5 * error;
                below[x + 2][c] += error;
            }
        }
        here.swap(below);
        std::fill(below.begin(), below.end(), std::array<int, 3>{});
    }
}

}  // namespace

Indexed indexed(const Image& rgb) {
    if (std::optional<Indexed> made = exactly(rgb)) return *std::move(made);
    Indexed made{medianCut(rgb), {}};
    diffuse(rgb, made);
    return made;
}

}  // namespace glibra::image
