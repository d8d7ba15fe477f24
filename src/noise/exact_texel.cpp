#include "noise/exact_texel.h"

#include <algorithm>
#include <array>

namespace glibra::noise {
namespace {

/// The gradients at one end of a cell along x, interpolated along y and z: a slope along x, and a level.
struct LineEnd {
    double slope, level;
};

double along(const Weights& w, double nearSlope, double farSlope) {
    return nearSlope * w.g0 + farSlope * w.g1;
}

double between(const Weights& w, double nearLevel, double farLevel) {
    return nearLevel * w.n0 + farLevel * w.n1;
}

std::uint8_t byteOf(const LineEnd& near, const LineEnd& far, const Weights& w) {
    const double noise = along(w, near.slope, far.slope) + between(w, near.level, far.level);
    return static_cast<std::uint8_t>(255 * std::clamp(0.5 + noise, 0., 1.));
}

}  // namespace

std::uint8_t exactByte(const tables::Octave3& table, const AxisPlace& x, const AxisPlace& y,
                       const AxisPlace& z) {
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto gradient = [&](std::size_t i, std::size_t j, std::size_t k) -> const std::array<double, 3>& {
        return table.gradients[(i + table.p[(j % cells + table.q[k % cells]) % cells]) % cells];
    };
    const auto mergedAlongZ = [&](std::size_t i, std::size_t j) -> std::array<double, 3> {
        const auto& near = gradient(i, j, z.cell);
        const auto& far = gradient(i, j, z.cell + 1);
        return {between(z.at, near[0], far[0]), between(z.at, near[1], far[1]), along(z.at, near[2], far[2])};
    };
    const auto lineEnd = [&](std::size_t i) -> LineEnd {
        const auto near = mergedAlongZ(i, y.cell);
        const auto far = mergedAlongZ(i, y.cell + 1);
        return {between(y.at, near[0], far[0]),
                along(y.at, near[1], far[1]) + between(y.at, near[2], far[2])};
    };
    return byteOf(lineEnd(x.cell), lineEnd(x.cell + 1), x.at);
}

std::uint8_t exactByte(const tables::Octave2& table, const AxisPlace& x, const AxisPlace& y) {
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto lineEnd = [&](std::size_t i) -> LineEnd {
        const auto& near = table.gradients[(i + table.p[y.cell]) % cells];
        const auto& far = table.gradients[(i + table.p[(y.cell + 1) % cells]) % cells];
        return {between(y.at, near[0], far[0]), along(y.at, near[1], far[1])};
    };
    return byteOf(lineEnd(x.cell), lineEnd(x.cell + 1), x.at);
}

}  // namespace glibra::noise
