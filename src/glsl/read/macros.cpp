#include "glsl/read/macros.h"

#include <algorithm>

namespace glibra::glsl {
namespace {

constexpr int kDeepestExpansion = 64;

/// The index after the parenthesis that closes the one at `open`; tokens.size() + 1 if none does.
std::size_t splitArguments(std::span<const ViewToken> tokens, std::size_t open,
                           std::vector<std::span<const ViewToken>>& arguments) {
    int depth = 0;
    std::size_t start = open + 1;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "(" || text == "[" || text == "{") ++depth;
        const bool closes = text == ")" || text == "]" || text == "}";
        if (closes) --depth;
        if ((depth == 0 && closes) || (depth == 1 && text == ",")) {
            arguments.push_back(tokens.subspan(start, i - start));
            start = i + 1;
        }
        if (depth == 0 && closes) return i + 1;
    }
    return tokens.size() + 1;
}

}  // namespace

void MacroTable::undefine(std::string_view name) {
    if (const auto found = macros_.find(name); found != macros_.end()) macros_.erase(found);
}

void MacroTable::expand(std::span<const ViewToken> tokens, std::vector<ViewToken>& out) {
    expandInto(tokens, out, 0);
}

std::vector<ViewToken> MacroTable::substitute(const Macro& macro,
                                              const std::vector<std::span<const ViewToken>>& arguments,
                                              const ViewToken& call, int depth) {
    std::vector<ViewToken> text;
    for (const ViewToken& token : macro.body) {
        if (++steps_ > kMostSteps) break;
        const auto parameter = token.kind == TokenKind::word
                                   ? std::find(macro.parameters.begin(), macro.parameters.end(), token.text)
                                   : macro.parameters.end();
        if (parameter != macro.parameters.end()) {
            const auto index = static_cast<std::size_t>(parameter - macro.parameters.begin());
            if (index < arguments.size()) expandInto(arguments[index], text, depth + 1);
            continue;
        }
        text.push_back(token);
        text.back().body = true;
        text.back().site = call.site;
        text.back().objectSite = call.body ? call.objectSite : !macro.takesArguments;
    }
    return text;
}

void MacroTable::expandInto(std::span<const ViewToken> tokens, std::vector<ViewToken>& out, int depth) {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const ViewToken& token = tokens[i];
        const auto found = token.kind == TokenKind::word ? macros_.find(token.text) : macros_.end();
        if (found == macros_.end() || depth > kDeepestExpansion || disabled_.contains(token.text) ||
            ++steps_ > kMostSteps) {
            // Arguments are copied for each use of their parameter, so what they hold counts, too.
            if (depth > 0) ++steps_;
            out.push_back(token);
            continue;
        }
        const Macro& macro = found->second;
        std::vector<std::span<const ViewToken>> arguments;
        std::size_t next = i + 1;
        if (macro.takesArguments) {
            if (next >= tokens.size() || tokens[next].text != "(") {
                out.push_back(token);
                continue;
            }
            next = splitArguments(tokens, next, arguments);
            if (next > tokens.size()) {
                out.push_back(token);
                continue;
            }
        }
        const std::vector<ViewToken> text = substitute(macro, arguments, token, depth);
        const std::string name(token.text);
        disabled_.insert(name);
        expandInto(text, out, depth + 1);
        disabled_.erase(name);
        i = next - 1;
    }
}

namespace {

/// Precedence climbing over C's integer operators.
class ConditionParser {
  public:
    explicit ConditionParser(std::span<const ViewToken> tokens) : tokens_(tokens) {}

    bool run(long long& value) {
        value = binary(0);
        return good_ && at_ == tokens_.size();
    }

