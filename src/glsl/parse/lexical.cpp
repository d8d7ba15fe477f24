#include "glsl/parse/lexical.h"

#include <algorithm>

#include "glsl/parse/usage.h"
#include "glsl/read/extensions.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

/// Finds the declarations of free words in the view of a stage, without a parser: it has to know the names.
class NameFinder {
  public:
    explicit NameFinder(Unit& unit) : unit_(unit), isLayout_(unit.view.size(), false) { findLayouts(); }

    void run() {
        std::set<std::string_view> names;
        for (std::uint32_t i = 0; i < unit_.view.size(); ++i)
            if (isFree(i) && declares(i)) names.insert(text(i));
        if (names.empty()) return;
        for (std::uint32_t i = 0; i < unit_.view.size(); ++i) {
            if (unit_.view[i].kind != TokenKind::word || !names.contains(text(i))) continue;
            if (isLayout_[i])
                unit_.layoutWords.insert(unit_.view[i].raw);
            else
                unit_.view[i].isName = true;
        }
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] bool isFree(std::uint32_t at) const {
        return unit_.view[at].kind == TokenKind::word && !isLayout_[at] &&
               isFreeWord(text(at), unit_.dialect);
    }

    void findLayouts() {
        for (std::uint32_t i = 0; i + 1 < unit_.view.size(); ++i) {
            if (text(i) != "layout" || text(i + 1) != "(") continue;
            const std::uint32_t end =
                closing(unit_.view, i + 1, static_cast<std::uint32_t>(unit_.view.size()));
            // A function or a constructor could have the name `layout` in old versions: only words, numbers
            // and a few signs are in the parentheses of a qualifier, and a declaration follows it.
            const bool isQualifier =
                end + 1 < unit_.view.size() && unit_.view[end + 1].kind == TokenKind::word;
            for (std::uint32_t k = i; isQualifier && k < end; ++k) isLayout_[k] = true;
        }
    }

    /// True if the token may be the type of a declaration.
    [[nodiscard]] bool mayBeType(std::uint32_t at) const {
        const ViewToken& token = unit_.view[at];
        return token.kind == TokenKind::word && !isQualifierWord(token.text) &&
               !isStatementWord(token.text) && token.text != "precision" && token.text != "struct";
    }
    /// True if a type with its sizes ends at the token: `float`, `S[2]`, or the '}' of a struct or block.
    [[nodiscard]] bool endsType(std::uint32_t at) const {
        if (text(at) == "}") return true;
        std::uint32_t i = at;
        while (text(i) == "]") {
            int depth = 0;
            do {
                if (text(i) == "]") ++depth;
                if (text(i) == "[") --depth;
            } while (depth > 0 && i-- > 0);
            if (i == 0 || i >= unit_.view.size()) return false;
            --i;
        }
        return mayBeType(i) && (i == at || isTypeWord(text(i)) || startsStatement(i));
    }
    /// True if no operand can stand before the token, so that it begins a declaration.
    [[nodiscard]] bool startsStatement(std::uint32_t at) const {
        if (at == 0) return true;
        const std::string_view before = text(at - 1);
        return before == ";" || before == "{" || before == "}" || before == "(" || before == "," ||
               unit_.view[at - 1].kind == TokenKind::word;
    }

    [[nodiscard]] bool declares(std::uint32_t at) const {
        if (at == 0) return false;
        const std::string_view next = text(at + 1);
        const std::string_view before = text(at - 1);
        if (before == "struct") return true;
        if (next == "{") return isBlockStorage(at - 1);
        if (endsType(at - 1)) {
            const bool isDeclarator = next == ";" || next == "," || next == "=" || next == "[";
            return isDeclarator || (before != "}" && (next == "(" || next == ")"));
        }
        if (before != "," || isTypeWord(text(at))) return before == "," && (next == ";" || next == "=");
        return next == ";" || next == "=" || next == "," || next == "[" || next == ")";
    }
    [[nodiscard]] bool isBlockStorage(std::uint32_t at) const {
        return unit_.view[at].kind == TokenKind::word && isQualifierWord(text(at));
    }

    Unit& unit_;
    std::vector<bool> isLayout_;
};

/// True if the version counts a comma expression of constants as a constant.
bool hasConstantSequences(const Dialect& dialect) {
    return dialect.es ? dialect.written < 300 : dialect.version < 430;
}

}  // namespace

void markNames(Unit& unit) {
    NameFinder(unit).run();
}

void dropIdleOperands(Unit& unit) {
    if (!hasConstantSequences(unit.dialect)) return;
    struct Group {
        std::uint32_t open;
        std::uint32_t comma = kNone;  ///< the last one that stands in no inner bracket
    };
    std::vector<Group> groups;
    std::vector<bool> isDropped(unit.view.size(), false);
    for (std::uint32_t i = 0; i < unit.view.size(); ++i) {
        const std::string_view text = unit.text(i);
        if (text.size() != 1) continue;
        if (opensBracket(text)) {
            groups.push_back({i});
        } else if (groups.empty()) {
            continue;
        } else if (text == ",") {
            groups.back().comma = i;
        } else if (closesBracket(text)) {
            const Group group = groups.back();
            groups.pop_back();
            const std::string_view before = group.open > 0 ? unit.text(group.open - 1) : std::string_view{};
            const bool isList = text != ")" || group.open == 0 || before == "]" ||
                                unit.view[group.open - 1].kind == TokenKind::word;
            if (isList || group.comma == kNone || group.comma == group.open + 1) continue;
            const Range idle{group.open + 1, group.comma + 1};
            if (!isIdle(unit, idle) || unit.hasAny(idle, {";", "{"})) continue;
            for (std::uint32_t k = idle.first; k < idle.end; ++k) isDropped[k] = true;
        }
    }
    std::vector<ViewToken> kept;
    for (std::uint32_t i = 0; i < unit.view.size(); ++i) {
        if (isDropped[i])
            unit.edits.remove(unit.view[i].raw);
        else
            kept.push_back(unit.view[i]);
    }
    unit.view = std::move(kept);
}

void replaceExtensionWords(Unit& unit) {
    std::set<std::string_view> own;  // functions of the user: a type stands before their names
    for (std::uint32_t i = 1; i < unit.view.size(); ++i)
        if (unit.text(i + 1) == "(" && unit.view[i - 1].kind == TokenKind::word &&
            !isStatementWord(unit.text(i - 1)))
            own.insert(unit.text(i));
    const auto replace = [&](ViewToken& token, std::string_view word) {
        token.text = word;
        unit.edits.replace(token.raw, std::string(word));
    };
    std::vector<ViewToken>& view = unit.view;
    for (std::uint32_t i = 0; i < view.size(); ++i) {
        if (view[i].kind != TokenKind::word || (i > 0 && view[i - 1].text == ".")) continue;
        const std::string_view word = coreWordOf(view[i].text, unit.enabled);
        const bool isFunction = !word.empty() && !word.starts_with("gl_") && !isTypeWord(word);
        if (!word.empty() && !(isFunction && (unit.text(i + 1) != "(" || own.contains(view[i].text)))) {
            replace(view[i], word);
        } else if (view[i].text == "unsigned" && unit.text(i + 1) == "int") {
            unit.edits.remove(view[i].raw);
            replace(view[i + 1], "uint");
            view[i].text = {};
        }
    }
    std::erase_if(view, [](const ViewToken& each) { return each.text.empty(); });
}

}  // namespace glibra::glsl
