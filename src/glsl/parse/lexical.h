#pragma once
// What the tokens of a stage are before they are parsed: words of the target's grammar that the declared
// version leaves to the user, words of extensions, `unsigned int`.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Replaces the words of the stage's extensions by those of the target (extensions.h), and `unsigned int` of
/// EXT_gpu_shader4 by `uint`, in the view and in the edits.
void replaceExtensionWords(Unit& unit);

/// Shortens `(a, b)` to `(b)` where `a` does nothing, because versions from 4.30 on do not count the former
/// as a constant (GLSL ES 1.00, 5.10; GLSL 4.50, 4.3.3). Only for sources of older versions.
void dropIdleOperands(Unit& unit);

/// Marks the words that the declared version leaves free and that the source declares as names: ViewToken::
/// isName. A shader may use such a word with the meaning of a later version, too (language, 7.4), so a word
/// is a name only where the source has a declaration of it, and then everywhere but in layout(...).
void markNames(Unit& unit);

}  // namespace glibra::glsl
