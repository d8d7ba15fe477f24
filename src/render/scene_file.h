#pragma once
// A scene file as the scene that is drawn.

#include <glibra/render.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "plan/overrides.h"
#include "render/stats.h"
#include "scene/interpret.h"
#include "scene/scene.h"

namespace glibra::render {

/// A scene as it is at time 0, with what gives it for other inputs.
struct InterpretedScene {
    scene::Scene scene;
    std::shared_ptr<scene::Interpretation> source;  ///< null: the scene is the same for all inputs
    scene::FrameInputs inputs;                      ///< of `scene`

    /// True if the scene changes with time.
    [[nodiscard]] bool changesWithTime() const;
};

/// Reads and interprets a scene file. The result holds the diagnostics of both steps, and no value only if
/// the file cannot be read (glib-E14, glib-E15). Values of variables come from options.set.
Result<InterpretedScene> interpretFile(const std::filesystem::path& path, const RenderOptions& options,
                                       Stats& stats);
/// Parses RenderOptions::set; no value if an entry cannot be parsed.
Result<std::vector<plan::Override>> parseOverrides(const std::vector<std::string>& set);

}  // namespace glibra::render
