#pragma once
// The blocks of functions as lists of statements, for what changes the code of a whole block.

#include <functional>
#include <span>
#include <vector>

#include "classroom/code_tree.h"

namespace glibra::classroom {

/// Calls `change` with the statements of every block of every function, inner blocks first, and of `switch`
/// with those between labels. What is no function stays. Blocks that are nested deeper than anybody writes
/// stay, too.
Code withBlocks(std::span<const CodeToken> tokens,
                const std::function<void(std::vector<Code>& statements)>& change);

/// True if `a` comes before `b`, by what tokens are compared by.
bool isBefore(const Code& a, const Code& b);

/// The parts between the commas outside of brackets, up to the end or to a bracket that closes.
std::vector<std::span<const CodeToken>> splitAtCommas(std::span<const CodeToken> list);

/// The tokens one after another.
Code joinedCode(const std::vector<Code>& parts);

}  // namespace glibra::classroom
