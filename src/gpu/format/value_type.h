#pragma once
// GLSL types by their GL number.

#include <glad/gl.h>

#include "base/program_resources.h"

namespace glibra::gpu {

/// The type that has the GL number `type`: GL_FLOAT_VEC3 is "vec3". An unknown number gives BaseType::other
/// without a word.
base::ValueType valueType(GLenum type);

}  // namespace glibra::gpu
