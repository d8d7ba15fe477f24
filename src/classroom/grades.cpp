#include "classroom/grades.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "base/text.h"
#include "base/utf8.h"
#include "suite/number_of.h"

namespace glibra::classroom {
namespace {

/// One record: fields of strangers are made harmless, those of the platform's own table stay as they are.
class Record {
  public:
    void text(std::string_view value) { add(csvField(value)); }
    void ours(std::string_view value) { text(base::printableText(value)); }
    void theirs(std::string_view value) { add(base::csvField(value, ",\"\r\n;")); }
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

/// Also the wide forms, which spreadsheets for East Asian languages accept.
bool beginsFormula(std::uint32_t code) {
    constexpr std::uint32_t kSigns[] = {'=', '+', '-', '@', 0xFF1D, 0xFF0B, 0xFF0D, 0xFF20, 0x2212};
    return std::ranges::find(kSigns, code) != std::end(kSigns);
}

constexpr bool isBlank(std::uint32_t code) {
    return code <= ' ' || (code >= 0x7F && code <= 0xA0) || code == 0x2028 || code == 0x2029 ||
           code == 0xFEFF;
}

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

/// "P2" and "991" of "P2 (991)"; nothing for a column that is no assignment.
std::optional<std::pair<std::string_view, std::string_view>> assignmentOf(std::string_view column) {
    const std::size_t open = column.rfind(" (");
    if (open == std::string_view::npos || !column.ends_with(')')) return std::nullopt;
    const std::string_view id = column.substr(open + 2, column.size() - open - 3);
    if (id.empty() || id.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    return std::pair(column.substr(0, open), id);
}

/// The column of Canvas's own table that `wanted` means: "P2 (991)" by that text, "P2" or "991"; nothing if
/// none or several fit.
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

/// One paragraph of plain text about a submission: its points by check, or its state.
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

using OrderedJson = nlohmann::ordered_json;

bool isFull(const Mark& mark) {
    return mark.points >= mark.most;
}

/// "at worst likeness 0.600 at uAd=0.3; compare the two pictures on the page".
std::string textOf(const Check& check, const Mark& mark, const Classroom& room) {
    std::string text = mark.reason;
    // A reason that names its place already says "at".
    if (mark.moment && !room.moments[*mark.moment].label.empty() && check.kind == Check::Kind::like)
        text += " at " + room.moments[*mark.moment].label;
    if (!isFull(mark)) text += (text.empty() ? "" : "; ") + adviceOf(check);
    return text;
}

struct Sums {
    double points = 0, most = 0;     ///< of automatic checks; `most` is without bonus
    double byHand = 0;               ///< the most that a person may give
    std::vector<std::string> names;  ///< of the checks by hand
};

Sums sumsOf(const Entry& entry) {
    Sums sums;
    for (const Mark& each : entry.marks) {
        if (each.isOpen) {
            sums.byHand += each.isBonus ? 0 : each.most;
            sums.names.push_back(each.check);
            continue;
        }
        sums.points += each.points;
        sums.most += each.isBonus ? 0 : each.most;
    }
    return sums;
}

/// What only the run of the whole class judges.
std::string leftOutText(const Rubric& rubric, const Sums& sums) {
    std::string text;
    if (!sums.names.empty())
        text = fmt::format("by hand, not judged here: {} ({:g} {}); ", fmt::join(sums.names, ", "),
                           sums.byHand, sums.byHand == 1 ? "point" : "points");
    return text + "only the run of the whole class compares the code with that of others" +
           (rubric.late ? " and takes points for lateness" : "");
}

std::string sumText(const Sums& sums) {
    return fmt::format("{:g} of {:g} automatic {}", sums.points, sums.most,
                       sums.most == 1 ? "point" : "points");
}

/// The messages of the scene, the sum, and what is left out.
std::string summaryText(const Rubric& rubric, const Entry& entry, const Sums& sums) {
    std::string text = sumText(sums) + "; " + leftOutText(rubric, sums) + "\n";
    if (const std::string why = reasonOf(entry); !why.empty()) text += why + "\n";
    for (const Diagnostic& each : entry.diagnostics) text += toString(each) + "\n";
    return text;
}

/// Calls `use` with each automatic check and its mark.
void forEach(const Rubric& rubric, const Entry& entry, const auto& use) {
    for (std::size_t i = 0; i < std::min(rubric.checks.size(), entry.marks.size()); ++i)
        if (!entry.marks[i].isOpen) use(rubric.checks[i], entry.marks[i]);
}

OrderedJson gradescopeOf(const Rubric& rubric, const Classroom& room, const Sums& sums) {
    OrderedJson tests = OrderedJson::array();
    forEach(rubric, room.entries.front(), [&](const Check& check, const Mark& mark) {
        tests.push_back({{"name", mark.check},
                         {"score", mark.points},
                         {"max_score", mark.isBonus ? 0 : mark.most},
                         {"status", isFull(mark) ? "passed" : "failed"},
                         {"output", textOf(check, mark, room)},
                         {"output_format", "text"},
                         {"visibility", "visible"}});
    });
    return {{"score", sums.points},
            {"execution_time", room.seconds},
            {"output", summaryText(rubric, room.entries.front(), sums)},
            {"output_format", "text"},
            {"visibility", "visible"},
            {"tests", std::move(tests)}};
}

OrderedJson submittyOf(const Rubric& rubric, const Classroom& room, const Sums& sums) {
    OrderedJson messages = OrderedJson::array();
    forEach(rubric, room.entries.front(), [&](const Check& check, const Mark& mark) {
        const std::string reason = textOf(check, mark, room);
        messages.push_back({{"message", fmt::format("{:g} of {:g}: {}{}{}", mark.points, mark.most,
                                                    mark.check, reason.empty() ? "" : ": ", reason)},
                            {"status", isFull(mark)      ? "success"
                                       : mark.points > 0 ? "warning"
                                                         : "failure"}});
    });
    messages.push_back(
        {{"message", summaryText(rubric, room.entries.front(), sums)}, {"status", "information"}});
    const double part = sums.most > 0 ? std::clamp(sums.points / sums.most, 0., 1.) : 1;
    return {{"status", "success"}, {"data", {{"score", part}, {"message", std::move(messages)}}}};
}

OrderedJson githubOf(const Rubric& rubric, const Classroom& room, const Sums& sums) {
    OrderedJson tests = OrderedJson::array();
    forEach(rubric, room.entries.front(), [&](const Check& check, const Mark& mark) {
        tests.push_back({{"name", mark.check},
                         {"status", isFull(mark) ? "pass" : "fail"},
                         {"score", mark.points},
                         {"message", textOf(check, mark, room)},
                         {"test_code", ""},
                         {"filename", ""},
                         {"line_no", 0},
                         {"execution_time", 0}});
    });
    return {{"version", 1},
            {"status", reachesAll(room) ? "pass" : "fail"},
            {"max_score", sums.most},
            {"tests", std::move(tests)}};
}

}  // namespace

std::string csvField(std::string_view text) {
    std::string clean;
    bool begun = false, isFormula = false;
    while (!text.empty()) {
        const base::Character next = base::firstCharacter(text);
        text.remove_prefix(next.bytes);
        if (isBlank(next.code)) {
            clean += ' ';
            continue;
        }
        if (!begun) isFormula = beginsFormula(next.code);
        begun = true;
        base::appendUtf8(clean, next.code);
    }
    if (isFormula) clean.insert(0, "'");
    return base::csvField(clean, ",;\"");
}

std::string gradesCsv(const Classroom& classroom) {
    const bool several = classroom.moments.size() > 1;
    const bool numbered = std::ranges::any_of(classroom.entries, [](const Entry& each) {
        return !each.submission.number.empty() || !each.submission.email.empty();
    });
    const bool pointed = mostPoints(classroom) > 0;
    Record head;
    for (const char* each : {"submission", "state", "reason", "scene", "pictures", "drawn", "flip",
                             "worst flip", "structure", "worst structure", "likeness", "errors", "warnings",
                             "stages", "uniforms", "most similar", "similarity", "not compared"})
        head.text(each);
    for (const Slider& each : classroom.sliders) head.text("reacts " + each.name);
    if (numbered)
        for (const char* each : {"number", "email"}) head.text(each);
    if (pointed) {
        for (const char* each : {"points", "most points"}) head.text(each);
        for (const Mark& each : classroom.entries.front().marks) head.text("points " + each.check);
        for (const char* each : {"not marked", "late", "comment"}) head.text(each);
    }
    if (several)
        for (const Moment& each : classroom.moments) {
            head.text("flip " + each.label);
            head.text("structure " + each.label);
            head.text("likeness " + each.label);
        }
    // Excel takes a table without this mark for one in the machine's own code page.
    const bool isAscii = std::ranges::all_of(classroom.entries, [](const Entry& each) {
        const std::string texts = each.submission.name + each.comment;
        return std::ranges::all_of(texts, [](char one) { return static_cast<unsigned char>(one) < 0x80; });
    });
    std::string table = (isAscii ? "" : "\xEF\xBB\xBF") + head.end();
    for (std::size_t i = 0; i < classroom.entries.size(); ++i) {
        const Entry& entry = classroom.entries[i];
        const std::optional<Scores> scores = scoresOf(entry);
        const auto part = [&](double Scores::* member) {
            return scores ? std::optional<double>((*scores).*member) : std::nullopt;
        };
        std::vector<std::string> stages, uniforms;
        const auto addNew = [](std::vector<std::string>& to, const std::string& word) {
            if (std::ranges::find(to, word) == to.end()) to.push_back(word);
        };
        for (const UsedProgram& program : entry.programs) {
            for (std::string stage : program.stages) {
                std::ranges::replace(stage, ' ', '-');
                addNew(stages, stage);
            }
            for (const DeclaredUniform& uniform : program.uniforms) addNew(uniforms, uniform.name);
        }
        Record line;
        line.text(entry.submission.name);
        line.text(stateOf(entry));
        line.text(reasonOf(entry));
        line.text(entry.submission.scene.empty()
                      ? std::string()
                      : entry.submission.scene.lexically_relative(entry.submission.folder).generic_string());
        line.count(classroom.moments.size());
        line.count(drawnCount(entry));
        line.score(part(&Scores::flip));
        line.score(part(&Scores::worstFlip));
        line.score(part(&Scores::structure));
        line.score(part(&Scores::worstStructure));
        line.score(part(&Scores::likeness));
        line.count(countOf(entry, Severity::error));
        line.count(countOf(entry, Severity::warning));
        line.text(fmt::format("{}", fmt::join(stages, " ")));
        line.text(fmt::format("{}", fmt::join(uniforms, " ")));
        const std::optional<Nearest> nearest = nearestOf(classroom, i);
        line.text(nearest ? comparedEntry(classroom, nearest->entry).submission.name : "");
        line.score(nearest ? std::optional(nearest->share) : std::nullopt);
        line.text(fmt::format("{}", fmt::join(entry.notCompared, "; ")));
        for (std::size_t slider = 0; slider < classroom.sliders.size(); ++slider)
            line.text(name(reactsOf(classroom, entry, slider)));
        if (numbered) {
            const std::vector<Member> members = membersOf(entry.submission);
            line.text(joined(members, &Member::number));
            line.text(joined(members, &Member::email));
        }
        if (pointed) {
            line.score(pointsOf(entry));
            line.score(mostPoints(classroom));
            for (const Mark& each : entry.marks)
                line.score(each.isOpen ? std::nullopt : std::optional(each.points));
            line.count(openCount(entry));
            line.text(entry.lateReason);
            line.text(entry.comment);
        }
        if (several)
            for (std::size_t moment = 0; moment < classroom.moments.size(); ++moment) {
                const std::optional<Score> score =
                    moment < entry.pictures.size() ? entry.pictures[moment].score : std::nullopt;
                line.score(score ? std::optional(score->flip) : std::nullopt);
                line.score(score ? std::optional(score->structure) : std::nullopt);
                line.score(score ? std::optional(score->likeness) : std::nullopt);
            }
        table += line.end();
    }
    return table;
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

bool reachesAll(const Classroom& room) {
    return std::ranges::all_of(room.entries.front().marks,
                               [](const Mark& each) { return each.isOpen || each.isBonus || isFull(each); });
}

std::vector<std::string> resultLines(const Rubric& rubric, const Classroom& room) {
    const Entry& entry = room.entries.front();
    std::vector<std::string> lines;
    std::size_t width = 0;
    const auto points = [](const Mark& mark) { return fmt::format("{:g} of {:g}", mark.points, mark.most); };
    for (const Mark& each : entry.marks) width = std::max(width, points(each).size());
    forEach(rubric, entry, [&](const Check& check, const Mark& mark) {
        const std::string reason = textOf(check, mark, room);
        lines.push_back(fmt::format("{:>{}}  {}{}{}{}", points(mark), width, mark.check,
                                    mark.isBonus ? " (bonus)" : "", reason.empty() ? "" : ": ", reason));
    });
    const Sums sums = sumsOf(entry);
    lines.push_back(sumText(sums));
    lines.push_back("glibra: note: " + leftOutText(rubric, sums));
    return lines;
}

std::string resultText(ResultFormat format, const Rubric& rubric, const Classroom& room) {
    const Sums sums = sumsOf(room.entries.front());
    const OrderedJson json = format == ResultFormat::gradescope ? gradescopeOf(rubric, room, sums)
                             : format == ResultFormat::submitty ? submittyOf(rubric, room, sums)
                                                                : githubOf(rubric, room, sums);
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace glibra::classroom
