#include "classroom/names.h"

#include <fmt/format.h>

#include <cstddef>
#include <regex>
#include <vector>

#include "base/contained.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 300;  // bytes; std::regex recurses once per byte
constexpr std::uint64_t kLargestMetadata = 16u << 20u;

std::string_view unquoted(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    text = text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
    if (text.size() >= 2 && (text.front() == '\'' || text.front() == '"') && text.back() == text.front())
        text = text.substr(1, text.size() - 2);
    return text;
}

/// The submitters of each submission of Gradescope's file, whose lines have one key each. A group hands in
/// one submission under the name of all. The file also has texts that programs of students have printed,
/// which lie deeper, in other sections.
std::map<std::string, Person> readMetadata(std::string_view text) {
    std::map<std::string, Person> people;
    Person* person = nullptr;
    std::string_view section;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
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
        if (section != "  :submitters:") continue;
        const auto take = [&](std::string_view key, std::string& to, const char* between) {
            const std::size_t at = line.find(key);
            if (at == std::string_view::npos || line.find_first_not_of(" -\t") != at) return;
            const std::string_view value = unquoted(line.substr(at + key.size()));
            if (value.empty() || (!to.empty() && !*between)) return;
            to += (to.empty() ? "" : between) + std::string(value);
        };
        take(":name:", person->name, ", ");
        take(":sid:", person->number, "");
        take(":email:", person->email, "");
    }
    return people;
}

}  // namespace

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
        rule.pattern_ = std::make_shared<Pattern>(Pattern{std::regex("(submission_(\\d+))", flags), 1, 2, 0});
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
    std::vector<std::byte> bytes;
    const base::Descriptor file = base::openBeneath(folder, "submission_metadata.yml");
    if (!file || base::readAll(file, kLargestMetadata, bytes) != 0) return;
    people_ = readMetadata({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::optional<Person> NameRule::split(const std::string& text) const {
    std::smatch found;
    if (!pattern_ || text.size() > kLongestName || !std::regex_match(text, found, pattern_->expression))
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
    }
    if (person.name.empty()) return std::nullopt;
    return person;
}

}  // namespace glibra::classroom
