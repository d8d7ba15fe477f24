#include "bench/report/reports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/page_template.h"
#include "base/text.h"
#include "embedded/bench_page.h"

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

namespace {

enum class Abscissa { setting, time };

// In units of the SVG's coordinates.
constexpr double kPlotWidth = 560, kPlotHeight = 380;
constexpr double kLeft = 52, kRight = 14, kTop = 28, kBottom = 54;
constexpr double kSign = 4.2;  ///< half the size of a point's symbol
constexpr std::size_t kStyles = 9;

struct Placed {
    const Point* point = nullptr;
    const Curve* curve = nullptr;
    double x = 0, y = 0, lowX = 0, highX = 0;
};

bool isDrawn(const Point& point, Abscissa abscissa) {
    return std::isfinite(point.error) &&
           (abscissa == Abscissa::setting ? point.setting > 0 : point.time.has_value());
}

double abscissaOf(const Point& point, Abscissa abscissa) {
    return abscissa == Abscissa::setting ? point.setting : point.time->median;
}

/// Circle, square, triangle, diamond, then from the start again.
std::string sign(std::size_t index, double x, double y, std::string_view attributes) {
    const double s = kSign;
    switch (index % 4) {
        case 0:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"{}/>", x, y, s, attributes);
        case 1:
            return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"{}/>",
                               x - .9 * s, y - .9 * s, 1.8 * s, 1.8 * s, attributes);
        case 2:
            return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"{}/>", x, y - 1.2 * s,
                               x + 1.1 * s, y + .8 * s, x - 1.1 * s, y + .8 * s, attributes);
        default:
            return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\"{}/>", x,
                               y - 1.3 * s, x + 1.3 * s, y, x, y + 1.3 * s, x - 1.3 * s, y, attributes);
    }
}

std::string tip(const Figure& figure, const Curve& curve, const Point& point) {
    std::string text =
        fmt::format("{}\n{}\n{}: {}{}{}", curve.name, point.label, figure.errorName, numberText(point.error),
                    figure.errorUnit.empty() ? "" : " ", figure.errorUnit);
    if (point.time)
        text += fmt::format("\ntime: {} ({} to {}, {} measurements)", secondsText(point.time->median, true),
                            secondsText(point.time->low, true), secondsText(point.time->high, true),
                            point.time->repeats);
    if (point.memory) text += "\nmemory: " + bytesText(*point.memory);
    if (point.isOnFront) text += "\non the Pareto front";
    return base::escapeXml(text);
}

std::string gridLines(const LogAxis& across, const LogAxis& up, bool hasZero) {
    const double right = kPlotWidth - kRight, floor = kPlotHeight - kBottom;
    std::string svg = "<g class=\"grid\">";
    std::string labels = "<g class=\"ticks\">";
    for (const Tick& tick : across.ticks()) {
        const double x = kLeft + tick.place * (right - kLeft);
        svg += fmt::format("<path d=\"M{0:.1f} {1}V{2}\"/>", x, kTop, floor);
        labels += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", x, floor + 21,
                              tick.label);
    }
    for (const Tick& tick : up.ticks()) {
        const double y = floor - tick.place * (floor - kTop);
        svg += fmt::format("<path d=\"M{0} {1:.1f}H{2}\"/>", kLeft, y, right);
        labels += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", kLeft - 7, y + 4,
                              tick.label);
    }
    if (hasZero)
        labels += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">0</text>", kLeft - 7, floor + 4);
    return svg +
           fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></g>", kLeft, kTop, right - kLeft,
                       floor - kTop) +
           labels + "</g>";
}

/// The name of the vertical axis is above the axis, where long names have room.
std::string axisNames(const Figure& figure, Abscissa abscissa) {
    const std::string across = abscissa == Abscissa::setting ? figure.settingName : "time in seconds";
    const std::string up = figure.errorUnit.empty()
                               ? figure.errorName
                               : fmt::format("{} ({})", figure.errorName, figure.errorUnit);
    return fmt::format(
        "<g class=\"names\"><text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>"
        "<text x=\"{}\" y=\"{}\">{}</text></g>",
        kLeft + (kPlotWidth - kRight - kLeft) / 2, kPlotHeight - 12, base::escapeXml(across), kLeft,
        kTop - 10, base::escapeXml(up));
}

