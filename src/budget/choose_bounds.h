#pragma once
// Chooses the values of the variables that a scene declares with Bound, such as the steps of a ray marcher or
// the size of a shadow map: the cheapest ones whose picture is within the bound of that of the finest ones.
//
// Nothing is known of what a program does with such a value, so every value that is chosen has been measured,
// together with those of the other variables, against a picture of the finest values.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "budget/decision.h"

namespace glibra::budget {

struct BoundVariable {
    std::string name;
    double coarsest = 0, current = 0, finest = 0;  ///< the ends are above 0; finest may be the smaller one
    bool isWhole = false;                          ///< only whole numbers are chosen
    bool isGiven = false;                          ///< --set states its value, which is kept
    Place place;
};

/// How far a picture is from that of the finest values.
struct PictureChange {
    double pixels = 0;   ///< how far contours are off
    double colored = 0;  ///< the share of the pixels, 0..1, that have another colour for another reason
};

struct BoundRequest {
    std::vector<BoundVariable> variables;
    double maxError = 0;    ///< pixels, above 0
    double resolution = 0;  ///< pixels: smaller changes are not measured
    std::string how{};      ///< "at 0 s, in pictures of 320 x 240", for the decisions
    /// Measures the picture with these values, one for each variable, against that of the finest ones.
    /// Diagnostics if one of them cannot be drawn.
    std::function<Result<PictureChange>(std::span<const double> values, std::span<const double> finest)>
        change;
};

struct ChosenBounds {
    std::vector<double> values;  ///< one for each variable; those that are not chosen are current
    std::vector<Decision> decisions;
    Diagnostics diagnostics;  ///< draw-W07 about a variable: the bound cannot be kept
};

/// The values that may be chosen, from the coarsest to the finest: each is twice or half the one before, up
/// to rounding.
std::vector<double> boundSteps(const BoundVariable& variable);

/// Chooses values. The error of the finest values themselves is estimated by the picture in which all
/// variables are one step coarser, and is part of the error that the bound limits. A variable whose last step
/// alone changes the picture by more than the bound is not chosen; nothing is chosen if a picture cannot be
/// drawn. Decisions and draw-W07 say why.
ChosenBounds chooseBounds(const BoundRequest& request);

}  // namespace glibra::budget
