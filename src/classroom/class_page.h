#pragma once
// The pages of a class, and those of its students.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "classroom/classroom.h"
#include "classroom/grades.h"

namespace glibra::classroom {

// Pages that leave the teacher's hands: one per student, and a class without names.

/// The class with "Submission 01" and so on for names, in an order that does not show the names, without
/// numbers, addresses, commands and folders. `keys` are the names in the new order.
Classroom anonymous(const Classroom& classroom, std::vector<std::string>& keys);

/// Pictures of a submission that are shown to its student and to who reviews it.
inline constexpr std::size_t kMostStudentPictures = 12;

// The page of a class, for a browser, and its table.

/// The page as HTML. Nothing on it needs its script, which compares pictures and sorts the table. The
/// passages of similar submissions are read from their own folders (and no link is followed); a passage whose
/// file cannot be read is named without its text.
/// `serves`: for a server (cli/class_input.h), to which points and comments are sent.
std::string classPage(const Classroom& classroom, bool serves = false);
/// The scripts that the page names: class.js, and grade.js if it is served.
std::string_view classScript();
std::string_view gradeScript();

/// What is written besides the page and the table.
struct SiteFiles {
    ImportOptions import{};     ///< the table for a grade book, if one is named
    bool studentPages = false;  ///< SITE/students/NAME.html
    bool isAnonymous = false;   ///< the page has no names; SITE/names.csv has the key
};

/// Writes the tables, the pages of students, and SITE/index.html last. Returns nothing, or one file-E10.
Diagnostics writeSite(const Classroom& classroom, const std::filesystem::path& site,
                      const SiteFiles& files = {});

}  // namespace glibra::classroom
