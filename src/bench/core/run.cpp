#include "bench/core/run.h"

#include <fmt/chrono.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <thread>
#include <type_traits>

#include "base/device_lost.h"
#include "system/places.h"

namespace glibra::bench {
namespace {

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
    machine.processor = system::processorModel();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.memory = static_cast<double>(system::machineMemory());
    machine.system = system::systemName();
    machine.compiler = compilerVersion();
    return machine;
}

void nameDriver(Machine& machine, Bench& bench) {
    try {
        const gpu::Capabilities& capabilities = bench.capabilities();
        machine.driver = bench.context().howOpened();
        machine.renderer = capabilities.renderer;
        machine.version = capabilities.version;
    } catch (const Failed&) {  // the subject says why
    }
}

/// What the other process needs: it was forked from this one, so addresses are the same.
struct Request {
    Subject subject;
    BenchOptions options;
};
static_assert(std::is_trivially_copyable_v<Request>);

Diagnostic failureOf(const Subject& subject, const std::string& why) {
    return diagnose("bench-E04", fmt::format("subject '{}' {}", subject.name, why));
}

Report failed(const Subject& subject, Diagnostic why) {
    Report report;
    report.subjects.push_back({std::string(subject.name), std::string(subject.title), 0, {}, {}});
    report.subjects.back().diagnostics.push_back(std::move(why));
    return report;
}

Report measuredHere(const Request& request) {
    return runOne(std::string(request.subject.name), std::string(request.subject.title),
                  request.subject.measure, request.options);
}

std::string answerTo(const std::string& text) {
    Request request;
    std::memcpy(&request, text.data(), sizeof request);
    try {
        return jsonReport(measuredHere(request));
    } catch (const base::DeviceLost& lost) {
        return jsonReport(failed(request.subject, base::diagnosticOf(lost, {})));
    } catch (const std::exception& failure) {
        return jsonReport(
            failed(request.subject, failureOf(request.subject, std::string("failed: ") + failure.what())));
    }
}

}  // namespace

Report runOne(const std::string& name, const std::string& title,
              const std::function<std::vector<Figure>(Bench&)>& measure, const BenchOptions& options) {
    using Steady = std::chrono::steady_clock;
    Bench bench(options);
    Report report;
    report.quick = options.quick;
    report.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    report.machine = describeMachine();
    nameDriver(report.machine, bench);
    const Steady::time_point start = Steady::now();
    SubjectRun& done = report.subjects.emplace_back(SubjectRun{name, title});
    bench.attempt([&] { done.figures = measure(bench); });
    done.seconds = std::chrono::duration<double>(Steady::now() - start).count();
    done.diagnostics = bench.problems();
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

Report runApart(Apart& apart, const Subject& subject, const BenchOptions& options) {
    const Request request{subject, options};
    if (!apart.isThere()) return measuredHere(request);
    std::string text(sizeof request, '\0');
    std::memcpy(text.data(), &request, sizeof request);
    const std::optional<std::string> answer = apart.run(answerTo, text);
    if (!answer) return failed(subject, failureOf(subject, apart.failure()));
    Result<Report> report = readJsonReport(*answer, std::string(subject.name));
    return report ? std::move(*report) : failed(subject, report.diagnostics.front());
}

std::optional<std::vector<Point>> filteredInBytes(Bench& bench, Bench::Measure measure) {
    if (bench.capabilities().family.find("llvmpipe") == std::string::npos || !bench.apart().isThere())
        return std::nullopt;
    BenchOptions options = bench.options();
    options.driver = bench.context().driver();
    options.filtersInBytes = true;
    const SubjectRun run = runApart(bench.apart(), {"bytes", "bytes", measure}, options).subjects.front();
    for (Diagnostic each : run.diagnostics) {
        each.severity = Severity::warning;  // the rest of the subject is measured all the same
        bench.report({std::move(each)});
    }
    if (hasError(run.diagnostics) || run.figures.empty()) return std::nullopt;
    return run.figures.front().curves.front().points;
}

Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress) {
    Apart apart;  // while no driver is loaded
    Report all;
    all.quick = options.quick;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (progress.begins) progress.begins(*chosen[i], i, chosen.size());
        Report one = runApart(apart, *chosen[i], options);
        all.subjects.push_back(std::move(one.subjects.front()));
        if (all.machine.driver.empty() && !one.machine.processor.empty()) all.machine = one.machine;
        if (all.date.empty()) all.date = one.date;
        if (progress.measured) progress.measured(all);
    }
    return all;
}

}  // namespace glibra::bench
