#include "classroom/constant_value.h"

#include <charconv>
#include <cmath>
#include <set>
#include <vector>

#include "glsl/parse/usage.h"
#include "glsl/read/condition.h"

namespace glibra::classroom {
namespace {

using Value = std::optional<double>;

constexpr int kDeepestOperation = 1'000;

Value numberOf(std::string_view text) {
    double value = 0;
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    const char* const end = text.data() + text.size();
    std::from_chars_result read{};
    if (isHex) {
        unsigned long long bits = 0;
        read = std::from_chars(text.data() + 2, end, bits, 16);
        value = static_cast<double>(bits);
    } else {
        read = std::from_chars(text.data(), end, value);
    }
    const std::string_view rest(read.ptr, static_cast<std::size_t>(end - read.ptr));
    if (read.ec != std::errc() || rest.find_first_not_of("uUfFlL") != std::string_view::npos)
        return std::nullopt;
    return value;
}

Value applied(std::string_view op, const Value& a, const Value& b) {
    const auto is = [](const Value& one, bool truth) { return one && (*one != 0) == truth; };
    if (op == "&&" && (is(a, false) || is(b, false))) return 0;
    if (op == "||" && (is(a, true) || is(b, true))) return 1;
    if (!a || !b) return std::nullopt;
    if (op == "&&" || op == "||") return is(a, true) && is(b, true) ? 1 : 0;
    if (op == "^^") return is(a, true) != is(b, true) ? 1 : 0;
    if (op == "==") return *a == *b ? 1 : 0;
    if (op == "!=") return *a != *b ? 1 : 0;
    if (op == "<") return *a < *b ? 1 : 0;
    if (op == ">") return *a > *b ? 1 : 0;
    if (op == "<=") return *a <= *b ? 1 : 0;
    if (op == ">=") return *a >= *b ? 1 : 0;
    if (op == "+") return *a + *b;
    if (op == "-") return *a - *b;
    if (op == "*") return *a * *b;
    // Whole numbers are divided in another way; the text does not show which these are.
    return std::nullopt;
}

class Evaluation {
  public:
    Evaluation(std::span<const CodeToken> code, const KnownValues& known) : code_(code), known_(known) {}

    Value run() {
        const Value value = operation(1);
        return at_ == code_.size() ? value : std::nullopt;
    }

  private:
    [[nodiscard]] std::string_view text() const {
        return at_ < code_.size() ? code_[at_].text : std::string_view{};
    }
    bool accept(std::string_view wanted) {
        if (text() != wanted || wanted.empty()) return false;
        ++at_;
        return true;
    }

    Value operation(int least) {
        Value value = operand();
        for (int strength = glsl::levelOf(text()); strength >= least; strength = glsl::levelOf(text())) {
            const std::string_view op = text();
            ++at_;
            value = applied(op, value, operation(strength + 1));
        }
        return value;
    }

    Value operand() {
        if (++depth_ > kDeepestOperation) return failed();
        const Value value = innerOperand();
        --depth_;
        return value;
    }

    Value innerOperand() {
        if (accept("!")) {
            const Value value = operand();
            return value ? Value(*value == 0 ? 1 : 0) : std::nullopt;
        }
        if (accept("-")) {
            const Value value = operand();
            return value ? Value(-*value) : std::nullopt;
        }
        if (accept("+")) return operand();
        if (accept("(")) {
            const Value value = operation(1);
            return accept(")") ? value : failed();
        }
        if (at_ >= code_.size()) return failed();
        const CodeToken& token = code_[at_++];
        if (token.isNumber) return numberOf(token.text);
        if (token.text == "true") return 1;
        if (token.text == "false") return 0;
        if (!token.isWord) return failed();
        if (text() == "(" || text() == "[" || text() == ".") {
            // What a function returns, and parts of a value, are not known.
            while (at_ < code_.size() && glsl::levelOf(text()) == 0 && text() != ")") skip();
            return std::nullopt;
        }
        const auto found = known_.find(token.text);
        return found == known_.end() ? std::nullopt : Value(found->second);
    }

    /// Goes on after a token, or after the bracket that ends what it opens.
    void skip() {
        int depth = 0;
        do {
            depth += text() == "(" || text() == "[" ? 1 : text() == ")" || text() == "]" ? -1 : 0;
            ++at_;
        } while (depth > 0 && at_ < code_.size());
    }

    Value failed() {
        at_ = code_.size() + 1;
        return std::nullopt;
    }

    std::span<const CodeToken> code_;
    const KnownValues& known_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

bool changes(std::string_view text) {
    return glsl::isAssignment(text) || glsl::isStep(text) || text == "[" || text == ".";
}

}  // namespace

std::optional<double> constantValue(std::span<const CodeToken> expression, const KnownValues& known) {
    return Evaluation(expression, known).run();
}

KnownValues knownValues(std::span<const CodeToken> code) {
    static const std::set<std::string_view> kTypes{"bool", "int", "uint", "float"};
    const auto text = [&](std::size_t i) { return i < code.size() ? code[i].text : std::string_view{}; };
    std::set<std::string_view> declared, repeated, constant, changed;
    std::vector<std::size_t> initialized;  // names before their "="
    for (std::size_t i = 1; i < code.size(); ++i) {
        if (!code[i].isWord) continue;
        const std::string_view name = code[i].text, before = text(i - 1), after = text(i + 1);
        if (code[i - 1].isWord && before != "return" && before != "else") {
            if (!declared.insert(name).second) repeated.insert(name);
            if (i > 1 && text(i - 2) == "const") constant.insert(name);
            if (kTypes.contains(before) && after == "=") initialized.push_back(i);
            continue;
        }
        // A function may change its argument.
        const bool isArgument =
            before == "," || (before == "(" && i > 1 && code[i - 2].isWord && text(i - 2) != "if" &&
                              text(i - 2) != "while" && text(i - 2) != "for" && text(i - 2) != "return");
        if (isArgument || changes(after) || before == "++" || before == "--") changed.insert(name);
    }
    KnownValues known;
    for (const std::size_t each : initialized) {
        const std::string_view name = code[each].text;
        if (repeated.contains(name) || (changed.contains(name) && !constant.contains(name))) continue;
        std::size_t end = each + 2;
        while (end < code.size() && text(end) != ";" && text(end) != ",") ++end;
        if (const auto value = constantValue(code.subspan(each + 2, end - each - 2), known))
            known[name] = *value;
    }
    return known;
}

}  // namespace glibra::classroom
