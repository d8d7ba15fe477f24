#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/subject.h"

namespace glibra::bench {

/// The figures of measureTessellation that concern edges.
Result<std::vector<Figure>> measureCracks(const Bench& bench, const gpu::Capabilities& capabilities);

}  // namespace glibra::bench
