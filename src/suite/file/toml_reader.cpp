#include "suite/file/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "glib/number.h"
#include "glib/suggest.h"
#include "glib/text.h"
#include "suite/file/toml_syntax.h"

namespace glibra::suite {
namespace {

constexpr std::size_t kMostMessages = 100;
constexpr std::size_t kBlock = 1024;  // bytes

/// False for the second and later bytes of a character of UTF-8.
bool beginsCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
}

/// The key nearest to a word, or that one of both continues: "max" for "maximum", "fraction" for "frac".
std::string nearestKey(std::string_view word, std::span<const std::string_view> keys) {
    constexpr std::size_t kLeast = 3;
    if (std::string near = glib::nearestName(word, keys); !near.empty()) return near;
    for (const std::string_view key : keys)
        if (std::min(word.size(), key.size()) >= kLeast && (word.starts_with(key) || key.starts_with(word)))
            return std::string(key);
    return {};
}

}  // namespace

std::string described(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::string:
            return "the text " + glib::inQuotes(**node.as_string());
        case toml::node_type::integer:
            return fmt::format("the number {}", **node.as_integer());
        case toml::node_type::floating_point:
            return "the number " + glib::numberText(**node.as_floating_point());
        case toml::node_type::boolean:
            return **node.as_boolean() ? "true" : "false";
        case toml::node_type::array:
            return "a list";
        case toml::node_type::table:
            return "a table";
        default:
            return "a date or time";
    }
}

TomlReader::TomlReader(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {
    // A byte order mark counts in no column.
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
    return blocks_[block] +
           static_cast<std::size_t>(std::count_if(rest.begin(), rest.end(), beginsCharacter));
}

Place TomlReader::place(const toml::source_position& position) const {
    // The library counts characters, we count bytes; what it makes itself has no place.
    if (position.line == 0) return {path_, 1, 1};
    const std::size_t line = std::min<std::size_t>(position.line, lines_.size());
    const std::size_t begin = lines_[line - 1];
    const std::size_t end = line < lines_.size() ? lines_[line] - 1 : text_.size();
    const std::size_t wanted = charactersBefore(begin) + std::max<std::size_t>(position.column, 1) - 1;
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), wanted);
    const auto block = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - blocks_.begin(), 1) - 1);
    std::size_t at = std::max(begin, block * kBlock);
    for (std::size_t seen = charactersBefore(at); at < end; ++at)
        if (beginsCharacter(text_[at]) && seen++ == wanted) break;
    return {path_, static_cast<int>(line), static_cast<int>(std::min(at, end) - begin) + 1};
}

const toml::table* TomlReader::root() {
    if (const auto offset = endlessKey(text_)) {
        const auto line = std::upper_bound(lines_.begin(), lines_.end(), *offset) - lines_.begin();
        const std::size_t column = *offset - lines_[static_cast<std::size_t>(line) - 1] + 1;
        error("suite-E01", "a key has too many parts",
              {path_, static_cast<int>(line), static_cast<int>(column)});
        return nullptr;
    }
    try {
        root_ = toml::parse(text_, path_);
    } catch (const toml::parse_error& wrong) {
        const Place where = place(wrong.source().begin);
        const std::size_t at =
            lines_.at(static_cast<std::size_t>(where.line) - 1) + static_cast<std::size_t>(where.column) - 1;
        error("suite-E01", syntaxMessage(wrong.description(), text_, std::min(at, text_.size())), where);
    }
    return root_ ? &*root_ : nullptr;
}

std::vector<TomlEntry> TomlReader::entries(const toml::table& table) const {
    std::vector<TomlEntry> all;
    for (const auto& [key, value] : table)
        all.push_back({std::string(key.str()), place(key.source().begin), &value});
    std::stable_sort(all.begin(), all.end(), [](const TomlEntry& a, const TomlEntry& b) {
        return std::tie(a.keyPlace.line, a.keyPlace.column) < std::tie(b.keyPlace.line, b.keyPlace.column);
    });
    return all;
}

