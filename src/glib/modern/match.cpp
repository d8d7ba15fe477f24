#include "glib/modern/match.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/suggest.h"
#include "glib/limits.h"
#include "glib/modern/grammar.h"
#include "glib/modern/read_values.h"
#include "glib/number.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

using Kind = Value::Kind;
using Node = SyntaxNode;

/// What a part of the syntax read: a key, values, or a tag (with its value as the next event).
struct Event {
    enum class Kind : std::uint8_t { key, value, tag };
    Kind kind = Kind::value;
    const Node* node = nullptr;
    std::size_t begin = 0;  ///< pieces
    std::size_t end = 0;
};

struct Expectation {
    std::string text;
    bool isWord = false;  ///< a key or one of several words, so that a suggestion can name it
};

bool isNumeric(const Value& value) {
    return value.kind == Kind::number || value.kind == Kind::expression;
}
bool isWord(const Value& value) {
    return value.kind == Kind::word || value.kind == Kind::truth;
}
bool isUnquoted(const Value& value) {
    return isWord(value) && !value.text.empty();
}

std::string_view beforePoint(std::string_view text) {
    return text.substr(0, text.find('.'));
}
std::string_view afterPoint(std::string_view text) {
    const std::size_t point = text.find('.');
    return point == std::string_view::npos ? std::string_view() : text.substr(point + 1);
}

/// True for identifiers with points between them; a leading point is allowed if something stands before it.
bool isDotted(std::string_view text, bool hasHead) {
    if (hasHead) {
        if (!text.starts_with('.')) return false;
        text.remove_prefix(1);
    }
    while (true) {
        const std::size_t point = text.find('.');
        if (!isIdentifier(text.substr(0, point))) return false;
        if (point == std::string_view::npos) return true;
        text.remove_prefix(point + 1);
    }
}

class Matcher {
  public:
    Matcher(const StatementRow& row, std::string_view text, std::vector<Piece> pieces,
            const IsDeclared& isDeclared, MessageLog& log)
        : row_(row),
          syntax_(syntaxOf(row)),
          text_(text),
          pieces_(std::move(pieces)),
          isDeclared_(isDeclared),
          log_(log) {}

    void read(Command& command) {
        std::size_t at = 0;
        const bool matched = match(syntax_.root, at);
        if (matched && at == pieces_.size())
            build(command);
        else
            report(matched, at, command.position);
    }

  private:
    // ---- What was found.

    const Value* piece(std::size_t at) const { return at < pieces_.size() ? &pieces_[at].value : nullptr; }
    bool isJoined(std::size_t at) const { return at < pieces_.size() && pieces_[at].isJoined; }

    bool fail(std::size_t at, std::string expected, bool isWord = false) {
        if (at > furthest_) {
            furthest_ = at;
            expected_.clear();
        }
        if (at == furthest_ && std::none_of(expected_.begin(), expected_.end(),
                                            [&](const Expectation& each) { return each.text == expected; }))
            expected_.push_back({std::move(expected), isWord});
        return false;
    }

    /// Takes back what an alternative that does not fit has read.
    bool rewind(std::size_t& at, std::size_t begin, std::size_t events) {
        at = begin;
        events_.resize(events);
        return false;
    }

    // ---- The syntax.

    bool match(const Node& node, std::size_t& at) {
        if (!node.repeats) return matchOnce(node, at, node.isSkippable);
        bool any = false;
        while (at < pieces_.size() || !any) {
            const std::size_t begin = at;
            if (!matchOnce(node, at, node.isSkippable || any) || at == begin) break;
            any = true;
        }
        return any || node.kind == Node::Kind::optional;
    }

    bool matchOnce(const Node& node, std::size_t& at, bool isSkippable) {
        switch (node.kind) {
            case Node::Kind::key:
                return matchKey(node, at);
            case Node::Kind::value:
                return matchValue(node, at, isSkippable);
            case Node::Kind::sequence:
                return matchSequence(node, at);
            case Node::Kind::choice:
                return matchChoice(node, at);
            case Node::Kind::optional:
                match(node.children.front(), at);
                return true;
            case Node::Kind::set:
                return matchSet(node, at);
            case Node::Kind::pairs:
                break;
        }
        return matchPairs(node, at);
    }

