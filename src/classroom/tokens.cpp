#include "classroom/tokens.h"

#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <span>
#include <utility>

#include "classroom/normal_form.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

using glsl::Token;
using glsl::TokenKind;

/// The significant tokens of a text, and its preprocessor lines.
class Text {
  public:
    explicit Text(std::string_view glsl) : text_(glsl::normalizeLines(glsl)) {
        tokens_ = glsl::lex(text_, joined_);
        std::vector<const Token*> line;
        for (const Token& each : tokens_) {
            if (each.kind == TokenKind::newline) {
                addLine(line);
                line.clear();
            } else if (glsl::isSignificant(each.kind)) {
                line.push_back(&each);
            }
        }
        addLine(line);
    }

    [[nodiscard]] std::span<const Token* const> code() const { return code_; }
    /// The texts of all macros, one after another.
    [[nodiscard]] std::span<const Token* const> macros() const { return macros_; }
    [[nodiscard]] std::span<const std::vector<const Token*>> directives() const { return directives_; }

  private:
    void addLine(const std::vector<const Token*>& line) {
        if (line.empty() || line.front()->text != "#") {
            code_.insert(code_.end(), line.begin(), line.end());
            return;
        }
        directives_.push_back(line);
        // What a macro computes is code like any other.
        if (line.size() > 1 && line[1]->text == "define")
            macros_.insert(macros_.end(), line.begin(), line.end());
    }

    std::string text_;
    std::deque<std::string> joined_;
    std::vector<Token> tokens_;
    std::vector<const Token*> code_, macros_;
    std::vector<std::vector<const Token*>> directives_;
};

int depthChange(std::string_view text, char open, char close) {
    if (text.size() != 1) return 0;
    return text[0] == open ? 1 : text[0] == close ? -1 : 0;
}

/// The first token after a global declaration that begins at `first`: after its ";".
std::size_t endOfDeclaration(std::span<const Token* const> code, std::size_t first) {
    int depth = 0;
    for (std::size_t i = first; i < code.size(); ++i) {
        depth += depthChange(code[i]->text, '{', '}');
        if (depth <= 0 && code[i]->text == ";") return i + 1;
    }
    return code.size();
}

bool beginsInterface(std::string_view word) {
    static const std::set<std::string_view> kWords{"uniform",   "in",      "out",   "inout",
                                                   "attribute", "varying", "buffer"};
    return kWords.contains(word);
}

std::vector<CodeToken> codeOf(std::span<const Token* const> tokens) {
    std::vector<CodeToken> code;
    for (const Token* each : tokens)
        code.push_back(
            {each->text, 0, {each->line, 0}, each->kind == TokenKind::word, each->kind == TokenKind::number});
    return code;
}

}  // namespace

/// FNV-1a, by Fowler, Noll and Vo.
std::uint32_t codeOfText(std::string_view text) {
    std::uint32_t code = 2166136261U;
    for (const char each : text) code = (code ^ static_cast<unsigned char>(each)) * 16777619U;
    return code;
}

std::vector<CodeToken> comparedCode(std::span<const CodeToken> tokens, const OwnFunctions& own) {
    const auto text = [&](std::size_t i) { return i < tokens.size() ? tokens[i].text : std::string_view{}; };
    std::vector<CodeToken> kept;
    std::size_t statement = 0;  // where the one that is being read begins in `kept`
    int braces = 0, parentheses = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const CodeToken& token = tokens[i];
        braces += depthChange(token.text, '{', '}');
        parentheses += depthChange(token.text, '(', ')');
        if (braces <= 0 && parentheses <= 0 && beginsInterface(token.text)) {
            kept.resize(statement);  // also what stands before the word: layout(...), flat
            int depth = 0;
            for (; i < tokens.size(); ++i) {
                depth += depthChange(text(i), '{', '}');
                if (depth <= 0 && text(i) == ";") break;
            }
            continue;
        }
        CodeToken& one = kept.emplace_back(token);
        one.code = codeOfText(token.text);
        if (token.isNumber) {
            one.code = kNumberCode;
        } else if (token.isWord) {
            const bool isBuiltIn =
                token.text.starts_with("gl_") || (text(i + 1) == "(" && !own.contains(token.text));
            if (glsl::keywordSince(token.text) == 0 && !isBuiltIn) one.code = kNameCode;
        }
        if (braces <= 0 && (token.text == ";" || token.text == "}")) statement = kept.size();
    }
    return kept;
}

std::vector<SourceToken> comparableTokens(std::string_view glsl, std::size_t most) {
    const Text text(glsl);
    const std::vector<CodeToken> written = codeOf(text.code()), macros = codeOf(text.macros());
    const OwnFunctions own = ownFunctions(written);
    std::deque<std::string> names;
    std::vector<CodeToken> all =
        withoutDetours(withoutDeadCode(withoutLists(comparedCode(written, own)), own), own, {}, names);
    all = inStatementOrder(inOrder(all, kNumberCode), own);
    const std::vector<CodeToken> last = inOrder(comparedCode(macros, own), kNumberCode);
    all.insert(all.end(), last.begin(), last.end());
    std::vector<SourceToken> tokens;
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
        tokens.push_back({all[i].code, all[i].line.number});
    return tokens;
}

std::vector<DeclaredUniform> declaredUniforms(std::string_view glsl) {
    const Text text(glsl);
    const std::span<const Token* const> code = text.code();
    std::vector<DeclaredUniform> found;
    const auto add = [&](std::string_view name, std::string_view type) {
        DeclaredUniform one{std::string(name), std::string(type)};
        if (std::ranges::find(found, one) == found.end()) found.push_back(std::move(one));
    };
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i]->text != "uniform") continue;
        const std::size_t end = endOfDeclaration(code, i);
        std::size_t at = i + 1;
        while (at < end && glsl::isQualifierWord(code[at]->text)) ++at;
        if (at + 1 < end && code[at]->kind == TokenKind::word) {
            if (code[at + 1]->text == "{") {
                add(code[at]->text, "block");
            } else {
                // float a, b[2] = ..., c;
                const std::string_view type = code[at]->text;
                int nested = 0;
                bool expectsName = true;
                for (++at; at < end; ++at) {
                    const std::string_view each = code[at]->text;
                    nested += depthChange(each, '(', ')') + depthChange(each, '[', ']') +
                              depthChange(each, '{', '}');
                    if (nested == 0 && each == ",") {
                        expectsName = true;
                    } else if (nested == 0 && expectsName && code[at]->kind == TokenKind::word) {
                        add(each, type);
                        expectsName = false;
                    }
                }
            }
        }
        i = end - 1;
    }
    return found;
}

const char* stageName(glsl::Stage stage) {
    constexpr std::array kNames{
        "vertex", "tessellation control", "tessellation evaluation", "geometry", "fragment", "compute"};
    return kNames.at(static_cast<std::size_t>(stage));
}

std::vector<std::string> includedNames(std::string_view glsl) {
    const Text text(glsl);
    std::vector<std::string> names;
    for (const std::vector<const Token*>& line : text.directives()) {
        if (line.size() < 3 || line[1]->text != "include") continue;
        const char* begin = line[2]->text.data();
        const std::string_view rest(
            begin, static_cast<std::size_t>(line.back()->text.data() + line.back()->text.size() - begin));
        const std::size_t open = rest.find_first_of("\"<");
        const std::size_t close = rest.find_first_of("\">", open + 1);
        if (open != std::string_view::npos && close != std::string_view::npos)
            names.emplace_back(rest.substr(open + 1, close - open - 1));
    }
    return names;
}

}  // namespace glibra::classroom
