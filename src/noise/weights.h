#pragma once
// The four polynomials of gradient noise (language, 9.2) for t in 0..1: n0 and n1 are the weights of the
// value at the near and the far end of a cell, g0 and g1 those of the slope.

namespace glibra::noise {

struct Weights {
    double n0, n1, g0, g1;
};

constexpr Weights weightsAt(double t) {
    const double n0 = 1 + t * t * t * (-10 + t * (15 - 6 * t));
    return {n0, 1 - n0, t * (1 + t * t * (-6 + t * (8 - 3 * t))), t * t * t * (-4 + t * (7 - 3 * t))};
}

}  // namespace glibra::noise
