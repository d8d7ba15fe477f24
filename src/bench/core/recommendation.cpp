#include "bench/core/recommendation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "bench/core/fit.h"
#include "bench/core/front.h"

namespace glibra::bench {
namespace {

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
        return fmt::format("use {}, for every {}", best.curve->name, figure.settingName);
    return fmt::format("use {}, the best choice over all settings of {} together, and for {} of {} alone",
                       best.curve->name, figure.settingName, best.best, smallest.size());
}

}  // namespace

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
