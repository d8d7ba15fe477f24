#include "classroom/code_blocks.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

constexpr int kDeepestBlock = 24, kDeepestStatement = 200;

std::string_view textOf(std::span<const CodeToken> tokens, std::size_t index) {
    return index < tokens.size() ? tokens[index].text : std::string_view{};
}

/// The statements of bodies, and what is made of them.
class Blocks {
  public:
    Blocks(std::span<const CodeToken> tokens, const std::function<void(std::vector<Code>&)>& change)
        : tokens_(tokens), brackets_(tokens), change_(change) {}

    /// The tokens begin ... end - 1 as the content of a block.
    Code block(std::size_t begin, std::size_t end, int depth) {
        std::vector<Code> statements;
        for (std::size_t at = begin; at < end;) {
            const std::size_t next = std::clamp(afterStatement(tokens_, brackets_, at, end), at + 1, end);
            statements.push_back(statement(at, next, depth));
            at = next;
        }
        change_(statements);
        return joinedCode(statements);
    }

    /// The tokens as a whole text, in which every function body is a block.
    Code text() {
        Code made;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            made.push_back(tokens_[i]);
            if (tokens_[i].text != ")" || textOf(tokens_, i + 1) != "{") continue;
            made.push_back(tokens_[i + 1]);
            const std::size_t after = brackets_.after(i + 1);
            const bool isClosed = after > i + 2 && textOf(tokens_, after - 1) == "}";
            append(made, block(i + 2, isClosed ? after - 1 : after, 0));
            if (isClosed) made.push_back(tokens_[after - 1]);
            i = after - 1;
        }
        return made;
    }

  private:
    static void append(Code& to, const Code& code) { to.insert(to.end(), code.begin(), code.end()); }

    Code statement(std::size_t begin, std::size_t end, int depth) {
        Code made;
        const bool stays = depth >= kDeepestBlock || tokens_[begin].text == "switch";
        for (std::size_t i = begin; i < end; ++i) {
            made.push_back(tokens_[i]);
            const bool opens =
                tokens_[i].text == "{" && (i == begin || tokens_[i - 1].text == ")" ||
                                           tokens_[i - 1].text == "else" || tokens_[i - 1].text == "do");
            const std::size_t after = brackets_.after(i);
            if (stays || !opens || after > end || after < i + 2 || tokens_[after - 1].text != "}") continue;
            append(made, block(i + 1, after - 1, depth + 1));
            made.push_back(tokens_[after - 1]);
            i = after - 1;
        }
        return made;
    }

    std::span<const CodeToken> tokens_;
    Brackets brackets_;
    const std::function<void(std::vector<Code>&)>& change_;
};

std::size_t afterNested(std::span<const CodeToken> tokens, const Brackets& brackets, std::size_t at,
                        std::size_t end, int nested) {
    if (at >= end || nested > kDeepestStatement) return end;
    const std::string_view each = textOf(tokens, at);
    if (each == "{") return std::min(brackets.after(at), end);
    if (each == "if" || each == "while" || each == "for" || each == "switch") {
        const std::size_t after =
            afterNested(tokens, brackets, std::min(brackets.after(at + 1), end), end, nested + 1);
        return each == "if" && textOf(tokens, after) == "else"
                   ? afterNested(tokens, brackets, after + 1, end, nested + 1)
                   : after;
    }
    if (each == "do") at = afterNested(tokens, brackets, at + 1, end, nested + 1);
    int depth = 0;
    for (; at < end; ++at) {
        depth += glsl::opensBracket(tokens[at].text) ? 1 : glsl::closesBracket(tokens[at].text) ? -1 : 0;
        if (depth < 0) return at;
        if (depth == 0 && tokens[at].text == ";") return at + 1;
    }
    return end;
}

}  // namespace

Brackets::Brackets(std::span<const CodeToken> tokens) : after_(tokens.size(), tokens.size()) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (glsl::opensBracket(tokens[i].text)) {
            open.push_back(i);
            continue;
        }
        after_[i] = i + 1;
        if (!glsl::closesBracket(tokens[i].text) || open.empty()) continue;
        after_[open.back()] = i + 1;
        open.pop_back();
    }
}

std::size_t Brackets::after(std::size_t open) const {
    return open < after_.size() ? after_[open] : after_.size();
}

std::size_t afterStatement(std::span<const CodeToken> tokens, const Brackets& brackets, std::size_t at,
                           std::size_t end) {
    return afterNested(tokens, brackets, at, end, 0);
}

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

bool isBefore(const Code& a, const Code& b) {
    return std::ranges::lexicographical_compare(a, b, {}, &CodeToken::code, &CodeToken::code);
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

Code withStatements(std::span<const CodeToken> body,
                    const std::function<void(std::vector<Code>& statements)>& change) {
    return Blocks(body, change).block(0, body.size(), 0);
}

}  // namespace glibra::classroom
