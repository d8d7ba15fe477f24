#pragma once
// The choices of raster state and samplers as GL names them.

#include <glad/gl.h>

#include "base/raster_state.h"

namespace glibra::gpu {

GLenum glFunction(base::Comparison comparison);
GLenum glFactor(base::BlendFactor factor);
GLenum glEquation(base::BlendEquation equation);
GLenum glAction(base::StencilAction action);

}  // namespace glibra::gpu
