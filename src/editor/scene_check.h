#pragma once
// The messages of `glibra check` about a scene and its shaders, and the names that it gives to them.

#include <glibra/render.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "editor/completion.h"
#include "scene/scene.h"

namespace glibra::editor {

/// A program of a scene.
struct SceneProgram {
    struct Stage {
        glsl::Stage stage = glsl::Stage::vertex;
        std::filesystem::path file;  ///< the scene itself if the shader stands in it
    };
    std::string name;
    std::string file;  ///< of its Program statement
    int line = 1;
    std::vector<Stage> stages;
};

/// The names of a scene.
struct SceneNames {
    std::vector<SceneProgram> programs;
    std::vector<KnownName>
        values;  ///< uniforms that Program statements set, and variables, with their values
};
SceneNames namesOf(const scene::Scene& scene);

/// Adds the programs to what an editor knows about a text, and what their shaders declare at their
/// interfaces: all of them for a scene, those of the same programs for a shader. The stage of a shader that
/// none of them uses is that of its suffix. `textOf` gives the text of a file, or an empty one.
void addProgramNames(CodeContext& context, const std::vector<SceneProgram>& programs,
                     const std::filesystem::path& file,
                     const std::function<std::string(const std::filesystem::path&)>& textOf);

/// The text of a shader of the stage that does as little as possible, and is right in a program of its own.
std::string simplestShader(glsl::Stage stage);

struct SceneCheck {
    Diagnostics diagnostics;
    std::vector<std::filesystem::path> files;  ///< shaders, what they include, and included scenes
    SceneNames names;

    [[nodiscard]] bool uses(const std::filesystem::path& file) const {
        return std::ranges::find(files, file) != files.end();
    }
};

/// Checks a scene without a graphics driver: its text, its files and the translation of its shaders. A file
/// with the suffix of a shader is checked in a program with the simplest stages that it needs: the errors in
/// its own text and in what it includes. RenderOptions::texts has the texts that are not saved.
/// `asksFrontEnd`: with what glslang's front end says of the shaders, where it is installed. Does not throw.
SceneCheck checkScene(const std::filesystem::path& file, const RenderOptions& options,
                      bool asksFrontEnd = false);

/// The same in a process of its own, which asks a graphics driver, too, or the front end where there is none.
/// A text that takes too long, or all memory, affects nothing else: what is known without the driver counts.
/// Without that there are no diagnostics, and `failure` says why.
struct ContainedCheck {
    SceneCheck check;
    std::string failure;
};
ContainedCheck checkContained(const std::filesystem::path& file, const RenderOptions& options);

}  // namespace glibra::editor
