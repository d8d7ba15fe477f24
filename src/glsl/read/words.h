#pragma once
// The words of GLSL 4.50: which are types, which are qualifiers, and since when each is taken.

#include <string_view>

namespace glibra::glsl {

/// The version in which the word became a keyword (110 ... 450); kReserved for words that 4.50 reserves
/// without using them; 0 for all other words.
int keywordSince(std::string_view word);
inline constexpr int kReserved = 1000;

/// "float", "vec3", "sampler2D", "void", ...: words that name a type by themselves.
bool isTypeWord(std::string_view word);

/// Words that may stand before the type of a declaration, including "attribute", "varying" and precision
/// words.
bool isQualifierWord(std::string_view word);

/// "if", "for", "return", ...
bool isStatementWord(std::string_view word);

/// Samplers, images and atomic counters.
bool isOpaqueTypeWord(std::string_view word);
bool isImageTypeWord(std::string_view word);

}  // namespace glibra::glsl
