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

// The pictures of a reference without its source, for students to run the checks of a rubric themselves: a
// folder with a PNG file per moment and reference.json, which says what each of them is drawn with.

struct ReferencePictures {
    std::string scene;  ///< the name of the reference's file, by which the scene of a folder is chosen
    std::vector<Moment> moments;               ///< without a script
    std::vector<std::filesystem::path> files;  ///< the picture of each, with the folder before it
};

inline constexpr const char* kReferenceFile = "reference.json";
/// The rubric that stands beside it, if there is one.
inline constexpr const char* kReferenceRubric = "rubric.toml";

/// True if the folder has a reference.json.
bool hasReferencePictures(const std::filesystem::path& folder);

/// Error: suite-E35, at the file. The pictures themselves are read by runClass.
Result<ReferencePictures> readReferencePictures(const std::filesystem::path& folder);

/// Writes the pictures of a reference that was drawn into `site`: PNG files without any text, named after
/// their moments, and reference.json. Those that the folder had before are removed. Nothing of the source of
/// the reference is written but the name of its file and what the moments state. Error: file-E10.
Diagnostics writeReferencePictures(const Classroom& classroom, const std::filesystem::path& site,
                                   const std::filesystem::path& folder);

}  // namespace glibra::classroom
