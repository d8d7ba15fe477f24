#pragma once
// Draws a scene in the compatibility profile, with fixed-function vertex arrays and matrices, and with
// shaders as they are written.

#include <cstddef>
#include <string>
#include <vector>

#include "compatibility_context.h"
#include "scene/scene.h"

namespace glibra::oracle {

/// The complete text of one stage.
struct Source {
    glsl::Stage stage = glsl::Stage::vertex;
    std::string text;
};

/// State of the compatibility profile that a program needs because of the variables that it writes
/// (language, 2.2 and 7.6). The case states it, so that the oracle does not have to read it from the shader's
/// text.
struct WrittenOutputs {
    int clipDistances = 0;
    bool backColors = false;
};

/// A picture of RGBA bytes, top row first.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::byte> data;
};

/// Draws all passes of an interpreted scene at its own size and at time 0, and returns the content of the
/// window. sources[i] are the stages of Scene::programs[i]. Throws std::runtime_error if anything fails, also
/// for GL errors.
Pixels drawAsWritten(const CompatibilityContext& context, const scene::Scene& scene,
                     const std::vector<std::vector<Source>>& sources, const WrittenOutputs& written);

}  // namespace glibra::oracle