std::string pathThrough(const std::vector<Placed>& points, std::string_view style) {
    if (points.size() < 2) return {};
    std::string path;
    for (const Placed& each : points)
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", each.x, each.y);
    return fmt::format("<path class=\"{}\" d=\"{}\"/>", style, path);
}

/// A step line: between two points of the front, the cheaper one is the best at its cost.
std::string frontLine(std::vector<Placed> points) {
    std::erase_if(points, [](const Placed& each) { return !each.point->isOnFront; });
    if (points.size() < 2) return {};
    std::ranges::sort(points, {}, &Placed::x);
    std::string path = fmt::format("M{:.1f} {:.1f}", points[0].x, points[0].y);
    for (std::size_t i = 1; i < points.size(); ++i)
        path += fmt::format("H{:.1f}V{:.1f}", points[i].x, points[i].y);
    return fmt::format("<path class=\"front\" d=\"{}\"/>", path);
}

/// A theory has the colour of the curve it belongs to.
std::size_t styleOf(const Figure& figure, std::size_t index) {
    return figure.curves[index].theoryOf.value_or(index) % kStyles;
}

/// Where settings are difficulties, costs hardly differ between them, and a line would zigzag.
bool isJoined(const Figure& figure, Abscissa abscissa) {
    return abscissa == Abscissa::setting || figure.alternatives != Alternatives::setting;
}

std::string curveSvg(const Figure& figure, std::size_t index, const std::vector<Placed>& points,
                     Abscissa abscissa) {
    std::string svg = fmt::format("<g class=\"curve c{}\" data-curve=\"{}\">", styleOf(figure, index), index);
    if (figure.curves[index].theoryOf) return svg + pathThrough(points, "line theory") + "</g>";
    if (isJoined(figure, abscissa)) svg += pathThrough(points, "line");
    for (const Placed& each : points)
        if (each.highX > each.lowX)
            svg += fmt::format("<path class=\"spread\" d=\"M{0:.1f} {2:.1f}H{1:.1f}\"/>", each.lowX,
                               each.highX, each.y);
    for (const Placed& each : points)
        svg += sign(index, each.x, each.y,
                    fmt::format(" class=\"point{}\" tabindex=\"0\" data-tip=\"{}\"",
                                each.point->isOnFront ? " on" : "", tip(figure, *each.curve, *each.point)));
    return svg + "</g>";
}

/// Plots the error over the setting or over the median time. Points without an error (or without a time) are
/// left out; an error of 0 is on the lower edge. Points on the front are filled, and a step line joins them
/// in the diagram of their cost. A bar shows the spread of a time. A theory is a dotted line without symbols.
/// Each point carries its values as data-tip. Empty if there are no points to plot.
std::string plot(const Figure& figure, Abscissa abscissa) {
    std::vector<double> costs, errors;
    for (const Curve& curve : figure.curves)
        for (const Point& point : curve.points) {
            if (!isDrawn(point, abscissa)) continue;
            costs.push_back(abscissaOf(point, abscissa));
            errors.push_back(point.error);
        }
    if (costs.empty()) return {};
    const LogAxis across(costs, 8), up(errors, 9);
    const double right = kPlotWidth - kRight, floor = kPlotHeight - kBottom;
    const auto placeX = [&](double cost) { return kLeft + across.place(cost) * (right - kLeft); };

    const bool hasFront = isTimed(figure) == (abscissa == Abscissa::time);
    std::string curves, fronts;
    std::vector<Placed> all;
    for (std::size_t i = 0; i < figure.curves.size(); ++i) {
        std::vector<Placed> points;
        for (const Point& point : figure.curves[i].points) {
            if (!isDrawn(point, abscissa)) continue;
            Placed placed{&point, &figure.curves[i]};
            placed.x = placed.lowX = placed.highX = placeX(abscissaOf(point, abscissa));
            placed.y = floor - up.place(point.error) * (floor - kTop);
            if (abscissa == Abscissa::time) {
                placed.lowX = placeX(point.time->low);
                placed.highX = placeX(point.time->high);
            }
            points.push_back(placed);
        }
        curves += curveSvg(figure, i, points, abscissa);
        all.insert(all.end(), points.begin(), points.end());
        if (hasFront && figure.alternatives == Alternatives::curve) fronts += frontLine(std::move(points));
    }
    if (hasFront && figure.alternatives == Alternatives::figure) fronts = frontLine(std::move(all));
    return fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} against {}\">",
                       kPlotWidth, kPlotHeight, base::escapeXml(figure.errorName),
                       abscissa == Abscissa::time ? "time" : base::escapeXml(figure.settingName)) +
           gridLines(across, up, std::ranges::find(errors, 0.) != errors.end()) +
           axisNames(figure, abscissa) + fronts + curves + "</svg>";
}

