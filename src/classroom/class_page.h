#pragma once
// The page of a class, for a browser, and its table.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "classroom/classroom.h"
#include "classroom/import_table.h"

namespace glibra::classroom {

/// Pairs of similar submissions that the page lists with their passages; the others are counted.
inline constexpr std::size_t kMostListedPairs = 50;

/// The page as HTML. Nothing on it needs its script, which compares pictures and sorts the table. The
/// passages of similar submissions are read from their own folders (and no link is followed); a passage whose
/// file cannot be read is named without its text.
/// `serves`: for a server (cli/class_serve.h), to which points and comments are sent.
std::string classPage(const Classroom& classroom, bool serves = false);
/// The scripts that the page names: class.js, and grade.js if it is served.
std::string_view classScript();
std::string_view gradeScript();

/// What is written besides the page and the table.
struct SiteFiles {
    ImportOptions import{};     ///< the table for a grade book, if one is named
    bool studentPages = false;  ///< SITE/students/NAME.html (student_page.h)
    bool isAnonymous = false;   ///< the page has no names; SITE/names.csv has the key
};

/// Writes the tables, the pages of students, and SITE/index.html last. Returns nothing, or one file-E10.
Diagnostics writeSite(const Classroom& classroom, const std::filesystem::path& site,
                      const SiteFiles& files = {});

}  // namespace glibra::classroom
