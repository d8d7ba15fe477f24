#include "suite/file/toml_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "base/suggest.h"
#include "base/utf8.h"
#include "glib/number.h"
#include "glib/text.h"

namespace glibra::suite {
namespace {

// Explains why a text is not TOML.

/// Hints for the most common mistakes; empty for others. `said` is the message of the parser about `offset`.
std::string_view syntaxHint(std::string_view said, std::string_view text, std::size_t offset) {
    const std::string_view rest = text.substr(offset);
    const bool endsLine = rest.empty() || rest[0] == '\n' || rest[0] == '\r';
    const std::string_view line = text.substr(0, offset).substr(text.substr(0, offset).rfind('\n') + 1);
    const bool isValue = line.find('=') != std::string_view::npos;
    if (rest.size() > 1 && rest[0] == '.' && glib::isDigit(rest[1]))
        return "a number needs a digit before its point, as 0.5";
    if (rest.size() > 1 && glib::isDigit(rest[0]) && rest[1] == '.' &&
        (rest.size() == 2 || !glib::isDigit(rest[2])))
        return "a number needs a digit after its point, as 1.0";
    if (said.starts_with("boolean") &&
        (glib::sameWord(rest.substr(0, 4), "true") || glib::sameWord(rest.substr(0, 5), "false")))
        return "true and false are written in small letters";
    if (rest.starts_with("\xe2\x80\x98") || rest.starts_with("\xe2\x80\x9c"))
        return "a text stands between plain quotes, as \"teapot.glib\"";
    if (said.starts_with("string") && endsLine) return "the closing quote is missing";
    if (said.starts_with("inline table") && endsLine)
        return "a table in braces stands on one line; of a long one each key gets a line: set.uKd = 0.5";
    if (!rest.empty() && rest[0] == ':' && !isValue) return "a key and its value have '=' between them";
    const bool isWord = said.starts_with("value") || said.starts_with("boolean") ||
                        (said.starts_with("decimal integer") && !rest.empty() && glib::isLetter(rest[0]));
    if (isWord && isValue) return "a text needs quotes, as \"teapot.glib\"";
    return {};
}

/// Returns the offset after the string that begins at `begin`: of one line, or of several lines between three
/// quotes.
std::size_t endOfString(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string three(3, quote);
    const bool isLong = text.substr(begin).starts_with(three);
    std::size_t at = begin + (isLong ? 3 : 1);
    for (; at < text.size(); ++at) {
        if (quote == '"' && text[at] == '\\')
            ++at;
        else if (isLong && text.substr(at).starts_with(three))
            return at + 3;
        else if (!isLong && (text[at] == quote || text[at] == '\n'))
            return at + 1;
    }
    return text.size();
}

/// Returns the message of toml++ about that offset of the text, without its preamble, and what to write
/// instead if it is a common mistake.
std::string syntaxMessage(std::string_view said, std::string_view text, std::size_t offset) {
    constexpr std::string_view kPreamble = "Error while parsing ";
    if (said.starts_with(kPreamble)) said.remove_prefix(kPreamble.size());
    if (said.find("TOML_MAX_NESTED_VALUES") != std::string_view::npos)
        return "not TOML: arrays and tables stand too deep in each other";
    const std::string_view hint = syntaxHint(said, text, offset);
    return fmt::format("not TOML: {}{}{}", base::printableText(said), hint.empty() ? "" : "; ", hint);
}

/// Returns the offset of the first key with too many parts ("a.b.c"), or nothing. The parser makes a table of
/// each part and destroys them recursively, so a key of 100,000 parts would overflow the stack.
std::optional<std::size_t> endlessKey(std::string_view text) {
    constexpr int kMostParts = 16;
    int dots = 0;
    std::size_t begin = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = endOfString(text, at) - 1;
        } else if (c == '#') {
            at = std::min(text.find('\n', at), text.size()) - 1;
        } else if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) {
            dots = 0;
            begin = at + 1;
        } else if (c == '.' && ++dots == kMostParts) {
            return std::min(text.find_first_not_of(" \t", begin), at);
        }
    }
    return std::nullopt;
}

constexpr std::size_t kMostMessages = 100;
constexpr std::size_t kBlock = 1024;  // bytes

/// False for the second and later bytes of a character of UTF-8.
bool beginsCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
}

