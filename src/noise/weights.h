#pragma once
// How a texel of the noise is made of the values of its lattice.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace glibra::noise {

// The four polynomials of gradient noise (language, 9.2) for t in 0..1: n0 and n1 are the weights of the
// value at the near and the far end of a cell, g0 and g1 those of the slope.

struct Weights {
    double n0, n1, g0, g1;
};

constexpr Weights weightsAt(double t) {
    const double n0 = 1 + t * t * t * (-10 + t * (15 - 6 * t));
    return {n0, 1 - n0, t * (1 + t * t * (-6 + t * (8 - 3 * t))), t * t * t * (-4 + t * (7 - 3 * t))};
}

// The positions of a texture's texels along one axis, in the cells of one octave.

struct AxisPlace {
    std::size_t cell = 0;  ///< 0..cells - 1
    Weights at{};          ///< weights at the texel's place in its cell
};

/// The positions of texels 0..n - 1.
inline std::vector<AxisPlace> axisPlaces(int n, int cells) {
    std::vector<AxisPlace> places;
    places.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        places.push_back(
            {static_cast<std::size_t>(i * cells / n), weightsAt(static_cast<double>(i * cells % n) / n)});
    return places;
}

// Memory for texels without initial values. Setting megabytes to zero takes longer than computing the texels
// that overwrite them.

template <class T>
struct Unset : std::allocator<T> {
    template <class Other>
    struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
        using other = Unset<Other>;
    };
    template <class Other>
    void construct(Other* at) noexcept {
        ::new (static_cast<void*>(at)) Other;
    }
    template <class Other, class... From>
    void construct(Other* at, From&&... from) {
        ::new (static_cast<void*>(at)) Other(std::forward<From>(from)...);
    }
};

/// A vector whose constructor and resize leave new bytes unset.
using TexelBytes = std::vector<std::uint8_t, Unset<std::uint8_t>>;
using TexelShorts = std::vector<std::uint16_t, Unset<std::uint16_t>>;

}  // namespace glibra::noise
