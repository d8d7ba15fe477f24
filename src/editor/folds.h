#pragma once
// The parts of a text that an editor can fold.

#include <cstddef>
#include <string_view>
#include <vector>

#include "source/syntax.h"

namespace glibra::editor {

/// Lines, from 0; the first one stays visible.
struct Fold {
    std::size_t first = 0, last = 0;
    bool isComment = false;
};

/// Blocks and shaders of a scene; blocks, comments and branches of the preprocessor of a shader.
std::vector<Fold> foldsOf(std::string_view text, source::CodeLanguage language);

}  // namespace glibra::editor
