#pragma once
// GL's names for what scenes and shaders are made of.

#include <glad/gl.h>

#include "geometry/mesh.h"
#include "glsl/types/stage.h"

namespace glibra::render {

/// GL_VERTEX_SHADER and so on.
GLenum glStage(glsl::Stage stage);

/// GL_POINTS and so on: the first argument of a draw.
GLenum glMode(geometry::Topology topology);

}  // namespace glibra::render
