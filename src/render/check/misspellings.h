#pragma once
// Warnings about names that are nearly right: what they were meant to set is not set, so the picture is
// wrong.

#include <glibra/diagnostic.h>

namespace glibra::render {

/// Takes the warnings about misspelt uniforms, attributes and members (language, 12.9) from `diagnostics` and
/// returns them as errors. `glibra check --run`, `test` and `class` fail with them, unless an
/// `Expect error` of the scene has removed them before.
Diagnostics takeMisspellings(Diagnostics& diagnostics);

}  // namespace glibra::render
