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
    std::string profile;  ///< "core", "compatibility" or empty, for sources that are not translated
    Place place;
};

/// Reads the words of a #version line after `version`. Reports the spellings that are tolerated or refused.
Dialect readVersion(std::span<const std::string_view> words, const Place& place, int targetVersion,
                    Report& report);

}  // namespace glibra::glsl
