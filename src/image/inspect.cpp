#include "image/inspect.h"

#include <cmath>
#include <cstring>

#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {

bool isOneColor(const Image& image) {
    const std::size_t pixel = static_cast<std::size_t>(image.components) * bytesOf(image.type);
    // All pixels are equal if and only if each byte equals the byte one pixel later.
    return image.data.size() <= pixel ||
           std::memcmp(image.data.data(), image.data.data() + pixel, image.data.size() - pixel) == 0;
}

NonFinite countNonFinite(const Image& image) {
    NonFinite found;
    if (image.type != Component::f32 || !isConsistent(image)) return found;
    const std::size_t rowValues = image.rowBytes() / sizeof(float);
    for (int y = 0; y < image.height; ++y) {
        const std::byte* row = image.row(y).data();
        for (std::size_t i = 0; i < rowValues; ++i) {
            const auto value = valueAt<float>(row, i);
            if (std::isfinite(value)) continue;
            if (found.nan + found.infinite == 0) {
                found.x = static_cast<int>(i / static_cast<std::size_t>(image.components));
                found.y = y;
            }
            ++(std::isnan(value) ? found.nan : found.infinite);
        }
    }
    return found;
}

}  // namespace glibra::image