std::optional<bool> TomlReader::truth(const toml::node& node, std::string_view name) {
    if (const auto* value = node.as_boolean()) return **value;
    wrongType(node, name, "true or false");
    return std::nullopt;
}

std::optional<double> TomlReader::number(const toml::node& node, std::string_view name, double low,
                                         double high) {
    const auto value = node.value<double>();
    if (!value || !node.is_number()) {
        wrongType(node, name, "a number");
        return std::nullopt;
    }
    if (*value >= low && *value <= high) return value;
    const std::string range =
        high < std::numeric_limits<double>::max()
            ? fmt::format("between {} and {}", glib::numberText(low), glib::numberText(high))
            : fmt::format("a finite number from {} upwards", glib::numberText(low));
    error("suite-E04", fmt::format("{}: {} is not {}", name, glib::numberText(*value), range), placeOf(node));
    return std::nullopt;
}

std::optional<int> TomlReader::whole(const toml::node& node, std::string_view name, int low, int high) {
    const auto* value = node.as_integer();
    if (!value) {
        wrongType(node, name, "a whole number");
        return std::nullopt;
    }
    if (**value >= low && **value <= high) return static_cast<int>(**value);
    error("suite-E04", fmt::format("{}: {} is not between {} and {}", name, **value, low, high),
          placeOf(node));
    return std::nullopt;
}

std::optional<std::string> TomlReader::text(const toml::node& node, std::string_view name) {
    const auto* value = node.as_string();
    if (!value) {
        wrongType(node, name, "a text between quotes");
        return std::nullopt;
    }
    const std::string& characters = **value;
    if (characters.empty() || characters.find('\0') != std::string::npos) {
        error("suite-E04",
              fmt::format("{}: {}", name,
                          characters.empty() ? "the text is empty" : "the text has a zero byte"),
              placeOf(node));
        return std::nullopt;
    }
    return characters;
}

std::optional<std::vector<std::string>> TomlReader::texts(const toml::node& node, std::string_view name) {
    const toml::array* list = node.as_array();
    if (!list) {
        if (!node.is_string()) {
            wrongType(node, name, "a text between quotes, or a list of such,");
            return std::nullopt;
        }
        auto one = text(node, name);
        if (!one) return std::nullopt;
        return std::vector<std::string>{std::move(*one)};
    }
    if (list->empty()) {
        error("suite-E04", fmt::format("{}: the list is empty", name), placeOf(node));
        return std::nullopt;
    }
    std::vector<std::string> all;
    for (const toml::node& each : *list)
        if (auto one = text(each, name)) all.push_back(std::move(*one));
    if (all.size() < list->size()) return std::nullopt;
    return all;
}

const toml::table* TomlReader::table(const toml::node& node, std::string_view name) {
    if (!node.is_table()) wrongType(node, name, "a table, as { key = value },");
    return node.as_table();
}

void TomlReader::unknownKey(const TomlEntry& entry, std::string_view where,
                            std::span<const std::string_view> keys) {
    const std::string near = nearestKey(entry.key, keys);
    error("suite-E02",
          fmt::format("unknown key {} {}; {}", glib::inQuotes(entry.key), where,
                      near.empty() ? fmt::format("it has the keys {}", fmt::join(keys, ", "))
                                   : fmt::format("did you mean '{}'?", near)),
          entry.keyPlace);
}

void TomlReader::wrongType(const toml::node& node, std::string_view name, std::string_view wanted) {
    error("suite-E03", fmt::format("{}: {} is wanted, not {}", name, wanted, described(node)), placeOf(node));
}

void TomlReader::error(const char* id, std::string text, Place place) {
    ++count_;
    if (problems_.size() < kMostMessages)
        problems_.push_back(glibra::error(id, std::move(text), std::move(place)));
}

Diagnostics TomlReader::take() {
    std::stable_sort(problems_.begin(), problems_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    if (count_ > problems_.size())
        problems_.push_back(
            note("", fmt::format("{} more errors are not shown", count_ - problems_.size()), {path_, 1, 1}));
    return std::exchange(problems_, {});
}

}  // namespace glibra::suite
