#include "editor/declared_names.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <limits>
#include <set>

#include "base/text.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::editor {
namespace {

constexpr std::string_view kSpacesAndTabs = " \t";

/// The word after `#what` in a directive; empty if it is another directive.
std::string_view wordOfDirective(std::string_view line, std::string_view what) {
    line.remove_prefix(std::min(line.find_first_not_of(kSpacesAndTabs), line.size()));
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    line.remove_prefix(std::min(line.find_first_not_of(kSpacesAndTabs), line.size()));
    if (!line.starts_with(what)) return {};
    line.remove_prefix(what.size());
    const std::size_t begin = line.find_first_not_of(kSpacesAndTabs);
    if (begin == 0 || begin == std::string_view::npos) return {};
    line.remove_prefix(begin);
    const auto* const end = std::ranges::find_if_not(line, base::isOfName);
    return line.substr(0, static_cast<std::size_t>(end - line.begin()));
}

class Reader {
  public:
    explicit Reader(std::string_view glsl) : text_(glsl) {
        readMacros();
        for (const glsl::Token& each : glsl::lex(text_, storage_))
            if (glsl::isSignificant(each.kind)) tokens_.push_back(each);
        std::vector<std::size_t> around;
        for (std::size_t at = 0; at < tokens_.size(); ++at) {
            const std::string_view word = wordAt(at);
            if ((word == ")" || word == "}") && !around.empty()) around.pop_back();
            open_.push_back(around.empty() ? tokens_.size() : around.back());
            if (word == "(" || word == "{") around.push_back(at);
        }
    }

    std::vector<DeclaredName> read() {
        for (std::size_t at = 0; at < tokens_.size(); ++at) {
            const std::string_view word = wordAt(at);
            if (word == "struct" && isName(at + 1)) {
                types_.insert(std::string(wordAt(at + 1)));
                add(at + 1, "struct", "struct " + std::string(wordAt(at + 1)), false);
            } else if (isType(word) && isName(at + 1) && beforeName(at) != ".") {
                declare(at);
            } else if (isName(at) && wordAt(at + 1) == "{" && isInterfaceWord(beforeName(at))) {
                add(at, "block", std::string(beforeName(at)) + " " + std::string(word), false);
                found_.back().isInterface = true;
            }
        }
        std::ranges::stable_sort(found_, {}, &DeclaredName::line);
        return std::move(found_);
    }

  private:
    /// Takes the macros, and blanks the lines of directives so that the rest can be read as code.
    void readMacros() {
        int line = 1;
        for (std::size_t begin = 0; begin < text_.size(); ++line) {
            const std::size_t end = std::min(text_.find('\n', begin), text_.size());
            const std::string_view whole = std::string_view(text_).substr(begin, end - begin);
            if (const std::string_view name = wordOfDirective(whole, "define"); !name.empty()) {
                const std::size_t first = whole.find('#');
                DeclaredName& macro = found_.emplace_back();
                macro.name = name;
                macro.type = "macro";
                macro.declaration = whole.substr(first);
                macro.line = line;
            }
            const std::size_t first = whole.find_first_not_of(kSpacesAndTabs);
            if (first != std::string_view::npos && whole[first] == '#')
                std::fill(text_.begin() + static_cast<std::ptrdiff_t>(begin),
                          text_.begin() + static_cast<std::ptrdiff_t>(end), ' ');
            begin = end + 1;
        }
    }

    [[nodiscard]] std::string_view wordAt(std::size_t at) const {
        return at < tokens_.size() ? tokens_[at].text : std::string_view();
    }
    [[nodiscard]] std::string_view beforeName(std::size_t at) const {
        return at > 0 ? wordAt(at - 1) : std::string_view();
    }
    [[nodiscard]] bool isName(std::size_t at) const {
        return at < tokens_.size() && tokens_[at].kind == glsl::TokenKind::word &&
               glsl::keywordSince(tokens_[at].text) == 0;
    }
    [[nodiscard]] bool isType(std::string_view word) const {
        return glsl::isTypeWord(word) || types_.contains(word);
    }
    [[nodiscard]] static bool isInterfaceWord(std::string_view word) {
        return word == "uniform" || word == "in" || word == "out" || word == "attribute" ||
               word == "varying" || word == "buffer";
    }

    void add(std::size_t at, std::string type, std::string declaration, bool isFunction) {
        DeclaredName& name = found_.emplace_back();
        name.name = wordAt(at);
        name.type = std::move(type);
        name.declaration = std::move(declaration);
        name.line = placeOf(at).line;
        name.column = placeOf(at).column;
        name.isFunction = isFunction;
        if (!isFunction) setScope(at, name);
    }

    [[nodiscard]] CodePlace placeOf(std::size_t at) const {
        if (at >= tokens_.size()) return {std::numeric_limits<int>::max(), 1};
        return {static_cast<int>(tokens_[at].line), static_cast<int>(tokens_[at].column)};
    }

