#pragma once
// Texels as an expression of GLSL makes them, to look at: `color.rgb * 10`, `1. - color.r`,
// `abs(color - near(1, 0))`.

#include <optional>
#include <string>

#include "gpu/context/context.h"
#include "render/check/object_content.h"

namespace glibra::view {

struct Displayed {
    std::optional<render::Content> content;  ///< of floats; a number is grey
    std::string problem;  ///< why there is none: the first message of the driver's compiler
};

/// Computes the expression for each texel of the first layer. It may use the texel as a sampler reads it
/// (`color`), its place from the lower left corner as integers (`texel`) and as 0..1 (`st`), the size
/// (`size`), and other texels, as far away as that (`near(1, 0)`). Integers beyond 2^24 are rounded.
Displayed displayedBy(gpu::Context& context, const render::Content& content, const std::string& expression);

}  // namespace glibra::view
