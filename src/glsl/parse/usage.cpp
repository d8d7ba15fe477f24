#include "glsl/parse/usage.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "glsl/read/preprocessor.h"

namespace glibra::glsl {
namespace {

/// Built-in functions that write to arguments. Bit i stands for argument i.
struct Output {
    std::string_view function;
    unsigned arguments;
};
constexpr std::array kWritingFunctions = std::to_array<Output>({{"modf", 2},
                                                                {"frexp", 2},
                                                                {"uaddCarry", 4},
                                                                {"usubBorrow", 4},
                                                                {"umulExtended", 12},
                                                                {"imulExtended", 12}});

void addDeclared(Unit& unit, const Declaration& declaration) {
    const auto add = [&](std::uint32_t at) {
        if (at != kNone) unit.declared.emplace(unit.text(at), at);
    };
    add(declaration.name);
    if (declaration.kind == DeclarationKind::requalify) return;
    for (const Declarator& each : declaration.declarators) add(each.name);
    if (declaration.kind == DeclarationKind::block && declaration.declarators.empty())
        for (const Declaration& member : declaration.members)
            for (const Declarator& each : member.declarators) add(each.name);
}

/// The arguments that each function writes in any of its overloads, as bits, by its name.
std::map<std::string_view, unsigned> outputArguments(const Unit& unit) {
    std::map<std::string_view, unsigned> result;
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::function && each.kind != DeclarationKind::prototype) continue;
        unsigned bits = 0;
        for (std::size_t i = 0; i < each.parameters.size() && i < 31; ++i) {
            const Storage storage = each.parameters[i].qualifiers.storage;
            if (storage == Storage::output || storage == Storage::inputOutput) bits |= 1U << i;
        }
        result[unit.text(each.name)] |= bits;
    }
    for (const Output& each : kWritingFunctions) result.emplace(each.function, each.arguments);
    return result;
}

/// True for whole numbers and operators.
bool isLiteral(std::span<const ViewToken> tokens) {
    return std::ranges::all_of(tokens, [](const ViewToken& token) {
        return token.kind == TokenKind::punctuator ||
               (token.kind == TokenKind::number && token.text.find('.') == std::string_view::npos);
    });
}

}  // namespace

unsigned builtinOutputs(std::string_view function) {
    const auto* const found = std::ranges::find_if(
        kWritingFunctions, [&](const Output& each) { return each.function == function; });
    return found == kWritingFunctions.end() ? 0U : found->arguments;
}

bool isIdle(const Unit& unit, Range range) {
    for (std::uint32_t i = range.first; i < range.end; ++i) {
        const std::string_view text = unit.text(i);
        const bool isCall =
            unit.view[i].kind == TokenKind::word && unit.text(i + 1) == "(" && !isTypeWord(text);
        if (isAssignment(text) || isStep(text) || isCall) return false;
    }
    return true;
}

std::set<std::string_view> functionsThatWriteArguments(const Unit& unit) {
    std::set<std::string_view> functions;
    for (const auto& [name, arguments] : outputArguments(unit))
        if (arguments != 0) functions.insert(name);
    return functions;
}

std::uint32_t afterSuffixes(const Unit& unit, std::uint32_t at) {
    const auto end = static_cast<std::uint32_t>(unit.view.size());
    ++at;
    while (at < end) {
        if (unit.text(at) == "[")
            at = std::min(unit.bodies.matches[at], end - 1) + 1;
        else if (unit.text(at) == "." && at + 1 < end && unit.view[at + 1].kind == TokenKind::word)
            at += 2;
        else
            break;
    }
    return at;
}

bool integerValue(const Unit& unit, Range range, long long& value) {
    if (range.empty() || range.end > unit.view.size()) return false;
    const std::span<const ViewToken> tokens(unit.view.data() + range.first, range.end - range.first);
    return isLiteral(tokens) && evaluateCondition(tokens, value);
}

namespace {

constexpr int kMostNestedConstants = 16;
constexpr std::size_t kMostConstantTokens = 500;

bool addConstant(const Unit& unit, Range range, std::vector<ViewToken>& to, int depth);

/// Adds the value of a constant of the outermost scope, in parentheses.
bool addNamed(const Unit& unit, std::string_view name, std::vector<ViewToken>& to, int depth) {
    const Variable* found = unit.firstVariable(name);
    if (found == nullptr || found->storage != Storage::constant || found->isArray() ||
        (found->type != "int" && found->type != "uint") || depth >= kMostNestedConstants)
        return false;
    to.push_back({"(", 0, TokenKind::punctuator});
    const Range value =
        unit.syntax.declarations[found->declaration].declarators[found->declarator].initializer;
    if (value.empty() || !addConstant(unit, value, to, depth + 1)) return false;
    to.push_back({")", 0, TokenKind::punctuator});
    return true;
}

/// Adds the tokens of an expression, with the values of constants in place of their names; false if it is not
/// made of whole numbers and constants.
bool addConstant(const Unit& unit, Range range, std::vector<ViewToken>& to, int depth) {
    for (std::uint32_t at = range.first; at < range.end; ++at) {
        const ViewToken& token = unit.view[at];
        if (to.size() >= kMostConstantTokens) return false;
        const bool isCast = (token.text == "int" || token.text == "uint") && unit.text(at + 1) == "(";
        if (token.kind == TokenKind::word) {
            if (!isCast && !addNamed(unit, token.text, to, depth)) return false;
        } else {
            if (!isLiteral(std::span(&token, 1))) return false;
            to.push_back(token);
        }
    }
    return true;
}

}  // namespace