    /// Where the name that is declared there ends, or what it is a member of.
    void setScope(std::size_t at, DeclaredName& name) const {
        const std::size_t open = open_[at];
        if (open == tokens_.size()) return;
        if (wordAt(open) == "(") {  // of a function, or of a loop
            const std::size_t after = afterBrackets(open, "(", ")");
            std::size_t end = after;
            if (wordAt(after) == "{")
                end = afterBrackets(after, "{", "}") - 1;
            else if (wordAt(open - 1) == "for")
                while (end < tokens_.size() && wordAt(end) != ";") ++end;
            name.scopeEnd = placeOf(end);
            return;
        }
        const bool isBlock = open > 1 && isName(open - 1) && isInterfaceWord(wordAt(open - 2));
        const bool isStructure =
            open > 0 && (wordAt(open - 1) == "struct" || (open > 1 && wordAt(open - 2) == "struct"));
        const std::size_t after = afterBrackets(open, "{", "}");
        name.isMember = isStructure || (isBlock && wordAt(after) != ";");
        if (!isStructure && !isBlock) name.scopeEnd = placeOf(after - 1);
    }

    /// The token after brackets that begin at `at`.
    [[nodiscard]] std::size_t afterBrackets(std::size_t at, std::string_view open,
                                            std::string_view close) const {
        int depth = 0;
        for (; at < tokens_.size(); ++at) {
            if (wordAt(at) == open) ++depth;
            if (wordAt(at) == close && --depth == 0) return at + 1;
        }
        return at;
    }

    /// "[3]" at `at`, and moves on.
    std::string sizes(std::size_t& at) const {
        std::string text;
        while (wordAt(at) == "[") {
            const std::size_t end = afterBrackets(at, "[", "]");
            for (; at < end; ++at) text += wordAt(at);
        }
        return text;
    }

    /// The ',' or ';' after an initialiser.
    [[nodiscard]] std::size_t endOfValue(std::size_t at) const {
        int depth = 0;
        for (; at < tokens_.size(); ++at) {
            const std::string_view word = wordAt(at);
            if (word == "(" || word == "[" || word == "{") ++depth;
            if (word == ")" || word == "]" || word == "}") --depth;
            if (depth < 0 || (depth == 0 && (word == "," || word == ";"))) return at;
        }
        return at;
    }

    /// The names after the type at `type`.
    void declare(std::size_t type) {
        std::string qualifiers;
        bool isInterface = false;
        for (std::size_t i = type; i > 0 && glsl::isQualifierWord(wordAt(i - 1)); --i) {
            qualifiers = std::string(wordAt(i - 1)) + " " + qualifiers;
            isInterface = isInterface || isInterfaceWord(wordAt(i - 1));
        }
        const std::string word(wordAt(type));
        std::size_t at = type + 1;
        if (wordAt(at + 1) == "(") {
            const std::size_t end = afterBrackets(at + 1, "(", ")");
            std::string declaration = word + " " + std::string(wordAt(at)) + "(";
            for (std::size_t i = at + 2; i + 1 < end; ++i) {
                const bool isJoined = wordAt(i) == "," || wordAt(i) == "[" || wordAt(i) == "]" ||
                                      i == at + 2 || wordAt(i - 1) == "[";
                declaration += (isJoined ? "" : " ") + std::string(wordAt(i));
            }
            return add(at, word, declaration + ")", true);
        }
        for (;;) {
            const std::size_t name = at++;
            const std::string size = sizes(at);
            std::string declaration = qualifiers;
            declaration += word + " " + std::string(wordAt(name)) + size;
            add(name, word + size, std::move(declaration), false);
            // A parameter `in vec3 n` is no interface: its declaration ends with ')' or a ',' and a type.
            const std::size_t end = wordAt(at) == "=" ? endOfValue(at) : at;
            found_.back().isInterface = isInterface && wordAt(end) != ")" && !isType(wordAt(end + 1)) &&
                                        !glsl::isQualifierWord(wordAt(end + 1));
            if (wordAt(end) == ";" && isInterface) found_.back().isInterface = true;
            if (wordAt(end) != "," || !isName(end + 1)) return;
            at = end + 1;
        }
    }

    std::string text_;
    std::deque<std::string> storage_;
    std::vector<glsl::Token> tokens_;
    std::vector<std::size_t> open_;  ///< for each token the bracket around it; the number of all tokens: none
    std::set<std::string, std::less<>> types_;
    std::vector<DeclaredName> found_;
};

}  // namespace

std::vector<DeclaredName> declaredNames(std::string_view glsl) {
    return Reader(glsl).read();
}

const DeclaredName* declarationOf(const std::vector<DeclaredName>& all, std::string_view name, CodePlace at,
                                  bool isMember) {
    const DeclaredName *found = nullptr, *other = nullptr;
    for (const DeclaredName& each : all) {
        if (each.name != name) continue;
        const CodePlace begin{each.line, each.column};
        const bool isSeen = isMember || (begin <= at && (!each.scopeEnd || at <= *each.scopeEnd));
        if (each.isMember != isMember || !isSeen) {
            if (other == nullptr && each.isMember == isMember && !each.scopeEnd)
                other = &each;  // further down
            continue;
        }
        if (found == nullptr || (!isMember && CodePlace{found->line, found->column} < begin)) found = &each;
    }
    return found != nullptr ? found : other;
}

int versionOf(std::string_view glsl) {
    constexpr int kFirst = 110;
    for (std::size_t begin = 0; begin < glsl.size();) {
        const std::size_t end = std::min(glsl.find('\n', begin), glsl.size());
        const std::string_view word = wordOfDirective(glsl.substr(begin, end - begin), "version");
        if (!word.empty()) return std::atoi(std::string(word).c_str());
        begin = end + 1;
    }
    return kFirst;
}

}  // namespace glibra::editor
