#pragma once
// One claim: a way that is said to be slower, and one that is said to be faster.

#include <glibra/result.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/core/paired.h"
#include "bench/core/subject.h"
#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"

namespace glibra::bench {

/// A way of doing a piece of work. What it draws with lives as long as `draw`.
struct Way {
    std::string name;
    std::function<void()> draw;  ///< without waiting for the device
    double error = 0;            ///< against the figure's reference
    double memory = 0;           ///< bytes
};

struct Claim {
    std::string name;       ///< of the figure: "pf06-length"
    std::string text;       ///< "A built-in function is never slower than the form written by hand"
    std::string work;       ///< what both do: "512 x 512 pixels, 32 times"
    std::string errorName;  ///< of Way::error, and what it is measured against
    std::string errorUnit, reference;
    Way slower, faster;
    bool mayBeEqual = false;  ///< the claim holds without a difference, too
};

/// What the claims are measured with.
struct ClaimSetup {
    Bench& bench;
    gpu::Context& context;
    [[nodiscard]] const gpu::Capabilities& capabilities() const { return context.capabilities(); }
    [[nodiscard]] int pairs() const { return bench.isQuick() ? 5 : 11; }
    /// Draws both in turn and waits each time.
    [[nodiscard]] PairedTiming time(const std::function<void()>& slower,
                                    const std::function<void()>& faster) const;
};

/// "true here, by 1.82 (1.75 .. 1.90)": what the ratio of the times says of a claim that it is above 1.
std::string verdict(const Timing& ratio, bool mayBeEqual);

/// Measures both ways.
Figure figureOf(const ClaimSetup& setup, const Claim& claim);

/// Claims about functions and statements of fragment shaders.
Result<std::vector<Figure>> measureFragmentClaims(const ClaimSetup& setup);
/// Claims about textures in place of computations and geometry.
Result<std::vector<Figure>> measureTextureClaims(const ClaimSetup& setup);
/// Claims about the shapes of work groups; none without compute stages.
Result<std::vector<Figure>> measureGroupClaims(const ClaimSetup& setup);
/// Claims about strips, geometry and tessellation stages, and culling.
Result<std::vector<Figure>> measureMeshClaims(const ClaimSetup& setup);

/// A value that functions can own together.
template <class T>
std::shared_ptr<T> shared(T value) {
    return std::make_shared<T>(std::move(value));
}

/// Draws with a value, which the function keeps alive.
template <class T>
std::function<void()> drawing(std::shared_ptr<T> value) {
    return [value = std::move(value)] { value->draw(); };
}

/// A target of side x side pixels.
Result<std::shared_ptr<gpu::Target>> targetOf(const ClaimSetup& setup, int side, gpu::TexelFormat format);

}  // namespace glibra::bench
