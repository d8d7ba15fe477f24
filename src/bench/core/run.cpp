#include "bench/core/run.h"

#include <fmt/chrono.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <utility>

#include "bench/core/machine.h"

namespace glibra::bench {
namespace {

using Cost = double (*)(const Point&);

/// Visits the points in rising cost: a point is on the front if it is more accurate than all before it. Equal
/// points are on it together.
void markFrontBy(std::vector<Point*> points, Cost cost) {
    std::ranges::sort(points, {}, [&](const Point* each) { return std::pair(cost(*each), each->error); });
    const Point* best = nullptr;
    for (Point* each : points) {
        const bool isEqual = best && cost(*each) == cost(*best) && each->error == best->error;
        each->isOnFront = !best || isEqual || each->error < best->error;
        if (each->isOnFront) best = each;
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
    const Cost cost = isTimed(figure) ? Cost([](const Point& each) { return each.time->median; })
                                      : Cost([](const Point& each) { return each.setting; });
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

namespace {

/// A report without subjects.
Report begin(Bench& bench, const BenchOptions& options) {
    Report report;
    report.quick = options.quick;
    report.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    report.machine = describeMachine();
    nameDriver(report.machine, bench);
    return report;
}

template <class Measure>
void add(Report& report, Bench& bench, std::string_view name, std::string_view title,
         const Measure& measure) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Result<std::vector<Figure>> measured = measure(bench);
    SubjectRun& done = report.subjects.emplace_back();
    done.name = name;
    done.title = title;
    done.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (measured) done.figures = std::move(*measured);
    done.diagnostics = std::move(measured.diagnostics);
    for (Figure& figure : done.figures) markFront(figure);
}

}  // namespace

Report run(std::span<const Subject* const> chosen, const BenchOptions& options, const Progress& progress) {
    Bench bench(options);
    Report report = begin(bench, options);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        progress(*chosen[i], i, chosen.size());
        add(report, bench, chosen[i]->name, chosen[i]->title, chosen[i]->measure);
    }
    return report;
}

Report runOne(const std::string& name, const std::string& title,
              const std::function<Result<std::vector<Figure>>(Bench&)>& measure,
              const BenchOptions& options) {
    Bench bench(options);
    Report report = begin(bench, options);
    add(report, bench, name, title, measure);
    return report;
}

bool lacksDriver(const Report& report) {
    return std::ranges::any_of(report.subjects, [](const SubjectRun& subject) {
        return std::ranges::any_of(subject.diagnostics,
                                   [](const Diagnostic& each) { return each.id == "gpu-E01"; });
    });
}

}  // namespace glibra::bench
