#pragma once
// Types of GLSL by their GL numbers, and the choices of raster state and samplers as GL names them.

#include <glad/gl.h>

#include "base/program_resources.h"
#include "base/raster_state.h"

namespace glibra::gpu {

/// The type that has the GL number `type`: GL_FLOAT_VEC3 is "vec3". An unknown number gives BaseType::other
/// without a word.
base::ValueType valueType(GLenum type);

GLenum glFunction(base::Comparison comparison);
GLenum glFactor(base::BlendFactor factor);
GLenum glEquation(base::BlendEquation equation);
GLenum glAction(base::StencilAction action);

}  // namespace glibra::gpu
