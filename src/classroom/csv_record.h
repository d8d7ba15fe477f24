#pragma once
// Records of comma-separated values (RFC 4180).

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::classroom {

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

}  // namespace glibra::classroom
