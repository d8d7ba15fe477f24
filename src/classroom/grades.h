#pragma once
// The table for a grade book.

#include <string>

#include "classroom/classroom.h"

namespace glibra::classroom {

/// Comma-separated values (RFC 4180, UTF-8): a line of names, then one line per submission. With several
/// moments there are two more columns for each, its FLIP and its structural difference. A score that could
/// not be measured is empty. If a name is not ASCII the text begins with a byte order mark, which Excel
/// needs.
std::string gradesCsv(const Classroom& classroom);

}  // namespace glibra::classroom
