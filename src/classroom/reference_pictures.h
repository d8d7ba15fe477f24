#pragma once
// The pictures of a reference without its source, for students to run the checks of a rubric themselves: a
// folder with a PNG file per moment and reference.json, which says what each of them is drawn with.

#include <glibra/result.h>

#include <filesystem>
#include <string>
#include <vector>

#include "classroom/classroom.h"

namespace glibra::classroom {

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
