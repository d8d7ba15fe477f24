#pragma once
// What a picture, a texture or a buffer holds, as numbers.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glibra::render {

/// Texels in rows from bottom to top, like gl_FragCoord, and layers after one another; or the elements of a
/// buffer, one per column.
struct Content {
    std::string name;  ///< for messages: "window", "life", "glow.level(2)"
    int width = 0, height = 1, depth = 1;
    int components = 4;
    double step = 0;  ///< the distance of neighbouring values of a normalised format; 0: exact values
    std::vector<double> values;
    bool isCube = false;       ///< the layers are faces
    bool isOfDoubles = false;  ///< the values are doubles, not floats or integers

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(depth);
    }
    /// The components of an element, counted from 0.
    [[nodiscard]] std::span<const double> at(std::size_t index) const {
        return std::span(values).subspan(index * static_cast<std::size_t>(components),
                                         static_cast<std::size_t>(components));
    }
};

}  // namespace glibra::render
