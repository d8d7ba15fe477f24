#pragma once
// What an error bound chooses: counts, tessellation levels and noise sizes.

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "budget/budget.h"
#include "budget/error_models.h"
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

// Chooses counts of meshes whose programs compute more at the vertices than their places, such as light. No
// theorem bounds what a program does, so the error is measured on pictures with finer meshes.

/// A draw with the numbers that its shape needs.
struct VertexDraw {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    const SurfaceModel* model = nullptr;
    std::vector<double> numbers;  ///< complete
    std::vector<double> before;   ///< those of the scene, or the defaults
    std::array<bool, 2> isFree{};
    plan::PlannedProgramIndex program{};
    Fidelity fidelity = Fidelity::shape;
    double scale = 0;  ///< pixels per model unit
};

struct VertexRequest {
    std::vector<VertexDraw> draws;
    double maxError = 0;  ///< pixels
    /// Measures the change from one set of shapes to another.
    std::function<std::optional<ContourShifts>(std::span<const ShapeChoice> from,
                                               std::span<const ShapeChoice> to)>
        shift;
};

/// The measured error of the values that a program computes at its vertices.
struct VertexError {
    double pixels = 0;   ///< how far contours are off, beyond the error of the shapes themselves
    double colored = 0;  ///< the share of the picture whose light is off by more than 8/255
    bool isKept = false;
};

/// The result for the draws of one program.
struct VertexResult {
    plan::PlannedProgramIndex program{};
    VertexError error;
};

struct VertexValues {
    std::vector<std::vector<double>> numbers;  ///< by draw of the request
    std::vector<VertexResult> programs;
};

/// Raises the free counts of a program's draws by one factor until contours are within the bound and all but
/// one of 1000 pixels have their colour. The error falls with the square of the counts, so the difference to
/// a picture with half as many again is five ninths of it. Counts along straight lines are compared with at
/// least those of the scene, because a program may show what repeats along them, and become those if they do
/// not keep the bound. Errors below a tenth of a pixel of the small pictures are not detected. The search
/// ends early, with isKept false, if meshes would become larger than kMostBudgetVertices or if finer ones do
/// not help. If no count of a program is free, only its error is measured. Returns nothing if pictures cannot
/// be drawn.
std::optional<VertexValues> vertexValues(const VertexRequest& request);

}  // namespace glibra::budget
