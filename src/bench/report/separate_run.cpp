#include "bench/report/separate_run.h"

#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "base/device_lost.h"
#include "bench/core/apart.h"
#include "bench/core/run.h"
#include "bench/report/json_report.h"

namespace glibra::bench {
namespace {

/// What the other process needs: it was forked from this one, so addresses are the same.
struct Request {
    const Subject* subject = nullptr;
    BenchOptions options;
};

Report measured(const Request& request) {
    const Subject& subject = *request.subject;
    return runOne(std::string(subject.name), std::string(subject.title), subject.measure, request.options);
}

Diagnostic failureOf(const Subject& subject, const std::string& why) {
    return diagnose("bench-E04", fmt::format("subject '{}' {}", subject.name, why));
}

Report failed(const Subject& subject, Diagnostic why) {
    Report report;
    report.subjects.push_back({std::string(subject.name), std::string(subject.title), 0, {}, {}});
    report.subjects.back().diagnostics.push_back(std::move(why));
    return report;
}

std::string answerTo(const std::string& text) {
    Request request;
    std::memcpy(&request, text.data(), sizeof request);
    try {
        return jsonReport(measured(request));
    } catch (const base::DeviceLost& lost) {
        return jsonReport(failed(*request.subject, base::diagnosticOf(lost, {})));
    } catch (const std::exception& failure) {
        return jsonReport(
            failed(*request.subject, failureOf(*request.subject, std::string("failed: ") + failure.what())));
    }
}

Report measuredApart(Apart& apart, const Request& request) {
    std::string text(sizeof request, '\0');
    std::memcpy(text.data(), &request, sizeof request);
    const std::optional<std::string> answer = apart.run(answerTo, text);
    if (!answer) return failed(*request.subject, failureOf(*request.subject, apart.failure()));
    Result<Report> report = readJsonReport(*answer, std::string(request.subject->name));
    return report ? std::move(*report) : failed(*request.subject, report.diagnostics.front());
}

}  // namespace

Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress) {
    static_assert(std::is_trivially_copyable_v<Request>);
    Apart apart;  // while no driver is loaded
    Report all;
    all.quick = options.quick;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (progress.begins) progress.begins(*chosen[i], i, chosen.size());
        const Request request{chosen[i], options};
        Report one = apart.isThere() ? measuredApart(apart, request) : measured(request);
        all.subjects.push_back(std::move(one.subjects.front()));
        if (all.machine.driver.empty() && !one.machine.processor.empty()) all.machine = one.machine;
        if (all.date.empty()) all.date = one.date;
        if (progress.measured) progress.measured(all);
    }
    return all;
}

}  // namespace glibra::bench
