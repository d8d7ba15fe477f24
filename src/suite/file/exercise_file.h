#pragma once
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

#include <glibra/result.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::suite {

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

}  // namespace glibra::suite
