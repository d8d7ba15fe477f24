#include "budget/contour_shift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace glibra::budget {
namespace {

constexpr std::size_t kSide = 16;
constexpr float kSmooth = 64.F / 255;

/// The components of a picture in 0..1; NaN is 0.
class Values {
  public:
    explicit Values(const image::Image& picture)
        : width_(static_cast<std::size_t>(picture.width)),
          height_(static_cast<std::size_t>(picture.height)),
          components_(static_cast<std::size_t>(picture.components)),
          values_(picture.data.size() / image::bytesOf(picture.type)) {
        if (picture.type == image::Component::u8)
            std::ranges::transform(picture.data, values_.begin(), [](std::byte each) {
                return static_cast<float>(std::to_integer<int>(each)) / 255.F;
            });
        else
            std::memcpy(values_.data(), picture.data.data(), values_.size() * sizeof(float));
        for (float& each : values_) each = each > 0 ? std::min(each, 1.F) : 0.F;
    }
    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t height() const { return height_; }
    [[nodiscard]] float at(std::size_t x, std::size_t y, std::size_t component) const {
        return values_[(y * width_ + x) * components_ + component];
    }
    [[nodiscard]] float gradient(std::size_t x, std::size_t y, std::size_t component) const {
        const std::size_t left = x > 0 ? x - 1 : x, right = std::min(x + 1, width_ - 1);
        const std::size_t above = y > 0 ? y - 1 : y, below = std::min(y + 1, height_ - 1);
        const auto slope = [](float difference, std::size_t steps) {
            return steps > 0 ? difference / static_cast<float>(steps) : 0.F;
        };
        return std::hypot(slope(at(right, y, component) - at(left, y, component), right - left),
                          slope(at(x, below, component) - at(x, above, component), below - above));
    }
    /// True if no component differs by more than `most` in the 3 x 3 pixels around.
    [[nodiscard]] bool isSmooth(std::size_t x, std::size_t y, float most) const {
        for (std::size_t component = 0; component < 3; ++component) {
            float low = 1, high = 0;
            for (std::size_t row = y > 0 ? y - 1 : y; row < std::min(y + 2, height_); ++row)
                for (std::size_t column = x > 0 ? x - 1 : x; column < std::min(x + 2, width_); ++column) {
                    low = std::min(low, at(column, row, component));
                    high = std::max(high, at(column, row, component));
                }
            if (high - low > most) return false;
        }
        return true;
    }

  private:
    std::size_t width_, height_, components_;
    std::vector<float> values_;
};

}  // namespace

ContourShifts::ContourShifts(const image::Image& from, const image::Image& to, double pixel) : pixel_(pixel) {
    add(from, to);
}

void ContourShifts::add(const image::Image& from, const image::Image& to) {
    const Values before(from), after(to);
    Compared& compared = moments_.emplace_back();
    compared.pixels = static_cast<double>(before.width() * before.height());
    for (std::size_t top = 0; top < before.height(); top += kSide)
        for (std::size_t left = 0; left < before.width(); left += kSide) {
            double changes = 0, gradients = 0, largest = 0;
            for (std::size_t y = top; y < std::min(top + kSide, before.height()); ++y)
                for (std::size_t x = left; x < std::min(left + kSide, before.width()); ++x) {
                    float here = 0, slope = 0;
                    for (std::size_t component = 0; component < 3; ++component) {
                        const float change = std::abs(after.at(x, y, component) - before.at(x, y, component));
                        here = std::max(here, change);
                        changes += static_cast<double>(change);
                        const float gradient = before.gradient(x, y, component);
                        slope = std::max(slope, gradient);
                        gradients += static_cast<double>(gradient);
                    }
                    largest = std::max(largest, static_cast<double>(here));
                    if (here > 0 && before.isSmooth(x, y, kSmooth) && after.isSmooth(x, y, kSmooth))
                        compared.smoothChanges.push_back({here, slope});
                }
            constexpr double kMost = kSide;  // larger shifts are not measured
            const double shift = changes < kMost * gradients ? changes / gradients : kMost;
            if (largest > 0) compared.squares.push_back({pixel_ * shift, largest});
        }
}

double ContourShifts::ofChangesAbove(double change) const {
    double largest = 0;
    for (const Compared& moment : moments_) {
        std::vector<double> shifts;
        for (const Square& each : moment.squares)
            if (each.largestChange > change) shifts.push_back(each.shift);
        if (shifts.empty()) continue;
        const auto rank = shifts.begin() + static_cast<std::ptrdiff_t>((shifts.size() - 1) * 98 / 100);
        std::nth_element(shifts.begin(), rank, shifts.end());
        largest = std::max(largest, *rank);
    }
    return largest;
}

double ContourShifts::shareOfSmoothChangesAbove(double change, double shift) const {
    double largest = 0;
    for (const Compared& moment : moments_) {
        const auto count = std::ranges::count_if(moment.smoothChanges, [&](const SmoothChange& each) {
            return static_cast<double>(each.change) >
                   change + static_cast<double>(each.gradient) * shift / pixel_;
        });
        largest = std::max(largest, static_cast<double>(count) / moment.pixels);
    }
    return largest;
}

}  // namespace glibra::budget
