#pragma once
// Splits the names that learning platforms give to the files and folders of their exports into the student
// and the number by which the platform knows the student.

#include <glibra/result.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::classroom {

// Files and folders that are named after students.

/// For each name a name of a file or folder that Linux, macOS and Windows accept. Where two would be one on a
/// disk that ignores upper and lower case, and where a name is hidden or that of a device, the number of the
/// submission, counted from 1, stands before it: "0012 ana".
std::vector<std::string> fileNames(std::vector<std::string> names);

// Files that the teacher names on the command line.

/// The content of a file, or of a pipe, as in --rubric <(...): it is the user's own, so waiting for it does
/// no harm. The errors of image::readFile.
Result<std::string> givenText(const std::filesystem::path& file, std::uint64_t largest);

/// Text in a code page of one byte for each character: `upper` has those from 0x80 on; the others are
/// Latin-1.
std::string fromCodePage(std::string_view bytes, std::u16string_view upper);

/// The grade books whose names and tables are known.
enum class GradeBook { none, moodle, canvas, gradescope };
std::string_view name(GradeBook book);

/// A student.
struct Member {
    std::string name, number, email;
};

/// Who handed something in, as the name of a file or folder says. Of a group, `name` has the names of all,
/// and number and address are those of the first member that has them.
struct Person {
    std::string name, number;
    std::string email{};
    std::string file{};   ///< the name that the student gave to the file; empty for a folder
    bool isLate = false;  ///< the platform says so
    std::string time{};   ///< when it was handed in, if the platform says so: "2026-11-20 23:59:00 Z"
    std::vector<Member> members{};  ///< of a group; empty for one student
};

/// The names, numbers or addresses of a group, "Bob Ng, Cy Two"; those that are empty are left out.
std::string joined(const std::vector<Member>& members, std::string Member::* which);

/// A rule that splits names. Copies share what they were made of.
///   moodle      "Ana Lee_1234567_assignsubmission_file_", for a file with the student's name after it
///   canvas      "leeana_LATE_123_456_a.glib": the sortable name, the user's id, the id of the file; or
///               "LATE_anon_a1B2c_456_a.glib" if it hides names
///   gradescope  "submission_123"; submission_metadata.yml beside it has names, student ids, addresses, times
/// Any other text is a regular expression (ECMAScript) that fits the whole name: group 1 is the name, group 2
/// the number, group 3 the student's own file name; 2 and 3 may be left out.
class NameRule {
  public:
    /// The rule that keeps names as they are.
    NameRule() = default;
    /// Error: the text is neither a platform nor a regular expression with a group.
    static Result<NameRule> of(const std::string& text);

    [[nodiscard]] GradeBook book() const { return book_; }
    /// Reads what the platform has put beside the submissions.
    void readBeside(const std::filesystem::path& folder);
    /// Nothing if the name does not fit.
    [[nodiscard]] std::optional<Person> split(const std::string& name) const;

  private:
    struct Pattern;
    GradeBook book_ = GradeBook::none;
    std::shared_ptr<const Pattern> pattern_;
    std::map<std::string, Person> people_;  ///< of submission_metadata.yml, by the name of the folder
};

}  // namespace glibra::classroom
