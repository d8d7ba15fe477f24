#pragma once
// Writes what a session shows as a shot of a suite, from which `glibra test` renders the same picture.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>

#include "view/session/session.h"

namespace glibra::view {

/// Returns the text of a [[shot]] with the scene and all options that differ from their defaults: size,
/// changed values, time (if a program reads it), view, axes and so on. A comment names what else the screen
/// shows (Session::onlyOnScreen). Paths are relative to `folder`, the folder of the suite file.
std::string shotText(const Session& session, const std::string& name, const std::filesystem::path& folder);

/// Appends the shot to a suite file, which is made if it does not exist. The earlier content stays byte for
/// byte. Nothing is written if the file is not a suite, has a shot of that name, or the name is not valid;
/// the diagnostics are those of suite::readSuiteText.
Diagnostics appendShot(const std::filesystem::path& suite, const std::string& name, const Session& session);

/// Returns a name that the suite does not have yet: that of the scene, with a number if necessary.
std::string freeShotName(const std::filesystem::path& suite, const Session& session);

}  // namespace glibra::view
