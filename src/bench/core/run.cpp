#include "bench/core/run.h"

#include <fmt/chrono.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <utility>

#include "bench/core/machine.h"
#include "bench/core/recommendation.h"

namespace glibra::bench {
namespace {

/// Times within this share of each other are equal, however often they were measured: a driver's next version
/// changes them by more.
constexpr double kSameTime = .02;

struct Cost {
    double low, high;
};

Cost timeOf(const Point& point) {
    return {std::min(point.time->low, point.time->median),
            std::max(point.time->high, point.time->median) * (1 + kSameTime)};
}

Cost settingOf(const Point& point) {
    return {point.setting, point.setting};
}

/// Visits the points in falling accuracy: a point is on the front if none of those that are on it, which are
/// more accurate, is as cheap. Times whose spreads overlap are equally cheap. Of equally accurate points a
/// cheaper one takes the place of the others.
void markFrontBy(std::vector<Point*> points, Cost (*cost)(const Point&)) {
    std::ranges::sort(points, {}, [&](const Point* each) { return std::pair(each->error, cost(*each).low); });
    std::vector<const Point*> front;
    for (Point* each : points) {
        const Cost own = cost(*each);
        each->isOnFront = std::ranges::none_of(front, [&](const Point* other) {
            const Cost its = cost(*other);
            return other->error < each->error ? its.low <= own.high : its.high < own.low;
        });
        if (each->isOnFront) front.push_back(each);
    }
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

bool isTimed(const Figure& figure) {
    return std::ranges::all_of(figure.curves, [](const Curve& curve) {
        return std::ranges::all_of(
            curve.points, [](const Point& each) { return each.time.has_value() || std::isnan(each.error); });
    });
}

void markFront(Figure& figure) {
    const auto cost = isTimed(figure) ? timeOf : settingOf;
    const bool hasFront = figure.alternatives != Alternatives::none;
    // Points with equal keys are alternatives.
    std::map<double, std::vector<Point*>> groups;
    for (std::size_t i = 0; i < figure.curves.size(); ++i)
        for (Point& point : figure.curves[i].points) {
            point.isOnFront = false;
            if (std::isnan(point.error) || figure.curves[i].theoryOf || !hasFront) continue;
            const double key = figure.alternatives == Alternatives::curve     ? static_cast<double>(i)
                               : figure.alternatives == Alternatives::setting ? point.setting
                                                                              : 0;
            groups[key].push_back(&point);
        }
    for (auto& [key, points] : groups) markFrontBy(std::move(points), cost);
}

Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress) {
    using Clock = std::chrono::steady_clock;
    Report report;
    report.quick = options.quick;
    report.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    report.machine = describeMachine();
    Bench bench(options);
    nameDriver(report.machine, bench);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const Subject& subject = *chosen[i];
        progress(subject, i, chosen.size());
        const Clock::time_point start = Clock::now();
        Result<std::vector<Figure>> measured = subject.measure(bench);
        SubjectRun& done = report.subjects.emplace_back();
        done.name = subject.name;
        done.title = subject.title;
        done.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (measured) done.figures = std::move(*measured);
        done.diagnostics = std::move(measured.diagnostics);
        for (Figure& figure : done.figures) {
            markFront(figure);
            if (std::string advice = recommendation(figure); !advice.empty())
                figure.findings.push_back(std::move(advice));
        }
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
