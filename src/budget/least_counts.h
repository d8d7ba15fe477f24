#pragma once
// The cheapest counts of a primitive that keep a bound.

#include <array>
#include <cstdint>
#include <vector>

#include "budget/surface_model.h"

namespace glibra::budget {

/// No mesh is made larger than this: finer ones cost more than any picture shows, and their vertices lie
/// apart by little more than a float's rounding.
inline constexpr std::uint64_t kMostBudgetVertices = 1'048'576;

/// What is wanted of one mesh.
struct CountsRequest {
    const SurfaceModel* model = nullptr;
    std::vector<double> numbers;     ///< complete, as the scene or the language has them
    std::array<bool, 2> isFree{};    ///< of model->counts: it may be chosen
    std::array<int, 2> least{1, 1};  ///< it is not chosen smaller
    Fidelity fidelity = Fidelity::shape;
    double allowed = 0;  ///< largest deviation in model units; infinity: any
};

struct LeastCounts {
    std::vector<double> numbers;
    double deviation = 0;  ///< by the model, model units
    bool isKept = false;   ///< deviation <= allowed
};

/// Of all counts that keep the bound those with the fewest vertices. Where none do, isKept is false: if a
/// count that is not free is too small, the others are as if it were free; else kMostBudgetVertices are too
/// few, and the counts are those that come nearest.
LeastCounts leastCounts(const CountsRequest& request);

}  // namespace glibra::budget
