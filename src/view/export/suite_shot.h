#pragma once
// What a session shows, as a shot of a suite: `glibra test` renders the same picture from it.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>

#include "view/session/session.h"

namespace glibra::view {

/// A [[shot]] with the scene, the picture's size, changed values, time (if a program reads it), view, axes:
/// everything that `glibra render` would be told; a comment says what else the screen shows
/// (Session::onlyOnScreen). Paths are written relative to `folder`, where the suite file is.
std::string shotText(const Session& session, const std::string& name, const std::filesystem::path& folder);

/// Adds the shot at the end of a suite file, which is made if it is not there. What it held stays byte for
/// byte. Nothing is written if the file would not be a suite then: it is none now, or has a shot of that
/// name, or the name cannot be one; the diagnostics are those of suite::readSuiteText.
Diagnostics appendShot(const std::filesystem::path& suite, const std::string& name, const Session& session);

/// A name that the suite does not have yet: the scene's, or the scene's with a number.
std::string freeShotName(const std::filesystem::path& suite, const Session& session);

}  // namespace glibra::view
