#pragma once

#include "bench/core/report.h"

namespace glibra::bench {

/// Processor, memory, operating system and compiler. The driver's members stay empty.
Machine describeMachine();

}  // namespace glibra::bench
