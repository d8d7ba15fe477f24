#pragma once
// The moments at which several scenes are drawn to be compared: every combination of times and values.

#include <glibra/result.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "suite/file/exercise_file.h"
#include "suite/suite.h"

namespace glibra::suite {

/// What all scenes are drawn with: a time, values of uniforms, and the other options of a picture.
struct Moment {
    std::string label;                ///< "uTol=0.1", "time=2.5"; empty if it is the only one
    Shot shot;                        ///< without a name; its script is the reference
    std::optional<ColorShare> has{};  ///< of an exercise
};

/// More pictures than this of every scene are a mistake.
inline constexpr std::size_t kMostMoments = 100;
Diagnostic tooManyMoments(std::uint64_t count);

/// Every combination of the values of the sweeps at every time, as in a suite. `sweeps` are keys of its
/// `sweep` table: "uTol = [0, 0.1, 0.2]". No times: the time of `picture`. Errors: those of a suite, with the
/// place in the text of the sweeps.
Result<std::vector<Moment>> momentsOf(const Shot& picture, std::span<const double> times,
                                      std::span<const std::string> sweeps);

/// Those of an exercise, whose reference is the solution; errors name its file.
Result<std::vector<Moment>> momentsOf(const Exercise& exercise, const std::filesystem::path& file,
                                      const RenderOptions& options = {});

}  // namespace glibra::suite
