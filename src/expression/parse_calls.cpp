#include <fmt/format.h>

#include <utility>

#include "base/suggest.h"
#include "expression/constructors.h"
#include "expression/parser.h"

namespace glibra::expression {
namespace {

constexpr std::size_t kMostArguments = 16;

}  // namespace

Parser::Parsed Parser::call(const Token& function) {
    const std::span<const FunctionRow> forms = functionsNamed(function.text);
    if (forms.empty()) return unknownFunction(function);
    const bool takesAll = forms.front().takesAll;
    build_.unchecked += takesAll ? 1 : 0;
    const auto arguments = argumentList(function);
    build_.unchecked -= takesAll ? 1 : 0;
    if (!arguments) return std::nullopt;
    const Range range = since(function.range.begin);
    std::vector<Type> types;
    for (const Operand& each : *arguments) types.push_back(each.type);
    if (forms.front().apply == nullptr) {
        Construction made = construct(function.text, types);
        if (made.id != nullptr) return problem(range, made.id, std::move(made.why));
        return build_.combined(*arguments, made.call.instruction, made.call.result, range);
    }
    for (const FunctionRow& form : forms) {
        const auto found = callOf(form, types);
        if (!found) continue;
        if (!form.readsTime) return build_.combined(*arguments, found->instruction, found->result, range);
        return moving(*arguments, *found, function, range);
    }
    return noSuchForm(forms, types, range);
}

Parser::Parsed Parser::moving(std::vector<Operand> arguments, const Call& call, const Token& function,
                              Range range) {
    const auto time = names_.find("time");
    if (!time || !time->type.isNumber() || time->count > 0)
        return problem(range, "expr-E07",
                       fmt::format("{} needs 'time', which has no value here", function.text));
    const Parsed now = loaded("time", *time, std::nullopt, range);
    if (!now) return std::nullopt;
    arguments.push_back(*now);
    return build_.combined(arguments, call.instruction, call.result, range);
}

std::nullopt_t Parser::unknownFunction(const Token& function) {
    if (names_.find(function.text))
        return problem(function.range, "expr-E08",
                       fmt::format("'{}' is a value, not a function; write '*' to multiply", function.text));
    std::vector<std::string_view> candidates;
    for (const FunctionRow& each : functionTable())
        if (candidates.empty() || candidates.back() != each.name()) candidates.push_back(each.name());
    return problem(function.range, "expr-E02",
                   fmt::format("unknown function {}{}", quoted(code_.text, function.range),
                               base::suggestion(function.text, candidates)));
}

std::nullopt_t Parser::noSuchForm(std::span<const FunctionRow> forms, std::span<const Type> types,
                                  Range range) {
    std::vector<std::string> prototypes, counts;
    for (const FunctionRow& each : forms) {
        const std::size_t count = parameterCount(each);
        if (count == types.size()) prototypes.emplace_back(each.prototype);
        const std::string number = std::to_string(count);
        if (counts.empty() || counts.back() != number) counts.push_back(number);
    }
    if (prototypes.empty())
        return problem(range, "expr-E04",
                       fmt::format("{} takes {} argument{}, found {}", forms.front().name(),
                                   joined(counts, " or "), counts.back() == "1" ? "" : "s", types.size()));
    std::vector<std::string> names;
    for (const Type& each : types) names.push_back(name(each));
    return problem(range, "expr-E03",
                   fmt::format("there is no {}({}), only {}", forms.front().name(), joined(names, ", "),
                               joined(prototypes, " and ")));
}

std::optional<std::vector<Operand>> Parser::argumentList(const Token& function) {
    const Level level(*this);
    if (depth_ > limits_.depth) return tooDeep();
    std::vector<Operand> arguments;
    take();  // the parenthesis
    if (takeIf(")"))
        return problem(since(function.range.begin), "expr-E04",
                       fmt::format("{} needs arguments, found none", function.text));
    do {
        const Parsed argument = expression();
        if (!argument || !settle(*argument)) return std::nullopt;
        arguments.push_back(*argument);
        if (arguments.size() > kMostArguments)
            return problem(since(function.range.begin), "expr-E04",
                           fmt::format("{} has more than {} arguments", function.text, kMostArguments));
    } while (takeIf(","));
    if (!takeIf(")")) return unexpected("',' or ')'");
    return arguments;
}

}  // namespace glibra::expression
