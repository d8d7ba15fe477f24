#pragma once
// A variable at file scope as the rules change it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/parse/syntax.h"

namespace glibra::glsl {

struct Variable : ChangeableQualifiers {
    std::size_t declaration = 0;  ///< index into the syntax
    std::size_t declarator = 0;
    std::string name;             ///< the user's
    std::uint32_t nameToken = 0;  ///< view index

    std::string type;                                         ///< a word; empty for struct { ... }
    std::vector<std::string> typeSizes;                       ///< the texts in the brackets after the type
    std::vector<std::string> nameSizes;                       ///< the texts in the brackets after the name
    std::vector<std::pair<std::string, std::string>> layout;  ///< names and values; a value may be empty

    bool changed = false;  ///< the head of its declaration has to be written again
    bool removed = false;
    bool sizesChanged = false;
    bool dropInitializer = false;
    std::string initializer;  ///< " = ..." to be written after the name
    std::string after;        ///< to be written after the declaration's ';'

    [[nodiscard]] bool isArray() const { return !typeSizes.empty() || !nameSizes.empty(); }
    /// Sizes from the outermost to the innermost. Those after the name come first.
    [[nodiscard]] std::vector<std::string> sizes() const;
    [[nodiscard]] const std::string* layoutValue(std::string_view key) const;
    void removeLayout(std::string_view key);
    void setLayout(std::string key, std::string value);
};

}  // namespace glibra::glsl