    bool matchSequence(const Node& node, std::size_t& at) {
        const std::size_t begin = at;
        const std::size_t events = events_.size();
        for (const Node& each : node.children)
            if (!match(each, at)) return rewind(at, begin, events);
        return true;
    }

    bool matchChoice(const Node& node, std::size_t& at) {
        return std::any_of(node.children.begin(), node.children.end(),
                           [&](const Node& each) { return match(each, at); });
    }

    bool matchSet(const Node& node, std::size_t& at) {
        struct Used {
            const Node* alternative;
            std::string suffix;
            std::size_t piece;
        };
        std::vector<Used> used;
        while (at < pieces_.size()) {
            const std::size_t begin = at;
            const std::size_t events = events_.size();
            const auto found = std::find_if(node.children.begin(), node.children.end(),
                                            [&](const Node& each) { return match(each, at); });
            if (found == node.children.end() || at == begin) break;
            std::string suffix(afterPoint(pieces_[begin].value.text));
            const auto before = std::find_if(used.begin(), used.end(), [&](const Used& each) {
                return each.alternative == &*found && each.suffix == suffix;
            });
            if (before != used.end()) {
                if (!conflict_ || begin > conflict_->second) conflict_ = {before->piece, begin};
                rewind(at, begin, events);
                break;
            }
            used.push_back({&*found, std::move(suffix), begin});
        }
        if (!used.empty() || !node.needsOne) return true;
        for (const Node& each : node.children) match(each, at);  // collects what is expected
        return false;
    }

    bool matchKey(const Node& node, std::size_t& at) {
        const Value* value = piece(at);
        if (value == nullptr || !isUnquoted(*value) || !sameWord(beforePoint(value->text), node.text))
            return fail(at, "'" + node.text + "'", true);
        if (!suffixFits(node, value->text)) {
            if (node.hasNumberSuffix) return fail(at, fmt::format("'{0}' or '{0}.1'", node.text));
            for (const std::string& each : node.words)
                fail(at, fmt::format("'{}.{}'", node.text, each), true);
            return fail(at, "'" + node.text + "'", true);
        }
        events_.push_back({Event::Kind::key, &node, at, at + 1});
        ++at;
        return true;
    }

    static bool suffixFits(const Node& node, std::string_view text) {
        if (text.find('.') == std::string_view::npos) return true;
        const std::string_view suffix = afterPoint(text);
        if (node.hasNumberSuffix)
            return !suffix.empty() && suffix.size() < 3 &&
                   std::all_of(suffix.begin(), suffix.end(), [](char c) { return c >= '0' && c <= '9'; });
        return std::any_of(node.words.begin(), node.words.end(),
                           [&](const std::string& each) { return sameWord(each, suffix); });
    }

    bool matchNumbers(const Node& node, std::size_t& at) {
        const std::size_t begin = at;
        bool hasExpression = false;
        while (at < pieces_.size() && at - begin < node.most && isNumeric(pieces_[at].value))
            hasExpression = pieces_[at++].value.kind == Kind::expression || hasExpression;
        const std::size_t count = at - begin;
        if (count < node.most)
            fail(at, node.most == 1 ? fmt::format("a number ({})", node.text)
                                    : fmt::format("number {} of {} ({})", count + 1, node.most, node.text));
        if (count < (hasExpression ? 1 : node.least)) return rewind(at, begin, events_.size());
        events_.push_back({Event::Kind::value, &node, begin, at});
        return true;
    }

