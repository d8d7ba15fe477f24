#pragma once
// The colours of code and messages in the current theme.

#include <glibra/diagnostic.h>
#include <imgui.h>

#include "view/edit/source_files.h"
#include "view/style/palette.h"

namespace glibra::view {

ImU32 syntaxColor(SyntaxKind kind);
ImU32 tintColor(CodeTint tint);
/// The color as ImGui's draw lists take it.
ImU32 packed(const Color& color);
/// Of a message's text, and of the marks of its place.
const Color& severityColor(Severity severity);

}  // namespace glibra::view
