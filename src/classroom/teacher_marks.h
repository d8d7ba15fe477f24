#pragma once
// What a teacher has typed: points instead of those of a check, and comments. It outlives the run, so it
// belongs to a submission by what lasts: the student's number, the name of what was handed in, the name. And
// it knows what was handed in when it was typed.

#include <glibra/result.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "classroom/classroom.h"

namespace glibra::classroom {

/// What a teacher has typed about one submission.
struct OwnMarks {
    std::map<std::string, double> points{};  ///< by the name of the check, instead of what the check gave
    std::string comment{};
    std::string number{}, folder{};  ///< of the student, and Submission::key; empty if they are not known
    /// For the points of each check the digest of what was handed in when they were typed. Without one they
    /// count as typed for what was there at the last run.
    std::map<std::string, std::string> handedIn{};
};
/// By the name that the submission had.
using TeacherMarks = std::map<std::string, OwnMarks>;

/// The file beside the page that keeps what a teacher has typed.
inline constexpr const char* kMarksFile = "marks.json";
/// The file that keeps the digests of what had been handed in at the last run.
inline constexpr const char* kDigestsFile = "handed-in.json";

/// No marks if there is no such file; error: it cannot be read (suite-E27).
Result<TeacherMarks> readTeacherMarks(const std::filesystem::path& site);
Result<TeacherMarks> parseTeacherMarks(std::string_view text, const std::string& file = {});
std::string toText(const TeacherMarks& marks);
/// Returns 0 or an error number.
int writeTeacherMarks(const TeacherMarks& marks, const std::filesystem::path& site);

/// By Submission::key.
using Digests = std::map<std::string, std::string>;
/// What the last run wrote; nothing if it cannot be read.
Digests readDigests(const std::filesystem::path& site);
void writeDigests(const Classroom& classroom, const std::filesystem::path& site);
/// Gives points without a digest that of the last run.
void addDigests(TeacherMarks& marks, const Classroom& classroom, const Digests& last);

/// For each entry of the class the name of its marks; empty if there are none. Marks belong to the only
/// submission with their number, else with their folder, else with their name (identitiesOf).
std::vector<std::string> placesOf(const TeacherMarks& marks, const Classroom& classroom);

/// The marks of an entry; new ones, with its number and folder, if it has none.
OwnMarks& marksOf(TeacherMarks& marks, const Classroom& classroom, std::size_t entry);
/// Types points for a check of an entry; nothing: those of the check again.
void typePoints(OwnMarks& marks, const Entry& entry, const std::string& check,
                const std::optional<double>& points);

/// Replaces points and adds comments in all entries; points stay within 0 and the most of the check. Points
/// that were typed for an earlier hand-in no longer replace those of a check, and those by hand stay with a
/// remark. Sets Classroom::unplaced. Returns what the teacher should know: marks that belong to no submission
/// or check, and to an earlier hand-in (suite-W05).
Diagnostics applyTeacherMarks(const TeacherMarks& marks, Classroom& classroom);

}  // namespace glibra::classroom
