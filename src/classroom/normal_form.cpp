#include "classroom/normal_form.h"

#include <algorithm>
#include <array>
#include <utility>

#include "glsl/parse/syntax.h"
#include "glsl/parse/tree.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::classroom {

CodeTree::CodeTree(std::span<const CodeToken> code, Of of) : code_(code) {
    std::vector<glsl::ViewToken> view;
    view.reserve(code.size());
    for (const CodeToken& each : code)
        view.push_back({each.text, static_cast<std::uint32_t>(view.size()),
                        each.isWord     ? glsl::TokenKind::word
                        : each.isNumber ? glsl::TokenKind::number
                                        : glsl::TokenKind::punctuator});
    if (of == Of::text) {
        syntax_ = glsl::parseSyntax(view);
    } else {
        glsl::Declaration& around = syntax_.declarations.emplace_back();
        around.kind = glsl::DeclarationKind::function;
        around.body = around.tokens = {0, static_cast<std::uint32_t>(view.size())};
    }
    bodies_ = glsl::parseBodies(view, syntax_);
    for (const glsl::Declaration& each : syntax_.declarations)
        if (each.code != glsl::kNone) functions_.push_back(each.code);
}

std::map<std::uint32_t, std::uint32_t> CodeTree::initializers() const {
    std::map<std::uint32_t, std::uint32_t> found;
    const auto add = [&](const auto& each) {
        if (each.value != glsl::kNone) found.emplace(each.name, each.value);
    };
    for (const glsl::LocalVariable& each : bodies_.locals) add(each);
    for (const glsl::Declaration& each : syntax_.declarations)
        for (const glsl::Declarator& one : each.declarators) add(one);
    return found;
}

namespace {

constexpr int kDeepestBlock = 24;

std::string_view textOf(std::span<const CodeToken> tokens, std::size_t index) {
    return index < tokens.size() ? tokens[index].text : std::string_view{};
}

/// The statements of bodies, and what is made of them.
class Blocks {
  public:
    Blocks(std::span<const CodeToken> tokens, const std::function<void(std::vector<Code>&)>& change)
        : tokens_(tokens), tree_(tokens), change_(change) {}

    Code text() {
        return tree_.changed(0, tokens_.size(), tree_.functions(),
                             [&](std::uint32_t each) { return block(each, 0); });
    }

  private:
    Code block(std::uint32_t id, int depth) {
        const std::span<const CodeToken> whole = tree_.code(id);
        const std::uint32_t last = tree_.node(id).lastChild;
        const bool isClosed = whole.size() > 1 && whole.back().text == "}" &&
                              (last == glsl::kNone || tree_.node(last).end < tree_.node(id).end);
        std::size_t at = tree_.node(id).first + 1;
        const std::size_t end = tree_.node(id).end - (isClosed ? 1 : 0);
        std::vector<Code> statements;
        Code made{whole.front()};
        const auto finish = [&] {
            change_(statements);
            append(made, joinedCode(std::exchange(statements, {})));
        };
        for (const std::uint32_t each : tree_.children(id)) {
            if (tree_.is(each, glsl::NodeKind::label)) {
                finish();
                append(made, {tokens_.begin() + static_cast<std::ptrdiff_t>(at),
                              tokens_.begin() + static_cast<std::ptrdiff_t>(tree_.node(each).end)});
                at = tree_.node(each).end;
                continue;
            }
            statements.push_back(tree_.changed(at, tree_.node(each).end, std::array{each},
                                               [&](std::uint32_t one) { return statement(one, depth); }));
            at = tree_.node(each).end;
        }
        if (at < end)
            statements.emplace_back(tokens_.begin() + static_cast<std::ptrdiff_t>(at),
                                    tokens_.begin() + static_cast<std::ptrdiff_t>(end));
        finish();
        if (isClosed) made.push_back(whole.back());
        return made;
    }

