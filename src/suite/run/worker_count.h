#pragma once
// The number of worker processes, and what each of them may take of the processors.

#include <glibra/driver.h>

#include <cstddef>

namespace glibra::suite {

/// `wanted` workers that draw `pieces` scenes or shots; 0: as many as draw them soonest. Where the processor
/// draws, that is one per processor, because processes are faster than threads on llvmpipe.
int drawingJobs(int wanted, Driver driver, std::size_t pieces);
/// `wanted` workers for work without a context; 0: one per processor.
int readingJobs(int wanted);
/// Call it in a worker before its context is opened. Divides the processors among the software rasterisers of
/// `jobs` workers, of which at most `pieces` have work. A value that the user has set stays.
void shareProcessors(int jobs, std::size_t pieces);

}  // namespace glibra::suite
