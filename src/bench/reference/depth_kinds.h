#pragma once
// Depth formats and mappings, and the gap that one step of each stands for.

#include <glad/gl.h>

#include <span>
#include <string_view>

namespace glibra::bench {

/// How depth is kept and mapped.
struct DepthKind {
    std::string_view name;
    GLenum format = GL_DEPTH_COMPONENT24;
    int bits = 24;  ///< of the mantissa with its leading one, for floats
    bool isFloat = false;
    bool isReversed = false;   ///< 1 at the near plane, 0 at the far plane
    bool isZeroToOne = false;  ///< normalised depth runs from 0 to 1 (glClipControl, GL 4.5), not from -1
};

/// 16, 24, 32F, reversed 32F with either range.
std::span<const DepthKind> depthKinds();

/// The gap behind distance z (eye space, near <= z <= far) that one step of the depth buffer stands for, in
/// the unit of z; NaN if it would reach beyond the far plane. With k = step (f - n) / (f n) it is k z^2 / (1
/// - k z), from depth f (z - n) / (z (f - n)); E. Lapidous and G. Jiao, Optimal Depth Buffer for Low-Cost
/// Graphics Hardware, 1999. The step is 1 / (2^b - 1) or the spacing of floats at that depth. The range -1..1
/// is itself kept as floats, and their spacing, halved on the way to 0..1, counts where it is larger.
double depthStep(const DepthKind& kind, double near, double far, double z);

}  // namespace glibra::bench
