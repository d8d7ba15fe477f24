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

/// Runs the script once (language, section 2) and records every draw with its complete state. Looks files up
/// and reads none, but for the first bytes of noise textures and of what `Texture` names, which tell their
/// dimension.
///
/// The result's `diagnostics` are what running it has found, in the order of the text, the script's own not
/// among them; those of files stay with the FileReference. A statement with an error is skipped, the others
/// are carried out. Does not throw.
Scene interpret(const glib::Script& script, const InterpretOptions& options = {});

}  // namespace glibra::scene