/// The key most similar to a word, or a key that continues the word or begins it: "max" for "maximum",
/// "fraction" for "frac".
std::string nearestKey(std::string_view word, std::span<const std::string_view> keys) {
    constexpr std::size_t kLeast = 3;
    if (std::string near = base::nearestName(word, keys); !near.empty()) return near;
    for (const std::string_view key : keys)
        if (std::min(word.size(), key.size()) >= kLeast && (word.starts_with(key) || key.starts_with(word)))
            return std::string(key);
    return {};
}

TomlPosition positionOf(const toml::source_region& source) {
    return {source.begin.line, source.begin.column};
}

/// The library limits how deep values are nested; endlessKey limits the keys.
TomlValue valueOf(const toml::node& node) {
    TomlValue value{{}, positionOf(node.source())};
    if (const auto* text = node.as_string()) {
        value.content = **text;
    } else if (const auto* whole = node.as_integer()) {
        value.content = **whole;
    } else if (const auto* number = node.as_floating_point()) {
        value.content = **number;
    } else if (const auto* truth = node.as_boolean()) {
        value.content = **truth;
    } else if (const auto* list = node.as_array()) {
        TomlList items;
        items.reserve(list->size());
        for (const toml::node& each : *list) items.push_back(valueOf(each));
        value.content = std::move(items);
    } else if (const auto* table = node.as_table()) {
        TomlTable entries;
        entries.reserve(table->size());
        for (const auto& [key, each] : *table)
            entries.push_back({std::string(key.str()), positionOf(key.source()), valueOf(each)});
        std::ranges::stable_sort(entries, {}, &TomlEntry::position);
        value.content = std::move(entries);
    }
    return value;
}

}  // namespace

bool hasKey(const TomlTable& table, std::string_view key) {
    return std::ranges::find(table, key, &TomlEntry::key) != table.end();
}

std::string described(const TomlValue& value) {
    if (const auto* text = value.as<std::string>()) return "the text " + glib::inQuotes(*text);
    if (const auto* whole = value.as<std::int64_t>()) return fmt::format("the number {}", *whole);
    if (const auto* number = value.as<double>()) return "the number " + glib::numberText(*number);
    if (const auto* truth = value.as<bool>()) return *truth ? "true" : "false";
    if (value.as<TomlList>()) return "a list";
    return value.as<TomlTable>() ? "a table" : "a date or time";
}

TomlReader::TomlReader(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {
    // A byte order mark is not part of any column.
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    lines_.push_back(0);
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (i % kBlock == 0) blocks_.push_back(characters);
        if (beginsCharacter(text_[i])) ++characters;
        if (text_[i] == '\n') lines_.push_back(i + 1);
    }
}

std::size_t TomlReader::charactersBefore(std::size_t offset) const {
    if (offset >= text_.size() && blocks_.empty()) return 0;
    const std::size_t block = std::min(offset / kBlock, blocks_.size() - 1);
    const std::string_view rest = text_.substr(block * kBlock, offset - block * kBlock);
    return blocks_[block] + static_cast<std::size_t>(std::ranges::count_if(rest, beginsCharacter));
}

Place TomlReader::placeOf(const TomlPosition& position) const {
    // The library counts characters, we count bytes. Tables that it makes itself have no place.
    if (position.line == 0) return {path_, 1, 1};
    const std::size_t line = std::min<std::size_t>(position.line, lines_.size());
    const std::size_t begin = lines_[line - 1];
    const std::size_t end = line < lines_.size() ? lines_[line] - 1 : text_.size();
    const std::size_t wanted = charactersBefore(begin) + std::max<std::size_t>(position.column, 1) - 1;
    const auto after = std::ranges::upper_bound(blocks_, wanted);
    const auto block = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - blocks_.begin(), 1) - 1);
    std::size_t at = std::max(begin, block * kBlock);
    for (std::size_t seen = charactersBefore(at); at < end; ++at)
        if (beginsCharacter(text_[at]) && seen++ == wanted) break;
    return {path_, static_cast<int>(line), static_cast<int>(std::min(at, end) - begin) + 1};
}

const TomlTable* TomlReader::root() {
    if (const auto offset = endlessKey(text_)) {
        const auto line = std::ranges::upper_bound(lines_, *offset) - lines_.begin();
        const std::size_t column = *offset - lines_[static_cast<std::size_t>(line) - 1] + 1;
        report("suite-E01", "a key has too many parts",
               Place{path_, static_cast<int>(line), static_cast<int>(column)});
        return nullptr;
    }
    try {
        root_ = valueOf(toml::parse(text_, path_));
    } catch (const toml::parse_error& wrong) {
        const Place where = placeOf(positionOf(wrong.source()));
        const std::size_t at =
            lines_.at(static_cast<std::size_t>(where.line) - 1) + static_cast<std::size_t>(where.column) - 1;
        report("suite-E01", syntaxMessage(wrong.description(), text_, std::min(at, text_.size())), where);
    }
    return root_ ? root_->as<TomlTable>() : nullptr;
}

