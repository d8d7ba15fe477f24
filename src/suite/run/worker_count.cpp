#include "suite/run/worker_count.h"

#include <stdlib.h>

#include <algorithm>
#include <string>

#include "base/parallel.h"
#include "gpu/context/hardware.h"

namespace glibra::suite {

int drawingJobs(int wanted, Driver driver, std::size_t pieces) {
    return wanted > 0 ? wanted : gpu::usualWorkers(driver, pieces, readingJobs(0));
}

int readingJobs(int wanted) {
    return static_cast<int>(base::threadCount(wanted));
}

void shareProcessors(int jobs, std::size_t pieces) {
    const auto workers = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(jobs), pieces));
    if (workers <= 1) return;
    const int threads = readingJobs(0) / workers;
    // 0: the caller rasterises. With one thread it would only wait for that thread.
    ::setenv("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0).c_str(), 0);
}

}  // namespace glibra::suite
