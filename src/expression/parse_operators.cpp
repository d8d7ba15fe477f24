#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/number.h"
#include "base/suggest.h"
#include "expression/apply.h"
#include "expression/functions.h"
#include "expression/measures.h"
#include "expression/parser.h"

namespace glibra::expression {
namespace {

// The operators of expressions, with GLSL's precedence and types.

/// The instruction for - ! ~ before a value.
std::optional<Call> operationOf(std::string_view sign, const Type& operand);

struct OperatorRow {
    std::string_view sign;
    int precedence;
    Op op;                  ///< of components, or of two numbers
    Apply apply = nullptr;  ///< in place of `op`, for two numbers
};

// The Khronos Group, The OpenGL Shading Language 4.60, section 5.1.
constexpr OperatorRow kOperators[] = {
    {"||", 1, Op::jumpKeepTrue},
    {"^^", 2, Op::logicalXor},
    {"&&", 3, Op::jumpKeepFalse},
    {"|", 4, Op::call, applyBitOr},
    {"^", 5, Op::call, applyBitXor},
    {"&", 6, Op::call, applyBitAnd},
    {"==", 7, Op::equal},
    {"!=", 7, Op::notEqual},
    {"<", 8, Op::less},
    {">", 8, Op::greater},
    {"<=", 8, Op::lessEqual},
    {">=", 8, Op::greaterEqual},
    {"<<", 9, Op::call, applyShiftLeft},
    {">>", 9, Op::call, applyShiftRight},
    {"+", 10, Op::add},
    {"-", 10, Op::subtract},
    {"*", 11, Op::multiply},
    {"/", 11, Op::divide},
    {"%", 11, Op::call, applyModulo},
};

const OperatorRow* rowOf(std::string_view sign) {
    const auto* const found =
        std::ranges::find_if(kOperators, [sign](const OperatorRow& row) { return row.sign == sign; });
    return found == std::end(kOperators) ? nullptr : found;
}

Call callWith(const Type& result, Op op, const Type& left, const Type& right, Apply apply = nullptr) {
    Call call{result, {}};
    call.instruction.op = op;
    call.instruction.apply = apply;
    call.instruction.n = static_cast<std::uint8_t>(result.size());
    call.instruction.a = static_cast<std::uint8_t>(left.size());
    call.instruction.b = static_cast<std::uint8_t>(right.size());
    return call;
}

/// Component by component; one number goes with all components.
std::optional<Call> componentwise(const OperatorRow& row, const Type& left, const Type& right) {
    if (left != right && !left.isNumber() && !right.isNumber()) return std::nullopt;
    return callWith(left.isNumber() ? right : left, row.op, left, right, row.apply);
}

/// The products of linear algebra, where one of the factors is a matrix.
std::optional<Call> product(const Type& left, const Type& right) {
    if (left.rows != right.rows) return std::nullopt;
    if (left.isMatrix() && right.isMatrix())
        return callWith(left, Op::call, left, right, applyMatrixTimesMatrix);
    if (left.isMatrix()) return callWith(right, Op::call, left, right, applyMatrixTimesVector);
    return callWith(left, Op::call, left, right, applyVectorTimesMatrix);
}

/// Precedence of an operator between two values: 1 for || up to 11 for * / %; 0 for other signs. Operators of
/// equal precedence are evaluated from left to right.
int precedenceOf(std::string_view sign) {
    const OperatorRow* row = rowOf(sign);
    return row == nullptr ? 0 : row->precedence;
}

/// The instruction for two values; nothing if the operator does not take their types. Not for && and ||.
std::optional<Call> operationOf(std::string_view sign, const Type& left, const Type& right) {
    const OperatorRow* row = rowOf(sign);
    if (row == nullptr) return std::nullopt;
    switch (row->op) {
        case Op::logicalXor:
            if (!left.isBoolean() || !right.isBoolean()) return std::nullopt;
            return callWith(Type::boolean(), row->op, left, right);
        case Op::equal:
        case Op::notEqual:
            if (left != right || left.kind == Kind::word) return std::nullopt;
            return callWith(Type::boolean(), row->op, left, right);
        case Op::less:
        case Op::greater:
        case Op::lessEqual:
        case Op::greaterEqual:
            if (!left.isNumber() || !right.isNumber()) return std::nullopt;
            return callWith(Type::boolean(), row->op, left, right);
        default:
            break;
    }
    if (!left.isNumeric() || !right.isNumeric()) return std::nullopt;
    if (row->apply == applyModulo)
        return left.isMatrix() || right.isMatrix() ? std::nullopt : componentwise(*row, left, right);
    if (row->apply != nullptr)
        return left.isNumber() && right.isNumber() ? componentwise(*row, left, right) : std::nullopt;
    const bool isLinear = (left.isMatrix() && !right.isNumber()) || (right.isMatrix() && !left.isNumber());
    if (row->op == Op::multiply && isLinear) return product(left, right);
    return componentwise(*row, left, right);
}

std::optional<Call> operationOf(std::string_view sign, const Type& operand) {
    if (sign == "!" && operand.isBoolean()) return callWith(operand, Op::logicalNot, operand, {});
    if (sign == "-" && operand.isNumeric()) return callWith(operand, Op::negate, operand, {});
    if (sign != "~" || !operand.isNumber()) return std::nullopt;
    Call call = callWith(operand, Op::call, operand, {}, applyBitNot);
    call.instruction.b = 0;
    return call;
}

}  // namespace

Parser::Parsed Parser::expression() {
    const Level level(*this);
    if (depth_ > limits_.depth) return tooDeep();
    Parsed condition = binary(1);
    if (!condition || !token_.is("?")) return condition;
    return conditional(*condition);
}

Parser::Parsed Parser::conditional(Operand condition) {
    if (!settle(condition)) return std::nullopt;
    if (!condition.type.isBoolean())
        return problem(condition.range, "expr-E03",
                       fmt::format("a condition is a bool, found {}", name(condition.type)));
    const Range mark = token_.range;
    take();
    // The branch that a constant condition never takes is read and then removed.
    const bool isKnown = condition.isConstant;
    const bool isTrue = isKnown && build_.valueOf(condition)[0] != 0;
    std::size_t toElse = 0, toEnd = 0;
    if (isKnown)
        build_.erase(condition.begin, build_.end(), 1);
    else
        toElse = build_.emitJump(Op::jumpIfFalse, mark, 1);
    Parsed yes = expression();
    if (!yes || !settle(*yes)) return std::nullopt;
    if (!token_.is(":")) return unexpected("':' and the value for the other case");
    const Range colon = token_.range;
    take();
    if (!isKnown) {
        toEnd = build_.emitJump(Op::jump, colon, 0);
        build_.jumpHere(toElse);
    }
    const std::size_t elseBegin = build_.end();
    if (!isKnown) build_.forget(yes->type.size());
    Parsed no = expression();
    if (!no || !settle(*no)) return std::nullopt;
    if (yes->type != no->type)
        return problem(since(condition.range.begin), "expr-E03",
                       fmt::format("both cases of '?' have the same type, found {} and {}", name(yes->type),
                                   name(no->type)));
    Operand result{.type = yes->type, .range = since(condition.range.begin), .begin = condition.begin};
    if (isKnown) {
        if (isTrue)
            build_.erase(elseBegin, build_.end(), no->type.size());
        else
            build_.erase(yes->begin, elseBegin, yes->type.size());
        result.isConstant = isTrue ? yes->isConstant : no->isConstant;
    } else {
        build_.jumpHere(toEnd);
    }
    return result;
}

Parser::Parsed Parser::binary(int least) {
    Parsed left = unary();
    while (left) {
        const Token sign = token_;
        const int precedence = sign.kind == TokenKind::sign ? precedenceOf(sign.text) : 0;
        if (precedence < least || precedence == 0) return left;
        take();
        if (sign.text == "&&" || sign.text == "||") {
            left = shortCircuit(*left, sign, precedence);
            continue;
        }
        Parsed right = binary(precedence + 1);
        if (!right) return std::nullopt;
        left = withinLimits(operation(*left, sign, *right));
    }
    return left;
}

Parser::Parsed Parser::operation(Operand left, const Token& sign, Operand right) {
    const Range range{left.range.begin, right.range.end};
    if (sign.text == "==" || sign.text == "!=") {
        if (left.choice && right.type == Type::word() && right.isConstant && !compareWithChoice(left, right))
            return std::nullopt;
        if (right.choice && left.type == Type::word() && left.isConstant && !compareWithChoice(right, left))
            return std::nullopt;
    }
    if (!settle(left) || !settle(right)) return std::nullopt;
    const auto call = operationOf(sign.text, left.type, right.type);
    if (!call) {
        const bool isOrder = sign.text[0] == '<' || sign.text[0] == '>';
        return problem(
            range, "expr-E03",
            fmt::format("'{}' does not combine {} and {}{}", sign.text, name(left.type), name(right.type),
                        isOrder && sign.text.size() < 3 && left.type.isVector() && left.type == right.type &&
                                sign.text != "<<" && sign.text != ">>"
                            ? "; lessThan() and greaterThan() compare vectors"
                            : ""));
    }
    return build_.combined({left, right}, call->instruction, call->result, range);
}

Parser::Parsed Parser::shortCircuit(Operand left, const Token& sign, int precedence) {
    const auto isBool = [&](const Operand& operand) {
        if (!settle(operand)) return false;
        if (!operand.type.isBoolean())
            problem(operand.range, "expr-E03",
                    fmt::format("'{}' combines bools, found {}", sign.text, name(operand.type)));
        return operand.type.isBoolean();
    };
    if (!isBool(left)) return std::nullopt;
    const bool decides = sign.text == "||";  // the value of the left side that decides
    const bool isKnown = left.isConstant;
    const bool isDecided = isKnown && (build_.valueOf(left)[0] != 0) == decides;
    std::size_t jump = 0;
    if (!isKnown)
        jump = build_.emitJump(decides ? Op::jumpKeepTrue : Op::jumpKeepFalse, sign.range, 1);
    else if (!isDecided)
        build_.erase(left.begin, build_.end(), 1);
    const std::size_t begin = build_.end();
    Parsed right = binary(precedence + 1);
    if (!right || !isBool(*right)) return std::nullopt;
    Operand result{
        .type = Type::boolean(), .range = {left.range.begin, right->range.end}, .begin = left.begin};
    if (isDecided) {
        build_.erase(begin, build_.end(), 1);
        result.isConstant = true;
    } else if (isKnown) {
        result.isConstant = right->isConstant;
    } else {
        build_.jumpHere(jump);
    }
    return withinLimits(result);
}

Parser::Parsed Parser::unary() {
    const Token sign = token_;
    const bool isSign = sign.is("-") || sign.is("+") || sign.is("!") || sign.is("~");
    if (!isSign) return postfix();
    const Level level(*this);
    if (depth_ > limits_.depth) return tooDeep();
    take();
    Parsed operand = unary();
    if (!operand || !settle(*operand)) return std::nullopt;
    const Range range = since(sign.range.begin);
    const auto call = operationOf(sign.is("+") ? "-" : sign.text, operand->type);
    if (!call)
        return problem(range, "expr-E03",
                       fmt::format("'{}' does not apply to {} {}{}", sign.text, article(name(operand->type)),
                                   name(operand->type),
                                   sign.is("!") && operand->type.kind == Kind::boolean ? "; use not()" : ""));
    if (sign.is("+")) {
        operand->range = range;
        operand->choice.reset();
        return operand;
    }
    return withinLimits(build_.combined({*operand}, call->instruction, call->result, range));
}

Parser::Parsed Parser::postfix() {
    const std::optional<MeasureCall> measure =
        token_.kind == TokenKind::name ? measureAt(text_, token_.range.begin) : std::nullopt;
    Parsed value = primary(measure ? &*measure : nullptr);
    while (value && (token_.is(".") || token_.is("["))) {
        if (!settle(*value)) return std::nullopt;
        value = withinLimits(token_.is(".") ? component(*value) : subscripted(*value));
    }
    if (value && measure && measure->seconds) {
        lexer_.goTo(measure->seconds->end);
        take();
        lastEnd_ = value->range.end = measure->seconds->end;
    }
    return value;
}

Parser::Parsed Parser::primary(const MeasureCall* measure) {
    const Token first = token_;
    if (first.kind == TokenKind::number) {
        take();
        return withinLimits(build_.pushed(first.number, Type::number(), first.range));
    }
    if (first.kind == TokenKind::name) {
        take();
        if (measure) return withinLimits(measured(*measure));
        if (token_.is("(")) return withinLimits(call(first));
        return withinLimits(named(first));
    }
    if (first.is("["))
        return problem(first.range, "expr-E01",
                       "expected a value, found '['; write vec3(1, 2, 3), or give a longer list a name: 'Let "
                       "a [5 3 1 2 4]'");
    if (!first.is("(")) return unexpected("a value");
    take();
    Parsed inner = expression();
    if (!inner) return inner;
    if (!takeIf(")")) return unexpected("')'");
    if (inner->unknownWord.empty()) inner->range = since(first.range.begin);
    return inner;
}

Parser::Parsed Parser::component(const Operand& value) {
    constexpr std::array<std::string_view, 3> kSets{"xyzw", "rgba", "stpq"};
    take();
    if (token_.kind != TokenKind::name) return unexpected("the name of a component");
    const Token name = token_;
    take();
    const Range range = since(value.range.begin);
    Instruction swizzle;
    swizzle.op = Op::swizzle;
    for (const std::string_view set : kSets) {
        if (name.text.size() > 4 || name.text.find_first_not_of(set) != std::string_view::npos) continue;
        if (value.type.isMatrix() || value.type.kind == Kind::word) break;
        swizzle.a = static_cast<std::uint8_t>(value.type.size());
        swizzle.n = static_cast<std::uint8_t>(name.text.size());
        for (std::size_t k = 0; k < name.text.size(); ++k) {
            const std::size_t index = set.find(name.text[k]);
            if (index >= value.type.rows)
                return problem(
                    name.range, "expr-E02",
                    fmt::format("a {} has no component '{}'", expression::name(value.type), name.text[k]));
            swizzle.target |= static_cast<std::uint32_t>(index) << (2 * k);
        }
        return build_.combined({value}, swizzle, Type::vector(name.text.size(), value.type.kind), range);
    }
    const std::vector<std::string> fields = names_.known(textOf(value.range));  // `mouse` has `mouse.down`
    return problem(name.range, "expr-E02",
                   fmt::format("{} {} has no component or field {}{}", article(expression::name(value.type)),
                               expression::name(value.type), quoted(text_, name.range),
                               base::suggestion(
                                   name.text, std::vector<std::string_view>(fields.begin(), fields.end()))));
}

Parser::Parsed Parser::subscript(std::size_t count) {
    take();
    Parsed index = expression();
    if (!index || !settle(*index)) return std::nullopt;
    if (!takeIf("]")) return unexpected("']'");
    if (!index->type.isNumber())
        return problem(index->range, "expr-E03",
                       fmt::format("a subscript is a number, found {}", name(index->type)));
    if (index->isConstant) {
        const double value = base::wholeNumber(build_.valueOf(*index)[0]).value;
        if (!(value >= 0 && value < static_cast<double>(count)))
            return problem(index->range, "expr-E06",
                           fmt::format("subscript {} is not between 0 and {}", value, count - 1));
    }
    return index;
}

Parser::Parsed Parser::subscripted(const Operand& value) {
    const std::size_t count = value.type.isMatrix() ? value.type.columns : value.type.rows;
    if (count < 2 || value.type.kind == Kind::word)
        return problem(value.range, "expr-E08",
                       fmt::format("{} {} has no elements", article(name(value.type)), name(value.type)));
    const Parsed index = subscript(count);
    if (!index) return std::nullopt;
    const Type type =
        value.type.isMatrix() ? Type::vector(value.type.rows) : Type::vector(1, value.type.kind);
    Instruction element;
    element.op = Op::element;
    element.n = static_cast<std::uint8_t>(type.size());
    element.b = static_cast<std::uint8_t>(count);
    return build_.combined({value, *index}, element, type, since(value.range.begin));
}

}  // namespace glibra::expression
