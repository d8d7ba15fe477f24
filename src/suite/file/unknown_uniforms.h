#pragma once
// Reports uniform variables that a shot sets and its scene does not have.

#include <glibra/diagnostic.h>

#include "suite/suite.h"

namespace glibra::suite {

/// Replaces each glib-W23 about a uniform of Shot::ownUniforms by suite-E19 with the place in the suite. A
/// sweep over a misspelt name would otherwise make equal pictures under different names and pass. Other
/// messages stay as they are.
void reportUnknownUniforms(const Shot& shot, Diagnostics& diagnostics);

}  // namespace glibra::suite
