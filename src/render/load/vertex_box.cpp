#include "render/load/vertex_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::render {
namespace {

template <std::size_t Components>
VertexBox boundsOfValues(const std::vector<float>& values) {
    constexpr float kMost = std::numeric_limits<float>::infinity();
    std::array<float, 4> low{kMost, kMost, kMost, kMost};
    std::array<float, 4> high{-kMost, -kMost, -kMost, -kMost};
    std::array<float, Components> zero{};  // becomes NaN where a value is not finite
    for (std::size_t i = 0; i + Components <= values.size(); i += Components)
        for (std::size_t k = 0; k < Components; ++k) {
            const float value = values[i + k];
            low[k] = value < low[k] ? value : low[k];
            high[k] = value > high[k] ? value : high[k];
            zero[k] += value * 0;
        }
    if constexpr (Components == 3) low[3] = high[3] = 1;
    VertexBox bounds;
    for (std::size_t k = 0; k < 4; ++k) {
        bounds.low[static_cast<int>(k)] = static_cast<double>(low[k]);
        bounds.high[static_cast<int>(k)] = static_cast<double>(high[k]);
    }
    bounds.isKnown = std::ranges::none_of(zero, [](float each) { return std::isnan(each); });
    return bounds;
}

}  // namespace

VertexBox boundsOf(const geometry::Mesh& mesh) {
    const geometry::Attribute* position = mesh.attribute(geometry::kPosition);
    if (position == nullptr || position->values.empty()) return {};
    switch (position->components) {
        case 3:
            return boundsOfValues<3>(position->values);
        case 4:
            return boundsOfValues<4>(position->values);
        default:
            return {};
    }
}

}  // namespace glibra::render
