#include "classroom/tokens.h"

#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <span>
#include <utility>

#include "classroom/code_tree.h"
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

std::vector<CodeToken> codeOf(std::span<const Token* const> tokens) {
    std::vector<CodeToken> code;
    for (const Token* each : tokens)
        code.push_back(
            {each->text, 0, {each->line, 0}, each->kind == TokenKind::word, each->kind == TokenKind::number});
    dropPrecisions(code);
    return code;
}

}  // namespace

/// FNV-1a, by Fowler, Noll and Vo.
std::uint32_t codeOfText(std::string_view text) {
    std::uint32_t code = 2166136261U;
    for (const char each : text) code = (code ^ static_cast<unsigned char>(each)) * 16777619U;
    return code;
}

void dropPrecisions(std::vector<CodeToken>& code) {
    constexpr std::array<std::string_view, 4> kWords{"highp", "mediump", "lowp", "precise"};
    bool isStatement = false;  // "precision highp float;"
    std::erase_if(code, [&](const CodeToken& each) {
        const bool begins = each.text == "precision", isWithin = isStatement || begins;
        isStatement = isWithin && each.text != ";";
        return isWithin || std::ranges::find(kWords, each.text) != kWords.end();
    });
}

std::vector<CodeToken> comparedCode(std::span<const CodeToken> tokens, const OwnFunctions& own) {
    std::vector<CodeToken> kept;
    const CodeTree tree(tokens);
    for (const glsl::Declaration& declaration : tree.declarations()) {
        if (declaration.qualifiers.isInterface()) continue;
        for (std::size_t i = declaration.tokens.first; i < declaration.tokens.end; ++i) {
            CodeToken& one = kept.emplace_back(tokens[i]);
            one.code = codeOfText(one.text);
            if (one.isNumber) {
                one.code = kNumberCode;
            } else if (one.isWord) {
                const bool isCall = i + 1 < tokens.size() && tokens[i + 1].text == "(";
                const bool isBuiltIn = one.text.starts_with("gl_") || (isCall && !own.contains(one.text));
                if (glsl::keywordSince(one.text) == 0 && !isBuiltIn) one.code = kNameCode;
            }
        }
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
    const std::vector<CodeToken> code = codeOf(text.code());
    const CodeTree tree(code);
    std::vector<DeclaredUniform> found;
    const auto add = [&](std::uint32_t name, std::string_view type) {
        DeclaredUniform one{std::string(code[name].text), std::string(type)};
        if (std::ranges::find(found, one) == found.end()) found.push_back(std::move(one));
    };
    for (const glsl::Declaration& each : tree.declarations()) {
        if (each.qualifiers.storage != glsl::Storage::uniform) continue;
        if (each.kind == glsl::DeclarationKind::block) add(each.name, "block");
        if (each.kind == glsl::DeclarationKind::variable)
            for (const glsl::Declarator& one : each.declarators) add(one.name, each.type.name);
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
