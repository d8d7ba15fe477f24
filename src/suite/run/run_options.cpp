#include "suite/run/run_options.h"

#include <fmt/format.h>
#include <algorithm>
#include <sstream>

#include "base/contained_call.h"
#include "base/parallel.h"
#include "gpu/context/context.h"
#include "suite/golden/golden_store.h"
#include "system/places.h"

namespace glibra::suite {
namespace {

std::string head(char kind, const ShotReference& shot) {
    return fmt::format("{} {} {}\n", kind, shot.suite, shot.shot);
}

struct ToText {
    std::string operator()(const DriverIs& message) const {
        return "k\n" + message.words + "\n" + message.key;
    }
    std::string operator()(const Begins& message) const { return head('b', message.shot); }
    std::string operator()(const Phase& message) const {
        return head(static_cast<char>(message.kind), message.shot);
    }
    std::string operator()(const Done& message) const {
        return head('d', message.shot) + toJsonLine(message.result) + "\n" +
               (message.accepted ? toLine(*message.accepted) : "");
    }
};

}  // namespace

std::string toText(const Message& message) {
    return std::visit(ToText{}, message);
}

std::optional<Message> parseMessage(const std::string& text) {
    std::istringstream lines(text);
    std::string first, second, third;
    std::getline(lines, first);
    std::getline(lines, second);
    std::getline(lines, third);
    if (first == "k") return DriverIs{second, third};
    std::istringstream words(first);
    char kind = 0;
    ShotReference shot;
    if (!(words >> kind >> shot.suite >> shot.shot)) return std::nullopt;
    if (kind == 'b') return Begins{shot};
    for (const Phase::Kind each :
         {Phase::Kind::awaits, Phase::Kind::drawn, Phase::Kind::judges, Phase::Kind::recalls})
        if (kind == static_cast<char>(each)) return Phase{each, shot};
    if (kind != 'd') return std::nullopt;
    Result<ShotResult> result = parseJsonLine(second, {});
    if (!result) return std::nullopt;
    Done done{shot, std::move(*result), std::nullopt};
    if (!third.empty()) done.accepted = parseLine(third, {}).value;
    return done;
}

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
    system::setVariable("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0), system::Replace::no);
}

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

base::WorkerOptions checkingOptions(const SiteWorkers& workers, std::size_t pieces,
                                    const std::function<bool()>& stop) {
    const int jobs = drawingJobs(workers.jobs, workers.driver, pieces);
    return {.workers = jobs,
            .timeout = workers.timeout,
            .memory = workers.memory.value_or(base::memoryShare(jobs, pieces)),
            .stop = stop,
            .sharesDevice = gpu::mayUseHardware(workers.driver),
            .sandbox = workers.drawing};
}

}  // namespace glibra::suite