std::optional<bool> TomlReader::truth(const TomlValue& value, std::string_view name) {
    if (const auto* truth = value.as<bool>()) return *truth;
    wrongType(value, name, "true or false");
    return std::nullopt;
}

std::optional<double> TomlReader::number(const TomlValue& value, std::string_view name, double low,
                                         double high) {
    std::optional<double> number;
    if (const auto* whole = value.as<std::int64_t>()) number = static_cast<double>(*whole);
    if (const auto* real = value.as<double>()) number = *real;
    if (!number) {
        wrongType(value, name, "a number");
        return std::nullopt;
    }
    if (*number >= low && *number <= high) return number;
    const std::string range =
        high < std::numeric_limits<double>::max()
            ? fmt::format("between {} and {}", glib::numberText(low), glib::numberText(high))
            : fmt::format("a finite number from {} upwards", glib::numberText(low));
    report("suite-E04", fmt::format("{}: {} is not {}", name, glib::numberText(*number), range), value);
    return std::nullopt;
}

std::optional<int> TomlReader::whole(const TomlValue& value, std::string_view name, int low, int high) {
    const auto* number = value.as<std::int64_t>();
    if (!number) {
        wrongType(value, name, "a whole number");
        return std::nullopt;
    }
    if (*number >= low && *number <= high) return static_cast<int>(*number);
    report("suite-E04", fmt::format("{}: {} is not between {} and {}", name, *number, low, high), value);
    return std::nullopt;
}

std::optional<std::string> TomlReader::text(const TomlValue& value, std::string_view name) {
    const auto* found = value.as<std::string>();
    if (!found) {
        wrongType(value, name, "a text between quotes");
        return std::nullopt;
    }
    const std::string& characters = *found;
    if (characters.empty() || characters.find('\0') != std::string::npos) {
        report("suite-E04",
               fmt::format("{}: {}", name,
                           characters.empty() ? "the text is empty" : "the text has a zero byte"),
               value);
        return std::nullopt;
    }
    return characters;
}

std::optional<std::vector<std::string>> TomlReader::texts(const TomlValue& value, std::string_view name) {
    const auto* list = value.as<TomlList>();
    if (!list) {
        if (!value.as<std::string>()) {
            wrongType(value, name, "a text between quotes, or a list of such");
            return std::nullopt;
        }
        auto one = text(value, name);
        if (!one) return std::nullopt;
        return std::vector<std::string>{std::move(*one)};
    }
    if (list->empty()) {
        report("suite-E04", fmt::format("{}: the list is empty", name), value);
        return std::nullopt;
    }
    std::vector<std::string> all;
    for (const TomlValue& each : *list)
        if (auto one = text(each, name)) all.push_back(std::move(*one));
    if (all.size() < list->size()) return std::nullopt;
    return all;
}

const TomlTable* TomlReader::table(const TomlValue& value, std::string_view name) {
    const auto* table = value.as<TomlTable>();
    if (!table) wrongType(value, name, "a table, as { key = value }");
    return table;
}

void TomlReader::unknownKey(const TomlEntry& entry, std::string_view where,
                            std::span<const std::string_view> keys) {
    const std::string near = nearestKey(entry.key, keys);
    report("suite-E02",
           fmt::format("unknown key {} {}; {}", glib::inQuotes(entry.key), where,
                       near.empty() ? fmt::format("the keys are {}", fmt::join(keys, ", "))
                                    : fmt::format("did you mean '{}'?", near)),
           entry.position);
}

void TomlReader::wrongType(const TomlValue& value, std::string_view name, std::string_view expected) {
    report("suite-E03", fmt::format("{}: expected {}, found {}", name, expected, described(value)), value);
}

void TomlReader::report(const char* id, const std::string& text, Place place) {
    ++count_;
    if (problems_.size() < kMostMessages)
        problems_.push_back(
            diagnose(id, base::printableText(text), std::move(place)));  // keys may have line ends
}

Diagnostics TomlReader::take() {
    std::ranges::stable_sort(problems_, [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    if (count_ > problems_.size())
        problems_.push_back(withoutId(Severity::note,
                                      fmt::format("{} more errors are not shown", count_ - problems_.size()),
                                      {path_, 1, 1}));
    return std::exchange(problems_, {});
}

}  // namespace glibra::suite
