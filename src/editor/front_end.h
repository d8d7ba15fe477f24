#pragma once
// The front end of glslang, for machines without a graphics driver.

#include <string>

#include "glsl/types/stage.h"

namespace glibra::editor {

/// What `glslangValidator` says of a shader, line by line as a driver would; empty if it finds nothing wrong,
/// or is not installed.
std::string frontEndLog(glsl::Stage stage, const std::string& source);

}  // namespace glibra::editor
