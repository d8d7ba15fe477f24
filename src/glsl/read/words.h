#pragma once
// The keywords of GLSL 4.50: types, qualifiers and statements, and the version that introduced each of them.

#include <string_view>
#include <vector>

#include "glsl/read/token.h"
#include "glsl/read/version.h"

namespace glibra::glsl {

/// The version in which the word became a keyword (110 ... 450); kReserved for words that 4.50 only reserves;
/// 0 for all other words.
int keywordSince(std::string_view word);
inline constexpr int kReserved = 1000;

/// True if the word is a keyword or reserved word of 4.50 and none of the version that the source declares
/// (language, 7.4). Words that this version only reserves count as free, too.
bool isFreeWord(std::string_view word, const Dialect& dialect);

/// All keywords and reserved words, in byte order.
std::vector<std::string_view> keywords();

/// True if `word` is in `list`, which has a blank before and after every word.
bool listed(std::string_view list, std::string_view word);

/// The words of a list with blanks between them.
std::vector<std::string_view> splitWords(std::string_view list);

/// True for words that name a type: "float", "vec3", "sampler2D", "void", ...
bool isTypeWord(std::string_view word);

/// True for words that may stand before the type of a declaration, also "attribute", "varying" and "highp".
bool isQualifierWord(std::string_view word);

/// True for "if", "for", "return", ...
bool isStatementWord(std::string_view word);

/// True for samplers, images and atomic counters.
bool isOpaqueTypeWord(std::string_view word);
bool isImageTypeWord(std::string_view word);

/// True for "=", "+=", "<<=", ...
bool isAssignment(std::string_view text);

/// True for "++" and "--".
constexpr bool isStep(std::string_view text) {
    return text == "++" || text == "--";
}

// The classes of words, of tokens that markNames (parse/lexical.h) has seen.

inline bool isQualifier(const ViewToken& token) {
    return token.kind == TokenKind::word && !token.isName && isQualifierWord(token.text);
}
inline bool isStatement(const ViewToken& token) {
    return token.kind == TokenKind::word && !token.isName && isStatementWord(token.text);
}
inline bool isType(const ViewToken& token) {
    return token.kind == TokenKind::word && !token.isName && isTypeWord(token.text);
}

}  // namespace glibra::glsl
