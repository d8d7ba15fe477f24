#pragma once

#include <filesystem>
#include <vector>

#include "glib/script.h"
#include "scene/scene.h"

namespace glibra::scene {

/// Folders searched besides the scene's own (language, 8.6): normally GLIBRA_PATH, split.
struct InterpretOptions {
    std::vector<std::filesystem::path> libraryRoots;
};

/// Runs the script once (language, section 2) and records every draw with its complete state. Looks files up, reads none.
/// Diagnostics of the text are in the result's `diagnostics`; those of files stay with the FileReference.
Scene interpret(const glib::Script& script, const InterpretOptions& options = {});

}  // namespace glibra::scene
