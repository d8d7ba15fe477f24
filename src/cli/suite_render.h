#pragma once
// `glibra render --suite`: renders every shot of a suite to a picture, without goldens.

#include "cli/suite_options.h"

namespace glibra::cli {

/// Writes OUTPUT/SHOT.png (.exr for float pixels); with several suites OUTPUT/SUITE/SHOT.png. Without an
/// output folder, it is SUITE/SHOT.png. With `resume`, shots whose picture exists are left out. Returns the
/// exit status.
int renderSuites(const SuiteArguments& arguments, const std::string& output);

}  // namespace glibra::cli
