#include "bench/core/front.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

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

}  // namespace glibra::bench