/// The symbol of curve `index` as a small picture for a legend.
std::string legendSign(const Figure& figure, std::size_t index) {
    const bool isTheory = figure.curves[index].theoryOf.has_value();
    return fmt::format(
        "<svg class=\"sign\" viewBox=\"0 0 26 12\" aria-hidden=\"true\"><g class=\"curve c{}\">"
        "<path class=\"line{}\" d=\"M1 6H25\"/>{}</g></svg>",
        styleOf(figure, index), isTheory ? " theory" : "",
        isTheory ? std::string() : sign(index, 13, 6, " class=\"point on\""));
}

std::vector<base::Fields> machineRows(const Report& report) {
    const Machine& machine = report.machine;
    return base::titledRows(
        {{"Processor", machine.processor},
         {"Cores", machine.cores > 0 ? std::to_string(machine.cores) : ""},
         {"Memory", machine.memory > 0 ? bytesText(machine.memory) : ""},
         {"System", machine.system},
         {"Compiler", machine.compiler},
         {"OpenGL", machine.driver.empty() ? "no driver" : machine.renderer + ", " + machine.version},
         {"Opened by", machine.driver},
         {"glibra", report.glibra},
         {"Date", report.date},
         {"Extent", report.quick ? "quick: fewer settings and measurements" : ""}});
}

/// Escapes the text and raises exponents such as "^-2.00".
std::string withPowers(std::string_view text) {
    const std::string escaped = base::escapeXml(text);
    std::string html;
    for (std::size_t i = 0; i < escaped.size(); ++i) {
        const std::size_t end =
            escaped[i] == '^' ? std::min(escaped.find_first_not_of("-.0123456789", i + 1), escaped.size())
                              : i;
        if (end > i + 1) {
            html += fmt::format("<sup>{}</sup>", escaped.substr(i + 1, end - i - 1));
            i = end - 1;
        } else {
            html += escaped[i];
        }
    }
    return html;
}

std::vector<std::string> withPowers(const std::vector<std::string>& texts) {
    std::vector<std::string> html;
    for (const std::string& each : texts) html.push_back(withPowers(each));
    return html;
}

base::Fields pointFields(const Curve& curve, const Point& point) {
    const auto& time = point.time;
    return {{"isOnFront", point.isOnFront},
            {"curve", curve.name},
            {"label", point.label},
            {"error", numberText(point.error)},
            {"spread", time ? fmt::format("{} to {}, {} measurements", secondsText(time->low, true),
                                          secondsText(time->high, true), time->repeats)
                            : ""},
            {"time", time ? secondsText(time->median, true) : ""},
            {"gpuTime", point.gpuTime ? secondsText(*point.gpuTime, true) : ""},
            {"memory", point.memory ? bytesText(*point.memory) : ""}};
}

/// In the order of Alternatives.
constexpr std::string_view kFrontNotes[] = {
    "", " Each curve has a front of its own.",
    " Each setting has a front of its own: it is a difficulty, not a cost.",
    " There is no front, because nothing of it is to be chosen."};

base::Fields figureFields(const Figure& figure, const std::string& subject) {
    std::vector<base::Fields> curves, points;
    bool hasTime = false, hasMemory = false, hasGpuTime = false;
    for (const Curve& curve : figure.curves) {
        curves.push_back(
            {{"index", curves.size()}, {"sign", legendSign(figure, curves.size())}, {"curve", curve.name}});
        for (const Point& point : curve.points) {
            points.push_back(pointFields(curve, point));
            hasTime |= point.time.has_value();
            hasMemory |= point.memory.has_value();
            hasGpuTime |= point.gpuTime.has_value();
        }
    }
    return {{"id", subject + "." + figure.name},
            {"title", figure.title},
            {"findings", withPowers(figure.findings)},
            {"plots", plot(figure, Abscissa::setting) + plot(figure, Abscissa::time)},
            {"curves", std::move(curves)},
            {"reference", figure.reference},
            {"frontNote", kFrontNotes[static_cast<std::size_t>(figure.alternatives)]},
            {"count", points.size()},
            {"setting", figure.settingName},
            {"errorName", figure.errorName},
            {"unit", figure.errorUnit},
            {"hasTime", hasTime},
            {"hasGpuTime", hasGpuTime},
            {"hasMemory", hasMemory},
            {"points", std::move(points)}};
}

