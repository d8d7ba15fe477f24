#pragma once
// Sweeps: values of uniform variables, and the file of an exercise that has them.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "suite/file/toml_reader.h"
#include "suite/suite.h"

namespace glibra::suite {

// The file beside a scene that an exercise begins with: it names the solution, and what is drawn of both to
// compare them.
//
//     solution = "../../lights/spotlight.glib"
//     times = [0, 1]
//     sweep = ["cutoff=[15, 24]", "exponent=[0, 40]"]
//
// Where many pictures are right, it says what one must have in place of being that of the solution:
//
//     has = { color = [0.7, 0.07, 0.04], within = 0.15, least = 0.002, most = 0.5 }

/// How much of a picture has a colour: each component within `within` of it.
struct ColorShare {
    std::array<double, 3> color{};  ///< red, green, blue, 0..1
    double within = 0;
    double least = 0, most = 1;  ///< of the pixels, 0..1
};

struct Exercise {
    std::filesystem::path solution;   ///< with the folder of the file before it
    std::vector<double> times;        ///< seconds; empty: one picture at time 0
    std::vector<std::string> sweeps;  ///< values of uniforms as class --sweep takes them
    std::optional<ColorShare> has;    ///< what every picture has; nothing: it is that of the solution
};

/// True if the text has the key `solution`, which suites do not have.
bool isExercise(std::string_view text);

/// Reads such a text; `file` is where it stands. Errors as of a suite: suite-E01 to suite-E04.
Result<Exercise> readExerciseText(std::string_view text, const std::filesystem::path& file);

/// The same for a file. No value and no diagnostics: it does not exist, or is no exercise.
Result<Exercise> readExercise(const std::filesystem::path& file);

/// Where the file of a scene would be: "glib/exercises/gl07/spotlight.toml".
std::filesystem::path exerciseFileOf(const std::filesystem::path& scene);

// Values of uniform variables in a suite. In `set` a key has one value: a number, true or false, a list of
// numbers (a vector, an array or a matrix, column by column), or a text as after "NAME=" of --set. In `sweep`
// a key has a list of such values, and every combination makes a shot. So [0, 0.1, 0.2] is one vec3 in `set`
// and three floats in `sweep`.

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
