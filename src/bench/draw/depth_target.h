#pragma once
// Pairs of surfaces drawn into a depth buffer of a chosen format.

#include <glibra/result.h>

#include <span>
#include <vector>

#include "bench/reference/depth_kinds.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"

namespace glibra::bench {

/// Two distances from the eye, near <= front <= back <= far.
struct DepthPair {
    double front = 0, back = 0;
};

class DepthTarget {
  public:
    /// A square of side x side pixels: RGBA8 with depth of the given internal format.
    static Result<DepthTarget> create(const gpu::Capabilities& capabilities, GLenum depthFormat, int side);

    /// For every pair: draws the farther surface, then the nearer one in the same pixel with a depth test
    /// that passes only nearer surfaces. The result says whether the nearer one is visible. At most side *
    /// side pairs.
    Result<std::vector<bool>> resolvePairs(const DepthKind& kind, double near, double far,
                                           std::span<const DepthPair> pairs);
    /// The share of pixels, 0..1, in which the farther of two parallel planes wins. The nearer plane fills
    /// the picture from 1 / 1.2 to 1 / .8 of the distance, bottom to top. The farther one is `gap` (a share
    /// of the distance) behind it along every line of sight, is larger than the picture, and is drawn first.
    Result<double> fighting(const DepthKind& kind, double near, double far, double distance, double gap);
    /// Clears, draws `layers` rectangles over all pixels from back to front, and waits.
    Diagnostics drawLayers(const DepthKind& kind, int layers);
    /// RGBA bytes of the last draw, top row first: black is empty, half white the farther surface, white the
    /// nearer.
    [[nodiscard]] Result<std::vector<std::byte>> picture() const;

  private:
    explicit DepthTarget(gpu::Program program) : program_(std::move(program)) {}
    void begin(const DepthKind& kind, double near, double far) const;
    Diagnostics draw(GLenum primitive, std::span<const float> vertices, float brightness) const;
    static void end();

    const gpu::Capabilities* capabilities_ = nullptr;
    gpu::Program program_;
    gpu::Renderbuffer color_;
    gpu::Name<glDeleteRenderbuffers> depth_;
    gpu::Framebuffer framebuffer_;
    int side_ = 0;
};

/// The depthKinds that this driver supports.
std::vector<DepthKind> usableKinds(const gpu::Capabilities& capabilities);

}  // namespace glibra::bench
