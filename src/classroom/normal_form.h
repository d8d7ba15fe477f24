#pragma once
// Brings shader code into a form that stays the same when somebody adds statements without effect, swaps
// operands of a sum or a product, or writes a constant differently. It is a form for comparing, not a
// program: products of matrices are sorted, too.

#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

namespace glibra::classroom {

/// A token of a file, without blanks and comments.
struct CodeToken {
    std::string_view text;
    std::uint32_t code = 0;  ///< what it is compared by
    std::int32_t line = 1;
    bool isWord = false, isNumber = false;
    bool isDirective = false;  ///< it is on a line of the preprocessor, which is left as it is
};

/// Removes from the functions of a text what has no effect: statements after return or discard, blocks whose
/// condition is false, expressions that assign nothing, assignments of a variable to itself, and variables
/// that are never read with all that is assigned to them. A call of one of `own` functions has an effect.
std::vector<CodeToken> withoutDeadCode(std::vector<CodeToken> tokens, const std::set<std::string_view>& own);

/// Sorts the operands of sums and products, computes with numbers, drops what adds 0 or multiplies by 1 and
/// parentheses around one operand, and writes "a += b" as "a = a + b". All numbers are compared by `number`.
std::vector<CodeToken> inOrder(const std::vector<CodeToken>& tokens, std::uint32_t number);

}  // namespace glibra::classroom
