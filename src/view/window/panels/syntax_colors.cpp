#include "view/window/panels/syntax_colors.h"

namespace glibra::view {

ImU32 syntaxColor(SyntaxKind kind) {
    const ImVec4 background = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
    const bool isLight = background.x + background.y + background.z > 1.5F;
    switch (kind) {
        case SyntaxKind::keyword:
            return isLight ? IM_COL32(150, 40, 140, 255) : IM_COL32(215, 145, 235, 255);
        case SyntaxKind::type:
            return isLight ? IM_COL32(20, 95, 170, 255) : IM_COL32(110, 185, 250, 255);
        case SyntaxKind::number:
            return isLight ? IM_COL32(160, 85, 0, 255) : IM_COL32(235, 180, 110, 255);
        case SyntaxKind::comment:
            return isLight ? IM_COL32(85, 125, 85, 255) : IM_COL32(120, 155, 120, 255);
        case SyntaxKind::directive:
            return isLight ? IM_COL32(120, 90, 20, 255) : IM_COL32(205, 200, 125, 255);
        case SyntaxKind::builtin:
            return isLight ? IM_COL32(0, 120, 120, 255) : IM_COL32(110, 210, 200, 255);
        case SyntaxKind::plain:
            break;
    }
    return ImGui::GetColorU32(ImGuiCol_Text);
}

}  // namespace glibra::view
