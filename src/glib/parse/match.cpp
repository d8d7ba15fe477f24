#include "glib/parse/match.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/suggest.h"
#include "glib/limits.h"
#include "glib/number.h"
#include "glib/syntax.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

using Node = SyntaxNode;
using Kind = Expectation::Kind;

// ---- What the syntax has read.

/// What a part of the syntax has read: a key, values, or a tag, whose value is the next event.
struct Event {
    enum class Kind : std::uint8_t { key, value, tag };
    Kind kind = Kind::value;
    const SyntaxNode* node = nullptr;
    std::size_t begin = 0;  ///< pieces
    std::size_t end = 0;
    std::string resembles{};  ///< KeyedValues::resembles
};

bool isName(const Event& event) {
    const ValueType type = event.node->type;
    return type == ValueType::object || type == ValueType::array || type == ValueType::any;
}

/// `true` is a truth only where any value may stand. The words of a list have one spelling.
void finishValue(Value& value, const SyntaxNode& node) {
    const bool isAny = node.type == ValueType::any || node.type == ValueType::constant;
    if (value.kind == Value::Kind::truth) {
        if (isAny) {
            value.text.clear();
        } else {
            value.kind = Value::Kind::word;
            value.number = 0;
        }
    }
    if (node.type == ValueType::oneOf && value.kind == Value::Kind::word) value.text = lower(value.text);
}

void checkTags(const StatementRow& row, const Command& command, MessageLog& log) {
    if (command.tags.size() > kMostTags) {
        log.report("glib-E15", fmt::format("{} has more than {} tags", row.name, kMostTags),
                   command.tags[kMostTags].position);
        return;
    }
    std::vector<const KeyedValues*> sorted;
    for (const KeyedValues& each : command.tags) sorted.push_back(&each);
    std::ranges::sort(sorted, [](const auto* a, const auto* b) {
        return std::pair(std::string_view(a->key), a) < std::pair(std::string_view(b->key), b);
    });
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i]->key == sorted[i - 1]->key) {
            log.report("glib-E18", fmt::format("{}: tag {} given twice", row.name, inQuotes(sorted[i]->key)),
                       sorted[i]->position);
            return;
        }
}

/// Fills `values`, `keys` and `tags` of the command from what the syntax has read. Reports glib-E15 for too
/// many tags and glib-E18 for a tag that is given twice.
void build(const StatementRow& row, const std::vector<Event>& events, Pieces pieces, Command& command,
           MessageLog& log) {
    std::vector<Value>* place = &command.values;
    for (const Event& event : events) {
        const Value& first = pieces[event.begin];
        if (event.kind == Event::Kind::key) {
            command.keys.push_back({event.node->text, lower(afterPoint(first.text)), {}, first.position, {}});
            place = &command.keys.back().values;
        } else if (event.kind == Event::Kind::tag) {
            KeyedValues tag{
                pieces.written(event.begin, event.end), {}, {}, first.position, {}, event.resembles};
            std::vector<NamePart> path = pieces.pathOf(event.begin, event.end);
            if (path.size() > 1 || !path.front().index.empty()) tag.path = std::move(path);
            command.tags.push_back(std::move(tag));
            place = &command.tags.back().values;
        } else if (first.kind == Value::Kind::word && isName(event)) {
            place->push_back(pieces.nameOf(event.begin, event.end));
        } else {
            for (std::size_t i = event.begin; i < event.end; ++i) place->push_back(pieces.take(i));
            finishValue(place->back(), *event.node);
        }
    }
    checkTags(row, command, log);
}

bool isWordItem(const Value& item) {
    return item.kind == Value::Kind::word;
}
bool hasComma(const Value& item) {
    return isWordItem(item) && item.text.find(',') != std::string::npos;
}

class ItemChecker {
  public:
    ItemChecker(const StatementRow& row, const Pieces& pieces, const DeclaredNames& names, MessageLog& log)
        : row_(row), pieces_(pieces), names_(names), log_(log) {}

