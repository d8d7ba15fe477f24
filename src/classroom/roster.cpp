#include "classroom/roster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "base/utf8.h"
#include "classroom/hand_in.h"
#include "classroom/names.h"
#include "glib/text.h"
#include "suite/number_of.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::size_t kMostProblems = 20;  // of a roster

/// "Participant 1234567", as Moodle's table has it, is 1234567.
std::string numberOf(const std::string& text) {
    constexpr std::string_view kParticipant = "Participant ";
    return text.starts_with(kParticipant) ? text.substr(kParticipant.size()) : text;
}

/// The letters and digits of a name without their order: "Lee, Ana" and "leeana" have the same. Letters
/// beyond ASCII stay bytes.
std::string sortedLetters(std::string_view name) {
    std::string letters;
    for (const char each : name) {
        const bool isBeyondAscii = static_cast<unsigned char>(each) >= 0x80;
        if (glib::isLetter(each) || glib::isDigit(each) || isBeyondAscii) letters += glib::lower(each);
    }
    std::ranges::sort(letters);
    return letters;
}

std::optional<std::size_t> firstColumn(const Roster& roster, std::initializer_list<const char*> names) {
    for (const char* each : names)
        if (const auto column = columnOf(roster, each)) return column;
    return std::nullopt;
}

/// Gives a member what the roster knows about the student.
void correct(Member& member, const Student& student) {
    if (!student.name.empty()) member.name = student.name;
    if (!student.number.empty()) member.number = student.number;
    if (!student.email.empty()) member.email = student.email;
}

/// The records of comma-separated values (RFC 4180), of a table whose separator is a semicolon, or of one
/// with tabs: the character that the first line has most often. A byte order mark is left out.
std::vector<std::vector<std::string>> csvRecords(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const std::string_view head = text.substr(0, text.find('\n'));
    char separator = ',';
    for (const char each : {';', '\t'})
        if (std::ranges::count(head, each) > std::ranges::count(head, separator)) separator = each;
    std::vector<std::vector<std::string>> records;
    std::vector<std::string> record;
    std::string field;
    bool quoted = false, any = false;
    const auto endRecord = [&] {
        if (!any) return;
        record.push_back(std::move(field));
        records.push_back(std::move(record));
        record.clear();
        field.clear();
        any = false;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char each = text[i];
        if (quoted) {
            if (each != '"')
                field += each;
            else if (i + 1 < text.size() && text[i + 1] == '"')
                field += text[++i];
            else
                quoted = false;
        } else if (each == '"' && field.empty()) {
            quoted = any = true;
        } else if (each == separator) {
            record.push_back(std::move(field));
            field.clear();
            any = true;
        } else if (each == '\n') {
            endRecord();
        } else if (each != '\r') {
            field += each;
            any = true;
        }
    }
    endRecord();
    return records;
}

}  // namespace

std::optional<std::size_t> columnOf(const Roster& roster, std::string_view name) {
    if (roster.records.empty()) return std::nullopt;
    const std::vector<std::string>& head = roster.records.front();
    for (std::size_t i = 0; i < head.size(); ++i)
        if (glib::sameWord(base::trimmed(head[i], kBlanks), name)) return i;
    return std::nullopt;
}

Result<Roster> readRoster(const fs::path& file) {
    constexpr std::uint64_t kLargest = 16U << 20U;
    Result<std::string> text = givenText(file, kLargest);
    if (!text) return text.diagnostics;
    Diagnostics problems;
    if (!base::isUtf8(*text)) {
        problems.push_back(withoutId(Severity::note, "the roster is not UTF-8; it is read as Latin-1",
                                     {file.generic_string(), 1, 1}));
        *text = fromCodePage(*text, {});
    }
    Roster roster{csvRecords(*text), {}};
    const auto name = firstColumn(roster, {"full name", "name", "student", "student name"});
    const auto first = firstColumn(roster, {"first name", "given name"});
    const auto last = firstColumn(roster, {"last name", "surname", "family name"});
    const auto number = firstColumn(
        roster, {"identifier", "id", "number", "sid", "student id", "id number", "sis user id", "user id"});
    const auto email = firstColumn(roster, {"email", "email address", "e-mail", "sis login id"});
    const auto scene = columnOf(roster, "scene");
    const auto days = columnOf(roster, "days late");
    const auto lateness = columnOf(roster, "lateness (h:m:s)");
    const auto status = columnOf(roster, "status");
    const auto time = firstColumn(roster, {"submitted", "submission time", "last modified (submission)"});
    if (!name && !first && !last && !number)
        return withoutId(Severity::error,
                         fmt::format("the roster '{}' has no column 'name' or 'number'; its first line has "
                                     "the names of the columns",
                                     file.generic_string()),
                         {file.generic_string(), 1, 1});
    for (std::size_t i = 1; i < roster.records.size(); ++i) {
        const auto field = [&](const std::optional<std::size_t>& column) {
            return column && *column < roster.records[i].size()
                       ? std::string(base::trimmed(roster.records[i][*column], kBlanks))
                       : std::string();
        };
        const auto warn = [&](const std::string& words, const char* expected) {
            // Moodle writes "-" for nobody's time.
            if (words.empty() || words == "-" || problems.size() >= kMostProblems) return;
            problems.push_back(withoutId(Severity::warning,
                                         fmt::format("cannot read '{}' in the roster '{}'; {}", words,
                                                     file.generic_string(), expected),
                                         {file.generic_string(), static_cast<int>(i + 1), 1}));
        };
        Student student{field(name), numberOf(field(number)), field(email), field(scene), {}, {}, i};
        if (student.name.empty()) student.name = base::trimmed(field(first) + " " + field(last), kBlanks);
        if (student.name.empty() && student.number.empty()) continue;
        // The second line of Canvas's table has the most points.
        if (student.number.empty() && glib::sameWord(student.name, "points possible")) continue;
        std::string late = field(days);
        std::ranges::replace(late, ',', '.');  // as in a spreadsheet in German
        if (const auto value = suite::numberOf<double>(late); value && *value >= 0 && *value < 1e4)
            student.daysLate = value;
        else
            warn(field(days), "'days late' is a number from 0 on");
        if (!student.daysLate) student.daysLate = latenessOf(field(lateness));
        if (!student.daysLate) warn(field(lateness), "a lateness is '27:13:05'");
        student.status = field(status);
        if (std::string words = field(time); isTime(words))
            student.time = std::move(words);
        else
            warn(words, "a time is '2026-11-20 23:59', or as Moodle writes it in English");
        roster.students.push_back(std::move(student));
    }
    return {std::move(roster), std::move(problems)};
}

