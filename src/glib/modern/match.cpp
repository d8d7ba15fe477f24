#include "glib/modern/match.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/suggest.h"
#include "glib/modern/build_command.h"
#include "glib/modern/grammar.h"
#include "glib/modern/items.h"
#include "glib/modern/mismatch.h"
#include "glib/modern/pieces.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

using Node = SyntaxNode;
using Kind = Expectation::Kind;

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
            case ValueType::array:  // [...] at the end is the value
                if (kind != Value::Kind::word || !isIdentifier(value->text)) return at;
                return pieces_.isSubscript(at + 1) && pieces_[at + 1].kind == Value::Kind::list &&
                               at + 2 < pieces_.size()
                           ? at + 2
                           : at + 1;
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
            if (tag == at || sameWord(key, pieces_[at].text)) {
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

    /// The key of the statement that is not used yet and that a word where a tag may stand is, or may be,
    /// misspelt. Empty if there is none.
    std::string unusedKeyNear(const Value& value) const {
        if (!isUnquoted(value)) return {};
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
    std::optional<std::vector<Piece>> pieces = readPieces(tokens, log);
    if (pieces) Matcher(row, {text, std::move(*pieces)}, names, log).read(command);
}

}  // namespace glibra::glib
