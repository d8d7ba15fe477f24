#pragma once
// Syntax colours.

#include <imgui.h>

#include "view/edit/syntax.h"

namespace glibra::view {

/// The colour in the current theme.
ImU32 syntaxColor(SyntaxKind kind);

}  // namespace glibra::view
