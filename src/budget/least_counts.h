#pragma once
// Finds the cheapest counts of a primitive that keep a bound.

#include <array>
#include <cstdint>
#include <vector>

#include "budget/surface_model.h"

namespace glibra::budget {

/// No mesh is made larger than this. Finer ones cost more than any picture shows, and the distances between
/// their vertices are near a float's rounding.
inline constexpr std::uint64_t kMostBudgetVertices = 1'048'576;

/// The requirements for one mesh.
struct CountsRequest {
    const SurfaceModel* model = nullptr;
    std::vector<double> numbers;     ///< complete, as the scene states them or by default
    std::array<bool, 2> isFree{};    ///< for each of model->counts: it may be chosen
    std::array<int, 2> least{1, 1};  ///< for each of model->counts: the smallest choice
    Fidelity fidelity = Fidelity::shape;
    double allowed = 0;  ///< largest deviation in model units; infinity: any
};

/// Returns the numbers with, among all counts that keep the bound, those with the fewest vertices. If none
/// keep it, then either a count that is not free is too small, and the others are chosen as if it were free;
/// or kMostBudgetVertices are too few, and the counts are those that come nearest to the bound.
std::vector<double> leastCounts(const CountsRequest& request);

}  // namespace glibra::budget
