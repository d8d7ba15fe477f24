#pragma once
// How precise the functions of GLSL are on this driver, measured by running them.

#include <glibra/result.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/reference/builtin_functions.h"
#include "gpu/capabilities.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/texture.h"

namespace glibra::bench {

enum class PrecisionStage { vertex, fragment };

/// What one sweep of arguments gave in one stage. Errors count in units in the last place of the exact
/// result, over all components.
struct Precision {
    double largest = 0;            ///< ULP; infinite where NaN or infinity came instead of a number
    double mean = 0;               ///< ULP, of the finite results
    double largestAbsolute = 0;    ///< of the finite results
    std::array<float, 8> worst{};  ///< arguments of the largest error
    std::size_t samples = 0;
    std::size_t notNumbers = 0;  ///< results that are NaN or infinite where the exact one is finite
    /// Largest error as a multiple of what the specification allows there; above 1: broken. Nothing where the
    /// specification leaves the precision open. 0 / 0 counts as 0.
    std::optional<double> ofBound;
};

/// One function over one sweep of arguments on the device.
class PrecisionRun {
  public:
    /// side * side argument sets. gpu-E02 if the driver refuses the shader.
    static Result<PrecisionRun> create(const gpu::Capabilities& capabilities, const BuiltinFunction& function,
                                       const ArgumentSweep& sweep, PrecisionStage stage, int side);
    /// Evaluates all of them once; does not wait.
    void draw() const;
    /// Of arguments and results.
    [[nodiscard]] double bytes() const { return 3. * side_ * side_ * 4 * sizeof(float); }
    /// Results of draw(): four floats an argument set, in the order of their indices.
    [[nodiscard]] Result<std::vector<float>> results(const gpu::Capabilities& capabilities) const;

  private:
    PrecisionRun(gpu::Texture a, gpu::Texture b, gpu::Target target, gpu::Program program, bool byPoints,
                 int side);
    gpu::Texture a_, b_;
    gpu::Target target_;
    gpu::Program program_;
    bool byPoints_;
    int side_;
};

/// Compares results (four floats an argument set) with the exact values. Results below the smallest normal
/// float may be 0, which the specification allows.
Precision judgePrecision(const BuiltinFunction& function, const ArgumentSweep& sweep,
                         const std::vector<float>& results);

/// One line of the table.
struct PrecisionRow {
    const BuiltinFunction* function = nullptr;
    const ArgumentSweep* sweep = nullptr;
    Precision vertex, fragment;
};

/// All functions over all their sweeps in both stages, side * side argument sets each.
Result<std::vector<PrecisionRow>> precisionTable(const gpu::Capabilities& capabilities, int side = 128);

/// The table for people: one line a sweep, and below it which bounds of the specification are broken.
std::string toText(const std::vector<PrecisionRow>& rows);

/// "0.25" or, of two arguments, "0.25, 3": the numbers that the function reads of them.
std::string argumentsText(const BuiltinFunction& function, const std::array<float, 8>& arguments);

}  // namespace glibra::bench
