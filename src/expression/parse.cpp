#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "expression/parser.h"

namespace glibra::expression {

std::string_view article(std::string_view noun) {
    return std::string_view("aeiou").find(noun.empty() ? 'x' : noun.front()) == std::string_view::npos ? "a"
                                                                                                       : "an";
}

std::string joined(std::span<const std::string> words, std::string_view last) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (k > 0) text += k + 1 == words.size() ? last : std::string_view(", ");
        text += words[k];
    }
    return text;
}

std::optional<Problem> Parser::parse() {
    if (token_.kind == TokenKind::end) {
        problem({0, static_cast<std::uint32_t>(code_.text.size())}, "expr-E01", "the expression is empty");
        return std::move(problem_);
    }
    if (auto result = expression(); result && !problem_) {
        if (token_.kind != TokenKind::end)
            unexpected("an operator or the end of the expression");
        else
            finish(*result);
    }
    return std::move(problem_);
}

std::nullopt_t Parser::problem(Range range, const char* id, std::string text) {
    if (!problem_) problem_ = problemAt(code_, range, id, std::move(text));
    return std::nullopt;
}

std::nullopt_t Parser::unexpected(std::string_view expected) {
    if (token_.kind == TokenKind::wrong)
        return problem(token_.range, "expr-E01",
                       fmt::format("{}: {}", quoted(code_.text, token_.range), token_.why));
    return problem(token_.range, "expr-E01",
                   fmt::format("expected {}, found {}", expected,
                               token_.kind == TokenKind::end ? std::string("the end of the expression")
                                                             : quoted(code_.text, token_.range)));
}

std::nullopt_t Parser::tooDeep() {
    return problem(token_.range, "expr-E05",
                   fmt::format("more than {} levels of parentheses, signs or conditions", limits_.depth));
}

Parser::Parsed Parser::withinLimits(Parsed operand) {
    if (operand && !build_.isWithinLimits())
        return problem({0, static_cast<std::uint32_t>(code_.text.size())}, "expr-E05",
                       "the expression is too long, or holds too many values at once");
    return operand;
}

void Parser::take() {
    lastEnd_ = token_.range.end;
    token_ = lexer_.next();
}

bool Parser::takeIf(std::string_view sign) {
    if (!token_.is(sign)) return false;
    take();
    return true;
}

Range Parser::since(std::uint32_t begin) const {
    return {begin, lastEnd_};
}

std::string_view Parser::textOf(Range range) const {
    return std::string_view(code_.text).substr(range.begin, range.end - range.begin);
}

bool Parser::wants(const Type& type) const {
    return std::ranges::find(wanted_.types, type) != wanted_.types.end();
}

void Parser::finish(Operand result) {
    if (!settle(result)) return;
    if (result.choice && wants(Type::word()) && !wants(Type::number())) wordOfChoice(result);
    const bool accepted = wanted_.types.empty() ? result.type.kind != Kind::word : wants(result.type);
    if (!accepted && !problem_) {
        std::vector<std::string> accepts;
        for (const Type& each : wanted_.types)
            if (each == Type::word())
                accepts.insert(accepts.end(), wanted_.words.begin(), wanted_.words.end());
            else
                accepts.push_back(name(each));
        if (accepts.empty()) accepts.emplace_back("number");
        problem(result.range, "expr-E03",
                fmt::format("expected {}, found {}", joined(accepts, " or "), name(result.type)));
    }
    if (problem_) return;
    code_.type = result.type;
    build_.finishUses();
    code_.instructions.shrink_to_fit();
    code_.ranges.shrink_to_fit();
}

void Parser::wordOfChoice(Operand& result) {
    std::vector<double> places;
    for (const std::string& each : code_.uses[*result.choice].symbol.words) {
        const auto found = std::ranges::find(wanted_.words, each);
        if (found == wanted_.words.end()) {
            problem(result.range, "expr-E03",
                    fmt::format("{} may be '{}'; expected {}", code_.uses[*result.choice].path, each,
                                joined(std::vector<std::string>(wanted_.words.begin(), wanted_.words.end()),
                                       " or ")));
            return;
        }
        places.push_back(static_cast<double>(found - wanted_.words.begin()));
    }
    Instruction word;
    word.op = Op::word;
    word.target = static_cast<std::uint32_t>(code_.constants.size());
    word.b = static_cast<std::uint8_t>(places.size());
    code_.constants.insert(code_.constants.end(), places.begin(), places.end());
    build_.emit(word, result.range, 1, 1);
    result.type = Type::word();
}

Checked<Expression> parse(std::string_view text, const Place& origin, const Names& names,
                          const Wanted& wanted, const Limits& limits) {
    auto code = std::make_shared<Code>();
    code->origin = origin;
    if (text.size() > limits.bytes)
        return problemAt(*code, {}, "expr-E05",
                         fmt::format("expression of {} bytes; the limit is {}", text.size(), limits.bytes));
    code->text = text;
    if (auto problem = Parser(*code, names, wanted, limits).parse()) return std::move(*problem);
    return Expression(std::move(code));
}

}  // namespace glibra::expression
