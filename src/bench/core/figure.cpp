#include "bench/core/figure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

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

/// Products of cost and error within this factor are equal, so that the noise of times decides nothing.
constexpr double kAlike = 1.5;

struct Choice {
    const Curve* curve = nullptr;
    const Point* point = nullptr;
    double cost = 1, error = 0;  ///< as they count
    [[nodiscard]] double product() const { return cost * error; }
};

/// An error above this is a wrong answer, which nothing can make worth its cost.
double largestUsable(const Figure& figure) {
    constexpr double kDegrees = 5, kShare = .01;
    if (figure.errorUnit == "degrees") return kDegrees;
    return figure.countsWrong ? kShare : std::numeric_limits<double>::infinity();
}

/// What may be recommended. Errors below the smallest one above 0 count as that.
std::vector<Choice> choicesOf(const Figure& figure) {
    const bool timed = isTimed(figure);
    const double usable = largestUsable(figure);
    double least = 1;
    for (const Curve& curve : figure.curves)
        for (const Point& each : curve.points)
            if (each.error > 0 && !curve.theoryOf) least = std::min(least, each.error);
    std::vector<Choice> choices;
    for (const Curve& curve : figure.curves)
        for (const Point& each : curve.points) {
            if (curve.theoryOf || !curve.isForScenes || !std::isfinite(each.error) || each.error > usable)
                continue;
            // Where settings are difficulties, they cost nothing.
            const double cost = timed                                          ? each.time->median
                                : figure.alternatives == Alternatives::setting ? 1
                                                                               : std::abs(each.setting);
            choices.push_back({&curve, &each, cost, std::max(each.error, least)});
        }
    return choices;
}

std::string describe(const Choice& choice, const Figure& figure) {
    std::string text = fmt::format("{} ({}", choice.curve->name, choice.point->label);
    text += fmt::format("): {} {}", figure.errorName, numberText(choice.point->error));
    if (!figure.errorUnit.empty()) text += " " + figure.errorUnit;
    if (choice.point->time) text += fmt::format(" in {}", secondsText(choice.point->time->median));
    return text;
}

/// The most accurate of those whose product is alike the smallest.
const Choice& bestOf(std::span<const Choice> choices) {
    const double smallest = std::ranges::min_element(choices, {}, &Choice::product)->product();
    return *std::ranges::min_element(choices, {}, [&](const Choice& each) {
        return std::tuple(each.product() > kAlike * smallest, each.error, each.cost);
    });
}

/// What to use of the choices of one figure.
std::string choosePoint(std::span<const Choice> choices, const Figure& figure) {
    const Choice& best = bestOf(choices);
    const Choice& finest = *std::ranges::min_element(
        choices, {}, [](const Choice& each) { return std::pair(each.error, each.cost); });
    const Choice& cheapest = *std::ranges::min_element(
        choices, {}, [](const Choice& each) { return std::pair(each.cost, each.error); });
    std::string text = "use " + describe(best, figure);
    if (finest.point != best.point) text += "; most accurate is " + describe(finest, figure);
    if (cheapest.point != best.point) text += "; cheapest is " + describe(cheapest, figure);
    return text;
}

/// What to use on each curve.
std::string chooseOnEach(std::span<const Choice> choices, const Figure& figure) {
    std::string text;
    for (const Curve& curve : figure.curves) {
        std::vector<Choice> own;
        for (const Choice& each : choices)
            if (each.curve == &curve) own.push_back(each);
        if (own.size() < 2) continue;
        text += (text.empty() ? "use " : "; ") + describe(bestOf(own), figure);
    }
    return text;
}

