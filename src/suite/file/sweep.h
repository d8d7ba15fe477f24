#pragma once
// Values of uniform variables in a suite. In `set` a key has one value: a number, true or false, a list of
// numbers (a vector, an array or a matrix, column by column), or a text as after "NAME=" of --set. In `sweep`
// a key has a list of such values, and every combination makes a shot. So [0, 0.1, 0.2] is one vec3 in `set`
// and three floats in `sweep`.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "suite/file/exercise_file.h"
#include "suite/file/toml_reader.h"
#include "suite/suite.h"

namespace glibra::suite {

/// A value as --set takes it, and as it appears in the name of a shot.
struct UniformValue {
    std::string text;  ///< "0.1", "1,0.5,0", "true", "{1 .5 0}"
    std::string
        label;  ///< "0.1", "1,0.5,0", "true"; "v2" (the second value) if it has more than four numbers
};

/// A uniform and its values: one in `set`, one or more in `sweep`.
struct UniformValues {
    std::string name;
    std::vector<UniformValue> values;
    Place place;
};

enum class UniformTable { set, sweep };

/// Reads one of the tables. A table inside it is a structure: { light = { color = [1, 1, 1] } } sets
/// "light.color".
std::vector<UniformValues> readUniforms(TomlReader& reader, const TomlTable& table, UniformTable kind);

/// One combination of the values of all sweeps.
struct Combination {
    std::string suffix;            ///< "@uTol=0.1@uAd=2"; empty without sweeps
    std::vector<std::string> set;  ///< "uTol=0.1", "uAd=2"
};

/// The number of combinations; 1 without sweeps, UINT64_MAX if it is larger than that.
std::uint64_t combinationCount(std::span<const UniformValues> sweeps);

/// All combinations. The values of the last sweep change fastest. The caller checks their number first.
std::vector<Combination> combinations(std::span<const UniformValues> sweeps);

// The moments at which several scenes are drawn to be compared: every combination of times and values.

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
