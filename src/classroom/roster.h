#pragma once
// The list of a class as a learning platform or a teacher keeps it, and which of its students handed
// something in.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "classroom/submissions.h"

namespace glibra::classroom {

struct Student {
    std::string name, number, email;
    std::string scene;                ///< pattern for --scene-of, or empty
    std::optional<double> daysLate;   ///< of the column "days late", or Gradescope's "Lateness (H:M:S)"
    std::optional<std::string> time;  ///< when it was handed in, as daysBetween reads it (hand_in.h)
    std::size_t record = 0;           ///< in Roster::records
    std::string status{};             ///< of Moodle: "Submitted for grading - 1 day late"
};

/// A roster. Its columns are found by their names, in any order and case: "name", "full name" or "student",
/// or "first name" and "last name" or "surname"; "number", "id", "id number", "sid", "identifier", "sis user
/// id"; "email", "email address"; "scene", "days late", "lateness (h:m:s)", "status"; "submitted",
/// "submission time" or "last modified (submission)".
struct Roster {
    std::vector<std::vector<std::string>> records;  ///< of the file; the first has the names of the columns
    std::vector<Student> students;
};

/// Errors: the file cannot be read, or has no column of names or numbers. Warnings: times and
/// lateness that cannot be read, up to a limit.
Result<Roster> readRoster(const std::filesystem::path& file);

/// The column of that name, in any case, or nothing.
std::optional<std::size_t> columnOf(const Roster& roster, std::string_view name);

/// The student with that number, else that address, else that name, in whatever order the parts of the name
/// stand ("leeana", "Lee, Ana", "Ana Lee"); nothing if none or several fit.
std::optional<std::size_t> studentOf(const Roster& roster, const Member& member);

/// Gives the submissions and the members of groups the names, numbers and addresses of the roster. Returns
/// for each student the submission, or nothing if nothing was handed in.
std::vector<std::optional<std::size_t>> applyRoster(const Roster& roster, Submissions& submissions);

/// The submission that `student` means: one of its identities (identitiesOf), or the name, number or address
/// of a student of the roster whose submission it is; nothing if there is none.
std::optional<std::size_t> submissionOf(const Submissions& submissions, const Roster* roster,
                                        const std::string& student);

}  // namespace glibra::classroom
