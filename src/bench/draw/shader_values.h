#pragma once
// A GLSL function evaluated for many inputs, a pixel each, in the driver's own arithmetic.

#include <glibra/result.h>

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "bench/core/bench.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/texture.h"

namespace glibra::bench {

using Four = std::array<float, 4>;

class ShaderValues {
  public:
    /// `glsl` defines `vec4 value()` of GLSL 4.10, which reads the inputs of its pixel as given(0),
    /// given(1) ... `inputs` holds `inputsEach` vectors a value. gpu-E01, or errors of the driver.
    static Result<ShaderValues> create(Bench& bench, std::string_view glsl, std::span<const Four> inputs,
                                       int inputsEach = 1);

    /// Draws and waits for it.
    void compute() const;
    /// What the last compute() gave, one vector a value.
    [[nodiscard]] Result<std::vector<Four>> values() const;
    /// Of the inputs and of what they become.
    [[nodiscard]] double bytes() const;
    /// For uniforms of `glsl`.
    [[nodiscard]] const gpu::Program& program() const { return program_; }

  private:
    ShaderValues(const gpu::Capabilities& capabilities, std::size_t count, gpu::Program program,
                 gpu::Texture inputs, gpu::Target target)
        : capabilities_(&capabilities),
          count_(count),
          program_(std::move(program)),
          inputs_(std::move(inputs)),
          target_(std::move(target)) {}

    const gpu::Capabilities* capabilities_;  ///< of the bench's context
    std::size_t count_;
    gpu::Program program_;
    gpu::Texture inputs_;
    gpu::Target target_;
};

}  // namespace glibra::bench
