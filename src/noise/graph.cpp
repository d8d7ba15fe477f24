#include "noise/graph.h"

#include <algorithm>
#include <cmath>

#include "geometry/mix.h"

namespace glibra::noise {
namespace {

/// A random number, uniform in -1..1. `kind` is 0 for heights, 1 and 2 for gradients along x and y.
double randomOf(const GraphOptions& options, int octave, int point, int kind) {
    const auto hash =
        geometry::mix(geometry::mix(static_cast<std::uint32_t>(point) + 0x9e3779b9U * (options.seed + 1)) +
                      static_cast<std::uint32_t>(8 * octave + kind));
    return static_cast<double>(hash >> 8) / 8388608.0 - 1;
}

/// Weights of height, gradient and curvature at the two ends of a cell.
struct CellWeights {
    std::array<double, 2> height, gradient, curvature;
};
CellWeights weightsOf(Smoothness smoothness, double t) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    if (smoothness == Smoothness::cubic)
        return {{1 - 3 * t2 + 2 * t3, 3 * t2 - 2 * t3}, {t - 2 * t2 + t3, t3 - t2}, {0, 0}};
    const double t4 = t3 * t;
    const double t5 = t4 * t;
    const double rise = 10 * t3 - 15 * t4 + 6 * t5;
    return {{1 - rise, rise},
            {t - 6 * t3 + 8 * t4 - 3 * t5, -4 * t3 + 7 * t4 - 3 * t5},
            {(t2 - 3 * t3 + 3 * t4 - t5) / 2, (t3 - 2 * t4 + t5) / 2}};
}

/// The lattice of one octave.
class Octave {
  public:
    Octave(const GraphOptions& options, int octave)
        : options_(options), octave_(octave), cells_(options.cells << octave) {}

    [[nodiscard]] double at(double x, double y) const {
        const double column = std::floor(x);
        const double row = std::floor(y);
        const CellWeights u = weightsOf(options_.smoothness, x - column);
        const CellWeights v = weightsOf(options_.smoothness, y - row);
        const bool isPlane = options_.dimensions == 2;
        double sum = 0;
        for (std::size_t b = 0; b < (isPlane ? 2U : 1U); ++b)
            for (std::size_t a = 0; a < 2; ++a) {
                const int i = wrapped(column + static_cast<double>(a));
                const int j = isPlane ? wrapped(row + static_cast<double>(b)) : 0;
                const double across = isPlane ? v.height[b] : 1;
                sum += across * (height(i, j) * u.height[a] + slope(i, j, 0) * u.gradient[a] +
                                 curvature(i, j) * u.curvature[a]);
                if (isPlane) sum += slope(i, j, 1) * u.height[a] * v.gradient[b];
            }
        return sum;
    }

    [[nodiscard]] GraphPoint atPoint(int index) const {
        const int i = index % cells_;
        const int j = index / cells_;
        const bool isCurved = options_.smoothness == Smoothness::quintic;
        return {height(i, j), slope(i, j, 0), isCurved ? curvature(i, j) : 0};
    }

  private:
    [[nodiscard]] int wrapped(double index) const {
        return static_cast<int>(index - std::floor(index / cells_) * cells_);
    }
    [[nodiscard]] int point(int i, int j) const { return i + cells_ * j; }

    [[nodiscard]] double height(int i, int j) const {
        if (octave_ == 0)
            if (const auto set = options_.heights.find(point(i, j)); set != options_.heights.end())
                return set->second;
        return options_.lattice == Lattice::gradient ? 0 : randomOf(options_, octave_, point(i, j), 0);
    }
    [[nodiscard]] double slope(int i, int j, int axis) const {
        if (octave_ == 0 && axis == 0)
            if (const auto set = options_.gradients.find(point(i, j)); set != options_.gradients.end())
                return set->second;
        if (options_.lattice != Lattice::value) return randomOf(options_, octave_, point(i, j), 1 + axis);
        if (options_.slopes == Slopes::zero) return 0;
        const int before = wrapped((axis == 0 ? i : j) - 1.0);
        const int after = wrapped((axis == 0 ? i : j) + 1.0);
        return axis == 0 ? (height(after, j) - height(before, j)) / 2
                         : (height(i, after) - height(i, before)) / 2;
    }

    [[nodiscard]] double curvature(int i, int j) const {
        const auto set = octave_ == 0 ? options_.curvatures.find(point(i, j)) : options_.curvatures.end();
        return set != options_.curvatures.end() ? set->second : 0;
    }

    const GraphOptions& options_;
    int octave_;
    int cells_;
};

}  // namespace

double graphNoise(const GraphOptions& options, double x, double y) {
    double sum = 0;
    double scale = 1;
    for (int octave = 0; octave < std::clamp(options.octaves, 1, kMostGraphOctaves); ++octave, scale /= 2) {
        const double noise = scale * Octave(options, octave).at(x / scale, y / scale);
        sum += options.turbulence ? std::abs(noise) : noise;
    }
    return sum;
}

GraphPoint graphPoint(const GraphOptions& options, int point) {
    return Octave(options, 0).atPoint(point);
}

double graphRange(const GraphOptions& options) {
    const double octaves = 2 - std::ldexp(1.0, 1 - std::clamp(options.octaves, 1, kMostGraphOctaves));
    const bool hasGradients = options.lattice != Lattice::value || options.slopes == Slopes::catmullRom;
    const double gradient = options.smoothness == Smoothness::cubic ? 1 / 4. : 5 / 16.;
    const double heights = options.lattice == Lattice::gradient ? 0 : 1;
    return octaves * (heights + (hasGradients ? gradient * options.dimensions : 0));
}

}  // namespace glibra::noise
