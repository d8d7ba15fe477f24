#pragma once
// Evaluates a GLSL function for many inputs, one pixel each, in the driver's arithmetic.

#include <glibra/result.h>

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "bench/core/bench.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/texture.h"

namespace glibra::bench {

using Four = std::array<float, 4>;

class ShaderValues {
  public:
    /// `glsl` defines `vec4 value()` in GLSL 4.10, which reads the inputs of its pixel as given(0), given(1)
    /// ... `inputs` holds `inputsPerValue` vectors per value. gpu-E01, or errors of the driver.
    static Result<ShaderValues> create(Bench& bench, std::string_view glsl, std::span<const Four> inputs,
                                       int inputsPerValue = 1);

    /// Draws and waits for it.
    void compute() const;
    /// Draws. The results, one vector per value.
    [[nodiscard]] Result<std::vector<Four>> values() const;
    /// Bytes of the inputs and the results.
    [[nodiscard]] double bytes() const;
    /// The program, for setting uniforms of `glsl`.
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