/// The curve with the best mean over the settings, among those that can be used at most of them.
std::string chooseCurve(std::span<const Choice> choices, const Figure& figure) {
    std::map<double, double> smallest;  // products by setting
    for (const Choice& each : choices) {
        const auto known = smallest.try_emplace(each.point->setting, each.product()).first;
        known->second = std::min(known->second, each.product());
    }
    struct Mean {
        const Curve* curve = nullptr;
        int settings = 0, best = 0;
        double product = 0, error = 0;  ///< sums of logarithms
    };
    std::vector<Mean> means;
    for (const Curve& curve : figure.curves) {
        Mean& mean = means.emplace_back(Mean{&curve});
        for (const Choice& each : choices) {
            if (each.curve != &curve) continue;
            const double ratio = each.product() / smallest.at(each.point->setting);
            ++mean.settings;
            mean.best += ratio <= kAlike ? 1 : 0;
            mean.product += std::log(ratio);
            mean.error += std::log(each.error);
        }
    }
    const int most = std::ranges::max_element(means, {}, &Mean::settings)->settings;
    std::erase_if(means, [&](const Mean& each) { return each.settings < most; });
    if (means.size() < 2 && figure.curves.size() < 2) return {};
    const double least = std::ranges::min_element(means, {}, &Mean::product)->product;
    const Mean& best = *std::ranges::min_element(means, {}, [&](const Mean& each) {
        return std::pair(each.product > least + most * std::log(kAlike), each.error);
    });
    if (best.best == static_cast<int>(smallest.size()))
        return fmt::format("use {}, at all settings of {}", best.curve->name, figure.settingName);
    return fmt::format("use {}, the best choice over all settings of {} together, and for {} of {} alone",
                       best.curve->name, figure.settingName, best.best, smallest.size());
}

}  // namespace

Curve& Figure::add(std::string_view curve, Point point) {
    Curve& to = curveNamed(*this, curve);
    to.points.push_back(std::move(point));
    return to;
}

void Figure::noteOrders(std::string_view setting, double from, std::size_t first) {
    for (std::size_t i = first; i < curves.size(); ++i)
        if (!curves[i].theoryOf) findings.push_back(orderSentence(curves[i], setting, from));
}

double fittedOrder(const Curve& curve, double from, double to) {
    double count = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
    for (const Point& point : curve.points) {
        if (!(point.error > 0) || std::isinf(point.error) || !(point.setting > 0)) continue;
        if (point.setting < from || point.setting > to) continue;
        const double x = std::log(point.setting), y = std::log(point.error);
        count += 1;
        sumX += x;
        sumY += y;
        sumXX += x * x;
        sumXY += x * y;
    }
    const double spread = count * sumXX - sumX * sumX;
    if (count < 2 || !(spread > 0)) return std::numeric_limits<double>::quiet_NaN();
    return (count * sumXY - sumX * sumY) / spread;
}

std::string orderSentence(const Curve& curve, std::string_view settingName, double from, double to) {
    constexpr double kFlat = .05;
    const double order = fittedOrder(curve, from, to);
    if (std::isnan(order)) return fmt::format("{}: the order of the error cannot be fitted", curve.name);
    if (std::abs(order) < kFlat)
        return fmt::format("{}: error does not depend on {}", curve.name, settingName);
    return fmt::format("{}: error {} as {}^{:.2f}", curve.name, order < 0 ? "falls" : "rises", settingName,
                       order);
}

std::string angleSentence(const Curve& degrees, std::string_view settingName, double from) {
    constexpr double kRounding = 1e-4;
    double largest = 0;
    for (const Point& each : degrees.points) largest = std::max(largest, each.error);
    if (largest >= kRounding) return orderSentence(degrees, settingName, from);
    return fmt::format("{}: within {} degrees, the rounding of float", degrees.name, numberText(largest));
}

std::string numberText(double value) {
    return std::isnan(value) ? "not measurable" : fmt::format("{:.3g}", value);
}

std::string secondsText(double seconds, bool greek) {
    if (seconds < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
    if (seconds < 1e-3) return fmt::format("{:.3g} {}s", seconds * 1e6, greek ? "\u00b5" : "u");
    if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
    return fmt::format("{:.3g} s", seconds);
}

std::string bytesText(double bytes) {
    constexpr double kStep = 1024;
    if (bytes < kStep) return fmt::format("{:.0f} bytes", bytes);
    for (const char* unit : {"KiB", "MiB"}) {
        bytes /= kStep;
        if (bytes < kStep) return fmt::format("{:.3g} {}", bytes, unit);
    }
    return fmt::format("{:.3g} GiB", bytes / kStep);
}

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

std::string recommendation(const Figure& figure) {
    if (figure.alternatives == Alternatives::none) return {};
    const std::vector<Choice> choices = choicesOf(figure);
    if (choices.size() < 2) return {};
    const std::string text = figure.alternatives == Alternatives::figure  ? choosePoint(choices, figure)
                             : figure.alternatives == Alternatives::curve ? chooseOnEach(choices, figure)
                                                                          : chooseCurve(choices, figure);
    return text.empty() ? text : "In short: " + text;
}

}  // namespace glibra::bench
