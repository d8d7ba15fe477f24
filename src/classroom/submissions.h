#pragma once
// Finds what a class has handed in: a folder or a .glib file per student.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace glibra::classroom {

struct Submission {
    std::string name;              ///< of the folder, or of the file without ".glib"
    std::filesystem::path folder;  ///< the scene may read what is in it and below, and nothing beside it
    std::filesystem::path scene;   ///< empty if there is none to draw
    std::string problem;           ///< why there is none; one sentence
    bool isUnlisted = false;       ///< a folder could not be listed, which may have the scene
};

struct SubmissionOptions {
    std::string scene;                          ///< pattern of the scene's name in each folder, or empty
    std::filesystem::path reference;            ///< not a submission; its file name is the preferred one
    std::vector<std::filesystem::path> others;  ///< files and folders that are not submissions
};

struct Submissions {
    std::vector<Submission> all;       ///< in the order of their names
    std::vector<std::string> leftOut;  ///< names of files that are neither scenes nor folders
};

inline constexpr std::size_t kMostSubmissions = 2'000;

/// Every folder in `folder` is a submission, and so is every .glib file; names that begin with "." are left
/// out, and so are folders named "shaders" and "textures", which scenes search as a library. No link is
/// followed: a submission that is one, or whose scene is one, has a `problem`.
///
/// The scene of a folder is chosen by chooseScene. Errors: the folder cannot be read, has no submission, or
/// has more than kMostSubmissions.
Result<Submissions> findSubmissions(const std::filesystem::path& folder, const SubmissionOptions& options);

/// Chooses among the scenes of a submission, whose paths are relative to its folder. With a pattern only
/// those that it fits count: it is compared with the file name, or with the whole path if it contains a "/".
/// Of several, the first of these rules that leaves exactly one decides: the file with the name of the
/// reference, the file named as the submission, the file that is less deep than all others. Returns its
/// index, or the reason why there is none.
struct ChosenScene {
    std::size_t index = 0;
    std::string problem;  ///< empty if a scene was chosen
};
ChosenScene chooseScene(std::span<const std::filesystem::path> scenes, const std::string& submission,
                        const SubmissionOptions& options);

}  // namespace glibra::classroom
