#include "bench/report/reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/text.h"

namespace glibra::bench {
namespace {

std::string describe(const Point& point, const std::string& unit) {
    std::string text = fmt::format("{}: {}", point.label, numberText(point.error));
    if (!unit.empty()) text += " " + unit;
    if (point.time) text += fmt::format(" in {}", secondsText(point.time->median));
    return text;
}

std::string curveLine(const Curve& curve, const Figure& figure, std::size_t width) {
    if (curve.points.empty()) return fmt::format("    {}\n", curve.name);
    const auto front = std::ranges::count_if(curve.points, &Point::isOnFront);
    std::string ends = describe(curve.points.front(), figure.errorUnit);
    if (curve.points.size() > 1) ends += "; " + describe(curve.points.back(), figure.errorUnit);
    return fmt::format("    {:<{}}  {} of {} on the front; {}\n", curve.name, width, front,
                       curve.points.size(), ends);
}

using base::csvField;

std::string number(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string timing(const std::optional<Timing>& time) {
    return time ? fmt::format("{},{},{},{}", time->median, time->low, time->high, time->repeats) : ",,,";
}

/// Subject, figure, curve, label.
using Key = std::array<std::string, 4>;

struct PlacedPoint {
    const Point* point = nullptr;
    const Figure* figure = nullptr;
};

using Points = std::vector<std::pair<Key, PlacedPoint>>;

Points sharedPoints(const Report& report, const Report& other) {
    Points points;
    for (const SubjectRun& subject : report.subjects) {
        if (std::ranges::none_of(other.subjects,
                                 [&](const SubjectRun& each) { return each.name == subject.name; }))
            continue;
        for (const Figure& figure : subject.figures)
            for (const Curve& curve : figure.curves)
                for (const Point& point : curve.points)
                    points.push_back(
                        {{subject.name, figure.name, curve.name, point.label}, {&point, &figure}});
    }
    return points;
}

PointChange changeOf(const Key& key, const PlacedPoint& before, const PlacedPoint& now,
                     const ComparisonOptions& options) {
    PointChange change;
    change.subject = key[0];
    change.figure = key[1];
    change.curve = key[2];
    change.label = key[3];
    change.errorUnit = now.figure->errorUnit;
    change.errorBefore = before.point->error;
    change.errorNow = now.point->error;
    const auto exceeds = [&](double larger, double smaller) {
        if (std::isnan(larger) || std::isnan(smaller)) return std::isnan(larger) && !std::isnan(smaller);
        return larger > smaller * (1 + options.errorTolerance);
    };
    change.errorIsWorse = exceeds(change.errorNow, change.errorBefore);
    change.errorIsBetter = exceeds(change.errorBefore, change.errorNow);
    if (before.point->time && now.point->time && before.point->time->median > 0) {
        const Timing &then = *before.point->time, &timed = *now.point->time;
        change.timeRatio = timed.median / then.median;
        change.timeIsWorse = timed.low > then.high;
        change.timeIsBetter = timed.high < then.low;
        change.timeFails =
            change.timeIsWorse && options.timeFactor && *change.timeRatio > *options.timeFactor;
    }
    return change;
}

std::string keyText(const Key& key) {
    return fmt::format("{}/{}/{} {}", key[0], key[1], key[2], key[3]);
}

std::string withUnit(double error, const std::string& unit) {
    return unit.empty() || std::isnan(error) ? numberText(error) : numberText(error) + " " + unit;
}

std::string changeLine(const PointChange& change, std::string_view word, const std::string& what) {
    return fmt::format("{:<7} {}/{}, {}, {}: {}\n", word, change.subject, change.figure, change.curve,
                       change.label, what);
}

}  // namespace

std::string textReport(const SubjectRun& subject) {
    std::string text = fmt::format("{} ({})\n", subject.title, secondsText(subject.seconds));
    for (const Figure& figure : subject.figures) {
        text += fmt::format("  {}: {}; {} against {}\n", figure.name, figure.title, figure.errorName,
                            figure.settingName);
        std::size_t width = 0;
        for (const Curve& curve : figure.curves) width = std::max(width, curve.name.size());
        for (const Curve& curve : figure.curves) text += curveLine(curve, figure, width);
        for (const std::string& finding : figure.findings) text += fmt::format("    - {}\n", finding);
    }
    return text;
}

std::string machineLine(const Machine& machine) {
    return fmt::format("{}, {} cores, {}; {}", machine.processor, machine.cores, machine.system,
                       machine.driver.empty() ? "no OpenGL driver" : machine.renderer);
}

std::string csvReport(const Report& report) {
    std::string csv =
        "subject,figure,curve,setting,label,error,error_unit,time_median_s,time_low_s,time_high_s,repeats,"
        "memory_bytes,front,gpu_time_s\n";
    for (const SubjectRun& subject : report.subjects)
        for (const Figure& figure : subject.figures)
            for (const Curve& curve : figure.curves)
                for (const Point& point : curve.points)
                    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csvField(subject.name),
                                       csvField(figure.name), csvField(curve.name), number(point.setting),
                                       csvField(point.label), number(point.error), csvField(figure.errorUnit),
                                       timing(point.time), point.memory ? number(*point.memory) : "",
                                       point.isOnFront ? 1 : 0, point.gpuTime ? number(*point.gpuTime) : "");
    return csv;
}

RunComparison compare(const Report& earlier, const Report& now, const ComparisonOptions& options) {
    RunComparison comparison;
    const Machine &then = earlier.machine, &machine = now.machine;
    comparison.sameMachine = then.processor == machine.processor && then.cores == machine.cores &&
                             then.renderer == machine.renderer && then.version == machine.version;
    const Points before = sharedPoints(earlier, now), after = sharedPoints(now, earlier);
    std::map<Key, PlacedPoint> known(before.begin(), before.end());
    std::vector<std::string> added;
    for (const auto& [key, point] : after) {
        const auto found = known.find(key);
        if (found == known.end()) {
            added.push_back(keyText(key));
            continue;
        }
        comparison.points.push_back(changeOf(key, found->second, point, options));
        known.erase(found);
    }
    if (earlier.quick != now.quick) return comparison;
    for (const auto& [key, point] : before)
        if (known.contains(key)) comparison.missing.push_back(keyText(key));
    comparison.missing.insert(comparison.missing.end(), added.begin(), added.end());
    return comparison;
}

bool isWorse(const RunComparison& comparison) {
    return std::ranges::any_of(comparison.points,
                               [](const PointChange& each) { return each.errorIsWorse || each.timeFails; });
}

std::string comparisonText(const RunComparison& comparison) {
    std::string errorLines, timeLines;
    std::size_t worse = 0, better = 0, slower = 0, faster = 0;
    std::vector<double> ratios;
    for (const PointChange& each : comparison.points) {
        if (each.errorIsWorse || each.errorIsBetter) {
            ++(each.errorIsWorse ? worse : better);
            errorLines += changeLine(each, each.errorIsWorse ? "worse" : "better",
                                     fmt::format("error {} -> {}", withUnit(each.errorBefore, each.errorUnit),
                                                 withUnit(each.errorNow, each.errorUnit)));
        }
        if (each.timeRatio) ratios.push_back(*each.timeRatio);
        if (each.timeIsWorse || each.timeIsBetter) {
            ++(each.timeIsWorse ? slower : faster);
            timeLines += changeLine(each,
                                    each.timeFails     ? "worse"
                                    : each.timeIsWorse ? "slower"
                                                       : "faster",
                                    fmt::format("{:.2f} times as long", *each.timeRatio));
        }
    }
    std::string text = errorLines + timeLines;
    for (const std::string& each : comparison.missing)
        text += fmt::format("{:<7} {}: in one of the runs only\n", "missing", each);
    text += fmt::format(
        "{} points in both runs: error worse at {}, better at {}; time beyond the spread: "
        "longer at {}, shorter at {}",
        comparison.points.size(), worse, better, slower, faster);
    if (!ratios.empty()) {
        std::ranges::sort(ratios);
        text += fmt::format(", median ratio {:.3f}", ratios[ratios.size() / 2]);
    }
    text += "\n";
    if (!comparison.sameMachine) text += "the runs come from different machines or drivers\n";
    return text;
}

}  // namespace glibra::bench