    bool matchFiles(const Node& node, std::size_t& at, bool isSkippable) {
        const std::size_t begin = at;
        while (at - begin < node.most) {
            const Value* value = piece(at);
            const bool fits = value != nullptr && (value->kind == Kind::text || isUnquoted(*value)) &&
                              !isKeyInstead(*value, isSkippable || node.isChosen || at > begin);
            if (!fits) {
                fail(at, node.most == 1
                             ? fmt::format("a file ({})", node.text)
                             : fmt::format("file {} of {} ({})", at - begin + 1, node.most, node.text));
                return rewind(at, begin, events_.size());
            }
            ++at;
        }
        events_.push_back({Event::Kind::value, &node, begin, at});
        return true;
    }

    bool matchValue(const Node& node, std::size_t& at, bool isSkippable) {
        if (node.type == ValueType::number) return matchNumbers(node, at);
        if (node.type == ValueType::file) return matchFiles(node, at, isSkippable);
        const std::size_t end = valueEnd(node, at, isSkippable);
        if (end == at) {
            if (node.type != ValueType::oneOf) return fail(at, describe(node));
            for (const std::string& each : node.words) fail(at, "'" + each + "'", true);
            return false;
        }
        events_.push_back({Event::Kind::value, &node, at, end});
        at = end;
        return true;
    }

    static std::string describe(const Node& node) {
        switch (node.type) {
            case ValueType::name:
            case ValueType::array:
                return node.text == "name" ? "a name" : fmt::format("a name ({})", node.text);
            case ValueType::object:
                return node.text == "object" ? "a name" : fmt::format("a name ({})", node.text);
            case ValueType::word:
            case ValueType::program:
                return fmt::format("a word ({})", node.text);
            case ValueType::key:
                return "a key of the keyboard";
            case ValueType::any:
            case ValueType::constant:
                return "a value";
            case ValueType::expression:
                return fmt::format("an expression in parentheses ({})", node.text);
            case ValueType::list:
            case ValueType::words:
                return fmt::format("a list in [ ] ({})", node.text);
            case ValueType::color:
                return "a colour {r g b}";
            case ValueType::components:
                return "components [r g b a]";
            default:
                return node.text;
        }
    }

    /// Returns the index after the value; `at` if there is none of this type.
    std::size_t valueEnd(const Node& node, std::size_t at, bool isSkippable) const {
        const Value* value = piece(at);
        if (value == nullptr) return at;
        const Kind kind = value->kind;
        const bool isLone = !isJoined(at + 1) || pieces_[at + 1].value.kind == Kind::word;
        bool fits = false;
        switch (node.type) {
            case ValueType::name:
                fits = isLone && kind == Kind::word && isIdentifier(value->text) &&
                       !isKeyInstead(*value, isSkippable || node.isChosen);
                break;
            case ValueType::array:  // [...] at the end is the value
                if (kind != Kind::word || !isIdentifier(value->text)) return at;
                return isSubscript(at + 1) && pieces_[at + 1].value.kind == Kind::list &&
                               at + 2 < pieces_.size()
                           ? at + 2
                           : at + 1;
            case ValueType::object:
                return isUnquoted(*value) && isKeyInstead(*value, isSkippable || node.isChosen)
                           ? at
                           : objectEnd(at);
            case ValueType::word:
                fits = isUnquoted(*value) && !isKeyInstead(*value, isSkippable);
                break;
            case ValueType::program:
                fits = isUnquoted(*value) || kind == Kind::text;
                break;
            case ValueType::key:
                fits = isUnquoted(*value) || kind == Kind::text || kind == Kind::number;
                break;
            case ValueType::any:
                if (kind == Kind::word) return objectEnd(at);
                [[fallthrough]];
            case ValueType::constant:
                fits = kind != Kind::word && kind != Kind::text;
                break;
            case ValueType::expression:
                fits = kind == Kind::expression;
                break;
            case ValueType::list:
                fits = kind == Kind::list;
                break;
            case ValueType::words:
                fits = kind == Kind::list && value->count.empty();
                break;
            case ValueType::color:
                fits = kind == Kind::color || kind == Kind::expression;
                break;
            case ValueType::components:
                fits = kind == Kind::color || kind == Kind::list || kind == Kind::expression;
                break;
            case ValueType::oneOf:
                fits = kind == Kind::expression ||
                       (isUnquoted(*value) &&
                        std::any_of(node.words.begin(), node.words.end(),
                                    [&](const std::string& each) { return sameWord(each, value->text); }));
                break;
            default:
                break;
        }
        return fits ? at + 1 : at;
    }

