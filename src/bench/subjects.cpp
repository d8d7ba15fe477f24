#include <vector>

#include "bench/primitives.h"
#include "bench/subject.h"

namespace glibra::bench {

std::span<const Subject> subjects() {
    static const std::vector<Subject> table{
        {"primitives", "Primitives: slices and stacks against the analytic surface", measurePrimitives},
    };
    return table;
}

}  // namespace glibra::bench
