#pragma once
// The errors that GLSL 4.60, section 4.7.1, allows the built-in functions: absolute, for component i of the
// exact result y of the arguments x. Functions that the section defines by an equation inherit the errors of
// its operations, added up to first order. For BuiltinFunction::allowed.

#include "bench/reference/builtin_arguments.h"

namespace glibra::bench::bounds {

/// `halves` / 2 units in the last place.
template <int halves>
long double ulps(const Arguments&, const Values& y, int i) {
    return halves * .5L * unitInLastPlace(y[static_cast<std::size_t>(i)]);
}

long double none(const Arguments& x, const Values& y, int i);
long double exponential(const Arguments& x, const Values& y, int i);  ///< exp, exp2
long double logarithm(const Arguments& x, const Values& y, int i);    ///< log, log2
long double power(const Arguments& x, const Values& y, int i);        ///< x[0] to the x[4]
long double root(const Arguments& x, const Values& y, int i);         ///< sqrt
long double hyperbolic(const Arguments& x, const Values& y, int i);   ///< sinh, cosh
long double hyperbolicTangent(const Arguments& x, const Values& y, int i);
long double angle(const Arguments& x, const Values& y, int i);       ///< radians
long double modulus(const Arguments& x, const Values& y, int i);     ///< of x[0] by x[4]
long double mixture(const Arguments& x, const Values& y, int i);     ///< of x[0] and x[1] by x[4]
long double smoothStep(const Arguments& x, const Values& y, int i);  ///< between -x[0] and x[1] at x[4]
// Vectors are x[0], x[1] ... and x[4], x[5] ...
long double dot(const Arguments& x, const Values& y, int i);  ///< of four components
long double length(const Arguments& x, const Values& y, int i);
long double distance(const Arguments& x, const Values& y, int i);
long double normalized(const Arguments& x, const Values& y, int i);
long double cross(const Arguments& x, const Values& y, int i);
long double reflected(const Arguments& x, const Values& y, int i);
long double product(const Arguments& x, const Values& y, int i);  ///< of the matrix x[0]..x[3] and a vector

}  // namespace glibra::bench::bounds
