#include <vector>

#include "bench/curves.h"
#include "bench/fractals.h"
#include "bench/primitives.h"
#include "bench/ray_sphere.h"
#include "bench/subject.h"
#include "bench/transforms.h"

namespace glibra::bench {

std::span<const Subject> subjects() {
    static const std::vector<Subject> table{
        {"primitives", "Primitives: slices and stacks against the analytic surface", measurePrimitives},
        {"transforms", "Transforms: float and double against 100 digits", measureTransforms},
        {"curves", "Curves and streamlines: fixed, adaptive, summed up", measureCurves},
        {"fractals", "Fractals: float and double by zoom", measureFractals},
        {"ray-sphere", "Ray and sphere: textbook and stable formulas", measureRaySphere},
    };
    return table;
}

}  // namespace glibra::bench
