#pragma once
// The fixed-function state of a draw as one value, without GL. `scene` fills it, `gpu` sets it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace glibra::base {

/// A test of a new value against the stored one: `less` passes if the new value is less.
enum class Comparison : std::uint8_t { never, less, lequal, equal, gequal, greater, notequal, always };

/// The test of one minus the values that passes where this one passes for the values.
constexpr Comparison mirrored(Comparison test) {
    switch (test) {
        case Comparison::less:
            return Comparison::greater;
        case Comparison::lequal:
            return Comparison::gequal;
        case Comparison::gequal:
            return Comparison::lequal;
        case Comparison::greater:
            return Comparison::less;
        default:
            return test;
    }
}

/// What a depth buffer holds, and which clip coordinates lead there.
enum class DepthOrder : std::uint8_t {
    usual,          ///< 0 near, 1 far; z goes from -w to w
    reversed,       ///< one minus that; z goes from 0 (far) to w if the driver can clip so, else from -w
    reversedCover,  ///< one minus that; z goes from -w to w with every driver
};

/// Which faces are left out.
enum class Cull : std::uint8_t { off, back, front, both };
/// Which order of vertices in the window makes a face a front face.
enum class Winding : std::uint8_t { ccw, cw };
constexpr Winding opposite(Winding winding) {
    return winding == Winding::ccw ? Winding::cw : Winding::ccw;
}
enum class PolygonMode : std::uint8_t { fill, line, point };
/// The vertex of a primitive that gives `flat` outputs their values.
enum class ProvokingVertex : std::uint8_t { last, first };

enum class BlendFactor : std::uint8_t {
    zero,
    one,
    sourceColor,
    oneMinusSourceColor,
    destinationColor,
    oneMinusDestinationColor,
    sourceAlpha,
    oneMinusSourceAlpha,
    destinationAlpha,
    oneMinusDestinationAlpha,
    constantColor,
    oneMinusConstantColor,
    constantAlpha,
    oneMinusConstantAlpha,
    sourceAlphaSaturate,
};
inline constexpr int kBlendFactorCount = 15;

/// `subtract` is source - destination. `min` and `max` do not use the factors.
enum class BlendEquation : std::uint8_t { add, subtract, reverseSubtract, min, max };
inline constexpr int kBlendEquationCount = 5;

struct BlendFunction {
    BlendFactor source = BlendFactor::one, destination = BlendFactor::zero;
    BlendEquation equation = BlendEquation::add;
    friend bool operator==(const BlendFunction&, const BlendFunction&) = default;
};

/// How a fragment's colour is combined with the stored one.
struct Blend {
    bool isOn = false;
    BlendFunction color, alpha;
    friend bool operator==(const Blend&, const Blend&) = default;
};

/// The source over the stored colour by its alpha, as in classic scenes. Alpha is the coverage of both.
inline constexpr Blend kBlendOver{
    true,
    {BlendFactor::sourceAlpha, BlendFactor::oneMinusSourceAlpha, BlendEquation::add},
    {BlendFactor::one, BlendFactor::oneMinusSourceAlpha, BlendEquation::add}};

/// What happens to the stored stencil value. `increment` and `decrement` stop at the limits.
enum class StencilAction : std::uint8_t {
    keep,
    zero,
    replace,
    increment,
    decrement,
    invert,
    incrementWrap,
    decrementWrap,
};

/// The stencil test of front or back faces: (reference & mask) is compared with (stored & mask).
struct StencilFace {
    Comparison function = Comparison::always;
    int reference = 0;
    std::uint32_t mask = ~0U;
    StencilAction fail = StencilAction::keep;       ///< the stencil test failed
    StencilAction depthFail = StencilAction::keep;  ///< the depth test failed
    StencilAction pass = StencilAction::keep;
    std::uint32_t writeMask = ~0U;
    friend bool operator==(const StencilFace&, const StencilFace&) = default;
};

struct ColorMask {
    bool red = true, green = true, blue = true, alpha = true;
    friend bool operator==(const ColorMask&, const ColorMask&) = default;
};

/// A rectangle in fractions of the target; (0, 0) is the lower left corner.
struct FractionRectangle {
    double x = 0, y = 0, width = 1, height = 1;
    friend bool operator==(const FractionRectangle&, const FractionRectangle&) = default;
};

/// Colour targets that have their own blending and colour mask.
inline constexpr std::size_t kRasterTargets = 8;

/// The default is the state at the beginning of a pass.
struct RasterState {
    Cull cull = Cull::off;
    Winding front = Winding::ccw;
    PolygonMode polygon = PolygonMode::fill;
    ProvokingVertex provoking = ProvokingVertex::last;
    bool discard = false;                      ///< primitives end before they are rasterised: no fragments
    double offsetFactor = 0, offsetUnits = 0;  ///< added to the depth of polygons in every polygon mode

    /// The members below mean 0 near and 1 far in any order: whoever sets them mirrors them.
    DepthOrder depthOrder = DepthOrder::usual;
    bool depthTest = true;  ///< false: no test, and no depth is written
    bool depthWrite = true;
    bool depthClamp = false;
    Comparison depthFunction = Comparison::lequal;
    double depthNear = 0, depthFar = 1;  ///< 0..1; depths of the near and far plane

    bool stencilTest = false;
    StencilFace stencilFront, stencilBack;

    std::array<Blend, kRasterTargets> blend{};
    std::array<double, 4> blendConstant{};
    std::array<ColorMask, kRasterTargets> write{};

    bool multisample = true;  ///< false: every sample of a pixel gets the same coverage
    bool alphaToCoverage = false;
    double sampleShading = 0;  ///< 0..1: fraction of the samples with an own run of the fragment shader

    FractionRectangle viewport;
    std::optional<FractionRectangle> scissor;  ///< nothing outside is drawn

    double lineWidth = 1, pointSize = 1;  ///< pixels
    bool pointSizeFromShader = false;

    /// Sets the blending of all targets.
    void blendAll(const Blend& all) { blend.fill(all); }

    friend bool operator==(const RasterState&, const RasterState&) = default;
};

// How a texture is read, as values without GL. `scene` fills them, `gpu` makes samplers of them.

/// The first word is the filter within a level, the second one that between levels.
enum class Filter : std::uint8_t {
    nearest,
    linear,
    nearestMipmapNearest,
    linearMipmapNearest,
    nearestMipmapLinear,
    linearMipmapLinear,
};

/// What is read outside of 0..1.
enum class Wrap : std::uint8_t { repeat, clampToEdge, mirroredRepeat, clampToBorder };

constexpr bool repeats(Wrap wrap) {
    return wrap == Wrap::repeat || wrap == Wrap::mirroredRepeat;
}

/// The depth that counts as farthest where depths are compared that way: comparisons with it hold.
constexpr double farthestDepth(Comparison comparison) {
    return comparison == Comparison::greater || comparison == Comparison::gequal ? 0 : 1;
}

struct SamplerState {
    Filter filter = Filter::linear;  ///< for enlarging, the filter within a level
    std::array<Wrap, 3> wrap{};      ///< along s, t and p
    double anisotropy = 1;           ///< 1: off; the driver's limit holds
    std::array<double, 4> border{};  ///< what clampToBorder reads
    /// Of depth, for samplers that compare: 1 where (reference compared with texel) holds.
    Comparison compare = Comparison::lequal;

    [[nodiscard]] bool readsMipmaps() const { return filter >= Filter::nearestMipmapNearest; }
    friend bool operator==(const SamplerState&, const SamplerState&) = default;
};

}  // namespace glibra::base
