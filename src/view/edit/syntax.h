#pragma once
// The names of source/syntax.h that the editor uses.

#include "source/syntax.h"

namespace glibra::view {

using source::CodeLanguage;
using source::SyntaxKind;
using source::syntaxOf;
using source::SyntaxPiece;
using source::SyntaxReader;

}  // namespace glibra::view