    /// Returns false if an item was reported.
    bool check(const Value& group, const Event& event) {
        const auto comma = std::ranges::find_if(group.items, hasComma);
        if (comma != group.items.end()) return refuse(*comma, blanksFor(group));
        const bool isPairs = event.node->kind == SyntaxNode::Kind::pairs;
        const bool takesWords = !isPairs && event.node->type == ValueType::words;
        const auto word = std::ranges::find_if(group.items, isWordItem);
        const bool allWords = std::ranges::all_of(group.items, isWordItem);
        const bool isChoice = group.kind == Value::Kind::range && allWords;
        if (word == group.items.end() || takesWords || isChoice) return true;
        if (isPairs && allWords && group.items.size() > 1 && isIdentifier(word->text))
            return refuse(*word, "; objects have a tag each, as in uTex[0] red uTex[1] green");
        const bool isList = group.kind == Value::Kind::list && allWords && group.items.size() > 1;
        std::string hint = hintFor(group, *word);
        if (hint.empty() && isList) hint = "; a choice of words stands in < >";
        return refuse(*word, hint);
    }

  private:
    bool refuse(const Value& item, const std::string& hint) {
        const std::string message =
            isMalformedNumber(item) ? fmt::format("{}: {} is not a number", row_.name, inQuotes(item.text))
                                    : fmt::format("{}: expected a number or (expression), found {}",
                                                  row_.name, inQuotes(item.text));
        log_.report("glib-E19", message + hint, item.position);
        return false;
    }

    static bool isMalformedNumber(const Value& item) {
        return hasComma(item) || (numberLength(item.text) > 0 && !looksLikeExpression(item.text));
    }

    std::string blanksFor(const Value& group) const {
        std::string all(pieces_.source(group));
        std::ranges::replace(all, ',', ' ');
        std::string text;
        for (const char c : all)
            if (c != ' ' || (!text.empty() && text.back() != ' ')) text += c;
        constexpr std::size_t kShown = 60;
        if (text.size() > kShown || text.find_first_of("\r\n") != std::string::npos)
            return "; write blanks between the values";
        return "; write blanks between the values: " + text;
    }

    /// What to write for a word: the expression that it, and a function's parentheses after it, make.
    std::string hintFor(const Value& group, const Value& word) const {
        std::size_t end = word.end;
        for (const Value& each : group.items)
            if (each.begin == end && each.kind == Value::Kind::expression) end = each.end;
        Value whole = word;
        whole.end = end;
        const std::string_view text = pieces_.source(whole);
        const std::string_view head = beforePoint(word.text);
        const bool isName = isDotted(word.text, false) && names_.has(head);
        if (isMalformedNumber(word) || (!isName && end == word.end && !looksLikeExpression(text))) return {};
        return fmt::format("; write ({}) for its value", text);
    }

    const StatementRow& row_;
    const Pieces& pieces_;
    const DeclaredNames& names_;
    MessageLog& log_;
};

/// Reports glib-E19 for the first item of [ ], { } and < > that is no value. The words that Repeat runs over
/// and those of a choice stay.
void checkItems(const StatementRow& row, const std::vector<Event>& events, const Pieces& pieces,
                const DeclaredNames& names, MessageLog& log) {
    ItemChecker checker(row, pieces, names, log);
    for (const Event& event : events) {
        if (event.kind != Event::Kind::value || pieces[event.begin].kind == Value::Kind::word) continue;
        for (std::size_t i = event.begin; i < event.end; ++i)
            if (!checker.check(pieces[i], event)) return;
    }
}

// ---- The syntax.

class Matcher {
  public:
    Matcher(const StatementRow& row, Pieces pieces, const DeclaredNames& names, MessageLog& log)
        : row_(row), syntax_(syntaxOf(row)), pieces_(std::move(pieces)), names_(names), log_(log) {}

    void read(Command& command) {
        std::size_t at = 0;
        const bool matched = match(syntax_.root, at);
        if (matched && at == pieces_.size()) {
            checkItems(row_, events_, pieces_, names_, log_);
            build(row_, events_, std::move(pieces_), command, log_);
        } else {
            mismatch_.report(row_, pieces_, names_, matched, at, command.position, log_);
        }
    }

