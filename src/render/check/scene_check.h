#pragma once
// glibra check: prepares everything and draws nothing.

#include <glibra/render.h>

#include <filesystem>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "render/load/shared_parts.h"

namespace glibra::render {

/// A shader as the driver gets it.
struct TranslatedShader {
    std::string name;  ///< "3-Dots.frag": number of the program in its scene, its name, the stage
    std::string source;
};

/// The result of glibra check.
struct CheckResult {
    Diagnostics diagnostics;
    std::vector<TranslatedShader> shaders;
};

/// Resolves and reads every file, computes every buffer, and compiles and links every program. Draws nothing
/// and skips nothing but built-in noise that no sampler reads. `shared`: parts of other scenes, or null.
/// `isForWeb`: the shaders are those of GLSL ES 3.00 (glsl/es/es.h), with what that lacks.
CheckResult checkScene(gpu::Context& context, const std::filesystem::path& scene,
                       const RenderOptions& options, SharedParts* shared = nullptr, bool isForWeb = false);

}  // namespace glibra::render
