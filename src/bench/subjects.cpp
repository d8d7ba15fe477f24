#include <vector>

#include "bench/builtins.h"
#include "bench/subject.h"

namespace glibra::bench {

std::span<const Subject> subjects() {
    static const std::vector<Subject> table{
        {"builtins", "GLSL functions: units in the last place, and what the specification allows",
         measureBuiltins},
    };
    return table;
}

}  // namespace glibra::bench
