#include "image/texel_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {

void flipRows(TexelBlock& block) {
    const std::size_t rowBytes = static_cast<std::size_t>(block.width) *
                                 static_cast<std::size_t>(block.components) * bytesOf(block.type);
    const auto height = static_cast<std::size_t>(block.height);
    const std::size_t slices = block.data.size() / (rowBytes * height);
    for (std::size_t slice = 0; slice < slices; ++slice)
        for (std::size_t y = 0; y < height / 2; ++y) {
            std::byte* const first = block.data.data() + slice * height * rowBytes;
            std::swap_ranges(first + y * rowBytes, first + (y + 1) * rowBytes,
                             first + (height - 1 - y) * rowBytes);
        }
}

void decodeSrgb(TexelBlock& block) {
    Image image{block.width, block.height * block.depth * block.faces, block.components, block.type,
                std::move(block.data)};
    image = withType(image, Component::f32);
    const std::size_t count = image.data.size() / sizeof(float);
    const auto components = static_cast<std::size_t>(block.components);
    for (std::size_t i = 0; i < count; ++i) {
        if (components == 4 && i % 4 == 3) continue;
        const auto encoded = static_cast<double>(valueAt<float>(image.data.data(), i));
        const auto value =
            static_cast<float>(encoded <= .04045 ? encoded / 12.92 : std::pow((encoded + .055) / 1.055, 2.4));
        std::memcpy(image.data.data() + i * sizeof value, &value, sizeof value);
    }
    block.type = Component::f32;
    block.data = std::move(image.data);
}

}  // namespace glibra::image
