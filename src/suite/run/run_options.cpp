#include "suite/run/run_options.h"

#include "base/memory_limit.h"
#include "suite/golden/golden_store.h"
#include "suite/run/worker_count.h"

namespace glibra::suite {

std::filesystem::path pictureFile(const std::filesystem::path& folder, const Suite& suite, const Shot& shot,
                                  bool severalSuites) {
    return (severalSuites ? folder / suite.name : folder) / goldenName(shot);
}

RunOptions drawingOptions(const SiteWorkers& workers, const std::filesystem::path& folder) {
    RunOptions options;
    options.driver = workers.driver;
    options.jobs = workers.jobs;
    options.timeout = workers.timeout;
    options.memory = workers.memory;
    options.onlyRender = folder;
    options.sandbox = workers.drawing;
    return options;
}

base::WorkerOptions readingOptions(const SiteWorkers& workers, std::size_t pieces,
                                   const std::function<bool()>& stop) {
    const int jobs = readingJobs(workers.jobs);
    return {.workers = jobs,
            .timeout = workers.timeout,
            .memory = workers.memory.value_or(base::memoryShare(jobs, pieces)),
            .stop = stop,
            .sandbox = workers.reading};
}

}  // namespace glibra::suite
