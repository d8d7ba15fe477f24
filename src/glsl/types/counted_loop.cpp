#include "glsl/types/counted_loop.h"

#include <algorithm>
#include <cmath>

namespace glibra::glsl {
namespace {

/// Mesa unrolls loops with constant bounds up to this number of rounds.
constexpr double kUnrolled = 32;
constexpr double kMostCounted = 1e18;

std::optional<double> applied(Operation operation, double a, double b) {
    switch (operation) {
        case Operation::add:
            return a + b;
        case Operation::subtract:
            return a - b;
        case Operation::multiply:
            return a * b;
        case Operation::divide:
            return a / b;
        case Operation::least:
            return std::min(a, b);
        case Operation::greatest:
            return std::max(a, b);
        case Operation::negate:
        case Operation::truncate:
            break;
    }
    return std::nullopt;
}

bool isConstant(const Formula& formula) {
    return std::ranges::none_of(formula.steps,
                                [](const auto& each) { return std::holds_alternative<std::string>(each); });
}

}  // namespace

std::optional<double> valueOf(const Formula& formula, const UniformValue& uniform) {
    std::vector<double> stack;
    for (const auto& each : formula.steps) {
        if (const auto* number = std::get_if<double>(&each)) {
            stack.push_back(*number);
            continue;
        }
        if (const auto* name = std::get_if<std::string>(&each)) {
            const std::optional<double> value = uniform(*name);
            if (!value) return std::nullopt;
            stack.push_back(*value);
            continue;
        }
        const Operation operation = std::get<Operation>(each);
        const bool isUnary = operation == Operation::negate || operation == Operation::truncate;
        if (stack.size() < (isUnary ? 1U : 2U)) return std::nullopt;
        const double last = stack.back();
        stack.pop_back();
        if (isUnary) {
            stack.push_back(operation == Operation::negate ? -last : std::trunc(last));
            continue;
        }
        const std::optional<double> result = applied(operation, stack.back(), last);
        if (!result) return std::nullopt;
        stack.back() = *result;
    }
    if (stack.size() != 1 || !std::isfinite(stack.back())) return std::nullopt;
    return stack.back();
}

double roundsOf(const CountedLoop& loop, const UniformValue& uniform) {
    const std::optional<double> first = valueOf(loop.first, uniform);
    const std::optional<double> bound = valueOf(loop.bound, uniform);
    const std::optional<double> step = valueOf(loop.step, uniform);
    if (!first || !bound || !step || *step == 0) return 0;
    if (!loop.untilEqual && (*step < 0) != loop.falling) return 0;
    const double steps = (*bound - *first) / *step;
    if (loop.untilEqual && steps != std::floor(steps)) return 0;  // it steps over the bound
    return std::clamp(loop.including ? std::floor(steps) + 1 : std::ceil(steps), 0., kMostCounted);
}

double emittedBy(const CountedLoop& loop, const UniformValue& uniform) {
    if (!loop.isSure) return 0;
    double each = loop.emits;
    for (const CountedLoop& inner : loop.inside) each += emittedBy(inner, uniform);
    return each == 0 ? 0 : roundsOf(loop, uniform) * each;
}

bool isOpen(const CountedLoop& loop, const UniformValue& uniform) {
    return !(roundsOf(loop, uniform) > 0) ||
           std::ranges::any_of(loop.inside, [&](const CountedLoop& each) { return isOpen(each, uniform); });
}

bool isUnrolled(const CountedLoop& loop) {
    const UniformValue none = [](std::string_view) { return std::nullopt; };
    return isConstant(loop.first) && isConstant(loop.bound) && isConstant(loop.step) &&
           roundsOf(loop, none) > 0 && roundsOf(loop, none) <= kUnrolled &&
           std::ranges::all_of(loop.inside, isUnrolled);
}

double totalRounds(const CountedLoop& loop, const UniformValue& uniform) {
    const double rounds = roundsOf(loop, uniform);
    double inside = 0;
    for (const CountedLoop& each : loop.inside) inside += totalRounds(each, uniform);
    if (isUnrolled(loop)) return 0;
    return std::min(kMostCounted, std::max(rounds * (1 + inside), inside));
}

}  // namespace glibra::glsl
