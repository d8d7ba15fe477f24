#pragma once
// The positions of a texture's texels along one axis, in the cells of one octave.

#include <cstddef>
#include <vector>

#include "noise/weights.h"

namespace glibra::noise {

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

}  // namespace glibra::noise
