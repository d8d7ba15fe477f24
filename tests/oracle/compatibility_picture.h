#pragma once
// A scene drawn in the compatibility profile: fixed-function vertex arrays and matrices, shaders as they are
// written.

#include <cstddef>
#include <string>
#include <vector>

#include "compatibility_context.h"
#include "scene/scene.h"

namespace glibra::oracle {

/// One stage's complete text.
struct Source {
    glsl::Stage stage = glsl::Stage::vertex;
    std::string text;
};

/// State of the compatibility profile that a program switches on by what it writes (specification, 2.2
/// and 7.6), told by the case, so that nobody has to find it out from the shader's text a second time.
struct WrittenOutputs {
    int clipDistances = 0;
    bool backColors = false;
};

/// RGBA bytes, top row first.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::byte> data;
};

/// Draws all passes of an interpreted scene at its own size and at time 0 and returns the window. sources[i]
/// are the stages of Scene::programs[i]. Throws std::runtime_error on whatever goes wrong, GL errors among
/// it.
Pixels drawAsWritten(const CompatibilityContext& context, const scene::Scene& scene,
                     const std::vector<std::vector<Source>>& sources, const WrittenOutputs& written);

}  // namespace glibra::oracle