    /// True if a word that may be left out is a key, or a misspelt key, rather than a value.
    bool isKeyInstead(const Value& value, bool mayBeLeftOut) const {
        if (!mayBeLeftOut || !isUnquoted(value)) return false;
        std::vector<std::string_view> keys(syntax_.keys.begin(), syntax_.keys.end());
        const std::string_view word = beforePoint(value.text);
        if (std::any_of(keys.begin(), keys.end(),
                        [&](std::string_view each) { return sameWord(each, word); }))
            return word.size() == value.text.size();
        return word.size() == value.text.size() && !isDeclared_(word) &&
               !base::nearestName(word, keys).empty();
    }

    // ---- Names with parts.

    /// True if a [k] or (k) touches the name before it.
    bool isSubscript(std::size_t at) const {
        if (!isJoined(at)) return false;
        const Value& value = pieces_[at].value;
        if (value.kind == Kind::expression) return true;
        return value.kind == Kind::list && value.count.empty() &&
               source(value).find_first_of("\r\n") == std::string_view::npos;
    }

    /// Returns the index after an object's name; `at` if there is none.
    std::size_t objectEnd(std::size_t at) const {
        const Value* value = piece(at);
        if (value == nullptr || value->kind != Kind::word || !isDotted(value->text, false)) return at;
        for (std::size_t next = at + 1;;) {
            if (isSubscript(next))
                ++next;
            else if (isJoined(next) && pieces_[next].value.kind == Kind::word &&
                     isDotted(pieces_[next].value.text, true))
                ++next;
            else
                return next;
        }
    }

    /// Returns the index after a tag; `at` if there is none. A [k] belongs to the tag if a point or a value
    /// follows; otherwise it is the tag's value.
    std::size_t tagEnd(std::size_t at) const {
        const Value* value = piece(at);
        if (value == nullptr || !isUnquoted(*value) || !isDotted(value->text, false)) return at;
        std::size_t next = at + 1;
        while (isSubscript(next) && pieces_[next].value.kind == Kind::list && valueFollows(next + 1)) {
            ++next;
            if (isJoined(next) && pieces_[next].value.kind == Kind::word) ++next;
        }
        return next;
    }

    bool valueFollows(std::size_t at) const {
        const Value* value = piece(at);
        if (value == nullptr) return false;
        if (value->kind != Kind::word) return true;
        if (isJoined(at) && isDotted(value->text, true)) return true;
        // A word is a value if what follows it is not: `uTex[2] shadow uB 5`, but `uA[3] uB 5`.
        const std::size_t next = objectEnd(at);
        if (next == at) return false;
        return next == pieces_.size() || pieces_[next].value.kind == Kind::word;
    }

    std::string_view source(const Value& value) const {
        return text_.substr(value.begin, value.end - value.begin);
    }

    bool matchPairs(const Node& node, std::size_t& at) {
        bool any = false;
        while (at < pieces_.size()) {
            const std::size_t tag = tagEnd(at);
            if (tag == at) {
                fail(at, "a tag");
                break;
            }
            const std::size_t end = anyEnd(tag);
            if (end == tag) {
                fail(tag, fmt::format("a value of '{}'", written(at, tag)));
                break;
            }
            events_.push_back({Event::Kind::tag, &node, at, tag});
            events_.push_back({Event::Kind::value, &node, tag, end});
            at = end;
            any = true;
        }
        if (!any && at == pieces_.size()) fail(at, "a tag");
        return any || !node.needsOne;
    }

    std::size_t anyEnd(std::size_t at) const {
        const Value* value = piece(at);
        if (value == nullptr || value->kind == Kind::text) return at;
        return value->kind == Kind::word ? objectEnd(at) : at + 1;
    }

