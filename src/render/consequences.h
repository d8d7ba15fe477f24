#pragma once
// Which messages stay, and which warnings are errors: a mistake is reported once, and without what only
// follows from it.

#include <glibra/diagnostic.h>

namespace glibra::render {

/// Removes repeated messages and those that only follow from another message of the list. If `strict`, then
/// makes errors of all warnings.
void applyStrict(Diagnostics& diagnostics, bool strict);

/// Takes the warnings about misspelt uniforms, attributes and members (language, 12.9) from `diagnostics` and
/// returns them as errors: what these names were meant to set is not set, so the picture is wrong. `glibra
/// check --run`, `test` and `class` fail with them, unless an `Expect error` of the scene has removed them
/// before.
Diagnostics takeMisspellings(Diagnostics& diagnostics);

}  // namespace glibra::render
