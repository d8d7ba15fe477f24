// The noise functions as language, 9 defines them. texels.cpp computes the texels from the same sums in a
// different order.

#include "noise/noise.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "noise/tables.h"
#include "noise/weights.h"

namespace glibra::noise {
namespace {

/// A coordinate's cell: the lattice points at both ends, and their weights.
struct Axis {
    std::array<std::size_t, 2> point;
    std::array<double, 2> value, slope;
};

std::optional<Axis> axisAt(double coordinate, int cells) {
    if (!std::isfinite(coordinate)) return std::nullopt;
    const double cell = std::floor(coordinate);
    const Weights w = weightsAt(coordinate - cell);
    const double wrapped = cell - std::floor(cell / cells) * cells;  // exact: cells is a power of two
    const auto near = static_cast<std::size_t>(wrapped);
    return Axis{{near, (near + 1) % static_cast<std::size_t>(cells)}, {w.n0, w.n1}, {w.g0, w.g1}};
}

}  // namespace

double noise3(double x, double y, double z, int octave) {
    const tables::Octave3& table = tables::kOctaves3.at(static_cast<std::size_t>(octave));
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto ax = axisAt(x, table.cells);
    const auto ay = axisAt(y, table.cells);
    const auto az = axisAt(z, table.cells);
    if (!ax || !ay || !az) return 0.5;
    double sum = 0;
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t b = 0; b < 2; ++b)
            for (std::size_t a = 0; a < 2; ++a) {
                const std::size_t h =
                    (ax->point[a] + table.p[(ay->point[b] + table.q[az->point[c]]) % cells]) % cells;
                const auto& g = table.gradients[h];
                sum += g[0] * ax->slope[a] * ay->value[b] * az->value[c] +
                       g[1] * ax->value[a] * ay->slope[b] * az->value[c] +
                       g[2] * ax->value[a] * ay->value[b] * az->slope[c];
            }
    return 0.5 + sum;
}

double noise2(double x, double y, int octave) {
    const tables::Octave2& table = tables::kOctaves2.at(static_cast<std::size_t>(octave));
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto ax = axisAt(x, table.cells);
    const auto ay = axisAt(y, table.cells);
    if (!ax || !ay) return 0.5;
    double sum = 0;
    for (std::size_t b = 0; b < 2; ++b)
        for (std::size_t a = 0; a < 2; ++a) {
            const auto& g = table.gradients[(ax->point[a] + table.p[ay->point[b]]) % cells];
            sum += g[0] * ax->slope[a] * ay->value[b] + g[1] * ax->value[a] * ay->slope[b];
        }
    return 0.5 + sum;
}

}  // namespace glibra::noise