base::Fields subjectFields(const SubjectRun& subject) {
    std::vector<std::string> problems;
    for (const Diagnostic& each : subject.diagnostics) problems.push_back(toString(each));
    const auto figure = [&](const Figure& each) { return figureFields(each, subject.name); };
    return {{"name", subject.name},
            {"subject", subject.title},
            {"shortTitle", subject.title.substr(0, subject.title.find(':'))},
            {"problems", withPowers(problems)},
            {"figures", base::rowsOf(subject.figures, figure)}};
}

}  // namespace

LogAxis::LogAxis(std::span<const double> values, int mostLabels) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kMargin = .04, kNarrowest = .3, kMostSteps = 2.5;
    low_ = kInfinity;
    high_ = -kInfinity;
    for (const double value : values)
        if (value > 0 && std::isfinite(value)) {
            low_ = std::min(low_, std::log10(value));
            high_ = std::max(high_, std::log10(value));
        }
    if (low_ > high_) low_ = 0, high_ = 1;
    const double lacking = std::max(0., kNarrowest - (high_ - low_));
    const double margin = kMargin * (high_ - low_) + lacking / 2;
    low_ -= margin;
    high_ += margin;
    if (high_ - low_ < kMostSteps)
        addSteps();
    else
        addDecades(mostLabels);
}

double LogAxis::place(double value) const {
    if (!(value > 0)) return 0;
    return std::clamp((std::log10(value) - low_) / (high_ - low_), 0., 1.);
}

/// "0.001", "20", "5000"; beyond 1e-3 .. 1e5 as a power of ten with a raised exponent (an SVG tspan).
static std::string tickLabel(double value) {
    if (value >= .999e-3 && value < 1e5) return fmt::format("{:.6g}", value);
    const int decade = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    const double digit = value / std::pow(10., decade);
    const std::string power = fmt::format("10<tspan class=\"power\" dy=\"-5\">{}</tspan>", decade);
    return std::abs(digit - 1) < 1e-6 ? power : fmt::format("{:.3g}\u00b7{}", digit, power);
}

void LogAxis::addDecades(int mostLabels) {
    const int first = static_cast<int>(std::ceil(low_)), last = static_cast<int>(std::floor(high_));
    const int every = std::max(1, (last - first + mostLabels) / mostLabels);
    for (int decade = first; decade <= last; ++decade)
        ticks_.push_back({(decade - low_) / (high_ - low_),
                          decade % every == 0 ? tickLabel(std::pow(10., decade)) : std::string()});
}

void LogAxis::addSteps() {
    constexpr std::size_t kFewest = 3;
    addDigits(std::array{1., 2., 5.});
    if (ticks_.size() >= kFewest) return;
    ticks_.clear();
    addDigits(std::array{1., 1.2, 1.5, 2., 3., 4., 5., 7.});
}

void LogAxis::addDigits(std::span<const double> digits) {
    for (int decade = static_cast<int>(std::floor(low_)); decade <= static_cast<int>(std::floor(high_));
         ++decade)
        for (const double digit : digits) {
            const double logarithm = decade + std::log10(digit);
            if (logarithm < low_ || logarithm > high_) continue;
            ticks_.push_back({(logarithm - low_) / (high_ - low_), tickLabel(digit * std::pow(10., decade))});
        }
}

std::string htmlReport(const Report& report, const RunComparison* comparison) {
    std::size_t figures = 0, points = 0;
    for (const SubjectRun& subject : report.subjects) {
        figures += subject.figures.size();
        for (const Figure& figure : subject.figures)
            for (const Curve& curve : figure.curves) points += curve.points.size();
    }
    const base::Fields fields = {
        {"style", bench_page::bench_css()},
        {"script", bench_page::bench_js()},
        {"extent", base::counted(report.subjects.size(), "subject") + ", " +
                       base::counted(figures, "diagram") + ", " + base::counted(points, "measured point")},
        {"machine", machineRows(report)},
        {"comparison", comparison ? comparisonText(*comparison) : ""},
        {"isWorse", comparison && isWorse(*comparison)},
        {"subjects", base::rowsOf(report.subjects, subjectFields)},
    };
    return base::filled(bench_page::page_html(), fields);
}

}  // namespace glibra::bench
