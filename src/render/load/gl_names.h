#pragma once
// GL's names for stages and topologies.

#include <glad/gl.h>

#include "geometry/mesh.h"
#include "glsl/types/stage.h"

namespace glibra::render {

/// GL_VERTEX_SHADER and so on.
GLenum glStage(glsl::Stage stage);

/// GL_POINTS and so on: the mode of a draw call.
GLenum glMode(geometry::Topology topology);

}  // namespace glibra::render
