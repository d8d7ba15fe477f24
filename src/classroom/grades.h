#pragma once
// The table for a grade book.

#include <fmt/format.h>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "classroom/classroom.h"

namespace glibra::classroom {

// Records of comma-separated values (RFC 4180).

/// One field. Text that a spreadsheet would take for a formula (after blanks it begins with = + - @, or with
/// a character that stands for one of them) gets an apostrophe before it; line ends and control characters
/// become blanks, because some programs split at them even in quotes.
std::string csvField(std::string_view text);

class CsvRecord {
  public:
    void text(std::string_view value) { add(csvField(value)); }
    void count(std::size_t value) { add(fmt::format("{}", value)); }
    void score(const std::optional<double>& value) { add(value ? fmt::format("{:.5f}", *value) : ""); }
    /// A field as it is to stand there, quoted if it has to be.
    void add(const std::string& field) {
        line_ += isFirst_ ? field : "," + field;
        isFirst_ = false;
    }
    std::string end() { return line_ + "\r\n"; }

  private:
    std::string line_;
    bool isFirst_ = true;
};

/// Comma-separated values (RFC 4180, UTF-8): a line of names, then one line per submission. With several
/// moments there are two more columns for each, its FLIP and its structural difference. A score that could
/// not be measured is empty. If a name is not ASCII the text begins with a byte order mark, which Excel
/// needs.
std::string gradesCsv(const Classroom& classroom);

}  // namespace glibra::classroom
