#pragma once
// The table in the form that the grade book of a learning platform imports.

#include <optional>
#include <string>
#include <vector>

#include "classroom/classroom.h"
#include "classroom/names.h"
#include "classroom/roster.h"

namespace glibra::classroom {

struct ImportOptions {
    GradeBook book = GradeBook::none;
    std::string assignment;          ///< the column of Canvas; the others need none
    const Roster* roster = nullptr;  ///< if given, its lines and columns are kept, with the grades in them
    /// For each student of the roster the entry, or nothing.
    std::vector<std::optional<std::size_t>> handed{};
};

/// Comma-separated values without a byte order mark, which the platforms do not need:
///   Moodle      Identifier ("Participant 123"), Full name, Email address, Grade, Last modified (grade),
///               Feedback comments; it refuses a table without the first, the fourth and the fifth of them
///               (mod/assign/feedback/offline)
///   Canvas      Student, ID, SIS User ID, SIS Login ID, Section, ASSIGNMENT
///   Gradescope  First Name, Last Name, SID, Email, Total Score, Max Points, Comments
/// There is one line for each student, so a group has several.
/// If the roster is the platform's own table, with these columns among others, it is that table with the
/// grades (and comments) filled in. A submission without points, or with a check that is not yet marked by
/// hand, has an empty grade, so that an import leaves the grade as it is.
std::string importTable(const Classroom& classroom, const ImportOptions& options);

/// The column of Canvas's own table that `wanted` means: "P2 (991)" by that text, "P2" or "991"; nothing if
/// none or several fit.
std::optional<std::size_t> assignmentColumn(const Roster& roster, std::string_view wanted);
/// Canvas's own table has no such column: which ones it has. Empty if there is nothing to say.
std::string whyNoAssignment(const ImportOptions& options);

/// The platform's own table has another maximum than the rubric, which grades are not scaled to. Empty if
/// there is nothing to say.
std::string whyOtherMaximum(const Classroom& classroom, const ImportOptions& options);

/// The file: "import-moodle.csv".
std::string importFile(GradeBook book);

/// One paragraph of plain text about a submission: its points by check, or its state.
std::string feedbackOf(const Classroom& classroom, std::size_t entry);

}  // namespace glibra::classroom
