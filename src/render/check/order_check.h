#pragma once
// Whether a picture depends on the order in which the invocations of shaders run, which OpenGL leaves open.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>

#include "gpu/context/context.h"

namespace glibra::render {

struct Conductor;

/// True if a program of the scene stores in a texture or buffer that its shaders also read, as atomic
/// operations do. The plans must have been made.
bool mayDependOnOrder(const Conductor& conductor);

/// Draws the picture at options.time twice from the beginning: as it is, and with the invocations of compute
/// programs in reverse, and those of draws whose fragment stages alone store in parts of the target in
/// reverse. memory-W07 names the first node whose texture or buffer differs, if the picture or what the scene
/// expects or prints differs too; otherwise memory-N01 does. Empty for a scene that mayDependOnOrder() is
/// false for, or that cannot be drawn.
Diagnostics checkOrder(gpu::Context& context, const std::filesystem::path& scene,
                       const RenderOptions& options);

}  // namespace glibra::render
