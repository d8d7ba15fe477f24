#include "view/window/panels/syntax_colors.h"

#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

const Color& kindColor(SyntaxKind kind) {
    const Palette& p = palette();
    switch (kind) {
        case SyntaxKind::keyword:
            return p.keyword;
        case SyntaxKind::type:
            return p.type;
        case SyntaxKind::number:
            return p.number;
        case SyntaxKind::comment:
            return p.comment;
        case SyntaxKind::directive:
            return p.directive;
        case SyntaxKind::builtin:
            return p.builtin;
        case SyntaxKind::plain:
            break;
    }
    return p.text;
}

}  // namespace

ImU32 syntaxColor(SyntaxKind kind) {
    return packed(kindColor(kind));
}

ImU32 tintColor(CodeTint tint) {
    const Tint color = tintOf(tint, palette().panel == paletteOf(true).panel);
    return IM_COL32(color.red, color.green, color.blue, color.alpha);
}

ImU32 packed(const Color& color) {
    return ImGui::ColorConvertFloat4ToU32(asVector(color));
}

const Color& severityColor(Severity severity) {
    if (severity == Severity::note) return palette().text;
    return severity == Severity::error ? palette().error : palette().warning;
}

}  // namespace glibra::view
