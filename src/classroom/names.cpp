#include "classroom/names.h"

#include <fmt/format.h>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <system_error>

#include "base/contained.h"
#include "base/files.h"
#include "base/text.h"
#include "base/utf8.h"
#include "image/file.h"
#include "suite/file/shot_name.h"

namespace glibra::classroom {
namespace {

/// True for the names of devices, which Windows gives no file, whatever follows a point.
bool isOfWindows(std::string_view name) {
    std::string word(name.substr(0, name.find('.')));
    while (word.ends_with(' ')) word.pop_back();
    for (const char* each : {"con", "prn", "aux", "nul", "conin$", "conout$"})
        if (base::sameWord(word, each)) return true;
    return word.size() == 4 && word[3] >= '0' && word[3] <= '9' &&
           (base::sameWord(word.substr(0, 3), "com") || base::sameWord(word.substr(0, 3), "lpt"));
}

std::string allowed(std::string_view name) {
    constexpr std::size_t kMostBytes = 200;
    std::string made;
    while (!name.empty()) {
        const base::Character next = base::firstCharacter(name);
        if (made.size() + next.bytes > kMostBytes) break;
        const bool isBad = !next.valid || next.code < ' ' || next.code == 0x7F ||
                           (next.code < 0x80 &&
                            std::string_view("/\\:*?\"<>|").find(name.front()) != std::string_view::npos);
        made += isBad ? "_" : name.substr(0, next.bytes);
        name.remove_prefix(next.bytes);
    }
    while (made.ends_with('.') || made.ends_with(' ')) made.pop_back();  // Windows drops them
    return made;
}

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 300;  // bytes; std::regex recurses once per byte
constexpr std::uint64_t kLargestMetadata = 16u << 20u;

std::string_view unquoted(std::string_view text) {
    text = base::trimmed(text, " \t\r");
    if (text.size() >= 2 && (text.front() == '\'' || text.front() == '"') && text.back() == text.front())
        text = text.substr(1, text.size() - 2);
    return text;
}

/// A line of the section :submitters:; each list item, which begins with "- ", is a member.
void readSubmitter(std::string_view line, std::vector<Member>& members) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos || line.substr(begin).starts_with(":submitters:")) return;
    if (line[begin] == '-' || members.empty()) members.emplace_back();
    const auto take = [&](std::string_view key, std::string& to) {
        const std::size_t at = line.find(key);
        if (at != std::string_view::npos && line.find_first_not_of(" -\t") == at && to.empty())
            to = unquoted(line.substr(at + key.size()));
    };
    take(":name:", members.back().name);
    take(":sid:", members.back().number);
    take(":email:", members.back().email);
}

/// The submitters of each submission of Gradescope's file, whose lines have one key each. A group hands in
/// one submission under the name of all. The file also has texts that programs of students have printed,
/// which lie deeper, in other sections.
std::map<std::string, Person> readMetadata(std::string_view text) {
    std::map<std::string, Person> people;
    Person* person = nullptr;
    std::string_view section;
    while (!text.empty()) {
        const std::string_view line = base::nextLine(text);
        if (line.starts_with("submission_")) {
            person = &people[std::string(line.substr(0, line.find(':')))];
            section = {};
            continue;
        }
        if (!person) continue;
        if (line.starts_with("  :")) {
            section = line.substr(0, line.find(':', 3) + 1);
            if (section == "  :created_at:") person->time = unquoted(line.substr(section.size()));
        }
        if (section == "  :submitters:") readSubmitter(line, person->members);
    }
    for (auto& [folder, each] : people) {
        each.name = joined(each.members, &Member::name);
        for (const Member& member : each.members) {
            if (each.number.empty()) each.number = member.number;
            if (each.email.empty()) each.email = member.email;
        }
        if (each.members.size() < 2) each.members.clear();
    }
    return people;
}

/// A place in a name that counts how often it is read: an expression such as (a+)+b tries a number of ways
/// that grows exponentially with the name.
class CountedLetter {
  public:
    using iterator_category = std::bidirectional_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountedLetter() = default;
    CountedLetter(const char* at, std::size_t& left) : at_(at), left_(&left) {}
    reference operator*() const {
        if (*left_ == 0) throw std::regex_error(std::regex_constants::error_complexity);
        --*left_;
        return *at_;
    }
    CountedLetter& operator++() {
        ++at_;
        return *this;
    }
    CountedLetter& operator--() {
        --at_;
        return *this;
    }
    CountedLetter operator++(int) { return {at_++, *left_}; }
    CountedLetter operator--(int) { return {at_--, *left_}; }
    friend bool operator==(const CountedLetter& a, const CountedLetter& b) { return a.at_ == b.at_; }

  private:
    const char* at_ = nullptr;
    std::size_t* left_ = nullptr;
};

/// False also if it cannot be decided in a million steps. `found` refers to `text`.
bool matches(const std::string& text, std::match_results<CountedLetter>& found,
             const std::regex& expression) try {
    static thread_local std::size_t left = 0;
    left = 1'000'000;
    const bool isMatch = std::regex_match(CountedLetter(text.data(), left),
                                          CountedLetter(text.data() + text.size(), left), found, expression);
    left = 1'000'000;  // for reading what was found
    return isMatch;
} catch (const std::regex_error&) {
    return false;
}

}  // namespace

