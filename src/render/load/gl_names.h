#pragma once
// GL's names for stages and topologies.

#include <glad/gl.h>

#include "glsl/types/stage.h"
#include "plan/frame_plan.h"

namespace glibra::render {

/// GL_VERTEX_SHADER and so on.
GLenum glStage(glsl::Stage stage);

/// GL_POINTS, GL_TRIANGLE_STRIP and so on: the mode of a draw call.
GLenum glMode(const plan::Submission& submission);

}  // namespace glibra::render
