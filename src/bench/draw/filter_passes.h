#pragma once
// Filters as chains of full-screen passes on the device, each into a texture of a chosen format.

#include <glibra/result.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/reference/filter_reference.h"
#include "gpu/context/capabilities.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/sampler.h"
#include "gpu/object/texture.h"

namespace glibra::bench {

/// Fragment shaders of a pass: they read uPicture and write fColor.
std::string directBlur(const std::vector<double>& weights);
/// One direction of the separable blur: vertical if `isVertical`, else horizontal.
std::string blurAlong(const std::vector<double>& weights, bool isVertical);
/// The same with half as many reads: the linear filter weights two neighbours by a place between them.
std::string pairedBlurAlong(const std::vector<double>& weights, bool isVertical);
std::string directSobel();
/// First pass: red is the column smoothed by 1 2 1, green its difference, times `scale` plus `bias`.
std::string sobelColumns(double scale, double bias);
/// Second pass: the length of the gradient, from the result of the first.
std::string sobelRows(double scale, double bias);

/// Consecutive passes: the first reads the picture, the last writes floats, the others write a texture of
/// format `between`.
class FilterChain {
  public:
    /// `fragments`: one shader per pass, at least one. The picture is uploaded as bytes.
    static Result<FilterChain> create(const gpu::Capabilities& capabilities, const Plane& picture,
                                      const std::vector<std::string>& fragments, gpu::TexelFormat between);
    /// Runs all passes; does not wait.
    void draw() const;
    /// The red component of the last pass.
    [[nodiscard]] Result<Plane> result(const gpu::Capabilities& capabilities) const;
    /// Bytes of the textures between the passes.
    [[nodiscard]] double bytesBetween() const;

  private:
    struct Pass {
        gpu::Program program;
        gpu::Target target;
    };
    explicit FilterChain(gpu::Texture picture) : picture_(std::move(picture)) {}
    // Textures are on the heap because targets refer to them by address.
    gpu::Texture picture_;
    std::vector<std::unique_ptr<const gpu::Texture>> between_;
    std::vector<Pass> passes_;
    gpu::Sampler linear_{gpu::Wrap::clampToEdge};
};

}  // namespace glibra::bench
