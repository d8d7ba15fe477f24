#pragma once
// The values that shaders get without asking (language, section 6), for one draw.

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "glsl/builtins.h"

namespace glibra::render {

struct DrawFacts {
    glm::dmat4 modelView{1.0};
    glm::dmat4 projection{1.0};
    double timer = 0;  ///< 0..1
    glm::dvec4 color{1.0};
    double pointSize = 1;
    glm::dmat4 texture{1.0};  ///< gl_TextureMatrix[0]
};

/// The value as numbers, column by column; arrays of matrices (the texture matrices) have `elements` of them.
std::vector<double> suppliedValue(glsl::Builtin builtin, const DrawFacts& facts, int elements);

}  // namespace glibra::render
