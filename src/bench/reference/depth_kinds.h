#pragma once
// Depth formats and mappings, and the gap that one step of each stands for.

#include <glad/gl.h>

#include <limits>
#include <span>
#include <string_view>

namespace glibra::bench {

/// How depth is stored and mapped.
struct DepthKind {
    std::string_view name;
    GLenum format = GL_DEPTH_COMPONENT24;
    int bits = 24;  ///< for floats, the mantissa including its leading one
    bool isFloat = false;
    bool isReversed = false;   ///< 1 at the near plane, 0 at the far plane
    bool isZeroToOne = false;  ///< normalised depth runs from 0 to 1 (glClipControl, GL 4.5), not from -1
};

/// 16 bit, 24 bit, 32 bit float, and reversed 32 bit float with either range.
std::span<const DepthKind> depthKinds();

/// Stands for a gap that does not exist.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The gap beyond distance z (eye space, near <= z <= far) that one step of the depth buffer stands for, in
/// the unit of z; NaN if it would reach beyond the far plane. With k = step (f - n) / (f n) it is k z^2 / (1
/// - k z), from depth f (z - n) / (z (f - n)); E. Lapidous and G. Jiao, Optimal Depth Buffer for Low-Cost
/// Graphics Hardware, 1999. The step is 1 / (2^b - 1) or the spacing of floats at that depth. Depths in -1..1
/// are floats themselves: their spacing, halved by the mapping to 0..1, is the step where it is larger.
double depthStep(const DepthKind& kind, double near, double far, double z);

}  // namespace glibra::bench
