#pragma once
// The moments at which a class is drawn: the times and sweeps of a command line (suite/file/sweep.h), the
// shots of a suite, or those of an exercise.

#include <glibra/result.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "classroom/classroom.h"
#include "suite/file/sweep.h"

namespace glibra::classroom {

using suite::momentsOf;

/// The shots of a suite file, whose scene is the reference; or the moments of an exercise
/// (suite/file/sweep.h), whose reference is the solution. Error: the shots have several scenes.
Result<std::vector<Moment>> momentsOfSuite(const std::filesystem::path& file);

/// The uniforms that the moments vary, and the time, each with the pairs of neighbouring moments that differ
/// in it alone; at most kMostPairs.
std::vector<Slider> slidersOf(std::span<const Moment> moments);
inline constexpr std::size_t kMostPairs = 12;

}  // namespace glibra::classroom
