#include "view/edit/code_palette.h"

namespace glibra::view {

Tint tintOf(CodeTint tint, bool isLight) {
    switch (tint) {
        case CodeTint::errorLine:
            return isLight ? Tint{220, 50, 40, 22} : Tint{220, 50, 40, 40};
        case CodeTint::warningLine:
            return isLight ? Tint{230, 170, 30, 34} : Tint{230, 170, 30, 22};
        case CodeTint::found:
            return isLight ? Tint{220, 180, 40, 80} : Tint{200, 160, 40, 28};
        case CodeTint::foundShown:
            return isLight ? Tint{250, 170, 40, 92} : Tint{200, 160, 40, 36};
        case CodeTint::selection:
            return isLight ? Tint{66, 150, 250, 56} : Tint{66, 150, 250, 50};
        case CodeTint::chosenRow:
            break;
    }
    return isLight ? Tint{66, 150, 250, 60} : Tint{66, 150, 250, 50};
}

Color tinted(const Color& background, const Tint& tint) {
    constexpr float kWhole = 255;
    const float alpha = static_cast<float>(tint.alpha) / kWhole;
    const auto mixed = [&](std::uint8_t top, float below) {
        return alpha * static_cast<float>(top) / kWhole + (1 - alpha) * below;
    };
    return {mixed(tint.red, background.r), mixed(tint.green, background.g), mixed(tint.blue, background.b)};
}

}  // namespace glibra::view
