#pragma once
// Sweeps over numbers that are computed on the CPU or in a shader: one result for each input.

#include <functional>
#include <string>
#include <vector>

#include "bench/core/device.h"

namespace glibra::bench {

using Numbers = std::vector<glm::dvec4>;

/// One setting of a sweep: what is computed from, and how wrong results are.
struct ComputedCase {
    double setting = 0;
    std::string label{};
    std::function<double(const Numbers& results)> error{};
    std::vector<Four> inputs{Four(0)};
};

/// A way to compute the results of a case: on the CPU, or in a shader.
struct Computation {
    std::string name;
    std::function<void(const ComputedCase& given, Numbers& results)> onCpu{};
    double bytes = 0;         ///< that the CPU works on
    bool isForScenes = true;  ///< as Curve has it
    std::string glsl{};       ///< as ShaderValues takes it
    std::function<void(const Shader& shader, const ComputedCase& given)> uniforms{};
};

/// Adds a curve for each way, with a point for each case. A result has `inputsPerValue` inputs. A shader with
/// a uniform uHalf gives its doubles in two parts. A way that the driver refuses is reported, and the others
/// are measured all the same.
void addComputed(Figure& figure, Bench& bench, const std::vector<Computation>& ways,
                 const std::vector<ComputedCase>& cases, int inputsPerValue = 1);

}  // namespace glibra::bench
