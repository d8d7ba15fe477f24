#pragma once
// `glibra render --suite`: every shot of a suite to a picture, without goldens.

#include "cli/suite_options.h"

namespace glibra::cli {

/// Writes OUTPUT/SHOT.png (float shots: .exr), with several suites OUTPUT/SUITE/SHOT.png; without an output
/// folder SUITE/SHOT.png. With `resume` shots whose picture is there are left out. The exit status.
int renderSuites(const SuiteArguments& arguments, const std::string& output);

}  // namespace glibra::cli
