#pragma once
// How a texture is read, as values without GL. `scene` fills them, `gpu` makes samplers of them.

#include <array>
#include <cstdint>

namespace glibra::base {

/// The first word is the filter within a level, the second one that between levels.
enum class Filter : std::uint8_t {
    nearest,
    linear,
    nearestMipmapNearest,
    linearMipmapNearest,
    nearestMipmapLinear,
    linearMipmapLinear,
};

/// What is read outside of 0..1.
enum class Wrap : std::uint8_t { repeat, clampToEdge, mirroredRepeat, clampToBorder };

constexpr bool repeats(Wrap wrap) {
    return wrap == Wrap::repeat || wrap == Wrap::mirroredRepeat;
}

struct SamplerState {
    Filter filter = Filter::linear;  ///< for enlarging, the filter within a level
    std::array<Wrap, 3> wrap{};      ///< along s, t and p
    double anisotropy = 1;           ///< 1: off; the driver's limit holds
    std::array<double, 4> border{};  ///< what clampToBorder reads

    [[nodiscard]] bool readsMipmaps() const { return filter >= Filter::nearestMipmapNearest; }
    friend bool operator==(const SamplerState&, const SamplerState&) = default;
};

}  // namespace glibra::base
