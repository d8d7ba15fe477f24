#include "bench/draw/noise_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <span>

namespace glibra::bench {
namespace {

constexpr double kMostByte = 255, kMostShort = 65535;

struct FormatRow {
    std::string_view name;
    gpu::TexelFormat texels;
};
/// In the order of NoiseFormat.
constexpr std::array<FormatRow, 5> kFormatRows{{{"8 bit, cut off", gpu::TexelFormat::rgba8},
                                                {"8 bit, rounded", gpu::TexelFormat::rgba8},
                                                {"16 bit", gpu::TexelFormat::rgba16},
                                                {"half float", gpu::TexelFormat::rgba16f},
                                                {"float", gpu::TexelFormat::rgba32f}}};

const FormatRow& formatRow(NoiseFormat format) {
    return kFormatRows.at(static_cast<std::size_t>(format));
}

float kept(float value, NoiseFormat format) {
    switch (format) {
        case NoiseFormat::byteFloor:
            return static_cast<float>(std::floor(value * kMostByte) / kMostByte);
        case NoiseFormat::byteNearest:
            return static_cast<float>(std::round(value * kMostByte) / kMostByte);
        case NoiseFormat::sixteenBits:
            return static_cast<float>(std::round(value * kMostShort) / kMostShort);
        case NoiseFormat::half:
            return glm::unpackHalf1x16(glm::packHalf1x16(value));
        case NoiseFormat::single:
            break;
    }
    return value;
}

template <class T>
std::vector<T> integers(const std::vector<float>& values, double most) {
    std::vector<T> result(values.size());
    std::ranges::transform(values, result.begin(),
                           [most](float value) { return static_cast<T>(std::lround(value * most)); });
    return result;
}

}  // namespace

std::string_view name(NoiseFormat format) {
    return formatRow(format).name;
}

gpu::TexelFormat texelFormat(NoiseFormat format) {
    return formatRow(format).texels;
}

Octaves exactNoise(const glm::dvec3& place) {
    Octaves values{};
    for (int octave = 0; octave < noise::kOctaves; ++octave) {
        const glm::dvec3 lattice = place * static_cast<double>(noise::cellsOf(octave));
        values[static_cast<std::size_t>(octave)] = noise::noise3(lattice.x, lattice.y, lattice.z, octave);
    }
    return values;
}

std::vector<float> exactTexels(int n) {
    std::vector<float> texels;
    const auto side = static_cast<std::size_t>(n);
    texels.reserve(side * side * side * noise::kOctaves);
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                for (const double each : exactNoise(glm::dvec3(x, y, z) / static_cast<double>(n)))
                    texels.push_back(static_cast<float>(each));
    return texels;
}

NoiseVolume::NoiseVolume(int n, NoiseFormat format, const std::vector<float>& exact)
    : n_(n), format_(format) {
    if (format == NoiseFormat::byteFloor) {
        const noise::TexelBytes bytes = noise::noise3Texels(n);
        values_.resize(bytes.size());
        std::ranges::transform(bytes, values_.begin(),
                               [](std::uint8_t byte) { return static_cast<float>(byte / kMostByte); });
        return;
    }
    values_.resize(exact.size());
    std::ranges::transform(exact, values_.begin(), [format](float value) { return kept(value, format); });
}

Octaves NoiseVolume::at(const glm::dvec3& place) const {
    std::array<std::array<std::size_t, 2>, 3> index{};
    glm::dvec3 share;
    for (int axis = 0; axis < 3; ++axis) {
        const double texel = (place[axis] - std::floor(place[axis])) * n_;
        const auto near = static_cast<std::size_t>(texel);
        share[axis] = texel - static_cast<double>(near);
        const auto side = static_cast<std::size_t>(n_);
        index[static_cast<std::size_t>(axis)] = {near % side, (near + 1) % side};
    }
    Octaves sum{};
    const auto side = static_cast<std::size_t>(n_);
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const double weight =
            (i ? share.x : 1 - share.x) * (j ? share.y : 1 - share.y) * (k ? share.z : 1 - share.z);
        const float* texel =
            values_.data() + ((index[2][k] * side + index[1][j]) * side + index[0][i]) * noise::kOctaves;
        for (std::size_t octave = 0; octave < sum.size(); ++octave) sum[octave] += weight * texel[octave];
    }
    return sum;
}

Result<gpu::Texture> NoiseVolume::upload(const gpu::Capabilities& capabilities) const {
    const gpu::TextureSize size{n_, n_, n_};
    const auto make = [&](const auto& values, gpu::TexelType type) {
        return gpu::Texture::create(
            capabilities, gpu::TextureShape::texture3D, texelFormat(format_), size,
            {.data = std::as_bytes(std::span(values)), .components = noise::kOctaves, .type = type});
    };
    switch (format_) {
        case NoiseFormat::byteFloor:
        case NoiseFormat::byteNearest:
            return make(integers<std::uint8_t>(values_, kMostByte), gpu::TexelType::u8);
        case NoiseFormat::sixteenBits:
            return make(integers<std::uint16_t>(values_, kMostShort), gpu::TexelType::u16);
        case NoiseFormat::half:
        case NoiseFormat::single:
            break;
    }
    return make(values_, gpu::TexelType::f32);
}

double NoiseVolume::bytes() const {
    return std::pow(n_, 3) * static_cast<double>(gpu::bytesPerTexel(texelFormat(format_)));
}

glm::dvec3 spread(int i) {
    constexpr double kRoot = 1.2207440846057596;  // of x^4 = x + 1
    glm::dvec3 place(.5);
    double step = 1;
    for (int axis = 0; axis < 3; ++axis) {
        step /= kRoot;
        place[axis] += step * i;
        place[axis] -= std::floor(place[axis]);
    }
    return place;
}

}  // namespace glibra::bench
