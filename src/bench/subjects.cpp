#include <vector>

#include "bench/antialiasing.h"
#include "bench/depth.h"
#include "bench/primitives.h"
#include "bench/subject.h"

namespace glibra::bench {

std::span<const Subject> subjects() {
    static const std::vector<Subject> table{
        {"primitives", "Primitives: slices and stacks against the analytic surface", measurePrimitives},
        {"antialiasing", "Antialiasing: samples a pixel and their filters", measureAntialiasing},
        {"depth", "Depth buffers: the smallest gap that is told apart", measureDepth},
    };
    return table;
}

}  // namespace glibra::bench