    std::string written(std::size_t begin, std::size_t end) const {
        return std::string(text_.substr(pieces_[begin].value.begin,
                                        pieces_[end - 1].value.end - pieces_[begin].value.begin));
    }

    // ---- The command.

    /// The index of a subscript, from its text between the brackets.
    Value indexOf(const Value& subscript) const {
        Value index = subscript;
        if (subscript.kind == Kind::expression) return index;
        if (subscript.items.size() == 1 && isNumeric(subscript.items.front())) return subscript.items.front();
        index.kind = Kind::expression;
        index.items.clear();
        const std::string_view all = source(subscript);
        index.text = all.substr(1, all.size() - 2);
        return index;
    }

    static void addParts(std::string_view text, std::vector<NamePart>& path) {
        if (text.starts_with('.')) text.remove_prefix(1);
        while (true) {
            const std::size_t point = text.find('.');
            path.push_back({std::string(text.substr(0, point)), {}});
            if (point == std::string_view::npos) return;
            text.remove_prefix(point + 1);
        }
    }

    std::vector<NamePart> pathOf(std::size_t begin, std::size_t end) const {
        std::vector<NamePart> path;
        for (std::size_t i = begin; i < end; ++i) {
            const Value& value = pieces_[i].value;
            if (value.kind == Kind::word || value.kind == Kind::truth)
                addParts(value.text, path);
            else
                path.back().index = {indexOf(value)};
        }
        return path;
    }

    Value nameOf(std::size_t begin, std::size_t end) const {
        Value name = pieces_[begin].value;
        name.kind = Kind::word;
        name.text = written(begin, end);
        name.end = pieces_[end - 1].value.end;
        name.path = pathOf(begin, end);
        return name;
    }

    static bool isName(const Event& event) {
        if (event.node->kind == Node::Kind::pairs) return true;
        const ValueType type = event.node->type;
        return type == ValueType::object || type == ValueType::array || type == ValueType::any;
    }

    void build(Command& command) {
        std::vector<Value>* place = &command.values;
        for (const Event& event : events_) {
            const Value& first = pieces_[event.begin].value;
            if (event.kind == Event::Kind::key) {
                command.keys.push_back(
                    {event.node->text, lower(afterPoint(first.text)), {}, first.position, {}});
                place = &command.keys.back().values;
            } else if (event.kind == Event::Kind::tag) {
                KeyedValues tag{written(event.begin, event.end), {}, {}, first.position, {}};
                std::vector<NamePart> path = pathOf(event.begin, event.end);
                if (path.size() > 1 || !path.front().index.empty()) tag.path = std::move(path);
                command.tags.push_back(std::move(tag));
                place = &command.tags.back().values;
            } else if (first.kind == Kind::word && isName(event)) {
                place->push_back(nameOf(event.begin, event.end));
            } else {
                for (std::size_t i = event.begin; i < event.end; ++i)
                    place->push_back(std::move(pieces_[i].value));
                finish(place->back(), *event.node);
            }
        }
        checkTags(command);
    }

    /// `true` is a truth only where any value may stand. The words of a list have one spelling.
    static void finish(Value& value, const Node& node) {
        const bool isAny =
            node.kind == Node::Kind::pairs || node.type == ValueType::any || node.type == ValueType::constant;
        if (value.kind == Kind::truth && isAny) value.text.clear();
        if (value.kind == Kind::truth && !isAny) value = plainWord(value);
        if (node.type == ValueType::oneOf && value.kind == Kind::word) value.text = lower(value.text);
    }
    static Value plainWord(Value value) {
        value.kind = Kind::word;
        value.number = 0;
        return value;
    }