std::optional<std::size_t> studentOf(const Roster& roster, const Member& member) {
    const auto only = [&](const auto& fits) -> std::optional<std::size_t> {
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < roster.students.size(); ++i) {
            if (!fits(roster.students[i])) continue;
            if (found) return std::nullopt;
            found = i;
        }
        return found;
    };
    const auto isSame = [](const std::string& a, const std::string& b) {
        return !a.empty() && glib::sameWord(a, b);
    };
    if (const auto found = only([&](const Student& each) { return isSame(member.number, each.number); }))
        return found;
    // A folder may be named by the number alone.
    if (const auto found = only([&](const Student& each) { return isSame(member.name, each.number); }))
        return found;
    if (const auto found = only([&](const Student& each) { return isSame(member.email, each.email); }))
        return found;
    const std::string letters = sortedLetters(member.name);
    if (letters.empty()) return std::nullopt;
    return only([&](const Student& each) { return sortedLetters(each.name) == letters; });
}

std::vector<std::optional<std::size_t>> applyRoster(const Roster& roster, Submissions& submissions) {
    std::vector<std::string> former;
    std::map<std::string, std::set<std::string>> numbers;  // of those with a name
    for (Submission& each : submissions.all) {
        std::vector<Member> members = membersOf(each);
        for (Member& member : members)
            if (const auto found = studentOf(roster, member)) correct(member, roster.students[*found]);
        former.push_back(std::exchange(each.name, joined(members, &Member::name)));
        numbers[each.name].insert(each.number = members.front().number);
        each.email = members.front().email;
        if (members.size() > 1) each.members = std::move(members);
    }
    std::set<std::string> taken;
    for (std::size_t i = 0; i < former.size(); ++i) {
        Submission& each = submissions.all[i];
        if (numbers[each.name].size() > 1 && !each.number.empty()) each.name += numberBesideName(each.number);
        for (int k = 1; !taken.insert(each.name).second; ++k)
            each.name = k == 1 ? former[i] : fmt::format("{} ({})", former[i], k);
    }
    std::ranges::sort(submissions.all, {}, &Submission::name);
    std::vector<std::optional<std::size_t>> handed(roster.students.size());
    for (std::size_t i = 0; i < submissions.all.size(); ++i)
        for (const Member& member : membersOf(submissions.all[i]))
            if (const auto found = studentOf(roster, member); found && !handed[*found]) handed[*found] = i;
    return handed;
}

std::optional<std::size_t> submissionOf(const Submissions& submissions, const Roster* roster,
                                        const std::string& student) {
    const auto first = [&](const auto& fits) -> std::optional<std::size_t> {
        const auto found = std::ranges::find_if(submissions.all, fits);
        if (found == submissions.all.end()) return std::nullopt;
        return static_cast<std::size_t>(found - submissions.all.begin());
    };
    const auto own = first([&](const Submission& each) {
        const std::vector<std::string> names = identitiesOf(each);
        return std::ranges::find(names, student) != names.end();
    });
    if (own || !roster) return own;
    const auto listed = studentOf(*roster, {student, student, student});
    if (!listed) return std::nullopt;
    return first([&](const Submission& each) {
        const std::vector<Member> members = membersOf(each);
        return std::ranges::any_of(
            members, [&](const Member& member) { return studentOf(*roster, member) == listed; });
    });
}

}  // namespace glibra::classroom
