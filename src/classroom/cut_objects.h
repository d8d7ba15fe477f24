#pragma once
// Cuts what a picture shows out of its background, so that it can be compared wherever it stands.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "image/image.h"

namespace glibra::classroom {

using Color = std::array<float, 3>;

inline constexpr int kSide = 128;  // pixels of the longer side of what is compared

/// Colours, row by row, top row first.
struct Colors {
    int width = 0, height = 0;
    std::vector<Color> at;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] const Color& pixel(int x, int y) const { return at[index(x, y)]; }
};

/// Values are limited to 0..1; grey is three equal components.
Colors colorsOf(const image::Image& image);

/// The largest difference of a component.
float colorDistance(const Color& a, const Color& b);

/// The most frequent colour of the pixels at the border.
Color backgroundOf(const Colors& colors);

/// A picture in one scale: its colours, and which pixels belong to the objects (0 to 1).
struct Scale {
    int side = 0;
    std::vector<Color> colors;
    std::vector<float> inside;
    std::vector<float> edges{};   ///< strength of the edge at each pixel, 0 outside of the objects
    std::vector<float> angles{};  ///< direction of the change, 0 to pi
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
    }
};

/// What differs from the background.
struct Objects {
    Color background{};
    std::vector<char> isObject;                    ///< of each pixel
    int left = 0, top = 0, right = 0, bottom = 0;  ///< the pixels at the ends
    /// Of the box around them, in pixels: the detail that the picture can have of them.
    [[nodiscard]] int longerSide() const { return std::max(right - left, bottom - top) + 1; }
};

/// The objects of a picture; nothing if there are none.
std::optional<Objects> findObjects(const Colors& colors);

/// The part of the objects to look at more closely: in a square of half the longer side, where that shows
/// most of them; of equal places the one nearest to the middle.
Objects closer(const Colors& colors, const Objects& objects);

/// The objects, cut out and scaled so that their longer side is kSide, with no more detail than `detail`
/// pixels on that side would have.
Scale cutOut(const Colors& colors, const Objects& objects, int detail);

}  // namespace glibra::classroom
