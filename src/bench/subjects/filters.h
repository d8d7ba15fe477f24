#pragma once
// Filters as chains of passes on the device.

#include "bench/core/device.h"
#include "bench/reference/filtering.h"

namespace glibra::bench {

/// Fragment shaders of consecutive passes: they read uPicture and write fColor.
using Passes = std::vector<std::string>;
Passes directBlur(const std::vector<double>& weights);
Passes separableBlur(const std::vector<double>& weights);
/// The same with half as many reads: the linear filter weights two neighbours by a place between them.
Passes pairedBlur(const std::vector<double>& weights);
Passes directSobel();
/// First pass: red is the column smoothed by 1 2 1, green its difference, times `scale` plus `bias`. Second
/// pass: the length of the gradient.
Passes separableSobel(double scale, double bias);

/// The first pass reads the picture, the last writes floats, the others write a texture of format `between`.
class FilterChain {
  public:
    /// At least one pass. The picture is uploaded as bytes.
    FilterChain(Bench& bench, const Plane& picture, const Passes& passes, gpu::TexelFormat between);
    /// Runs all passes; does not wait.
    void draw() const;
    /// The red component of the last pass.
    [[nodiscard]] Plane result() const;
    /// Bytes of the textures between the passes.
    [[nodiscard]] double bytesBetween() const;

  private:
    struct Pass {
        Shader shader;
        Texels into;
        gpu::Target target;
    };
    const gpu::Capabilities& capabilities_;
    Texels picture_;
    std::vector<Pass> passes_;
};

}  // namespace glibra::bench
