#pragma once

#include <filesystem>
#include <vector>

#include "glib/script.h"
#include "scene/scene.h"

namespace glibra::scene {

/// Folders that are searched after the scene's own (language, 8.6): normally those in GLIBRA_PATH.
struct InterpretOptions {
    std::vector<std::filesystem::path> libraryRoots;
};

/// Runs the script once (language, 2) and records every draw with its complete state. Files are looked up but
/// not read, except for the first bytes of texture files, which show their dimension.
///
/// The `diagnostics` of the result are in the order of the text. They contain neither those of the script nor
/// those of files, which stay in the FileReference. A statement with an error is skipped and the others are
/// executed. Does not throw.
Scene interpret(const glib::Script& script, const InterpretOptions& options = {});

}  // namespace glibra::scene
