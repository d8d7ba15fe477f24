#include "expression/expression.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/number.h"

namespace glibra::expression {
namespace {

bool allFinite(const double* values, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
        if (!std::isfinite(values[k])) return false;
    return true;
}

const char* whyNotFinite(const double* values, std::size_t count) {
    return std::any_of(values, values + count, [](double value) { return std::isnan(value); })
               ? "the result is not a number"
               : "the result is infinite";
}

/// Components of `a` and `b`, at the end of the stack, give n components in the place of `a`. If one of them
/// has a single component, it is used for all.
template <class Operation>
void eachComponent(double*& top, const Instruction& i, const Operation& operation) {
    double* b = top - i.b;
    double* a = b - i.a;
    top = a + i.n;
    if (i.a == i.b) {
        for (std::size_t k = 0; k < i.n; ++k) a[k] = operation(a[k], b[k]);
    } else if (i.b == 1) {
        const double all = *b;
        for (std::size_t k = 0; k < i.n; ++k) a[k] = operation(a[k], all);
    } else {
        const double all = *a;
        for (std::size_t k = 0; k < i.n; ++k) a[k] = operation(all, b[k]);
    }
}

template <class Comparison>
void compare(double*& top, const Comparison& comparison) {
    --top;
    top[-1] = comparison(top[-1], top[0]) ? 1 : 0;
}

/// The index of an element; `count` if there is no such element.
std::size_t elementAt(double subscript, std::size_t count) {
    const double whole = base::wholeNumber(subscript).value;
    return whole >= 0 && whole < static_cast<double>(count) ? static_cast<std::size_t>(whole) : count;
}

/// Runs code. What can fail returns why, for the instruction at which the run stopped.
class Machine {
  public:
    Machine(const Code& code, const Values* values, double* stack)
        : code_(code), values_(values), stack_(stack), top_(stack) {}

