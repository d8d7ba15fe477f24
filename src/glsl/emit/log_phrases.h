#pragma once
// What the message of a compile log is about, in the words of each compiler.

#include <string_view>

namespace glibra::glsl {

/// The name that a message says to be undeclared; empty if it says something else.
std::string_view undeclaredName(std::string_view message);

/// True for messages about types that do not fit.
bool isAboutTypes(std::string_view message);

/// True for messages that follow from an error before them on the same line.
bool isConsequence(std::string_view message);

/// True for a message that a token does not fit the grammar.
bool isSyntaxError(std::string_view message);

}  // namespace glibra::glsl
