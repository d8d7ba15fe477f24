#pragma once
// Finds what a class has handed in: a folder, a zip file or a .glib file per student.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "classroom/names.h"

namespace glibra::classroom {

struct Submission {
    std::string name;               ///< of the student, or of the folder, or of the file without its ending
    std::filesystem::path folder;   ///< the scene may read what is in it and below, and nothing beside it
    std::filesystem::path scene;    ///< empty if there is none to draw
    std::string problem;            ///< why there is none; one sentence
    bool isUnlisted = false;        ///< a folder could not be listed, which may have the scene
    std::string number{}, email{};  ///< of the student, as the learning platform or the roster has them
    bool isLate = false;            ///< the learning platform says so
    std::string time{};             ///< when it was handed in, if the learning platform says so
    std::string key{};              ///< the name of the folder or file that was handed in
    /// Zip files to unpack, and files to copy beside them, with the names that they get there. `folder` is
    /// made of them by unpackSubmissions.
    struct Part {
        std::filesystem::path file;
        std::string name;
    };
    std::vector<Part> parts{};
    std::vector<Member> members{};  ///< of a group, whose `name` has all names; empty for one student
};

/// Who has handed it in: the members of a group, or one student.
std::vector<Member> membersOf(const Submission& submission);
/// What follows the name of a student if another one has it, too: " (1234567)".
std::string numberBesideName(const std::string& number);
/// What --scene-of may call a submission: its name, also without the number that tells it from others of this
/// name, its number and key, and the names and numbers of the members.
std::vector<std::string> identitiesOf(const Submission& submission);

struct SubmissionOptions {
    std::vector<std::string> scenes;            ///< patterns of the scene's name, where a folder has several
    std::filesystem::path reference;            ///< not a submission; its file name is the preferred one
    std::vector<std::filesystem::path> others;  ///< files and folders that are not submissions
    NameRule names{};                           ///< what names of files and folders consist of
    std::map<std::string, std::string> sceneOf{};  ///< the pattern for one submission, by name, number or key
};

struct Submissions {
    std::vector<Submission> all;       ///< in the order of their names
    std::vector<std::string> leftOut;  ///< names of files that are neither scenes nor folders
};

inline constexpr std::size_t kMostSubmissions = 2'000;
inline constexpr int kDeepestFolder = 32;                ///< of a submission, and in a zip file
inline constexpr const char* kMark = ".made-by-glibra";  ///< a file in folders that are made anew in each run

/// Every folder in `folder` is a submission, and so is every .glib and every zip file; names that begin with
/// "." are left out, and so are folders named "shaders" and "textures", which scenes search as a library. A
/// file "x.glib.txt" is a submission with a `problem`. With a rule of names all files of one student are one
/// submission. No link is followed: a submission that is one, or whose scene is one, has a `problem`.
///
/// The scene of a folder is chosen by chooseScene, without what `options` names as no submission. A folder
/// without one that has one zip file is that file. Errors: the folder cannot be read, has no submission, or
/// has more than kMostSubmissions.
Result<Submissions> findSubmissions(const std::filesystem::path& folder, const SubmissionOptions& options);

/// What one student is about to hand in: a folder, a zip file or a .glib file, as one of many would be found.
/// Error: it is none of these.
Result<Submissions> ownSubmission(const std::filesystem::path& path, const SubmissionOptions& options);

/// True for a file name that ends with ".zip".
bool isArchive(const std::filesystem::path& file);

/// Gives a submission the scene of its folder, or the problem why there is none.
void findScene(Submission& submission, const SubmissionOptions& options);

}  // namespace glibra::classroom
