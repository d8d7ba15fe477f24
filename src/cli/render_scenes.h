#pragma once
// `glibra render SCENE...`: scenes to pictures, in worker processes.

#include <optional>
#include <string>

#include "cli/render_arguments.h"
#include "render/file/job.h"

namespace glibra::cli {

/// The texture and the file of a --save; nothing if it is not NAME=FILE.
std::optional<render::Job::Save> readSave(const std::string& text);

/// Renders the scenes and prints what went wrong. Returns the exit status: the worst of all scenes.
int renderScenes(const RenderArguments& arguments);

}  // namespace glibra::cli
