#pragma once
// What an error bound chooses: counts, tessellation levels and noise sizes.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "budget/budget.h"
#include "budget/surface_model.h"
#include "plan/frame_plan.h"

namespace glibra::budget {

// The uniforms of a program that decide tessellation levels and nothing else.

struct LevelUniform {
    plan::UniformIndex uniform{};
    double value = 0;
    /// The range of its slider. Without a slider: 1 to the driver's highest level.
    double least = 1, most = 64;
};

/// The uniforms that TranslatedProgram::levelUniforms names and to which the scene gives a single value above
/// 0.
std::vector<LevelUniform> levelUniforms(const plan::PlannedProgram& program, double mostLevel);

// Finds the lowest tessellation levels that keep a bound, by measuring.

struct LevelsRequest {
    std::vector<LevelUniform> uniforms;
    bool isFree = false;  ///< they may be chosen; otherwise only their error is measured
    double maxError = 0;  ///< pixels
    /// Returns the largest error in pixels of all patches that the uniforms affect, with these values.
    std::function<std::optional<double>(std::span<const LevelValue> values)> error;
};

struct LeastLevels {
    std::vector<LevelValue> values;
    double pixels = 0;
    bool isKept = false;  ///< pixels <= maxError
};

/// The uniforms keep their proportions as far as their ranges allow. Returns nothing if the error cannot be
/// measured.
std::optional<LeastLevels> leastLevels(const LevelsRequest& request);

// The part of choose() that chooses tessellation levels.

/// A draw of patches into a picture of that size.
struct TessellatedDraw {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    const scene::Draw* draw = nullptr;
    glm::dvec2 size{0};  ///< pixels
};

struct ChosenLevels {
    std::vector<plan::Override> overrides;  ///< values of uniforms that decide levels
    std::vector<Decision> decisions;
    std::vector<Miss> misses;
    std::vector<Unknown> unknown;
};

/// `draws` is indexed like FramePlan::programs; all draws of one program have the same levels.
ChosenLevels chooseLevels(const scene::Scene& scene, const plan::FramePlan& plan,
                          const std::map<plan::PlannedProgramIndex, std::vector<TessellatedDraw>>& draws,
                          const Request& request);

// The part of choose() that chooses noise textures.

/// How a noise texture is seen.
struct NoiseUse {
    /// The size of a period in pixels. Until it has been measured, a period is taken to be one unit of the
    /// model on which the noise is seen, or half the height of the picture if there is no bound for that.
    double period = 0;
    const scene::Draw* draw = nullptr;
};

struct ChosenNoise {
    std::vector<NoiseChoice> choices;  ///< only for textures that change
    std::vector<Decision> decisions;
    std::vector<Miss> misses;
};

ChosenNoise chooseNoise(const scene::Scene& scene, const std::map<scene::TextureIndex, NoiseUse>& uses,
                        const Request& request);

// Finds the cheapest counts of a primitive that keep a bound.

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
