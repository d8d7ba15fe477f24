#pragma once
// #version lines and the dialects that they declare (language, 7.2).

#include <glibra/diagnostic.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/report.h"
#include "glsl/read/token.h"

namespace glibra::glsl {

/// The first version with compute shaders.
inline constexpr int kFirstWithCompute = 430;

/// The version that a source declares, after the tolerance of the language (language, 7.2).
struct Dialect {
    int version = 330;    ///< a known desktop version
    int written = 330;    ///< the number that __VERSION__ gives
    bool given = false;   ///< the source has a #version line
    bool core = false;    ///< that line has the word core
    bool es = false;      ///< it declares a version of GLSL ES
    std::string profile;  ///< "core", "compatibility" or empty, for sources that are not translated
    Place place;
};

/// "4.30" for 430.
inline std::string dotted(int version) {
    return std::to_string(version).insert(1, ".");
}

/// True if a backslash at the end of a // comment continues it (GLSL 4.20, GLSL ES 3.00).
inline bool continuesComments(const Dialect& dialect) {
    return dialect.written >= (dialect.es ? 300 : 420);
}

/// The line that follows "#line number": `number` itself from GLSL 3.30 on and in GLSL ES, before that the
/// next one.
inline long long lineAfterDirective(const Dialect& dialect, long long number) {
    return dialect.es || dialect.version >= 330 ? number : number + 1;
}

/// Reads the words of a #version line after `version`. Reports the spellings that are tolerated or refused.
Dialect readVersion(std::span<const std::string_view> words, const Place& place, int targetVersion,
                    Report& report);

// ---- Keywords
// The keywords of GLSL 4.50: types, qualifiers and statements, and the version that introduced each of them.

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
