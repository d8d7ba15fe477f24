#pragma once
// What decides how a program is written in GLSL ES, besides its text.

#include "glsl/types/request.h"

namespace glibra::glsl {

struct EsOptions {
    /// Textures that the program reads may have a border, which whoever draws says by the uniforms of
    /// borders.h.
    bool hasBorders = false;
    DrawForms draws{};
};

}  // namespace glibra::glsl
