#include "image/orientation.h"

#include <cstring>
#include <utility>

namespace glibra::image {

Image upright(Image image, unsigned orientation) {
    if (orientation < 2 || orientation > 8) return image;
    const bool swapsAxes = orientation >= 5;
    const bool fromRight = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool fromBottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    Image turned{image.width, image.height, image.components, image.type, {}};
    if (swapsAxes) std::swap(turned.width, turned.height);
    turned.data.resize(image.data.size());
    const std::size_t pixel = static_cast<std::size_t>(image.components) * bytesOf(image.type);
    const std::byte* from = image.data.data();
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column, from += pixel) {
            int x = swapsAxes ? row : column, y = swapsAxes ? column : row;
            if (fromRight) x = turned.width - 1 - x;
            if (fromBottom) y = turned.height - 1 - y;
            std::memcpy(turned.data.data() + static_cast<std::size_t>(y) * turned.rowBytes() +
                            static_cast<std::size_t>(x) * pixel,
                        from, pixel);
        }
    return turned;
}

}  // namespace glibra::image
