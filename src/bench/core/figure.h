#pragma once
// Run time against error as values: curves of measured points, what is fitted to them, and what they advise.

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glibra::bench {

/// Repeated measurements of one piece of work, in seconds.
struct Timing {
    double median = 0;
    double low = 0;   ///< 25th percentile
    double high = 0;  ///< 75th percentile
    int repeats = 0;
};

/// The cost and the error of one setting.
struct Point {
    double setting = 0;  ///< what buys accuracy: slices, samples, texels per side
    std::string label;   ///< the setting in words: "64 slices", "8 bit"
    /// Against the reference, in the figure's errorUnit, never negative; NaN: not measurable.
    double error = 0;
    std::optional<Timing> time{};     ///< absent if the cost is too small to measure
    std::optional<double> memory{};   ///< bytes that the method works on: vertices, texels, pixels, state
    std::optional<double> gpuTime{};  ///< seconds that the device works for a picture; absent: not measured
    bool isOnFront = false;           ///< no alternative is as cheap and more accurate; set by the run
};

struct Curve {
    std::string name;  ///< the method: "trilinear, half float"
    std::vector<Point> points{};
    /// Index of the curve whose theory this is. A theory is not measured and is on no front.
    std::optional<std::size_t> theoryOf{};
    bool isForScenes = true;  ///< false: shown, but nothing that a scene can use
};

/// Which points of a figure can replace each other. A Pareto front consists of alternatives.
enum class Alternatives {
    figure,   ///< all points: settings buy accuracy on every curve
    curve,    ///< points of one curve: the curves do different jobs
    setting,  ///< points of one setting: a setting is a difficulty, such as a distance, and not a cost
    none      ///< no points: the setting is what the figure looks for, or the curves do different jobs
};

/// One diagram. Its curves share an error measure and a reference.
struct Figure {
    /// Adds a finding.
    template <class... Arguments>
    void note(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        findings.push_back(fmt::format(text, std::forward<Arguments>(arguments)...));
    }
    /// Adds a point to the curve of that name, which is added if there is none.
    Curve& add(std::string_view curve, Point point);
    /// The last point of a curve.
    [[nodiscard]] const Point& last(std::size_t curve) const { return curves[curve].points.back(); }
    /// Adds the order of each curve from number `first` on, but theories.
    void noteOrders(std::string_view setting, double from = 0, std::size_t first = 0);

    std::string name{};         ///< unique within the subject, lower case with hyphens: "sphere-position"
    std::string title{};        ///< "Sphere: distance of the mesh from the surface"
    std::string settingName{};  ///< "slices"
    std::string errorName{};    ///< "largest distance"
    std::string errorUnit{};    ///< "radii", "pixels", "1/255", "" for a ratio
    std::string
        reference{};  ///< what the error is measured against, and why that is independent of the method
    std::vector<Curve> curves{};
    std::vector<std::string> findings{};  ///< sentences about the points: "error falls as slices^-2.00"
    Alternatives alternatives = Alternatives::figure;
    bool countsWrong = false;  ///< the error is the share of rays, pixels ... that are wrong
};

/// The curve of that name, which is added if there is none.
inline Curve& curveNamed(Figure& figure, std::string_view name) {
    for (Curve& each : figure.curves)
        if (each.name == name) return each;
    return figure.curves.emplace_back(Curve{.name = std::string(name)});
}

/// The slope of log(error) over log(setting) by least squares: the order p of error ~ setting^p. Only points
/// with a finite error above 0 and a setting within [from, to] are used; NaN for fewer than two of them.
double fittedOrder(const Curve& curve, double from = 0, double to = std::numeric_limits<double>::infinity());

/// "sphere: error falls as slices^-2.00", "rises as", or "does not depend on" for orders within .05 of 0;
/// "cannot be fitted" if fittedOrder is NaN.
std::string orderSentence(const Curve& curve, std::string_view settingName, double from = 0,
                          double to = std::numeric_limits<double>::infinity());

/// The same for angles in degrees. If all are below 1e-4, which float rounding makes of exact normals:
/// "sphere: within 3e-06 degrees, the rounding of float".
std::string angleSentence(const Curve& degrees, std::string_view settingName, double from = 0);

/// Three significant digits: "0.00123", "1.5e-07"; "not measurable" for NaN.
std::string numberText(double value);
/// "4 ns", "12.3 us", "1.5 ms", "2.1 s"; microseconds with the Greek letter if `greek`.
std::string secondsText(double seconds, bool greek = false);
/// "17 bytes", "2.1 KiB", "300 MiB".
std::string bytesText(double bytes);

/// True if the cost on a front is the median time, because every point with an error has one. Otherwise the
/// setting is the cost.
bool isTimed(const Figure& figure);

/// Sets Point::isOnFront: no alternative to the point is at least as cheap and as accurate, and better in one
/// of the two. Times are equally cheap if their spreads (25 to 75 %) overlap or they differ by less than 2 %,
/// so that a point that is only a little faster does not excuse a large error. A point without an error is
/// never on a front.
void markFront(Figure& figure);

/// One sentence that says what to use: the point with the smallest product of cost and error, with what the
/// most accurate and the cheapest one would give instead. Products within a factor of 1.5 are equal, and the
/// most accurate of equal ones is used, so that the sentence is the same in the next run. Where settings are
/// difficulties (Alternatives::setting), the curve with the smallest geometric mean of the products. Curves
/// that scenes cannot use are left out, and so are wrong answers: angles of more than 5 degrees, and more
/// than 1 of 100 that is wrong (Figure::countsWrong). Empty if nothing is to be chosen.
std::string recommendation(const Figure& figure);

}  // namespace glibra::bench