  private:
    struct Operator {
        std::string_view text;
        int level;
    };
    static constexpr Operator kOperators[] = {
        {"||", 1}, {"&&", 2}, {"|", 3},  {"^", 4},  {"&", 5}, {"==", 6}, {"!=", 6}, {"<", 7},  {">", 7},
        {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};

    [[nodiscard]] std::string_view peek() const { return at_ < tokens_.size() ? tokens_[at_].text : ""; }

    long long fail() {
        good_ = false;
        at_ = tokens_.size();
        return 0;
    }

    long long binary(int lowest) {
        if (++depth_ > 200) return fail();
        long long left = unary();
        while (good_ && at_ < tokens_.size()) {
            const auto* const found = std::find_if(std::begin(kOperators), std::end(kOperators),
                                                   [&](const Operator& each) { return each.text == peek(); });
            if (found == std::end(kOperators) || found->level <= lowest) break;
            ++at_;
            left = apply(found->text, left, binary(found->level));
        }
        --depth_;
        return left;
    }

    long long apply(std::string_view op, long long a, long long b) {
        const auto x = static_cast<unsigned long long>(a);
        const auto y = static_cast<unsigned long long>(b);
        if (op == "||") return (a != 0 || b != 0) ? 1 : 0;
        if (op == "&&") return (a != 0 && b != 0) ? 1 : 0;
        if (op == "|") return static_cast<long long>(x | y);
        if (op == "^") return static_cast<long long>(x ^ y);
        if (op == "&") return static_cast<long long>(x & y);
        if (op == "==") return a == b ? 1 : 0;
        if (op == "!=") return a != b ? 1 : 0;
        if (op == "<") return a < b ? 1 : 0;
        if (op == ">") return a > b ? 1 : 0;
        if (op == "<=") return a <= b ? 1 : 0;
        if (op == ">=") return a >= b ? 1 : 0;
        if (op == "<<") return static_cast<long long>(x << (y & 63));
        if (op == ">>") return a >> (y & 63);
        if (op == "+") return static_cast<long long>(x + y);
        if (op == "-") return static_cast<long long>(x - y);
        if (op == "*") return static_cast<long long>(x * y);
        if (b == 0 || b == -1) return b == 0 ? fail() : (op == "/" ? static_cast<long long>(0 - x) : 0);
        return op == "/" ? a / b : a % b;
    }

    long long unary() {
        if (++depth_ > 200 || at_ >= tokens_.size()) return fail();
        const ViewToken& token = tokens_[at_++];
        long long value = 0;
        if (token.text == "!")
            value = unary() == 0 ? 1 : 0;
        else if (token.text == "-")
            value = static_cast<long long>(0 - static_cast<unsigned long long>(unary()));
        else if (token.text == "+")
            value = unary();
        else if (token.text == "~")
            value = ~unary();
        else if (token.text == "(") {
            value = binary(0);
            if (peek() != ")") return fail();
            ++at_;
        } else if (token.kind == TokenKind::number)
            value = number(token.text);
        else if (token.kind != TokenKind::word)
            return fail();
        --depth_;
        return value;
    }

    static long long number(std::string_view text) {
        unsigned long long value = 0;
        const bool hex = text.starts_with("0x") || text.starts_with("0X");
        const unsigned base = hex ? 16 : (text.starts_with("0") ? 8 : 10);
        for (const char c : text.substr(hex ? 2 : 0)) {
            unsigned digit = 99;
            if (c >= '0' && c <= '9') digit = static_cast<unsigned>(c - '0');
            if (c >= 'a' && c <= 'f') digit = static_cast<unsigned>(c - 'a') + 10;
            if (c >= 'A' && c <= 'F') digit = static_cast<unsigned>(c - 'A') + 10;
            if (digit >= base) break;
            value = value * base + digit;
        }
        return static_cast<long long>(value);
    }

    std::span<const ViewToken> tokens_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool good_ = true;
};

}  // namespace

bool evaluateCondition(std::span<const ViewToken> tokens, long long& value) {
    return ConditionParser(tokens).run(value);
}

}  // namespace glibra::glsl