    std::optional<Problem> run(std::size_t first) {
        const std::size_t count = code_.instructions.size();
        for (at_ = first; at_ < count; ++at_) {
            const Instruction& i = code_.instructions[at_];
            double* const before = top_;
            switch (i.op) {
                case Op::push:
                    top_ = std::copy_n(code_.constants.data() + i.target, i.n, top_);
                    continue;
                case Op::load:
                    if (auto problem = load(i, 0)) return problem;
                    continue;
                case Op::loadAt:
                    if (auto problem = loadAt(i)) return problem;
                    continue;
                case Op::local:
                    top_ = std::copy_n(stack_ + i.target, i.n, top_);
                    continue;
                case Op::leave: {
                    const double* const result = top_ - i.n;
                    top_ = std::copy_n(result, i.n, top_ - i.n - i.target);
                    continue;
                }
                case Op::negate:
                    for (double* each = top_ - i.n; each != top_; ++each) *each = -*each;
                    continue;
                case Op::add:
                    eachComponent(top_, i, [](double a, double b) { return a + b; });
                    break;
                case Op::subtract:
                    eachComponent(top_, i, [](double a, double b) { return a - b; });
                    break;
                case Op::multiply:
                    eachComponent(top_, i, [](double a, double b) { return a * b; });
                    break;
                case Op::divide: {
                    const double* const divisor = before - i.b;
                    const bool byZero = std::find(divisor, divisor + i.b, 0.0) != divisor + i.b;
                    eachComponent(top_, i, [](double a, double b) { return a / b; });
                    if (byZero && i.isChecked) return fail("division by zero");
                    break;
                }
                case Op::less:
                    compare(top_, [](double a, double b) { return a < b; });
                    continue;
                case Op::lessEqual:
                    compare(top_, [](double a, double b) { return a <= b; });
                    continue;
                case Op::greater:
                    compare(top_, [](double a, double b) { return a > b; });
                    continue;
                case Op::greaterEqual:
                    compare(top_, [](double a, double b) { return a >= b; });
                    continue;
                case Op::equal:
                case Op::notEqual: {
                    double* const a = top_ - 2 * std::size_t{i.a};
                    const bool same = std::equal(a, a + i.a, a + i.a);
                    top_ = a + 1;
                    *a = same == (i.op == Op::equal) ? 1 : 0;
                    continue;
                }
                case Op::logicalNot:
                    top_[-1] = 1 - top_[-1];
                    continue;
                case Op::logicalXor:
                    compare(top_, [](double a, double b) { return a != b; });
                    continue;
                case Op::swizzle:
                    swizzle(i);
                    continue;
                case Op::element: {
                    const std::size_t index = elementAt(top_[-1], i.b);
                    if (index == i.b) return fail(outOfRange(top_[-1], i.b));
                    double* const whole = top_ - 1 - std::size_t{i.n} * i.b;
                    top_ = std::copy_n(whole + index * i.n, i.n, whole);
                    continue;
                }
                case Op::word: {
                    const std::size_t index = elementAt(top_[-1], i.b);
                    if (index == i.b) return fail(outOfRange(top_[-1], i.b));
                    top_[-1] = code_.constants[i.target + index];
                    continue;
                }
                case Op::call: {
                    double* const base =
                        top_ - (std::size_t{i.a} + std::size_t{i.b} + std::size_t{i.c} + std::size_t{i.d});
                    top_ = base + i.n;
                    if (const char* why = i.apply(base, i)) {
                        if (i.isChecked) return fail(why);
                        std::fill(base, top_, std::nan(""));
                    }
                    break;
                }
                case Op::jump:
                    at_ += i.target;
                    continue;
                case Op::jumpIfFalse:
                    if (*--top_ == 0) at_ += i.target;
                    continue;
                case Op::jumpKeepFalse:
                    if (top_[-1] == 0)
                        at_ += i.target;
                    else
                        --top_;
                    continue;
                case Op::jumpKeepTrue:
                    if (top_[-1] != 0)
                        at_ += i.target;
                    else
                        --top_;
                    continue;
            }
            if (i.isChecked && !allFinite(top_ - i.n, i.n)) return fail(whyNotFinite(top_ - i.n, i.n));
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] Problem fail(std::string_view why) const {
        const Range range = code_.ranges[at_];
        return problemAt(code_, range, "expr-E06", fmt::format("{}: {}", quoted(code_, range), why));
    }

    static std::string outOfRange(double subscript, std::size_t count) {
        return fmt::format("subscript {} is not between 0 and {}", base::wholeNumber(subscript).value,
                           count - 1);
    }

    std::optional<Problem> load(const Instruction& i, std::size_t element) {
        const Symbol& symbol = code_.uses[i.target].symbol;
        const double* const value = values_ == nullptr ? nullptr : values_->find(symbol.slot, element);
        if (value == nullptr) {
            std::string text = fmt::format("{} has no value here", quoted(code_, code_.ranges[at_]));
            if (const std::string why =
                    values_ == nullptr ? std::string() : values_->whyMissing(symbol.slot, element);
                !why.empty())
                text += ": " + why;
            return problemAt(code_, code_.ranges[at_], "expr-E07", std::move(text));
        }
        if (i.isChecked && !allFinite(value, i.n)) return fail(whyNotFinite(value, i.n));
        top_ = std::copy_n(value, i.n, top_);
        return std::nullopt;
    }

    std::optional<Problem> loadAt(const Instruction& i) {
        const std::size_t count = code_.uses[i.target].symbol.count;
        const double subscript = *--top_;
        const std::size_t index = elementAt(subscript, count);
        if (index == count) return fail(outOfRange(subscript, count));
        return load(i, index);
    }

    void swizzle(const Instruction& i) {
        constexpr std::uint32_t kMask = 3;
        double* const from = top_ - i.a;
        double picked[4] = {};
        for (std::uint32_t k = 0; k < i.n; ++k) picked[k] = from[(i.target >> (2 * k)) & kMask];
        top_ = std::copy_n(picked, i.n, from);
    }

    const Code& code_;
    const Values* values_;
    double* stack_;
    double* top_;
    std::size_t at_ = 0;
};

/// The body that a range stands in; null for the text itself.
const CalledBody* bodyOf(const Code& code, Range range) {
    const auto next = std::ranges::upper_bound(code.bodies, range.begin, {}, &CalledBody::begin);
    return next == code.bodies.begin() ? nullptr : &*std::prev(next);
}

Checked<Value> valueOf(const Code& code, const Values* values) {
    double stack[kMostDoubles];
    if (auto problem = Machine(code, values, stack).run(0)) return std::move(*problem);
    Value value{code.type, {}};
    std::copy_n(stack, code.type.size(), value.components.begin());
    return value;
}

}  // namespace

std::string Values::whyMissing(std::uint32_t /*slot*/, std::size_t /*element*/) const {
    return {};
}

std::optional<Problem> run(const Code& code, std::size_t first, const Values* values, double* stack) {
    return Machine(code, values, stack).run(first);
}

std::string quoted(const Code& code, Range range) {
    const CalledBody* const body = bodyOf(code, range);
    return body == nullptr
               ? quoted(code.text, range)
               : quoted(body->function->body, {range.begin - body->begin, range.end - body->begin});
}

Problem problemAt(const Code& code, Range range, const char* id, std::string message) {
    if (const CalledBody* const body = bodyOf(code, range)) {
        const Place in = placeAt(body->function->body, range.begin - body->begin, body->function->origin);
        message =
            fmt::format("{}: {} ({}line {}, column {})", quoted(code.text, body->call), message,
                        in.file == code.origin.file ? std::string() : in.file + ", ", in.line, in.column);
        range = body->call;
    }
    return {diagnose(id, std::move(message), placeAt(code.text, range.begin, code.origin)), range};
}

Type Expression::type() const {
    return code_->type;
}
const std::string& Expression::text() const {
    return code_->text;
}
const Place& Expression::origin() const {
    return code_->origin;
}
Depends Expression::depends() const {
    return code_->depends;
}
std::span<const Use> Expression::uses() const {
    return code_->uses;
}

std::optional<Value> Expression::constant() const {
    if (!code_->uses.empty()) return std::nullopt;
    auto value = valueOf(*code_, nullptr);
    return value ? std::optional(*value) : std::nullopt;
}

Checked<Value> Expression::evaluate(const Values& values) const {
    return valueOf(*code_, &values);
}

bool operator==(const Expression& a, const Expression& b) {
    if (a.code_ == b.code_) return true;
    const auto sameUse = [](const Use& x, const Use& y) {
        return x.path == y.path && x.symbol.slot == y.symbol.slot && x.symbol.count == y.symbol.count;
    };
    return a.code_->text == b.code_->text && a.code_->type == b.code_->type &&
           a.code_->instructions == b.code_->instructions && a.code_->constants == b.code_->constants &&
           std::equal(a.code_->uses.begin(), a.code_->uses.end(), b.code_->uses.begin(), b.code_->uses.end(),
                      sameUse);
}

}  // namespace glibra::expression
