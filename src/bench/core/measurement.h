#pragma once
// Run time against error, as values: curves of measured points.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace glibra::bench {

/// Repeated measurements of one piece of work, in seconds.
struct Timing {
    double median = 0;
    double low = 0;   ///< 25th percentile
    double high = 0;  ///< 75th percentile
    int repeats = 0;
};

/// What one setting costs and how wrong it is.
struct Point {
    double setting = 0;  ///< what accuracy is bought with: slices, samples, texels a side
    std::string label;   ///< the setting for people: "64 slices", "8 bit"
    double error =
        0;  ///< against the reference, in the figure's errorUnit, never negative; NaN: not measurable
    std::optional<Timing> time{};    ///< absent where the cost cannot be told apart from nothing
    std::optional<double> memory{};  ///< bytes of the data that it works on: vertices, texels, pixels, state
    bool isOnFront =
        false;  ///< no other point of the figure is both as cheap and more accurate; set by the run
};

struct Curve {
    std::string name;  ///< the method: "trilinear, half float"
    std::vector<Point> points{};
    /// Index of the curve that this is the theory of: nothing measured, and on no front.
    std::optional<std::size_t> theoryOf{};
};

/// Which points of a figure could stand for one another. A Pareto front is one of alternatives.
enum class Alternatives {
    figure,   ///< all of them: settings buy accuracy, whatever the curve
    curve,    ///< those of a curve: the curves do different jobs
    setting,  ///< those of a setting: settings are no price but a difficulty, such as a distance
    none      ///< none: the setting is neither, but what is looked for
};

/// One diagram: the curves share an error measure and a reference.
struct Figure {
    std::string name;         ///< unique in the subject, lower case with hyphens: "sphere-position"
    std::string title;        ///< "Sphere: distance of the mesh from the surface"
    std::string settingName;  ///< "slices"
    std::string errorName;    ///< "largest distance"
    std::string errorUnit;    ///< "radii", "pixels", "1/255", "" for a ratio
    std::string reference;  ///< what the error is measured against, and why it shares nothing with the method
    std::vector<Curve> curves{};
    std::vector<std::string>
        findings{};  ///< sentences computed from the figures: "error falls as slices^-2.00"
    Alternatives alternatives = Alternatives::figure;
};

}  // namespace glibra::bench
