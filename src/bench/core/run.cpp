#include "bench/core/run.h"

#include <fmt/chrono.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>
#include <utility>

#include "bench/core/front.h"
#include "bench/core/recommendation.h"

namespace glibra::bench {
namespace {

/// The value of the first line of /proc/cpuinfo that starts with one of the names under which kernels list
/// the processor's model.
std::string processorModel() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        for (const std::string_view name : {"model name", "Model", "CPU implementer"}) {
            const std::size_t colon = line.find(": ");
            if (line.starts_with(name) && colon != std::string::npos) return line.substr(colon + 2);
        }
    return {};
}

std::string compilerVersion() {
#if defined(__clang__)
    return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    return {};
#endif
}

/// Processor, memory, operating system and compiler. The driver's members stay empty.
Machine describeMachine() {
    Machine machine;
    machine.processor = processorModel();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.memory =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    utsname system{};
    if (::uname(&system) == 0)
        machine.system = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
    machine.compiler = compilerVersion();
    return machine;
}

void nameDriver(Machine& machine, Bench& bench) {
    const Result<gpu::Context*> context = bench.context();
    if (!context) return;
    const gpu::Capabilities& capabilities = (*context)->capabilities();
    machine.driver = (*context)->howOpened();
    machine.renderer = capabilities.renderer;
    machine.version = capabilities.version;
}

}  // namespace

Report runOne(const std::string& name, const std::string& title,
              const std::function<Result<std::vector<Figure>>(Bench&)>& measure,
              const BenchOptions& options) {
    using Steady = std::chrono::steady_clock;
    Bench bench(options);
    Report report;
    report.quick = options.quick;
    report.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    report.machine = describeMachine();
    nameDriver(report.machine, bench);
    const Steady::time_point start = Steady::now();
    Result<std::vector<Figure>> measured = measure(bench);
    SubjectRun& done = report.subjects.emplace_back();
    done.name = name;
    done.title = title;
    done.seconds = std::chrono::duration<double>(Steady::now() - start).count();
    if (measured) done.figures = std::move(*measured);
    done.diagnostics = std::move(measured.diagnostics);
    for (Figure& figure : done.figures) {
        markFront(figure);
        if (std::string advice = recommendation(figure); !advice.empty())
            figure.findings.push_back(std::move(advice));
    }
    return report;
}

bool lacksDriver(const Report& report) {
    return std::ranges::any_of(report.subjects, [](const SubjectRun& subject) {
        return std::ranges::any_of(subject.diagnostics,
                                   [](const Diagnostic& each) { return each.id == "gpu-E01"; });
    });
}

}  // namespace glibra::bench
