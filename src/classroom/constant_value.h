#pragma once
// The value of an expression of numbers, so that `if (2 < 1)` hides as little as `if (false)`.

#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "classroom/code_tree.h"

namespace glibra::classroom {

/// Variables that always have the value of their declaration.
using KnownValues = std::map<std::string_view, double>;

/// Finds variables of the types bool, int, uint and float whose declaration gives them a constant value and
/// that nothing changes afterwards. Names that are declared several times are left out.
KnownValues knownValues(const CodeTree& tree, std::span<const CodeToken> code, const OwnFunctions& own);

/// The value of an expression, where true is 1; nothing if it depends on anything else. `false && a` and
/// `true || a` have a value whatever `a` is, and so have `a && false` and `a || true` unless `a` has an
/// effect.
std::optional<double> constantValue(const CodeTree& tree, std::uint32_t expression, const KnownValues& known,
                                    const OwnFunctions& own);

}  // namespace glibra::classroom
