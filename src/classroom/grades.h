#pragma once
// What is written for grade books and graders: the table of grades, the one that the grade book of a learning
// platform imports, and the results of automatic checks.

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "classroom/classroom.h"
#include "classroom/names.h"
#include "classroom/roster.h"
#include "classroom/rubric.h"

namespace glibra::classroom {

// Records of comma-separated values (RFC 4180).

/// One field. Text that a spreadsheet would take for a formula (after blanks it begins with = + - @, or with
/// a character that stands for one of them) gets an apostrophe before it; line ends and control characters
/// become blanks, because some programs split at them even in quotes.
std::string csvField(std::string_view text);

/// Comma-separated values (RFC 4180, UTF-8): a line of names, then one line per submission. With several
/// moments there are two more columns for each, its FLIP and its structural difference. A score that could
/// not be measured is empty. If a name is not ASCII the text begins with a byte order mark, which Excel
/// needs.
std::string gradesCsv(const Classroom& classroom);

// The table in the form that the grade book of a learning platform imports.

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

/// Canvas's own table has no such column: which ones it has. Empty if there is nothing to say.
std::string whyNoAssignment(const ImportOptions& options);

/// The platform's own table has another maximum than the rubric, which grades are not scaled to. Empty if
/// there is nothing to say.
std::string whyOtherMaximum(const Classroom& classroom, const ImportOptions& options);

/// The file: "import-moodle.csv".
std::string importFile(GradeBook book);

// What the automatic checks of a rubric say about one submission, for the student who is about to hand it in,
// and for platforms that run checks themselves.

/// The first entry of the class is the submission; its marks are those of the rubric.

/// True if every automatic check without bonus has all its points.
bool reachesAll(const Classroom& classroom);

/// A line per check: "2 of 4  looks like it: at worst likeness 0.600 at uAd=0.3; compare ...", the sum, and
/// what is not judged here.
std::vector<std::string> resultLines(const Rubric& rubric, const Classroom& classroom);

/// The platforms that read the result of a run as JSON.
enum class ResultFormat {
    gradescope,  ///< results.json (gradescope-autograders.readthedocs.io, "Autograder Specifications")
    submitty,    ///< validation_results.json of a custom validator (submitty.org, "Validation")
    github       ///< what the runners of GitHub Classroom hand to autograding-grading-reporter, before base64
};

/// Checks by hand are left out, and named in a text. Points of a bonus raise the score and not its most.
std::string resultText(ResultFormat format, const Rubric& rubric, const Classroom& classroom);

}  // namespace glibra::classroom