std::vector<std::string> fileNames(std::vector<std::string> names) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string name = allowed(names[i]);
        if (name.empty() || name.front() == '.' || isOfWindows(name) ||
            taken.contains(suite::nameOnAnyDisk(name)))
            name = fmt::format("{:04} {}", i + 1, name);
        while (!taken.insert(suite::nameOnAnyDisk(name)).second) name += '_';
        names[i] = std::move(name);
    }
    return names;
}

Result<std::string> givenText(const std::filesystem::path& file, std::uint64_t largest) {
    if (std::error_code failure; std::filesystem::is_fifo(file, failure)) {
        std::ifstream pipe(file, std::ios::binary);
        std::string text(largest + 1, '\0');
        pipe.read(text.data(), static_cast<std::streamsize>(text.size()));
        text.resize(static_cast<std::size_t>(pipe.gcount()));
        if (text.size() > largest)
            return diagnose("file-E09",
                            fmt::format("'{}' is longer than {} bytes", file.generic_string(), largest));
        return text;
    }
    const auto bytes = image::readFile(file, {file.generic_string(), {}}, largest);
    if (!bytes) return bytes.diagnostics;
    return std::string(base::asText(*bytes));
}

std::string fromCodePage(std::string_view bytes, std::u16string_view upper) {
    std::string text;
    for (const char each : bytes) {
        const std::uint32_t code = static_cast<unsigned char>(each);
        base::appendUtf8(text, code < 0x80 || code - 0x80 >= upper.size() ? code : upper[code - 0x80]);
    }
    return text;
}

std::string joined(const std::vector<Member>& members, std::string Member::* which) {
    std::string all;
    for (const Member& each : members)
        if (!(each.*which).empty()) all += (all.empty() ? "" : ", ") + each.*which;
    return all;
}

std::string_view name(GradeBook book) {
    constexpr std::string_view kNames[] = {"", "moodle", "canvas", "gradescope"};
    return kNames[static_cast<std::size_t>(book)];
}

struct NameRule::Pattern {
    std::regex expression;
    int name = 1, number = 2, file = 3, late = 0;  ///< groups; 0: none
    int code = 0, lateCode = 0;                    ///< of a student without a name, and that it is late
};

Result<NameRule> NameRule::of(const std::string& text) try {
    NameRule rule;
    const auto flags = std::regex::ECMAScript | std::regex::optimize;
    if (text == "moodle") {
        rule.book_ = GradeBook::moodle;
        rule.pattern_ = std::make_shared<Pattern>(
            Pattern{std::regex("([^_].*?)_(\\d+)_assignsubmission_[a-z]+(?:_(.*))?", flags)});
    } else if (text == "canvas") {
        rule.book_ = GradeBook::canvas;
        rule.pattern_ = std::make_shared<Pattern>(Pattern{
            std::regex("(?:(.+?)_(?:(LATE)_)?(\\d+)|(?:(LATE)_)?(anon_[A-Za-z0-9]+))_\\d+_(.+)", flags), 1, 3,
            6, 2, 5, 4});
    } else if (text == "gradescope") {
        rule.book_ = GradeBook::gradescope;
        rule.pattern_ = std::make_shared<Pattern>(Pattern{std::regex("(submission_\\d+)", flags), 1, 0, 0});
    } else {
        Pattern pattern{std::regex(text, flags)};
        const auto groups = static_cast<int>(pattern.expression.mark_count());
        if (groups == 0)
            return withoutId(
                Severity::error,
                fmt::format("--names '{}': expected moodle, canvas, gradescope, or a regular expression with "
                            "a group for the name, as '(.*)_([0-9]+)'",
                            text));
        if (groups < 2) pattern.number = 0;
        if (groups < 3) pattern.file = 0;
        rule.pattern_ = std::make_shared<Pattern>(std::move(pattern));
    }
    return rule;
} catch (const std::regex_error&) {
    return withoutId(Severity::error, fmt::format("--names '{}': this is no regular expression", text));
}

void NameRule::readBeside(const fs::path& folder) {
    if (book_ != GradeBook::gradescope) return;
    const auto text = base::textIn(base::openBeneath(folder, "submission_metadata.yml"), kLargestMetadata);
    if (text) people_ = readMetadata(*text);
}

std::optional<Person> NameRule::split(const std::string& text) const {
    std::match_results<CountedLetter> found;
    if (!pattern_ || text.size() > kLongestName || !matches(text, found, pattern_->expression))
        return std::nullopt;
    const auto group = [&](int which) { return which > 0 ? found.str(static_cast<std::size_t>(which)) : ""; };
    Person person{group(pattern_->name), group(pattern_->number)};
    if (const std::string code = group(pattern_->code); !code.empty()) person.name = person.number = code;
    person.file = group(pattern_->file);
    person.isLate = !group(pattern_->late).empty() || !group(pattern_->lateCode).empty();
    if (const auto known = people_.find(text); known != people_.end()) {
        if (!known->second.name.empty()) person.name = known->second.name;
        if (!known->second.number.empty()) person.number = known->second.number;
        person.email = known->second.email;
        person.time = known->second.time;
        person.members = known->second.members;
    }
    if (person.name.empty()) return std::nullopt;
    return person;
}

}  // namespace glibra::classroom
