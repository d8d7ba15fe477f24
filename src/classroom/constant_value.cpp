#include "classroom/constant_value.h"

#include <cmath>
#include <limits>
#include <ranges>
#include <set>

#include "glsl/read/preprocessor.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

using Value = std::optional<double>;

/// A value that every type has exactly, so that nothing rounds or overflows it; nothing for others.
Value exact(double value) {
    constexpr double kMost = 1 << 24;
    const bool isTiny = value != 0 && std::abs(value) < std::numeric_limits<float>::min();
    if (!(std::abs(value) <= kMost) || isTiny || static_cast<double>(static_cast<float>(value)) != value)
        return std::nullopt;
    return value;
}

Value numberOf(std::string_view text) {
    const Value value = glsl::numberValue(text);
    const bool isDouble = text.find_first_of("lL") != std::string_view::npos;
    return value ? exact(isDouble ? *value : static_cast<double>(static_cast<float>(*value))) : value;
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
    if (op == "+") return exact(*a + *b);
    if (op == "-" && *a >= *b) return exact(*a - *b);  // without a sign, others are large
    if (op == "*") return exact(*a * *b);
    // Whole numbers are divided in another way; the text does not show which these are.
    return std::nullopt;
}

bool changes(std::string_view text) {
    return glsl::isAssignment(text) || glsl::isStep(text) || text == "[" || text == ".";
}

}  // namespace

Value constantValue(const CodeTree& tree, std::uint32_t expression, const KnownValues& known,
                    const OwnFunctions& own) {
    using enum glsl::NodeKind;
    const glsl::Node& it = tree.node(expression);
    const std::string_view text = it.kind == number || it.kind == name ? tree.text(expression) : "";
    if (it.kind == number) return numberOf(text);
    if (it.kind == group) return constantValue(tree, it.child, known, own);
    if (it.kind == name) {
        if (text == "true" || text == "false") return text == "true" ? 1 : 0;
        const auto found = known.find(text);
        return found == known.end() ? std::nullopt : Value(found->second);
    }
    if (it.kind == prefix) {
        Value value = constantValue(tree, it.child, known, own);
        const std::span<const CodeToken> signs =
            tree.code(expression).first(tree.node(it.child).first - it.first);
        const bool isSigned =
            tree.is(it.child, number) && tree.text(it.child).find_first_of("uU") == std::string_view::npos;
        for (const CodeToken& each : signs | std::views::reverse) {
            if (!value || (each.text != "!" && each.text != "-" && each.text != "+")) return std::nullopt;
            if (each.text == "!") value = *value == 0 ? 1 : 0;
            if (each.text == "-" && !isSigned) return std::nullopt;
            if (each.text == "-") value = -*value;
        }
        return value;
    }
    if (it.kind != chain) return std::nullopt;
    Value value = constantValue(tree, it.child, known, own);
    for (std::uint32_t each = tree.node(it.child).next; each != glsl::kNone; each = tree.node(each).next) {
        const bool isOpen = !value;
        value = applied(tree.before(each), value, constantValue(tree, each, known, own));
        if (isOpen && value && hasEffect(tree.code(expression).first(tree.node(each).first - it.first), own))
            return std::nullopt;
    }
    return value;
}

KnownValues knownValues(const CodeTree& tree, std::span<const CodeToken> code, const OwnFunctions& own) {
    static const std::set<std::string_view> kTypes{"bool", "int", "uint", "float"};
    const auto text = [&](std::size_t i) { return i < code.size() ? code[i].text : std::string_view{}; };
    std::set<std::string_view> declared, repeated, constant, changed;
    for (std::size_t i = 1; i < code.size(); ++i) {
        if (!code[i].isWord) continue;
        const std::string_view name = code[i].text;
        std::size_t first = i, last = i;  // with the parentheses around it: (a) = b
        while (first > 1 && text(first - 1) == "(" && text(last + 1) == ")" && !code[first - 2].isWord) {
            --first;
            ++last;
        }
        const std::string_view before = text(first - 1), after = text(last + 1);
        if (code[i - 1].isWord && before != "return" && before != "else") {
            if (!declared.insert(name).second) repeated.insert(name);
            if (i > 1 && text(i - 2) == "const") constant.insert(name);
            continue;
        }
        // A function may change its argument.
        const bool isArgument = before == "," || (before == "(" && first > 1 && code[first - 2].isWord &&
                                                  text(first - 2) != "if" && text(first - 2) != "while" &&
                                                  text(first - 2) != "for" && text(first - 2) != "return");
        if (isArgument || changes(after) || before == "++" || before == "--") changed.insert(name);
    }
    KnownValues known;
    for (const auto& [at, expression] : tree.initializers()) {
        const std::string_view name = code[at].text;
        if (!kTypes.contains(text(at - 1)) || text(at + 1) != "=" || repeated.contains(name) ||
            (changed.contains(name) && !constant.contains(name)))
            continue;
        if (const Value value = constantValue(tree, expression, known, own)) known[name] = *value;
    }
    return known;
}

}  // namespace glibra::classroom
