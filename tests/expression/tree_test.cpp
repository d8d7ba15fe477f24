// Random trees of operations are printed with as few parentheses as GLSL's grammar needs, read, and
// evaluated; the tree itself is evaluated directly.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "support.h"

namespace glibra::expression::test {
namespace {

/// A number or a bool, with the precedence of its text (GLSL 4.60, 5.1, from 1 for ?: to 14 for names).
struct Tree {
    std::string text;
    int precedence = 14;
    bool isTruth = false;
    std::optional<double> value;  ///< nothing: an error
};

constexpr std::array<std::pair<const char*, double>, 5> kNames{
    {{"a", 2}, {"b", 3}, {"c", 5}, {"x", -.5}, {"time", 2.5}}};

std::optional<double> finite(double value) {
    return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

class Grower {
  public:
    explicit Grower(unsigned seed) : random_(seed) {}

    Tree number(int depth) {
        if (depth == 0 || below(8) == 0) return leaf();
        switch (below(7)) {
            case 0:
            case 1:
            case 2:
                return arithmetic(depth);
            case 3: {
                const Tree inner = number(depth - 1);
                return {"-" + wrapped(inner, 13), 13, false,
                        inner.value ? std::optional<double>(-*inner.value) : std::nullopt};
            }
            case 4:
                return function(depth);
            case 5: {
                // Components of a vector
                const Tree x = number(depth - 1), y = number(depth - 1);
                const bool second = below(2) == 1;
                Tree result{"vec2(" + x.text + ", " + y.text + (second ? ").y" : ")[0]"), 14, false,
                            std::nullopt};
                if (x.value && y.value) result.value = second ? y.value : x.value;
                return result;
            }
            default:
                return conditional(depth);
        }
    }

  private:
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }

    /// In parentheses if the text binds less than its place needs; now and then without need.
    std::string wrapped(const Tree& tree, int needed) {
        return tree.precedence < needed || below(12) == 0 ? "(" + tree.text + ")" : tree.text;
    }

    Tree leaf() {
        if (below(2) == 0) {
            const auto& [name, value] = kNames.at(below(kNames.size()));
            return {name, 14, false, value};
        }
        const double value = static_cast<double>(below(40)) / 4;
        const std::string text = std::to_string(value);
        return {text, 14, false, value};
    }

    Tree arithmetic(int depth) {
        const Tree left = number(depth - 1), right = number(depth - 1);
        const std::size_t which = below(5);
        const int precedence = which < 2 ? 11 : 12;
        Tree result{wrapped(left, precedence) + " " + "+-*/%"[which] + " " + wrapped(right, precedence + 1),
                    precedence, false, std::nullopt};
        if (!left.value || !right.value) return result;
        const double a = *left.value, b = *right.value;
        if (which == 0) result.value = finite(a + b);
        if (which == 1) result.value = finite(a - b);
        if (which == 2) result.value = finite(a * b);
        if (which == 3 && b != 0) result.value = finite(a / b);
        if (which == 4 && b != 0) {
            double rest = std::fmod(a, b);
            if (rest != 0 && (rest < 0) != (b < 0)) rest += b;
            result.value = rest == 0 || rest == b ? 0 : rest;  // never -0
        }
        return result;
    }

    Tree function(int depth) {
        const Tree x = number(depth - 1), y = number(depth - 1);
        const std::size_t which = below(4);
        const char* const names[] = {"sqrt", "floor", "max", "atan"};
        Tree result{std::string(names[which]) + "(" + x.text + (which >= 2 ? ", " + y.text : "") + ")", 14,
                    false, std::nullopt};
        if (!x.value || (which >= 2 && !y.value)) return result;
        if (which == 0) result.value = finite(std::sqrt(*x.value));
        if (which == 1) result.value = std::floor(*x.value);
        if (which == 2) result.value = std::max(*x.value, *y.value);
        if (which == 3) result.value = std::atan2(*x.value, *y.value);
        return result;
    }

    Tree conditional(int depth) {
        const Tree condition = truth(depth - 1), yes = number(depth - 1), no = number(depth - 1);
        Tree result{wrapped(condition, 2) + " ? " + yes.text + " : " + wrapped(no, 1), 1, false,
                    std::nullopt};
        if (condition.value) result.value = *condition.value != 0 ? yes.value : no.value;
        return result;
    }

    Tree truth(int depth) {
        if (depth == 0 || below(3) == 0) {
            const Tree left = number(std::max(depth - 1, 0)), right = number(std::max(depth - 1, 0));
            const std::size_t which = below(4);
            const char* const signs[] = {" < ", " >= ", " == ", " != "};
            const int precedence = which < 2 ? 9 : 8;
            Tree result{wrapped(left, precedence) + signs[which] + wrapped(right, precedence + 1), precedence,
                        true, std::nullopt};
            if (!left.value || !right.value) return result;
            const double a = *left.value, b = *right.value;
            result.value = which == 0 ? a < b : which == 1 ? a >= b : which == 2 ? a == b : a != b;
            return result;
        }
        if (below(5) == 0) {
            const Tree inner = truth(depth - 1);
            return {"!" + wrapped(inner, 13), 13, true,
                    inner.value ? std::optional<double>(1 - *inner.value) : std::nullopt};
        }
        const Tree left = truth(depth - 1), right = truth(depth - 1);
        const std::size_t which = below(3);
        const char* const signs[] = {" || ", " ^^ ", " && "};
        const int precedence = 2 + static_cast<int>(which);
        Tree result{wrapped(left, precedence) + signs[which] + wrapped(right, precedence + 1), precedence,
                    true, std::nullopt};
        if (!left.value) return result;
        const bool a = *left.value != 0;
        if ((which == 0 && a) || (which == 2 && !a))
            result.value = a;
        else if (right.value)
            result.value = which == 1 ? (a != (*right.value != 0)) : *right.value != 0;
        return result;
    }

    std::mt19937 random_;
};

TEST(ExpressionTrees, MeanWhatTheirTextSays) {
    const NameTable table = sceneTable();
    int good = 0, bad = 0;
    for (unsigned seed = 0; seed < 20'000; ++seed) {
        const Tree tree = Grower(seed).number(2 + static_cast<int>(seed % 5));
        if (tree.text.size() > 8000) continue;
        const auto expression = parse(tree.text, {}, table);
        ASSERT_TRUE(expression) << tree.text << ": " << expression.problem.message.text;
        const auto value = expression->evaluate(table);
        ASSERT_EQ(static_cast<bool>(value), tree.value.has_value()) << tree.text;
        if (value) {
            ASSERT_EQ(value->number(), *tree.value) << tree.text;
        } else {
            ASSERT_EQ(value.problem.message.id, "expr-E06") << tree.text;
        }
        ++(value ? good : bad);
    }
    EXPECT_GT(good, 10'000);
    EXPECT_GT(bad, 500);
}

}  // namespace
}  // namespace glibra::expression::test
