#include "glsl/parse/usage.h"

#include <algorithm>
#include <array>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/condition.h"
#include "glsl/read/words.h"

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

bool globalIntegerValue(const Unit& unit, Range range, int depth, long long& value);

/// The value of a constant of the outermost scope as text; empty if it is not known or negative.
std::string constantText(const Unit& unit, std::string_view name, int depth) {
    const auto isConstant = [&](const Variable& each) {
        return each.storage == Storage::constant && each.name == name && !each.isArray();
    };
    const auto found = std::ranges::find_if(unit.variables, isConstant);
    if (found == unit.variables.end()) return {};
    const Declaration& declaration = unit.syntax.declarations[found->declaration];
    long long value = 0;
    const bool isKnown =
        globalIntegerValue(unit, declaration.declarators[found->declarator].initializer, depth + 1, value);
    return isKnown && value >= 0 ? std::to_string(value) : std::string{};
}

bool globalIntegerValue(const Unit& unit, Range range, int depth, long long& value) {
    if (range.empty() || range.end > unit.view.size() || depth > kMostNestedConstants) return false;
    std::vector<ViewToken> tokens(unit.view.begin() + range.first, unit.view.begin() + range.end);
    std::deque<std::string> constants;  // what the tokens point to
    for (ViewToken& each : tokens) {
        if (each.kind != TokenKind::word) continue;
        each.text = constants.emplace_back(constantText(unit, each.text, depth));
        if (each.text.empty()) return false;
        each.kind = TokenKind::number;
    }
    return isLiteral(tokens) && evaluateCondition(tokens, value);
}

}  // namespace

bool globalIntegerValue(const Unit& unit, Range range, long long& value) {
    return globalIntegerValue(unit, range, 0, value);
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
    for (std::uint32_t i = 0; i < unit.view.size(); ++i) {
        if (unit.bodies.roles[i] != WordRole::global) continue;
        const std::string name(unit.text(i));
        unit.uses[name].push_back(i);
        if (isWrittenAt(unit, i)) unit.writes[name].push_back(i);
        const auto output = outputs.find(unit.text(i));
        if (output == outputs.end() || output->second == 0 || unit.text(i + 1) != "(") continue;
        const std::uint32_t close =
            std::min<std::uint32_t>(unit.bodies.matches[i + 1], static_cast<std::uint32_t>(unit.view.size()));
        unsigned argument = 0;
        bool start = true;
        for (std::uint32_t k = i + 2; k < close; ++k) {
            const std::string_view text = unit.text(k);
            if (start && unit.bodies.roles[k] == WordRole::global && argument < 31 &&
                (output->second >> argument & 1U) != 0)
                unit.writes[std::string(text)].push_back(k);
            start = start && text == "(";
            if (text == ",") {
                ++argument;
                start = true;
            } else if ((text == "(" || text == "[") && unit.bodies.matches[k] < close && !start) {
                k = unit.bodies.matches[k];
            }
        }
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

}  // namespace glibra::glsl
