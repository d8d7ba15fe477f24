#pragma once
// Changes to a text that respect its form: most of the changed texts are still statements of their language,
// and so get past the lexer. A target whose input is text defines grammar() and is linked with
// text_mutator.cpp.

#include <string>
#include <string_view>
#include <vector>

namespace glibra::fuzz {

/// What the changes insert, from the program's own tables.
struct Grammar {
    std::vector<std::string> words;                  ///< one token each: names of commands, keys, keywords
    std::vector<std::string> statements;             ///< whole lines without their end
    std::string_view separators = " \t,;()[]{}<>=";  ///< bytes that are no part of a word or number
};

/// The grammar of this target.
const Grammar& grammar();

}  // namespace glibra::fuzz
