#pragma once
// From a line of the user to the lines that the translation made of it.

#include <glibra/diagnostic.h>

#include <string>
#include <vector>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// A line of a translated source.
struct EmittedLine {
    int number = 0;  ///< in TranslatedStage::source, from 1
    std::string text;
};

/// The lines that the translation of a stage made of the user's line at `place`, in order, without blank
/// lines and #line directives.
std::vector<EmittedLine> emittedLines(const TranslatedStage& stage, const Place& place);

}  // namespace glibra::glsl
