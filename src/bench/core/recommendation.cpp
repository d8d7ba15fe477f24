#include "bench/core/recommendation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "bench/core/fit.h"
#include "bench/core/front.h"

namespace glibra::bench {
namespace {

struct Choice {
    const Curve* curve;
    const Point* point;
};

double costOf(const Choice& choice, bool timed) {
    return timed ? choice.point->time->median : std::abs(choice.point->setting);
}

std::string describe(const Choice& choice, const Figure& figure) {
    std::string text = fmt::format("{} ({}", choice.curve->name, choice.point->label);
    text += fmt::format("): {} {}", figure.errorName, numberText(choice.point->error));
    if (!figure.errorUnit.empty()) text += " " + figure.errorUnit;
    if (choice.point->time) text += fmt::format(" in {}", secondsText(choice.point->time->median));
    return text;
}

/// What to use of the points of one front.
std::string choose(const std::vector<Choice>& front, const Figure& figure, bool timed) {
    const auto cost = [&](const Choice& each) { return costOf(each, timed); };
    const auto value = [&](const Choice& each) { return cost(each) * each.point->error; };
    const Choice best = *std::ranges::min_element(front, {}, value);
    const Choice cheapest = *std::ranges::min_element(front, {}, cost);
    const Choice finest =
        *std::ranges::min_element(front, {}, [](const Choice& each) { return each.point->error; });
    std::string text = "use " + describe(best, figure);
    if (finest.point != best.point) text += "; most accurate is " + describe(finest, figure);
    if (cheapest.point != best.point) text += "; cheapest is " + describe(cheapest, figure);
    return text;
}

/// The curve that is on the fronts of most settings.
std::string chooseCurve(const std::vector<Choice>& front, const Figure& figure) {
    std::map<const Curve*, std::set<double>> settings;
    std::set<double> all;
    for (const Choice& each : front) {
        settings[each.curve].insert(each.point->setting);
        all.insert(each.point->setting);
    }
    const Curve* best = nullptr;
    for (const Curve& each : figure.curves)
        if (settings.contains(&each) && (!best || settings[&each].size() > settings[best].size()))
            best = &each;
    const std::size_t count = settings[best].size();
    if (count == all.size()) return fmt::format("use {}, for every {}", best->name, figure.settingName);
    return fmt::format("use {}, the best choice for {} of {} settings of {}", best->name, count, all.size(),
                       figure.settingName);
}

}  // namespace

std::string recommendation(const Figure& figure) {
    std::vector<Choice> front;
    for (const Curve& curve : figure.curves)
        for (const Point& point : curve.points)
            if (point.isOnFront && std::isfinite(point.error)) front.push_back({&curve, &point});
    if (figure.alternatives == Alternatives::none || front.size() < 2) return {};
    if (figure.alternatives == Alternatives::setting) return "In short: " + chooseCurve(front, figure);
    const bool timed = isTimed(figure);
    if (figure.alternatives == Alternatives::figure) return "In short: " + choose(front, figure, timed);
    std::string text;
    for (const Curve& curve : figure.curves) {
        std::vector<Choice> own;
        std::ranges::copy_if(front, std::back_inserter(own),
                             [&](const Choice& each) { return each.curve == &curve; });
        if (own.size() < 2) continue;
        const auto value = [&](const Choice& each) { return costOf(each, timed) * each.point->error; };
        text += (text.empty() ? "" : "; ") + describe(*std::ranges::min_element(own, {}, value), figure);
    }
    return text.empty() ? text : "In short: use " + text;
}

}  // namespace glibra::bench
