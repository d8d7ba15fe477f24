#pragma once
// The tokens that the preprocessor makes of a source, and what two other preprocessors make of it.

#include <string>
#include <vector>

#include "glsl/types/request.h"

namespace glibra::glsl::test {

using Tokens = std::vector<std::string>;

struct Preprocessed {
    Tokens tokens;
    std::string ids;  ///< of the messages
    Diagnostics messages;
};

/// What glibra makes of a fragment stage "a.frag", without the rules that translate.
Preprocessed preprocessed(const std::string& text);

/// What glslangValidator -E makes of it; one token "error: ..." if it reports an error.
Tokens glslangTokens(const std::string& text);

/// What the C preprocessor makes of it.
Tokens cppTokens(const std::string& text);

}  // namespace glibra::glsl::test
