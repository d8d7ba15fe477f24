#pragma once
// The moments at which a class is drawn: the times and sweeps of a command line, the shots of a suite, or
// those of an exercise.

#include <glibra/result.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "classroom/classroom.h"

namespace glibra::classroom {

/// More pictures than this of every submission are a mistake.
inline constexpr std::size_t kMostMoments = 100;

/// Every combination of the values of the sweeps at every time, as in a suite. `sweeps` are keys of its
/// `sweep` table: "uTol = [0, 0.1, 0.2]". No times: the time of `picture`. Errors: those of a suite, with the
/// place in the text of the sweeps.
Result<std::vector<Moment>> momentsOf(const suite::Shot& picture, std::span<const double> times,
                                      std::span<const std::string> sweeps);

/// The shots of a suite file, whose scene is the reference; or the moments of an exercise
/// (suite/file/exercise_file.h), whose reference is the solution. Error: the shots have several scenes.
Result<std::vector<Moment>> momentsOfSuite(const std::filesystem::path& file);

/// The uniforms that the moments vary, and the time, each with the pairs of neighbouring moments that differ
/// in it alone; at most kMostPairs.
std::vector<Slider> slidersOf(std::span<const Moment> moments);
inline constexpr std::size_t kMostPairs = 12;

}  // namespace glibra::classroom