    void checkTags(const Command& command) {
        if (command.tags.size() > kMostTags) {
            log_.report("glib-E15", fmt::format("{} has more than {} tags", row_.name, kMostTags),
                        command.tags[kMostTags].position);
            return;
        }
        std::vector<const KeyedValues*> sorted;
        for (const KeyedValues& each : command.tags) sorted.push_back(&each);
        std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) {
            return std::pair(std::string_view(a->key), a) < std::pair(std::string_view(b->key), b);
        });
        for (std::size_t i = 1; i < sorted.size(); ++i)
            if (sorted[i]->key == sorted[i - 1]->key) {
                log_.report("glib-E18",
                            fmt::format("{}: tag {} given twice", row_.name, inQuotes(sorted[i]->key)),
                            sorted[i]->position);
                return;
            }
    }

    // ---- Errors.

    std::string foundText(std::size_t at) const {
        const std::string_view all = source(pieces_[at].value);
        return inQuotes(all.substr(0, all.find_first_of("\r\n")));
    }

    std::string listOfExpected() const {
        constexpr std::size_t kShown = 8;
        std::string text;
        const std::size_t shown = std::min(expected_.size(), kShown);
        for (std::size_t i = 0; i < shown; ++i) {
            if (i > 0) text += i + 1 == shown && shown == expected_.size() ? " or " : ", ";
            text += expected_[i].text;
        }
        return shown < expected_.size() ? text + " ..." : text;
    }

    std::string suggested(std::string_view word) const {
        std::vector<std::string_view> words;
        for (const Expectation& each : expected_)
            if (each.isWord) words.push_back(std::string_view(each.text).substr(1, each.text.size() - 2));
        std::string nearest = base::nearestName(word, words);
        if (nearest.empty()) nearest = base::nearestName(beforePoint(word), words);
        return nearest;
    }

    void report(bool matched, std::size_t at, Position command) {
        if (conflict_ && conflict_->second >= std::max(furthest_, at)) return reportConflict();
        if (furthest_ < at) {
            furthest_ = at;
            expected_.clear();
        }
        if (furthest_ >= pieces_.size()) {
            log_.report(
                "glib-E17",
                fmt::format("{}: expected {}, found the end of the statement", row_.name, listOfExpected()),
                command);
            return;
        }
        const Value& found = pieces_[furthest_].value;
        const bool expectsWord = std::any_of(expected_.begin(), expected_.end(),
                                             [](const Expectation& each) { return each.isWord; });
        if (isUnquoted(found) && expectsWord) {
            const std::string nearest = suggested(found.text);
            if (!nearest.empty())
                return reportAt("glib-E16", fmt::format("unknown word {}; did you mean '{}'?",
                                                        foundText(furthest_), nearest));
            return reportAt("glib-E16", fmt::format("unknown word {}; expected {}", foundText(furthest_),
                                                    listOfExpected()));
        }
        if (matched && furthest_ == at)
            return reportAt("glib-E18", fmt::format("surplus argument {}", foundText(furthest_)));
        reportAt("glib-E19", fmt::format("expected {}, found {}", listOfExpected(), foundText(furthest_)));
    }

    void reportAt(const char* id, const std::string& message) {
        log_.report(id, fmt::format("{}: {}", row_.name, message), pieces_[furthest_].value.position);
    }

    void reportConflict() {
        const auto [before, at] = *conflict_;
        furthest_ = at;
        if (sameWord(pieces_[before].value.text, pieces_[at].value.text))
            return reportAt("glib-E18", fmt::format("{} given twice", foundText(at)));
        reportAt("glib-E18", fmt::format("{} contradicts {}", foundText(at), foundText(before)));
    }

    const StatementRow& row_;
    const Syntax& syntax_;
    std::string_view text_;
    std::vector<Piece> pieces_;
    const IsDeclared& isDeclared_;
    MessageLog& log_;
    std::vector<Event> events_;
    std::size_t furthest_ = 0;
    std::vector<Expectation> expected_;
    std::optional<std::pair<std::size_t, std::size_t>> conflict_;  ///< the earlier and the later piece
};

}  // namespace

void readStatement(const StatementRow& row, std::string_view text, std::span<const Token> tokens,
                   const IsDeclared& isDeclared, Command& command, MessageLog& log) {
    std::optional<std::vector<Piece>> pieces = readPieces(tokens, log);
    if (pieces) Matcher(row, text, std::move(*pieces), isDeclared, log).read(command);
}

}  // namespace glibra::glib
