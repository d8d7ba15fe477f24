#pragma once
// #version lines and the dialects that they declare (language, 7.2).

#include <glibra/diagnostic.h>

#include <span>
#include <string>
#include <string_view>

#include "glsl/read/report.h"

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

}  // namespace glibra::glsl
