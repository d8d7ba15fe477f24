#include "glsl/read/condition.h"

#include <charconv>
#include <utility>

namespace glibra::glsl {
namespace {

constexpr int kDeepestCondition = 200;

/// Precedence climbing over C's integer operators, in 64 bits.
class ConditionParser {
  public:
    explicit ConditionParser(std::span<const Piece> pieces) : pieces_(pieces) {}

    Condition run() {
        result_.value = binary(0);
        if (isGood() && at_ < pieces_.size())
            fail(peek() == ")" ? "a ')' has no '('"
                               : "expected an operator before '" + std::string(peek()) + "'");
        return std::move(result_);
    }

  private:
    [[nodiscard]] bool isGood() const { return result_.error.empty(); }
    [[nodiscard]] std::string_view peek() const {
        return at_ < pieces_.size() ? pieces_[at_].token.text : std::string_view{};
    }

    long long fail(std::string error) {
        if (isGood()) {
            result_.error = std::move(error);
            result_.at = at_ < pieces_.size() ? &pieces_[at_] : nullptr;
        }
        at_ = pieces_.size();
        return 0;
    }

    long long binary(int lowest) {
        if (++depth_ > kDeepestCondition) return fail("more than 200 expressions inside each other");
        long long left = unary();
        while (isGood() && at_ < pieces_.size()) {
            const std::string_view op = peek();
            const int level = op == "^^" ? 0 : levelOf(op);  // the preprocessor has C's operators
            if (level <= lowest) break;
            ++at_;
            const bool isDecided = (op == "||" && left != 0) || (op == "&&" && left == 0);
            skipped_ += isDecided ? 1 : 0;
            const long long right = binary(level);
            skipped_ -= isDecided ? 1 : 0;
            left = apply(op, left, right);
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
        if (b == 0) return skipped_ > 0 ? 0 : fail("division by 0");
        if (b == -1) return op == "/" ? static_cast<long long>(0 - x) : 0;
        return op == "/" ? a / b : a % b;
    }

    long long unary() {
        if (++depth_ > kDeepestCondition) return fail("more than 200 expressions inside each other");
        if (at_ >= pieces_.size())
            return fail(pieces_.empty() ? "the condition is missing" : "a value is missing at the end");
        const Piece& piece = pieces_[at_++];
        const std::string_view text = piece.token.text;
        long long value = 0;
        if (text == "!") {
            value = unary() == 0 ? 1 : 0;
        } else if (text == "-") {
            value = static_cast<long long>(0 - static_cast<unsigned long long>(unary()));
        } else if (text == "+") {
            value = unary();
        } else if (text == "~") {
            value = ~unary();
        } else if (text == "(") {
            value = binary(0);
            if (peek() != ")") return fail("a ')' is missing");
            ++at_;
        } else if (piece.token.kind == TokenKind::word) {
            if (!result_.unknown && skipped_ == 0) result_.unknown = &piece;
        } else if (piece.token.kind != TokenKind::number || !readInteger(text, value)) {
            --at_;
            return fail(piece.token.kind == TokenKind::number
                            ? "'" + std::string(text) + "' is no whole number"
                            : "expected a value before '" + std::string(text) + "'");
        }
        --depth_;
        return value;
    }

    std::span<const Piece> pieces_;
    Condition result_;
    std::size_t at_ = 0;
    int depth_ = 0;
    int skipped_ = 0;  ///< more than 0 inside operands that are not needed
};

template <class... Base>
std::optional<double> parsed(std::string_view text, auto value, Base... base) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value, base...);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return static_cast<double>(value);
}

}  // namespace

Condition evaluateCondition(std::span<const Piece> pieces) {
    return ConditionParser(pieces).run();
}

bool evaluateCondition(std::span<const ViewToken> tokens, long long& value) {
    std::vector<Piece> pieces(tokens.size());
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        pieces[i].token.text = tokens[i].text;
        pieces[i].token.kind = tokens[i].kind;
    }
    const Condition found = evaluateCondition(pieces);
    value = found.value;
    return found.error.empty();
}

int levelOf(std::string_view op) {
    struct Operator {
        std::string_view text;
        int level;
    };
    static constexpr Operator kOperators[] = {{"||", 1}, {"^^", 2}, {"&&", 3}, {"|", 4},  {"^", 5},
                                              {"&", 6},  {"==", 7}, {"!=", 7}, {"<", 8},  {">", 8},
                                              {"<=", 8}, {">=", 8}, {"<<", 9}, {">>", 9}, {"+", 10},
                                              {"-", 10}, {"*", 11}, {"/", 11}, {"%", 11}};
    for (const Operator& each : kOperators)
        if (each.text == op) return each.level;
    return 0;
}

bool readInteger(std::string_view text, long long& value) {
    const bool isHexadecimal = text.starts_with("0x") || text.starts_with("0X");
    const unsigned base = isHexadecimal ? 16 : (text.starts_with("0") ? 8 : 10);
    std::string_view digits = text.substr(isHexadecimal ? 2 : 0);
    if (digits.ends_with("u") || digits.ends_with("U")) digits.remove_suffix(1);
    if (digits.empty()) return false;
    unsigned long long number = 0;
    for (const char c : digits) {
        unsigned digit = base;
        if (c >= '0' && c <= '9') digit = static_cast<unsigned>(c - '0');
        if (c >= 'a' && c <= 'f') digit = static_cast<unsigned>(c - 'a') + 10;
        if (c >= 'A' && c <= 'F') digit = static_cast<unsigned>(c - 'A') + 10;
        if (digit >= base) return false;
        number = number * base + digit;
    }
    value = static_cast<long long>(number);
    return true;
}

std::optional<double> numberValue(std::string_view text) {
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    while (!text.empty() && std::string_view(isHex ? "uU" : "uUfFlL").find(text.back()) != text.npos)
        text.remove_suffix(1);
    return isHex ? parsed(text.substr(2), 0ULL, 16) : parsed(text, 0.);
}

}  // namespace glibra::glsl