bool globalIntegerValue(const Unit& unit, Range range, long long& value) {
    std::vector<ViewToken> tokens;
    return !range.empty() && range.end <= unit.view.size() && addConstant(unit, range, tokens, 0) &&
           evaluateCondition(tokens, value);
}

std::string sizeText(const Unit& unit, Range range) {
    long long value = 0;
    return globalIntegerValue(unit, range, value) ? std::to_string(value) : textOf(unit, range);
}

int constantIndex(const Unit& unit, std::uint32_t openBracket) {
    if (unit.text(openBracket) != "[") return -1;
    long long value = 0;
    const std::uint32_t close = unit.bodies.matches[openBracket];
    if (!integerValue(unit, {openBracket + 1, close}, value) || value < 0 || value > 1000) return -1;
    return static_cast<int>(value);
}

bool isWrittenAt(const Unit& unit, std::uint32_t at) {
    std::uint32_t first = at;
    std::uint32_t after = afterSuffixes(unit, at);
    while (true) {
        const std::string_view before = first > 0 ? unit.text(first - 1) : std::string_view{};
        if (isStep(before)) return true;
        if (isAssignment(unit.text(after)) || isStep(unit.text(after))) return true;
        // `(name).xy = ...` is a change; `if (name) ++other` is none.
        const bool wrapped = before == "(" && unit.text(after) == ")" && first > 1 &&
                             unit.view[first - 2].kind != TokenKind::word && unit.text(first - 2) != "]";
        if (!wrapped) return false;
        --first;
        after = afterSuffixes(unit, after);
    }
}

void findUsage(Unit& unit) {
    for (const Declaration& each : unit.syntax.declarations) addDeclared(unit, each);
    const std::map<std::string_view, unsigned> outputs = outputArguments(unit);
    std::vector<bool> isOutput(unit.view.size(), false);
    for (const Call& each : unit.bodies.calls) {
        const auto output = outputs.find(unit.text(each.name));
        if (output == outputs.end() || unit.bodies.roles[each.name] != WordRole::global) continue;
        for (std::size_t i = 0; i < each.arguments.size() && i < 31; ++i) {
            std::uint32_t at = each.arguments[i].first;
            while (unit.text(at) == "(") ++at;
            if (at < isOutput.size() && (output->second >> i & 1U) != 0) isOutput[at] = true;
        }
    }
    for (std::uint32_t i = 0; i < unit.view.size(); ++i) {
        if (unit.bodies.roles[i] != WordRole::global) continue;
        const std::string name(unit.text(i));
        unit.uses[name].push_back(i);
        if (isOutput[i] || isWrittenAt(unit, i)) unit.writes[name].push_back(i);
    }
}

std::optional<Range> bodyOfMain(const Unit& unit) {
    const Declaration* main = nullptr;
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::function || unit.text(each.name) != "main") continue;
        if (main != nullptr) return std::nullopt;
        main = &each;
    }
    return main != nullptr ? std::optional(main->body) : std::nullopt;
}

bool isAlwaysExecuted(const Unit& unit, Range body, std::uint32_t at) {
    if (!body.contains(at) || at == 0) return false;
    const std::string_view before = unit.text(at - 1);
    if (before != "{" && before != "}" && before != ";") return false;
    int depth = 0;
    for (std::uint32_t i = body.first; i < at; ++i) {
        const std::string_view text = unit.text(i);
        if (text == "return") return false;
        depth += text == "{" ? 1 : text == "}" ? -1 : 0;
    }
    return depth == 1;
}

bool isLiteralOne(std::string_view number) {
    return number == "1" || number == "1." || number == "1.0" || number == "1.f" || number == "1.0f";
}

Range conditionOf(const Unit& unit, const Node& loop, Range head) {
    if (loop.kind != NodeKind::forLoop) return head;
    std::uint32_t first = head.first + 1;
    while (first < head.end && unit.text(first) != ";") ++first;
    std::uint32_t last = first + 1;
    while (last < head.end && unit.text(last) != ";") ++last;
    return {first, std::min(last + 1, head.end)};
}

std::uint32_t beforeValue(const Unit& unit, Range condition) {
    const std::uint32_t before = condition.first;
    // There may be const before the type.
    for (std::uint32_t name = before + 2; name < std::min(before + 4, condition.end - 1); ++name)
        if (unit.bodies.roles[name] == WordRole::localDeclaration) return name + 1;
    return before;
}

}  // namespace glibra::glsl