    /// With its blocks changed.
    Code statement(std::uint32_t id, int depth) {
        const glsl::Node& it = tree_.node(id);
        if (depth < kDeepestBlock && it.kind == glsl::NodeKind::block) return block(id, depth + 1);
        const bool isControl = it.kind >= glsl::NodeKind::branch && it.kind <= glsl::NodeKind::choice;
        const auto code = tree_.code(id);
        if (depth >= kDeepestBlock || !isControl) return {code.begin(), code.end()};
        return tree_.changed(it.first, it.end, tree_.children(id),
                             [&](std::uint32_t each) { return statement(each, depth); });
    }

    static void append(Code& to, const Code& code) { to.insert(to.end(), code.begin(), code.end()); }

    std::span<const CodeToken> tokens_;
    CodeTree tree_;
    const std::function<void(std::vector<Code>&)>& change_;
};

}  // namespace

bool isVariableName(std::span<const CodeToken> tokens, std::size_t index) {
    return tokens[index].isWord && glsl::keywordSince(tokens[index].text) == 0 &&
           textOf(tokens, index + 1) != "(" && (index == 0 || tokens[index - 1].text != ".");
}

bool isDeclaredName(std::span<const CodeToken> tokens, std::size_t index) {
    return index > 0 && isVariableName(tokens, index) && tokens[index - 1].isWord &&
           !glsl::isStatementWord(tokens[index - 1].text);
}

std::string_view targetOf(std::span<const CodeToken> tokens, std::size_t begin, std::size_t sign) {
    constexpr std::size_t kLongest = 1'000;  // tokens of what is assigned to
    begin = std::max(begin, sign - std::min(sign, kLongest));
    for (std::size_t at = sign; at > begin;) {
        if (tokens[at - 1].text == "]") {
            for (int depth = 0; at > begin;) {
                --at;
                depth += tokens[at].text == "]" ? 1 : tokens[at].text == "[" ? -1 : 0;
                if (depth == 0) break;
            }
        } else if (tokens[at - 1].isWord) {
            if (at < begin + 2 || tokens[at - 2].text != ".") return tokens[at - 1].text;
            at -= 2;
        } else {
            break;
        }
    }
    return textOf(tokens, sign + 1);
}

CodeToken sign(std::string_view text, CodeLine line) {
    return {text, codeOfText(text), line};
}

std::vector<CodeToken> assignedBy(std::span<const CodeToken> target, const CodeToken& by,
                                  std::span<const CodeToken> value) {
    if (by.text == "=") return {value.begin(), value.end()};
    Code made(target.begin(), target.end());
    made.push_back(sign(by.text.substr(0, by.text.size() - 1), by.line));
    made.push_back(sign("(", by.line));
    made.insert(made.end(), value.begin(), value.end());
    made.push_back(sign(")", by.line));
    return made;
}

bool isBefore(const Code& a, const Code& b) {
    return std::ranges::lexicographical_compare(a, b, {}, &CodeToken::code, &CodeToken::code);
}

std::vector<std::span<const CodeToken>> splitAtCommas(std::span<const CodeToken> list) {
    std::vector<std::span<const CodeToken>> parts;
    std::size_t begin = 0, end = 0;
    for (int depth = 0; end < list.size(); ++end) {
        const std::string_view each = list[end].text;
        depth += glsl::opensBracket(each) ? 1 : glsl::closesBracket(each) ? -1 : 0;
        if (depth < 0) break;
        if (depth > 0 || each != ",") continue;
        parts.push_back(list.subspan(begin, end - begin));
        begin = end + 1;
    }
    if (end > 0) parts.push_back(list.subspan(begin, end - begin));
    return parts;
}

Code joinedCode(const std::vector<Code>& parts) {
    Code made;
    for (const Code& each : parts) made.insert(made.end(), each.begin(), each.end());
    return made;
}

Code withBlocks(std::span<const CodeToken> tokens,
                const std::function<void(std::vector<Code>& statements)>& change) {
    return Blocks(tokens, change).text();
}

}  // namespace glibra::classroom
