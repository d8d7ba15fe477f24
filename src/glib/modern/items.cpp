#include "glib/modern/items.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "glib/number.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

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

}  // namespace

void checkItems(const StatementRow& row, const std::vector<Event>& events, const Pieces& pieces,
                const DeclaredNames& names, MessageLog& log) {
    ItemChecker checker(row, pieces, names, log);
    for (const Event& event : events) {
        if (event.kind != Event::Kind::value || pieces[event.begin].kind == Value::Kind::word) continue;
        for (std::size_t i = event.begin; i < event.end; ++i)
            if (!checker.check(pieces[i], event)) return;
    }
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
