#pragma once
// Run time against error as values: curves of measured points.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
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
    double error =
        0;  ///< against the reference, in the figure's errorUnit, never negative; NaN: not measurable
    std::optional<Timing> time{};  ///< absent if the cost is too small to measure
    std::optional<double>
        memory{};  ///< bytes of the data that the method works on: vertices, texels, pixels, state
    std::optional<double> gpuTime{};  ///< seconds that the device works for a picture; absent: not measured
    bool isOnFront =
        false;  ///< no other point of the figure is both as cheap and more accurate; set by the run
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
    std::string name;         ///< unique within the subject, lower case with hyphens: "sphere-position"
    std::string title;        ///< "Sphere: distance of the mesh from the surface"
    std::string settingName;  ///< "slices"
    std::string errorName;    ///< "largest distance"
    std::string errorUnit;    ///< "radii", "pixels", "1/255", "" for a ratio
    std::string reference;  ///< what the error is measured against, and why that is independent of the method
    std::vector<Curve> curves{};
    std::vector<std::string>
        findings{};  ///< sentences computed from the figures: "error falls as slices^-2.00"
    Alternatives alternatives = Alternatives::figure;
    bool countsWrong = false;  ///< the error is the share of rays, pixels ... that are wrong
};

/// The curve of that name, which is added if there is none.
inline Curve& curveNamed(Figure& figure, std::string_view name) {
    for (Curve& each : figure.curves)
        if (each.name == name) return each;
    return figure.curves.emplace_back(Curve{.name = std::string(name)});
}

}  // namespace glibra::bench
