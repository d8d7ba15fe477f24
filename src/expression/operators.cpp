#include "expression/operators.h"

#include <algorithm>

#include "expression/apply.h"

namespace glibra::expression {
namespace {

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

}  // namespace

int precedenceOf(std::string_view sign) {
    const OperatorRow* row = rowOf(sign);
    return row == nullptr ? 0 : row->precedence;
}

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

}  // namespace glibra::expression
