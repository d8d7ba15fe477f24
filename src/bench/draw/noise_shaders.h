#pragma once
// Noise on the device: from a texture filtered by the driver, from one filtered by the shader, and from the
// function itself.

#include <glibra/result.h>

#include <string>
#include <vector>

#include "bench/draw/noise_volume.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/sampler.h"

namespace glibra::bench {

enum class NoiseShader { driverFilter, shaderFilter, function };

/// A picture of the plane `corner` + x `across` + y `up` through the noise, with x and y from 0 to 1. Places
/// are in periods.
struct NoisePlane {
    glm::dvec3 corner{0}, across{1, 0, 0}, up{0, 1, 0};
};

class NoisePicture {
  public:
    static Result<NoisePicture> create(const gpu::Capabilities& capabilities, NoiseShader shader, int side);

    /// Draws and waits. The first two shaders sample the texture; `function` ignores it.
    void draw(const NoisePlane& plane, const gpu::Texture* texture, gpu::Wrap wrap = gpu::Wrap::repeat) const;
    /// The octaves of every pixel of the last draw, rows from the top.
    [[nodiscard]] Result<std::vector<float>> pixels() const;
    /// The place in the noise that a pixel shows.
    [[nodiscard]] glm::dvec3 place(const NoisePlane& plane, int column, int row) const;
    [[nodiscard]] int side() const { return target_.width(); }

  private:
    NoisePicture(gpu::Program program, gpu::Target target)
        : program_(std::move(program)), target_(std::move(target)) {}

    const gpu::Capabilities* capabilities_ = nullptr;
    gpu::Program program_;
    gpu::Target target_;
};

}  // namespace glibra::bench
