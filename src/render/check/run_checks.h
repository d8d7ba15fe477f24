#pragma once
// Answers the checks of a scene from what its renderer draws, and finds what depends on the order of
// invocations.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>

#include "gpu/context/context.h"
#include "render/scene_renderer.h"

namespace glibra::render {

/// The notes of the Print statements (check-N02) about what the buffers hold now.
Diagnostics printed(SceneRenderer& renderer);

/// True if the scene has Expect statements that run, or may do so at a time that they name.
bool hasChecks(const scene::Scene& scene);

/// Answers the checks at their own times, and at `time` those without one: an error for each that does not
/// hold or cannot be answered. Draws the pictures that it needs, at least that of `time`, and adds what
/// drawing them reports to `reported`, the scene's own diagnostics. What Expect error asks for is removed
/// from these.
Diagnostics answerChecks(SceneRenderer& renderer, double time, Diagnostics& reported, Stats& stats);

/// What is left of the reports of a scene that cannot be drawn: what Expect error asks for is removed. If no
/// error is left, each other check is check-E02.
Diagnostics answerWithoutPicture(const std::filesystem::path& scene, const RenderOptions& options,
                                 Diagnostics reported);

/// Draws the scene and answers its checks, for `glibra check --run`. The result has what was reported,
/// without what Expect error asks for, and an error for each check that does not hold. `known` is what
/// checkScene() has reported, which the result keeps. `shared`: parts of other scenes, or null.
Diagnostics runChecks(gpu::Context& context, const std::filesystem::path& scene, const RenderOptions& options,
                      Diagnostics known = {}, SharedParts* shared = nullptr);

// ---- Orders of invocations
// Whether a picture depends on the order in which the invocations of shaders run, which OpenGL leaves open.

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
