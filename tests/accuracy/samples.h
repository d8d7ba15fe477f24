#pragma once
// Small reports made by hand, and a shortcut to the figures of a subject.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/core/run.h"

namespace glibra::bench::test {

inline Point pointAt(double setting, double error) {
    return {.setting = setting, .label = std::to_string(static_cast<int>(setting)), .error = error};
}

inline Point timedPoint(double setting, double error, double seconds) {
    Point point = pointAt(setting, error);
    point.time = Timing{seconds, .9 * seconds, 1.1 * seconds, 7};
    return point;
}

/// One subject with two curves, with times and memory at some points, and with names that need quoting.
Report sampleReport();

/// The figures of a subject in a quick run.
inline std::vector<Figure> quickFigures(Bench::Measure measure) {
    Bench bench({.quick = true});
    std::vector<Figure> figures;
    bench.attempt([&] { figures = measure(bench); });
    for (const Diagnostic& each : bench.problems()) ADD_FAILURE() << toString(each);
    return figures;
}

inline const Figure& figureOf(const std::vector<Figure>& figures, std::string_view name) {
    const auto found = std::ranges::find(figures, name, &Figure::name);
    if (found == figures.end()) throw std::out_of_range("no figure " + std::string(name));
    return *found;
}

/// Null if there is none, for what not every driver has.
inline const Curve* findCurve(const Figure& figure, std::string_view name) {
    const auto found = std::ranges::find(figure.curves, name, &Curve::name);
    return found == figure.curves.end() ? nullptr : &*found;
}
inline const Curve& curveOf(const Figure& figure, std::string_view name) {
    if (const Curve* found = findCurve(figure, name)) return *found;
    throw std::out_of_range("no curve " + std::string(name));
}

/// Tests of the figures of a subject, which is measured once, in a quick run.
template <auto measure>
class FiguresOf : public testing::Test {
  protected:
    static void SetUpTestSuite() { figures = quickFigures(measure); }
    static void TearDownTestSuite() { figures.clear(); }
    static const Figure& figure(std::string_view name) { return figureOf(figures, name); }
    static const Curve& curve(std::string_view in, std::string_view name) {
        return curveOf(figure(in), name);
    }
    static inline std::vector<Figure> figures;
};

/// Checks that names are unique, texts are not empty, errors are measurable and not negative, and labels of a
/// curve are unique.
void expectSound(const std::vector<Figure>& figures);

}  // namespace glibra::bench::test
