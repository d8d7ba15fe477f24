#pragma once
// The precision of the GLSL functions on this driver, measured by running them.

#include <glibra/result.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/reference/builtin_functions.h"
#include "gpu/context/capabilities.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/texture.h"

namespace glibra::bench {

enum class PrecisionStage { vertex, fragment };

/// The result of one sweep of arguments in one stage. Errors are in units in the last place of the exact
/// result, over all components.
struct Precision {
    double largest = 0;          ///< ULP; infinite if a result is NaN or infinite but the exact one is finite
    double mean = 0;             ///< ULP, of the finite results
    double largestAbsolute = 0;  ///< of the finite results
    std::array<float, 8> worst{};  ///< arguments with the largest error
    std::size_t samples = 0;
    std::size_t notNumbers = 0;  ///< results that are NaN or infinite where the exact one is finite
    /// The largest error as a multiple of what the specification allows; above 1 the bound is broken. Empty
    /// if the specification leaves the precision undefined. 0 / 0 is 0.
    std::optional<double> timesTheBound;
};

/// One function over one sweep of arguments on the device.
class PrecisionRun {
  public:
    /// side * side argument sets. gpu-E02 if the driver rejects the shader.
    static Result<PrecisionRun> create(const gpu::Capabilities& capabilities, const BuiltinFunction& function,
                                       const ArgumentSweep& sweep, PrecisionStage stage, int side);
    /// Evaluates all sets once; does not wait.
    void draw() const;
    /// Bytes of arguments and results.
    [[nodiscard]] double bytes() const { return 3. * side_ * side_ * 4 * sizeof(float); }
    /// The results of draw(): four floats per argument set, in the order of their indices.
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

/// Compares results (four floats per argument set) with the exact values. Results below the smallest normal
/// float may be 0, as the specification allows.
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

/// The table as text: one line per sweep, then the bounds of the specification that are broken.
std::string toText(const std::vector<PrecisionRow>& rows);

/// "0.25" or, for two arguments, "0.25, 3": the numbers that the function reads.
std::string argumentsText(const BuiltinFunction& function, const std::array<float, 8>& arguments);

}  // namespace glibra::bench