  private:
    /// Takes back what an alternative that does not fit has read.
    bool rewind(std::size_t& at, std::size_t begin, std::size_t events) {
        at = begin;
        events_.resize(events);
        return false;
    }

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
        return std::ranges::any_of(node.children, [&](const Node& each) { return match(each, at); });
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
            const auto found =
                std::ranges::find_if(node.children, [&](const Node& each) { return match(each, at); });
            if (found == node.children.end() || at == begin) break;
            std::string suffix(afterPoint(pieces_[begin].text));
            const auto before = std::ranges::find_if(
                used, [&](const Used& each) { return each.alternative == &*found && each.suffix == suffix; });
            if (before != used.end()) {
                mismatch_.contradict(before->piece, begin);
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
        const Value* value = pieces_.find(at);
        if (value == nullptr || !isUnquoted(*value) || !sameWord(beforePoint(value->text), node.text))
            return mismatch_.expectWord(at, node.text);
        if (!suffixFits(node, value->text)) {
            if (node.hasNumberSuffix)
                return mismatch_.expect(at,
                                        {Kind::other, fmt::format("'{0}' or '{0}.1'", node.text), node.text});
            for (const std::string& each : node.words)
                mismatch_.expectWord(at, fmt::format("{}.{}", node.text, each));
            return mismatch_.expectWord(at, node.text);
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
                   std::ranges::all_of(suffix, [](char c) { return c >= '0' && c <= '9'; });
        return isAmong(suffix, node.words);
    }

    bool matchNumbers(const Node& node, std::size_t& at) {
        const std::size_t begin = at;
        bool hasExpression = false;
        while (at < pieces_.size() && at - begin < node.most && isNumeric(pieces_[at]))
            hasExpression = pieces_[at++].kind == Value::Kind::expression || hasExpression;
        const std::size_t count = at - begin;
        if (count < node.most)
            mismatch_.expect(
                at, {Kind::number,
                     node.most == 1 ? fmt::format("a number ({})", node.text)
                                    : fmt::format("number {} of {} ({})", count + 1, node.most, node.text)});
        if (count < (hasExpression ? 1 : node.least)) return rewind(at, begin, events_.size());
        events_.push_back({Event::Kind::value, &node, begin, at});
        return true;
    }

    bool matchFiles(const Node& node, std::size_t& at, bool isSkippable) {
        const std::size_t begin = at;
        while (at - begin < node.most) {
            const Value* value = pieces_.find(at);
            const bool fits = value != nullptr && (value->kind == Value::Kind::text || isUnquoted(*value)) &&
                              !isKeyInstead(*value, isSkippable || node.isChosen || at > begin);
            if (!fits) {
                mismatch_.expect(
                    at, {Kind::other, node.most == 1 ? fmt::format("a file ({})", node.text)
                                                     : fmt::format("file {} of {} ({})", at - begin + 1,
                                                                   node.most, node.text)});
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
            if (node.type != ValueType::oneOf) return mismatch_.expect(at, describe(node));
            for (const std::string& each : node.words) mismatch_.expectWord(at, each);
            return false;
        }
        events_.push_back({Event::Kind::value, &node, at, end});
        at = end;
        return true;
    }

    static Expectation describe(const Node& node) {
        switch (node.type) {
            case ValueType::name:
            case ValueType::array:
                return {Kind::other, node.text == "name" ? "a name" : fmt::format("a name ({})", node.text)};
            case ValueType::object:
                return {Kind::other,
                        node.text == "object" ? "a name" : fmt::format("a name ({})", node.text)};
            case ValueType::word:
            case ValueType::program:
                return {Kind::other, fmt::format("a word ({})", node.text)};
            case ValueType::key:
                return {Kind::other, "a key of the keyboard"};
            case ValueType::any:
            case ValueType::constant:
                return {Kind::value, "a value"};
            case ValueType::expression:
                return {Kind::expression, fmt::format("an expression in parentheses ({})", node.text)};
            case ValueType::list:
            case ValueType::words:
                return {Kind::list, fmt::format("a list in [ ] ({})", node.text)};
            case ValueType::color:
                return {Kind::color, "a colour {r g b}"};
            case ValueType::components:
                return {Kind::components, "components [r g b a]"};
            default:
                return {Kind::other, node.text};
        }
    }

    /// Returns the index after the value; `at` if there is none of this type.
    std::size_t valueEnd(const Node& node, std::size_t at, bool isSkippable) const {
        const Value* value = pieces_.find(at);
        if (value == nullptr) return at;
        const Value::Kind kind = value->kind;
        const bool isLone = !pieces_.isJoined(at + 1) || pieces_[at + 1].kind == Value::Kind::word;
        bool fits = false;
        switch (node.type) {
            case ValueType::name:
                fits = isLone && kind == Value::Kind::word && isIdentifier(value->text) &&
                       !isKeyInstead(*value, isSkippable || node.isChosen);
                break;
            case ValueType::array:  // [...] or (...) at the end is the value
                if (kind != Value::Kind::word || !isIdentifier(value->text)) return at;
                return pieces_.isSubscript(at + 1) && at + 2 < pieces_.size() ? at + 2 : at + 1;
            case ValueType::object:
                return isUnquoted(*value) && isKeyInstead(*value, isSkippable || node.isChosen) &&
                               !isNamedLikeKey(at, isSkippable)
                           ? at
                           : pieces_.objectEnd(at);
            case ValueType::word:
                fits = isUnquoted(*value) && !isKeyInstead(*value, isSkippable);
                break;
            case ValueType::program:
                fits = isUnquoted(*value) || kind == Value::Kind::text;
                break;
            case ValueType::key:
                fits = isUnquoted(*value) || kind == Value::Kind::text || kind == Value::Kind::number;
                break;
            case ValueType::any:
                if (kind == Value::Kind::word) return pieces_.objectEnd(at);
                [[fallthrough]];
            case ValueType::constant:
                fits = kind != Value::Kind::word && kind != Value::Kind::text;
                break;
            case ValueType::expression:
                fits = kind == Value::Kind::expression;
                break;
            case ValueType::list:
                fits = kind == Value::Kind::list;
                break;
            case ValueType::words:
                fits = kind == Value::Kind::list && value->count.empty();
                break;
            case ValueType::color:
                fits = kind == Value::Kind::color || kind == Value::Kind::expression;
                break;
            case ValueType::components:
                fits = kind == Value::Kind::color || kind == Value::Kind::list ||
                       kind == Value::Kind::expression;
                break;
            case ValueType::oneOf:
                fits = kind == Value::Kind::expression ||
                       (isUnquoted(*value) && isAmong(value->text, node.words));
                break;
            default:
                break;
        }
        return fits ? at + 1 : at;
    }

    /// True if a word that may be left out is a key, or a misspelt key, rather than a value.
    bool isKeyInstead(const Value& value, bool mayBeLeftOut) const {
        if (!mayBeLeftOut || !isUnquoted(value)) return false;
        if (isRepeatedKey(value)) return true;
        if (row_.id == CommandId::program) return false;
        std::vector<std::string_view> keys(syntax_.keys.begin(), syntax_.keys.end());
        const std::string_view word = beforePoint(value.text);
        // A buffer `Count` may be named after the key `buffer`, though there is a key `count`.
        if (names_.mayHave(word) && std::ranges::find(keys, word) == keys.end()) return false;
        if (isAmong(word, keys)) return word.size() == value.text.size();
        return word.size() == value.text.size() && !names_.mayHave(word) &&
               !base::nearestName(word, keys).empty();
    }

    /// True for the name of an object that is also a key, where that key cannot stand: a key that only stands
    /// after others, as `depth` in Pass; after a key that needs a name, as in `Expect buffer count [1]`; and
    /// as a target, as in `Pass color depth`.
    bool isNamedLikeKey(std::size_t at, bool isSkippable) const {
        const Value& value = pieces_[at];
        if (!names_.mayHave(value.text)) return false;
        if (!isAmong(value.text, syntax_.outerKeys)) return true;
        const bool isAfterKey =
            !events_.empty() && events_.back().kind == Event::Kind::key && events_.back().end == at;
        if (isAfterKey && !isSkippable) return true;
        const bool wantsNumber = value.text == "depth" || value.text == "stencil";
        const Value* next = pieces_.find(at + 1);
        return wantsNumber && (next == nullptr || !isNumeric(*next));
    }

    bool matchPairs(const Node& node, std::size_t& at) {
        bool any = false;
        while (at < pieces_.size()) {
            const std::size_t tag = pieces_.tagEnd(at);
            std::string key = unusedKeyNear(pieces_[at]);
            if (tag == at || sameWord(key, pieces_[at].text) || isRepeatedKey(pieces_[at])) {
                mismatch_.expect(at, {Kind::other, "a tag"});
                break;
            }
            const std::size_t end = anyEnd(tag);
            if (end == tag) {
                if (key.empty())
                    mismatch_.expect(
                        tag, {Kind::value, fmt::format("a value of '{}'", pieces_.onOneLine(at, tag))});
                else
                    mismatch_.expect(at, {Kind::other, "a tag"});
                break;
            }
            events_.push_back({Event::Kind::tag, &node, at, tag, std::move(key)});
            events_.push_back({Event::Kind::value, &node, tag, end});
            at = end;
            any = true;
        }
        if (!any && at == pieces_.size()) mismatch_.expect(at, {Kind::other, "a tag"});
        return any || !node.needsOne;
    }

    /// True for the key of Program, which may stand several times.
    bool isRepeatedKey(const Value& value) const {
        return row_.id == CommandId::program && isUnquoted(value) && isAmong(value.text, syntax_.keys);
    }

    /// The key of the statement that is not used yet and that a word where a tag may stand is, or may be,
    /// misspelt. Empty if there is none.
    std::string unusedKeyNear(const Value& value) const {
        if (!isUnquoted(value) || row_.id == CommandId::program) return {};
        std::vector<std::string_view> keys;
        for (const std::string& each : syntax_.keys)
            if (std::ranges::none_of(events_, [&](const Event& event) {
                    return event.kind == Event::Kind::key && event.node->text == each;
                }))
                keys.push_back(each);
        const auto isKey = [&](std::string_view each) { return sameWord(each, value.text); };
        const auto found = std::ranges::find_if(keys, isKey);
        return found != keys.end() ? std::string(*found) : std::string(base::nearestName(value.text, keys));
    }

    std::size_t anyEnd(std::size_t at) const {
        const Value* value = pieces_.find(at);
        if (value == nullptr || value->kind == Value::Kind::text) return at;
        return value->kind == Value::Kind::word ? pieces_.objectEnd(at) : at + 1;
    }

    const StatementRow& row_;
    const Syntax& syntax_;
    Pieces pieces_;
    const DeclaredNames& names_;
    MessageLog& log_;
    std::vector<Event> events_;
    Mismatch mismatch_;
};

}  // namespace

void readStatement(const StatementRow& row, std::string_view text, std::span<const Token> tokens,
                   const DeclaredNames& names, Command& command, MessageLog& log) {
    std::optional<std::vector<Piece>> pieces = readPieces(tokens, log, row.id == CommandId::let);
    if (pieces) Matcher(row, {text, std::move(*pieces)}, names, log).read(command);
}

bool hasMalformedValue(std::span<const Token> tokens) {
    std::size_t depth = 0;
    for (std::size_t i = 1; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        if (token.kind == TokenKind::open) ++depth;
        if (token.kind == TokenKind::close && depth > 0) --depth;
        const bool isWord = depth > 0 && token.kind == TokenKind::word && !token.truth();
        const bool isTagValue = depth > 0 || tokens[i - 1].isWord();
        if (isWord || (isTagValue && token.kind == TokenKind::number && !isCompleteNumber(token.text)))
            return true;
    }
    return false;
}

}  // namespace glibra::glib
