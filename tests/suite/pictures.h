#pragma once
// Small pictures with known pixels, and a shot that shows one.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/png/png_writer.h"
#include "suite/run/verdict.h"
#include "suite/suite.h"

namespace glibra::suite {

/// An 8-bit RGB picture of `value(x, y, component)`.
inline image::Image picture(int width, int height, const std::function<int(int, int, int)>& value) {
    image::Image image{width, height, 3, image::Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.data.push_back(static_cast<std::byte>(value(x, y, c)));
    return image;
}

/// A gradient of 32 x 32 pixels, brighter by `more`.
inline image::Image gradient(int more = 0) {
    return picture(32, 32, [more](int x, int y, int c) { return 4 * x + 2 * y + 10 * c + more; });
}

inline image::Image oneColor(int value) {
    return picture(32, 32, [value](int, int, int) { return value; });
}

/// The bytes of a PNG picture, different for each value.
inline std::string png(int value) {
    const std::vector<std::byte> bytes = image::encodePng(oneColor(value));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A 32-bit float RGB picture of one colour, except for one pixel.
inline image::Image floats(float most, float one) {
    image::Image image{8, 8, 3, image::Component::f32, {}};
    std::vector<float> values(192, most);
    values[100] = one;
    const auto bytes = std::as_bytes(std::span(values));
    image.data.assign(bytes.begin(), bytes.end());
    return image;
}

inline Shot shotNamed(const std::string& name) {
    Shot shot;
    shot.name = name;
    shot.script = name + ".glib";
    return shot;
}

inline Attempt attemptAt(const Shot& shot, const image::Image& image) {
    Attempt attempt;
    attempt.shot = &shot;
    attempt.own.picture = image;
    return attempt;
}

}  // namespace glibra::suite
