#include "gpu/format/texels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace glibra::gpu {
namespace {

/// 1 of a whole number that stands for a fraction.
double unitOf(TexelType type) {
    switch (type) {
        case TexelType::u8:
            return 255;
        case TexelType::i8:
            return 127;
        case TexelType::u16:
            return 65535;
        case TexelType::i16:
            return 32767;
        case TexelType::u32:
            return 4294967295.0;
        case TexelType::i32:
            return 2147483647;
        default:
            return 1;
    }
}

template <class T>
double loaded(const std::byte* at) {
    T value;
    std::copy_n(at, sizeof value, reinterpret_cast<std::byte*>(&value));
    return static_cast<double>(value);
}

double load(const std::byte* at, TexelType type) {
    switch (type) {
        case TexelType::u8:
            return loaded<std::uint8_t>(at);
        case TexelType::i8:
            return loaded<std::int8_t>(at);
        case TexelType::u16:
            return loaded<std::uint16_t>(at);
        case TexelType::i16:
            return loaded<std::int16_t>(at);
        case TexelType::u32:
            return loaded<std::uint32_t>(at);
        case TexelType::i32:
            return loaded<std::int32_t>(at);
        default:
            return static_cast<double>(loaded<float>(at));
    }
}

template <class T>
void stored(double value, std::byte* at) {
    if constexpr (std::is_integral_v<T>)
        value = std::clamp(std::nearbyint(value), static_cast<double>(std::numeric_limits<T>::min()),
                           static_cast<double>(std::numeric_limits<T>::max()));
    const auto as = static_cast<T>(value);
    std::copy_n(reinterpret_cast<const std::byte*>(&as), sizeof as, at);
}

void store(double value, TexelType type, std::byte* at) {
    switch (type) {
        case TexelType::u8:
            return stored<std::uint8_t>(value, at);
        case TexelType::i8:
            return stored<std::int8_t>(value, at);
        case TexelType::u16:
            return stored<std::uint16_t>(value, at);
        case TexelType::i16:
            return stored<std::int16_t>(value, at);
        case TexelType::u32:
            return stored<std::uint32_t>(value, at);
        case TexelType::i32:
            return stored<std::int32_t>(value, at);
        default:
            return stored<float>(value, at);
    }
}

}  // namespace

TexelType typeOf(GLenum type) {
    for (const TexelType each :
         {TexelType::u8, TexelType::u16, TexelType::u32, TexelType::i8, TexelType::i16, TexelType::i32})
        if (glType(each) == type) return each;
    return TexelType::f32;
}

std::vector<std::byte> converted(std::span<const std::byte> texels, TexelLayout from, TexelLayout to,
                                 bool isNormalized) {
    const std::size_t in = bytesOf(from.type), out = bytesOf(to.type);
    const auto have = static_cast<std::size_t>(from.components),
               want = static_cast<std::size_t>(to.components);
    const std::size_t count = texels.size() / (in * have);
    std::vector<std::byte> result(count * out * want);
    const double scale = isNormalized ? unitOf(to.type) / unitOf(from.type) : 1;
    const double one = isNormalized ? unitOf(to.type) : 1;
    const bool isSame = from.type == to.type;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < want; ++c) {
            std::byte* const at = result.data() + (i * want + c) * out;
            const std::byte* const source = texels.data() + (i * have + c) * in;
            if (c >= have)
                store(c == 3 ? one : 0, to.type, at);
            else if (isSame)
                std::copy_n(source, in, at);
            else
                store(load(source, from.type) * scale, to.type, at);
        }
    return result;
}

std::vector<std::byte> forEs(std::span<const std::byte> texels, TexelLayout layout, TexelFormat format) {
    const base::TexelFormatRow& row = base::rowOf(format);
    const Transfer transfer = nativeTransfer(format);
    const bool isFraction = !isInteger(format);
    if (format == TexelFormat::rgb10_a2) {
        const std::vector<std::byte> floats = converted(texels, layout, {4, TexelType::f32}, true);
        std::vector<std::byte> result(floats.size() / 4);
        for (std::size_t i = 0; i < result.size() / 4; ++i) {
            const auto bits = [&](std::size_t c, double most) {
                const double value =
                    std::clamp(load(floats.data() + (i * 4 + c) * 4, TexelType::f32), 0.0, 1.0);
                return static_cast<std::uint32_t>(std::nearbyint(value * most));
            };
            const std::uint32_t packed =
                bits(0, 1023) | bits(1, 1023) << 10U | bits(2, 1023) << 20U | bits(3, 3) << 30U;
            std::copy_n(reinterpret_cast<const std::byte*>(&packed), 4, result.data() + i * 4);
        }
        return result;
    }
    return converted(texels, layout, {hasDepth(format) ? 1 : row.components, typeOf(transfer.type)},
                     isFraction);
}

}  // namespace glibra::gpu
