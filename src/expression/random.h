#pragma once
// Random numbers and noise of expressions. They use integers and the exactly rounded operations of IEEE 754
// only, so that they are the same bits on every machine.

#include <cstdint>
#include <optional>

namespace glibra::expression {

/// A number in [0, 1), a multiple of 2^-53: number `i` of the sequence that splitmix64 gives after the state
/// base::splitMixed(seed + c), where c = 0x9e3779b97f4a7c15. Both arguments are cut toward zero. Nothing if
/// one is beyond
/// +-2^63.
std::optional<double> random(double i, double seed);

/// Gradient noise (Perlin, Improving Noise, 2002) in 1 to 3 dimensions: in -1..1, 0 at points with whole
/// coordinates, twice differentiable, without a period. `point` has `dimensions` finite coordinates.
double gradientNoise(const double* point, int dimensions);

}  // namespace glibra::expression
