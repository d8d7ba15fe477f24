#pragma once
// Depth formats and mappings, the gap that one step of each stands for, and pairs of surfaces drawn with
// them.

#include <array>
#include <vector>

#include "bench/core/device.h"

namespace glibra::bench {

/// How depth is stored and mapped.
struct DepthKind {
    std::string_view name;
    gpu::TexelFormat format = gpu::TexelFormat::depth24;
    int bits = 24;             ///< for floats, the mantissa including its leading one
    bool isReversed = false;   ///< 1 at the near plane, 0 at the far plane
    bool isZeroToOne = false;  ///< normalised depth runs from 0 to 1 (glClipControl, GL 4.5), not from -1
    [[nodiscard]] bool isFloat() const { return format == gpu::TexelFormat::depth32f; }
};
inline constexpr std::array kDepthKinds{
    DepthKind{"16 bit", gpu::TexelFormat::depth16, 16},
    DepthKind{"24 bit", gpu::TexelFormat::depth24, 24},
    DepthKind{"32 bit float", gpu::TexelFormat::depth32f, 24},
    DepthKind{"32 bit float, reversed, -1..1", gpu::TexelFormat::depth32f, 24, true},
    DepthKind{"32 bit float, reversed, 0..1", gpu::TexelFormat::depth32f, 24, true, true},
};
/// Those that this driver supports.
std::vector<DepthKind> usableKinds(const gpu::Capabilities& capabilities);

/// The gap beyond distance z (eye space, near <= z <= far) that one step of the depth buffer stands for, in
/// the unit of z; NaN if it would reach beyond the far plane. With k = step (f - n) / (f n) it is k z^2 / (1
/// - k z), from depth f (z - n) / (z (f - n)); E. Lapidous and G. Jiao, Optimal Depth Buffer for Low-Cost
/// Graphics Hardware, 1999. The step is 1 / (2^b - 1) or the spacing of floats at that depth. Depths in -1..1
/// are floats themselves: their spacing, halved by the mapping to 0..1, is the step where it is larger.
double depthStep(const DepthKind& kind, double near, double far, double z);

/// Two distances from the eye, near <= front <= back <= far.
struct DepthPair {
    double front = 0, back = 0;
};

/// A square picture with depth of that kind. The state of the context stays as it was.
class DepthPicture {
  public:
    DepthPicture(Bench& bench, const DepthKind& kind, int side);
    /// For every pair: draws the farther surface, then the nearer one in the same pixel with a depth test
    /// that passes only nearer surfaces. The result says whether the nearer one is visible. At most side *
    /// side pairs.
    [[nodiscard]] std::vector<bool> resolvePairs(double near, double far,
                                                 std::span<const DepthPair> pairs) const;
    /// The share of pixels, 0..1, in which the farther of two parallel planes wins. The nearer plane fills
    /// the picture from 1 / 1.2 to 1 / .8 of the distance, bottom to top. The farther one is `gap` (a share
    /// of the distance) behind it along every line of sight, is larger than the picture, and is drawn first.
    [[nodiscard]] double fighting(double near, double far, double distance, double gap) const;
    /// Clears, draws `layers` rectangles over all pixels from back to front, and waits.
    void drawLayers(int layers) const;

  private:
    struct Layer {
        GLenum primitive;
        std::vector<float> vertices;
        double brightness;
    };
    void draw(double near, double far, const std::vector<Layer>& layers) const;
    DepthKind kind_;
    Canvas canvas_;
    Shader shader_;
};

std::vector<Figure> measureDepth(Bench& bench);

}  // namespace glibra::bench
