#pragma once

#include <cstddef>

namespace glibra::editor {

/// Byte offsets in a text.
struct TextRange {
    std::size_t begin = 0, end = 0;
    friend bool operator==(const TextRange&, const TextRange&) = default;
};

}  // namespace glibra::editor
