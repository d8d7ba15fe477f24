#pragma once
// The arguments of the function or command that is being written.

#include <string>
#include <string_view>
#include <vector>

#include "editor/completion.h"

namespace glibra::editor {

/// A signature or usage, in three parts: before the argument that is being written, this argument, and what
/// comes after it. Without an argument everything stands in `before`.
struct SignatureParts {
    std::string before, argument, after;
};

struct CallHint {
    std::string word;  ///< of the function or command; empty: nothing is called at the cursor
    std::vector<SignatureParts> signatures;
};

/// What is called where the cursor stands: the innermost function whose parenthesis is open in a shader or an
/// expression, or else the command of a scene's line, after its word. Names without arguments give nothing.
CallHint callAt(std::string_view text, std::size_t cursor, const CodeContext& context);

}  // namespace glibra::editor
