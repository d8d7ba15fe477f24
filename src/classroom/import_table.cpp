#include "classroom/import_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/text.h"
#include "base/utf8.h"
#include "classroom/grades.h"
#include "suite/number_of.h"

namespace glibra::classroom {
namespace {

/// One record: fields of strangers are made harmless, those of the platform's own table stay as they are.
class Record {
  public:
    void ours(std::string_view text) { record_.text(base::printableText(text)); }
    void theirs(std::string_view text) { record_.add(base::csvField(text, ",\"\r\n;")); }
    std::string end() { return record_.end(); }

  private:
    CsvRecord record_;
};

std::string gradeOf(const Classroom& room, const std::optional<std::size_t>& entry) {
    // Who has not been marked yet has no grade: an import would make the points that are missing 0.
    if (!entry || openCount(room.entries[*entry]) > 0) return {};
    const std::optional<double> points = pointsOf(room.entries[*entry]);
    return points ? fmt::format("{:.2f}", *points) : std::string();
}

constexpr const char* kMoodleHead[] = {
    "Identifier", "Full name", "Email address", "Grade", "Last modified (grade)", "Feedback comments"};
constexpr const char* kCanvasHead[] = {"Student", "ID", "SIS User ID", "SIS Login ID", "Section"};
constexpr const char* kGradescopeHead[] = {"First Name",  "Last Name",  "SID",     "Email",
                                           "Total Score", "Max Points", "Comments"};

/// The tables of a platform. The columns of Canvas that have grades are named by assignments.
struct BookForm {
    std::array<const char*, 2> marks{};      ///< columns by which its own table is known
    const char *grade = "", *feedback = "";  ///< columns of its own table that are filled in
    const char* maximum = "";                ///< the column that has the most points
    std::span<const char* const> head{};     ///< of a table that is made here
};

const BookForm& formOf(GradeBook book) {
    static constexpr std::array<BookForm, 4> kForms{
        {{},
         {{"identifier", "grade"}, "grade", "feedback comments", "maximum grade", kMoodleHead},
         {{"student", "id"}, "", "", "", kCanvasHead},
         {{"sid", "total score"}, "total score", "comments", "max points", kGradescopeHead}}};
    return kForms.at(static_cast<std::size_t>(book));
}

/// The platform's own table with the grades in it.
std::string filledTable(const Classroom& room, const ImportOptions& options) {
    const Roster& roster = *options.roster;
    std::vector<std::string> head = roster.records.front();
    const bool isCanvas = options.book == GradeBook::canvas;
    const auto known = [&](const std::optional<std::size_t>& column, const std::string& otherwise) {
        if (!column) head.push_back(otherwise);
        return column.value_or(head.size() - 1);
    };
    const BookForm& form = formOf(options.book);
    const std::size_t grade = isCanvas
                                  ? known(assignmentColumn(roster, options.assignment), options.assignment)
                                  : known(columnOf(roster, form.grade), "Grade");
    const std::size_t feedback =
        isCanvas ? head.size() : known(columnOf(roster, form.feedback), "Feedback comments");
    std::string table;
    const auto add = [&](const std::vector<std::string>& record, std::optional<std::size_t> entry,
                         bool isHead) {
        Record line;
        for (std::size_t i = 0; i < head.size(); ++i) {
            const std::string old = isHead ? head[i] : i < record.size() ? record[i] : "";
            if (isHead || !entry || (i != grade && i != feedback))
                line.theirs(old);
            else if (i == grade)
                line.ours(gradeOf(room, entry).empty() ? old : gradeOf(room, entry));
            else
                line.ours(feedbackOf(room, *entry));
        }
        table += line.end();
    };
    add(head, std::nullopt, true);
    std::vector<std::optional<std::size_t>> entryOf(roster.records.size());
    for (std::size_t i = 0; i < roster.students.size() && i < options.handed.size(); ++i)
        entryOf[roster.students[i].record] = options.handed[i];
    for (std::size_t i = 1; i < roster.records.size(); ++i) add(roster.records[i], entryOf[i], false);
    return table;
}

/// True if the roster is a table of the platform.
bool isOwnTable(const ImportOptions& options) {
    return options.roster && options.book != GradeBook::none &&
           std::ranges::all_of(formOf(options.book).marks,
                               [&](const char* each) { return columnOf(*options.roster, each).has_value(); });
}

/// "P2" and "991" of "P2 (991)"; nothing for a column that is no assignment.
std::optional<std::pair<std::string_view, std::string_view>> assignmentOf(std::string_view column) {
    const std::size_t open = column.rfind(" (");
    if (open == std::string_view::npos || !column.ends_with(')')) return std::nullopt;
    const std::string_view id = column.substr(open + 2, column.size() - open - 3);
    if (id.empty() || id.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    return std::pair(column.substr(0, open), id);
}

/// "Ana Maria", "Lee" of "Ana Maria Lee" and of "Lee, Ana Maria".
std::pair<std::string, std::string> firstAndLast(const std::string& name) {
    if (const std::size_t comma = name.find(", "); comma != std::string::npos)
        return {name.substr(comma + 2), name.substr(0, comma)};
    const std::size_t blank = name.rfind(' ');
    if (blank == std::string::npos) return {name, {}};
    return {name.substr(0, blank), name.substr(blank + 1)};
}

/// The most points that the platform's own table states, by its first line that has a number for it.
std::optional<double> maximumOf(const ImportOptions& options) {
    const Roster& roster = *options.roster;
    const bool isCanvas = options.book == GradeBook::canvas;
    const auto column = isCanvas ? assignmentColumn(roster, options.assignment)
                                 : columnOf(roster, formOf(options.book).maximum);
    for (std::size_t i = 1; column && i < roster.records.size(); ++i) {
        const std::vector<std::string>& record = roster.records[i];
        // Canvas has a line of its own for it.
        if (*column >= record.size() || (isCanvas && record[0].find("Points Possible") == std::string::npos))
            continue;
        if (const auto value = suite::numberOf<double>(record[*column])) return value;
    }
    return std::nullopt;
}

/// The line of one student, in the columns of importTable().
std::string gradeLine(const Classroom& room, GradeBook book, std::size_t entry, const Member& student) {
    const std::string grade = gradeOf(room, entry);
    Record line;
    switch (book) {
        case GradeBook::moodle:
            line.ours(student.number.empty() ? "" : "Participant " + student.number);
            line.ours(student.name);
            line.ours(student.email);
            line.ours(grade);
            line.theirs("-");  // never: Moodle keeps a grade that was given since
            line.ours(feedbackOf(room, entry));
            break;
        case GradeBook::canvas:
            line.ours(student.name);
            line.ours(student.number);
            for (int empty = 0; empty < 3; ++empty) line.ours("");
            line.ours(grade);
            break;
        case GradeBook::gradescope: {
            const auto [first, last] = firstAndLast(student.name);
            line.ours(first);
            line.ours(last);
            line.ours(student.number);
            line.ours(student.email);
            line.ours(grade);
            line.ours(mostPoints(room) > 0 ? fmt::format("{:g}", mostPoints(room)) : "");
            line.ours(feedbackOf(room, entry));
            break;
        }
        case GradeBook::none:
            break;
    }
    return line.end();
}

}  // namespace

std::optional<std::size_t> assignmentColumn(const Roster& roster, std::string_view wanted) {
    if (const auto same = columnOf(roster, wanted)) return same;
    std::optional<std::size_t> found;
    const std::vector<std::string>& head = roster.records.front();
    for (std::size_t i = 0; i < head.size(); ++i) {
        const auto assignment = assignmentOf(head[i]);
        if (!assignment || (assignment->first != wanted && assignment->second != wanted)) continue;
        if (found) return std::nullopt;
        found = i;
    }
    return found;
}

std::string whyNoAssignment(const ImportOptions& options) {
    if (options.book != GradeBook::canvas || !isOwnTable(options) ||
        assignmentColumn(*options.roster, options.assignment))
        return {};
    std::string known;
    for (const std::string& each : options.roster->records.front())
        if (assignmentOf(each)) known += fmt::format("{}'{}'", known.empty() ? "" : ", ", each);
    return fmt::format(
        "the roster has no column '{}', so that Canvas would add one; --assignment names one: {}",
        options.assignment, known.empty() ? "it has none" : known);
}

std::string whyOtherMaximum(const Classroom& room, const ImportOptions& options) {
    const double own = mostPoints(room);
    if (own <= 0 || !isOwnTable(options)) return {};
    const std::optional<double> theirs = maximumOf(options);
    if (!theirs || std::abs(*theirs - own) < 1e-6) return {};
    return fmt::format(
        "the roster says that there are at most {:g} points, and the rubric has {:g}; grades are not scaled",
        *theirs, own);
}

std::string importFile(GradeBook book) {
    return fmt::format("import-{}.csv", name(book));
}

std::string feedbackOf(const Classroom& room, std::size_t index) {
    const Entry& entry = room.entries[index];
    std::string text;
    for (const Mark& each : entry.marks)
        text += (text.empty() ? "" : "; ") +
                (each.isOpen ? fmt::format("{}: {}", each.check, each.reason)
                             : fmt::format("{}: {:g} of {:g}{}{}", each.check, each.points, each.most,
                                           each.reason.empty() ? "" : ", ", each.reason));
    if (entry.marks.empty()) {
        text = stateOf(entry);
        if (const std::string reason = reasonOf(entry); !reason.empty()) text += ": " + reason;
    }
    if (!entry.lateReason.empty()) text += "; " + entry.lateReason;
    if (!entry.comment.empty()) text += ". " + entry.comment;
    return text;
}

std::string importTable(const Classroom& room, const ImportOptions& options) {
    if (isOwnTable(options)) return filledTable(room, options);
    if (options.book == GradeBook::none) return {};
    Record head;
    for (const char* each : formOf(options.book).head) head.theirs(each);
    if (options.book == GradeBook::canvas) head.ours(options.assignment);
    std::string table = head.end();
    if (options.book == GradeBook::canvas && mostPoints(room) > 0) {
        Record most;
        most.theirs("    Points Possible");
        for (int i = 0; i < 4; ++i) most.ours("");
        most.ours(fmt::format("{:g}", mostPoints(room)));
        table += most.end();
    }
    for (std::size_t i = 0; i < room.entries.size(); ++i)
        for (const Member& member : membersOf(room.entries[i].submission))
            table += gradeLine(room, options.book, i, member);
    return table;
}

}  // namespace glibra::classroom
