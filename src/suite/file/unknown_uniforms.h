#pragma once
// Uniforms that a shot names and its scene does not have.

#include <glibra/diagnostic.h>

#include "suite/suite.h"

namespace glibra::suite {

/// Puts suite-E19, with the place in the suite, in place of each glib-W23 about a uniform of
/// Shot::ownUniforms: a sweep over a misspelt name would make equal pictures under different names and pass.
/// Other messages stay as they are.
void reportUnknownUniforms(const Shot& shot, Diagnostics& diagnostics);

}  // namespace glibra::suite
