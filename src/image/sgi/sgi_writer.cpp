#include "image/sgi/sgi_writer.h"

#include <cstdint>

#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

constexpr std::size_t kHeaderBytes = 512;

/// Two numbers of 16 bits.
std::uint32_t pair(std::uint32_t first, std::uint32_t second) {
    return first << 16U | second;
}

/// What the header does not set, such as the name of the picture, is 0.
std::vector<std::byte> sgiHeader(const Image& image) {
    constexpr std::uint32_t kMagic = 0x01da, kDimensions = 3;
    const auto bytes = static_cast<std::uint32_t>(bytesOf(image.type));
    const auto width = static_cast<std::uint32_t>(image.width);
    const auto height = static_cast<std::uint32_t>(image.height);
    const auto channels = static_cast<std::uint32_t>(image.components);
    const std::uint32_t least = 0, largest = bytes == 1 ? 0xff : 0xffff;
    std::vector<std::byte> header;
    for (const std::uint32_t each :
         {pair(kMagic, bytes), pair(kDimensions, width), pair(height, channels), least, largest})
        putBig32(header, each);
    header.resize(kHeaderBytes);
    return header;
}

/// The channels one after the other, each from the bottom row to the top one, big-endian.
template <class Value>
void putChannels(const Image& image, std::vector<std::byte>& file) {
    const auto components = static_cast<std::size_t>(image.components);
    for (std::size_t channel = 0; channel < components; ++channel)
        for (int y = image.height; y-- > 0;) {
            const std::byte* const row = image.row(y).data();
            for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
                const auto value = valueAt<Value>(row, components * x + channel);
                if constexpr (sizeof value == 2) file.push_back(static_cast<std::byte>(value >> 8U));
                file.push_back(static_cast<std::byte>(value));
            }
        }
}

}  // namespace

std::vector<std::byte> encodeSgi(const Image& image) {
    const Image whole = withComponents(image, image.components % 2 == 0 ? 4 : 3);
    const Image source = image.type == Component::f32 ? withType(whole, Component::u16) : whole;
    std::vector<std::byte> file = sgiHeader(source);
    file.reserve(kHeaderBytes + source.data.size());
    if (source.type == Component::u8)
        putChannels<std::uint8_t>(source, file);
    else
        putChannels<std::uint16_t>(source, file);
    return file;
}

}  // namespace glibra::image
